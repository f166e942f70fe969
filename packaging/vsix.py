#!/usr/bin/env python3
"""Packages for VS Code: one for each platform, which contains the program, and one for browsers, which
contains the WebAssembly module.

    packaging/vsix.py OUT PROGRAM [MODULES]     writes the package with PROGRAM for this machine, and the one
                                                with the module in MODULES
"""

import contextlib
import fcntl
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True

from project import ROOT, project, timestamp
from targets import find, host

SOURCES = ROOT / "editors/vscode"
FILES = ("README.md", "CHANGELOG.md", "LICENSE", "language-configuration.json", "syntaxes/*.json", "media/*")
WEB = "web"
# The module with previews; its name in the package.
MODULE = "shaderport.wasm"


@contextlib.contextmanager
def bundled():
    """A folder with the bundles of the extension and the licences of what they contain."""
    with tempfile.TemporaryDirectory() as folder:
        # Tests may install at the same time; npm writes that file last.
        with open(SOURCES / "package.json", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not (SOURCES / "node_modules/.package-lock.json").is_file():
                install = '. "$0" && patiently npm ci --loglevel=error --no-audit --no-fund >&2'
                subprocess.run(["bash", "-c", install, ROOT / "tests/need"], cwd=SOURCES, check=True)
        subprocess.run(["node", "build.mjs", folder], cwd=SOURCES, check=True)
        yield Path(folder)


def write_platform(target, program, bundles, out):
    """Writes the package with the program for a platform."""
    manifest = read_manifest()
    files = {f"bin/{program.name}": program, "dist/extension.js": bundles / "extension.js"}
    return pack(manifest, files, bundles, target.vscode, out)


def write_web(modules, bundles, out):
    """Writes the package for browsers."""
    manifest = read_manifest()
    del manifest["main"]
    manifest["browser"] = "dist/browser.js"
    manifest["capabilities"] = {"untrustedWorkspaces": {"supported": True}, "virtualWorkspaces": True}
    del manifest["contributes"]["configuration"]["properties"]["shaderlint.path"]
    for part in ("breakpoints", "debuggers"):
        del manifest["contributes"][part]
    files = {f"dist/{name}": bundles / name for name in ("browser.js", "worker.js")}
    return pack(manifest, files | {f"dist/{MODULE}": modules / MODULE}, bundles, WEB, out)


def read_manifest():
    """The manifest without what only its sources need."""
    manifest = json.loads((SOURCES / "package.json").read_text())
    for name in ("scripts", "dependencies", "devDependencies"):
        del manifest[name]
    return manifest | {"version": project().version}


def pack(manifest, files, bundles, target, out):
    """Writes a package; `files` are sources by path."""
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        all_files = {path.relative_to(SOURCES): path for pattern in FILES for path in SOURCES.glob(pattern)}
        for path, source in (all_files | files | {"dist/licenses.txt": bundles / "licenses.txt"}).items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, folder / path)
            (folder / path).chmod(0o755 if str(path).startswith("bin/") else 0o644)
        (folder / "package.json").write_text(json.dumps(manifest, indent=4))
        path = out.resolve() / f"{manifest['name']}-{target}-{manifest['version']}.vsix"
        vsce = [SOURCES / "node_modules/.bin/vsce", "package", "--no-dependencies", "--target", target, "--out", path]
        # The archive has local times.
        environment = os.environ | {"SOURCE_DATE_EPOCH": str(timestamp()), "TZ": "UTC"}
        said = subprocess.run(vsce, cwd=folder, env=environment, capture_output=True, text=True)
        if said.returncode != 0:
            raise SystemExit(f"packaging/build: vsce does not pack for {target}:\n{said.stdout}{said.stderr}")
    return path


def main():
    out, program, *modules = map(Path, sys.argv[1:])
    with bundled() as bundles:
        write_platform(find(host()), program, bundles, out)
        for folder in modules:
            write_web(folder, bundles, out)


if __name__ == "__main__":
    main()
