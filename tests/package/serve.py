"""Serves packages to the tests, at an address that it prints first.

    serve.py FOLDER     /files/NAME is a file in FOLDER; /npm is a registry of the npm packages in it
"""

import base64
import functools
import hashlib
import http.server
import json
import pathlib
import sys
import tarfile
import urllib.parse


def packages(folder):
    """The npm packages in a folder: their files and manifests, by name."""
    found = {}
    for path in sorted(pathlib.Path(folder).glob("*.tgz")):
        with tarfile.open(path) as archive:
            manifest = json.load(archive.extractfile("package/package.json"))
        found[manifest["name"]] = path, manifest
    return found


class Handler(http.server.SimpleHTTPRequestHandler):
    """Answers requests for files and for metadata of npm packages."""

    def __init__(self, *args, found, **rest):
        self.found = found
        super().__init__(*args, **rest)

    def do_GET(self):
        path = urllib.parse.unquote(self.path)
        if path.startswith("/files/"):
            self.path = path.removeprefix("/files")
            super().do_GET()
        elif path.removeprefix("/npm/") in self.found:
            body = json.dumps(self.metadata(path.removeprefix("/npm/"))).encode()
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)
        else:
            self.send_error(404)

    def metadata(self, name):
        """What a registry answers for a package with one version."""
        path, manifest = self.found[name]
        digest = base64.b64encode(hashlib.sha512(path.read_bytes()).digest()).decode()
        address = f"http://{self.headers['Host']}/files/{path.name}"
        version = manifest["version"]
        dist = {"tarball": address, "integrity": f"sha512-{digest}"}
        return {"name": name, "dist-tags": {"latest": version}, "versions": {version: manifest | {"dist": dist}}}

    def log_message(self, *args):
        pass


def main():
    folder = sys.argv[1]
    handler = functools.partial(Handler, found=packages(folder), directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        print(f"http://127.0.0.1:{server.server_port}", flush=True)
        server.serve_forever()


main()
