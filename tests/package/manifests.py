"""Checks what packages and manifests say: versions, addresses, checksums, and the rules of each format.

    manifests.py FOLDER     the output of packaging/build
"""

import csv
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import zipfile

import yaml
from packaging.metadata import Metadata

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
OUT = pathlib.Path(sys.argv[1])
PACKAGE = next(
    package
    for package in json.loads(
        subprocess.check_output(
            ["cargo", "metadata", "--no-deps", "--offline", "--format-version", "1"], cwd=ROOT
        )
    )["packages"]
    if package["name"] == "shaderlint"
)
VERSION = PACKAGE["version"]
REPOSITORY = PACKAGE["repository"]
RELEASES = f"{REPOSITORY}/releases/download/v{VERSION}"
TARGETS = subprocess.check_output([ROOT / "packaging/build", "--list"], text=True).split()
SUMS = dict(reversed(line.split("  ")) for line in (OUT / "SHA256SUMS").read_text().splitlines() if line)


def archive(triple):
    """The file name of an archive."""
    return f"shaderlint-{VERSION}-{triple}." + ("zip" if "windows" in triple else "tar.gz")


def checksum(triple):
    """The checksum of an archive; zeros where a dry run did not build it."""
    return SUMS.get(archive(triple), "0" * 64)


def text(path):
    """A manifest. An unquoted checksum of digits would be a number in YAML."""
    return (OUT / "manifests" / path).read_text()


def check_wheel():
    """Metadata, and the checksums of RECORD."""
    (path,) = OUT.glob("*.whl")
    with zipfile.ZipFile(path) as wheel:
        names = wheel.namelist()
        info = f"shaderlint-{VERSION}.dist-info"
        metadata = Metadata.from_email(wheel.read(f"{info}/METADATA"), validate=True)
        assert (metadata.name, str(metadata.version)) == ("shaderlint", VERSION)
        assert str(metadata.requires_python) == ">=3.8"
        assert "](docs/" not in metadata.description, "links must be absolute"
        record = list(csv.reader(wheel.read(f"{info}/RECORD").decode().splitlines()))
        assert [row[0] for row in record] == names
        for name, _, size in record[:-1]:
            assert wheel.getinfo(name).file_size == int(size), name
        tags = re.findall("Tag: (.*)", wheel.read(f"{info}/WHEEL").decode())
    assert path.name == f"shaderlint-{VERSION}-py3-none-{'.'.join(t.split('-')[2] for t in tags)}.whl"


def check_npm():
    """The main package names the package of each target."""
    with tarfile.open(OUT / f"shaderlint-{VERSION}.tgz") as package:
        manifest = json.load(package.extractfile("package/package.json"))
        modes = {member.name: member.mode for member in package.getmembers()}
    assert all(modes[f"package/{path}"] == 0o755 for path in manifest["bin"].values())
    platforms = manifest["optionalDependencies"]
    fallbacks = {name for name in platforms if name.startswith("@shaderlint/wasm-")}
    assert set(platforms.values()) == {VERSION} and len(platforms) == len(TARGETS) + len(fallbacks)
    for path in OUT.glob("shaderlint-*-*.tgz"):
        with tarfile.open(path) as package:
            platform = json.load(package.extractfile("package/package.json"))
        if platform["name"] == "shaderlint-wasm":
            continue
        if platform["name"] in fallbacks:
            alias = platform["name"].removeprefix("@").replace("/", "-")
            assert platform["dependencies"] == {alias: f"npm:shaderlint-wasm@{VERSION}"}
            continue
        name = "-".join([*platform["os"], *platform["cpu"]])
        name += {"glibc": "-gnu", "musl": "-musl", "": ""}["".join(platform.get("libc", []))]
        assert platform["name"] == f"@shaderlint/{name}" and platform["name"] in platforms
    return manifest


def check_fallbacks():
    """On each platform npm installs programs or the module, never both."""

    def fits(manifest, field, value):
        listed = manifest.get(field, [])
        wanted = [item for item in listed if not item.startswith("!")]
        return f"!{value}" not in listed and (not wanted or value in wanted)

    manifests = []
    for path in OUT.glob("shaderlint-wasm-*-*.tgz"):
        with tarfile.open(path) as package:
            manifests.append(json.load(package.extractfile("package/package.json")))
    assert manifests
    systems = {"linux": "linux", "darwin": "darwin", "windows": "win32"}
    cpus = {"x86_64": "x64", "aarch64": "arm64"}
    programs = {
        (systems[next(s for s in systems if s in triple)], cpus[triple.split("-")[0]]) for triple in TARGETS
    }
    for system in [*systems.values(), "freebsd", "android", "sunos"]:
        for cpu in ["x64", "arm64", "arm", "ia32", "riscv64", "s390x"]:
            modules = [m["name"] for m in manifests if fits(m, "os", system) and fits(m, "cpu", cpu)]
            assert len(modules) == ((system, cpu) not in programs), (system, cpu, modules)


def filled(template, values):
    """A template of `cargo binstall` with its values."""
    return re.sub(r"\{ ([\w-]+) \}", lambda match: values[match[1]], template)


def check_binstall():
    """The addresses that `cargo binstall` composes are those of the archives, and so are the folders in them."""
    metadata = PACKAGE["metadata"]["binstall"]
    for triple in [*TARGETS, "x86_64-pc-windows-msvc"]:
        used = metadata | metadata["overrides"].get(triple, {})
        windows = "windows" in triple
        values = {"repo": REPOSITORY, "version": VERSION, "name": "shaderlint", "target": triple}
        values |= {"bin": "shaderport", "binary-ext": ".exe" if windows else ""}
        address, inside = (filled(used[key], values) for key in ("pkg-url", "bin-dir"))
        built = triple.replace("-msvc", "-gnu")
        assert address == f"{RELEASES}/{archive(built)}", address
        assert used["pkg-fmt"] == ("zip" if windows else "tgz")
        path = OUT / archive(built)
        if path.exists():
            with tarfile.open(path) as archived:
                assert inside in archived.getnames(), inside
        assert inside.startswith(archive(built).removesuffix(".zip").removesuffix(".tar.gz")), inside


def check_server(npm):
    """What the registry's schema for `server.json` and its rules for packages require."""
    server = json.loads(text("mcp/server.json"))
    schema = r"https://static\.modelcontextprotocol\.io/schemas/[\d-]+/server\.schema\.json"
    assert re.fullmatch(schema, server["$schema"])
    assert re.fullmatch(r"[a-zA-Z0-9.-]+/[a-zA-Z0-9._-]+", server["name"]) and 3 <= len(server["name"]) <= 200
    assert 1 <= len(server["title"]) <= 100 and 1 <= len(server["description"]) <= 100
    assert server["version"] == VERSION and server["websiteUrl"] == REPOSITORY
    known = {"registryType", "identifier", "version", "runtimeHint", "transport", "packageArguments"}
    for package in server["packages"]:
        assert set(package) == known and package["transport"] == {"type": "stdio"}
        assert package["identifier"] == "shaderlint" and package["version"] == VERSION
        assert all(a["type"] == "positional" and a["value"] for a in package["packageArguments"])
    assert {p["registryType"] for p in server["packages"]} == {"npm", "pypi"}
    # Both packages name their owner.
    assert npm["mcpName"] == server["name"]
    (wheel,) = OUT.glob("*.whl")
    with zipfile.ZipFile(wheel) as opened:
        metadata = opened.read(f"shaderlint-{VERSION}.dist-info/METADATA").decode()
    assert f"mcp-name: {server['name']} " in metadata


def check_vscode():
    """The packages for VS Code name their platform, and the one for browsers has no program."""
    packages = sorted(OUT.glob("*.vsix"))
    # One for each target that was built.
    assert len(packages) == 1 + len(list(OUT.glob("shaderlint-*-*-*.tar.gz")) + list(OUT.glob("shaderlint-*.zip")))
    for path in packages:
        with zipfile.ZipFile(path) as package:
            manifest = json.loads(package.read("extension/package.json"))
            platform = re.search('TargetPlatform="(.*?)"', package.read("extension.vsixmanifest").decode())[1]
            programs = [entry for entry in package.infolist() if entry.filename.startswith("extension/bin/")]
        assert path.name == f"shaderlint-{platform}-{VERSION}.vsix" and manifest["version"] == VERSION
        assert ("main" in manifest, "browser" in manifest) == ((False, True) if platform == "web" else (True, False))
        assert all(entry.external_attr >> 16 & 0o111 for entry in programs) and bool(programs) == ("main" in manifest)


def check_others(npm):
    """Homebrew, Scoop, winget and mason."""
    formula = text("homebrew/shaderlint.rb")
    found = re.findall(r'url "(.*)"\n\s*sha256 "(.*)"', formula)
    found = {u.replace("#{homepage}", REPOSITORY).replace("#{version}", VERSION): c for u, c in found}
    triples = [t for t in TARGETS if t.endswith(("-apple-darwin", "-linux-gnu"))]
    assert found == {f"{RELEASES}/{archive(t)}": checksum(t) for t in triples}
    assert f'version "{VERSION}"' in formula and f'homepage "{REPOSITORY}"' in formula

    windows = "x86_64-pc-windows-gnu"
    scoop = json.loads(text("scoop/shaderlint.json"))["architecture"]["64bit"]
    assert (scoop["url"], scoop["hash"]) == (f"{RELEASES}/{archive(windows)}", checksum(windows))
    assert scoop["extract_dir"] == archive(windows).removesuffix(".zip")

    kinds = {"": "version", ".installer": "installer", ".locale.en-US": "defaultLocale"}
    for part, kind in kinds.items():
        manifest = yaml.safe_load(text(f"winget/shaderlint.shaderlint{part}.yaml"))
        assert manifest["ManifestType"] == kind and str(manifest["PackageVersion"]) == VERSION
        assert manifest["PackageIdentifier"] == "shaderlint.shaderlint"
        for installer in manifest.get("Installers", []):
            assert installer["InstallerUrl"] == scoop["url"]
            assert installer["InstallerSha256"] == scoop["hash"].upper()
    mason = yaml.safe_load(text("mason/packages/shaderlint/package.yaml"))
    assert mason["name"] == "shaderlint" and mason["homepage"] == REPOSITORY
    assert mason["source"]["id"] == f"pkg:npm/shaderlint@{VERSION}"
    assert mason["bin"] == {name: f"npm:{name}" for name in npm["bin"]}
    # Zed builds its extension from the repository.
    zed = dict(re.findall('^(version|repository) = "(.*)"$', (ROOT / "editors/zed/extension.toml").read_text(), re.M))
    assert zed == {"version": VERSION, "repository": REPOSITORY}
    # What `docker build` copies.
    docker = (OUT / "docker/Dockerfile").read_text()
    assert "\nFROM scratch\n" in docker and "COPY linux/${TARGETARCH}/ " in docker


def check_all():
    """All checks; no template value is left."""
    check_wheel()
    npm = check_npm()
    check_fallbacks()
    check_binstall()
    check_server(npm)
    check_vscode()
    check_others(npm)
    for name, expected in SUMS.items():
        assert hashlib.sha256((OUT / name).read_bytes()).hexdigest() == expected, name
    for path in OUT.rglob("*"):
        if path.is_file() and path.suffix in (".rb", ".json", ".yaml", ".toml", ".sh", ".md"):
            content = path.read_text()
            assert "{{" not in content, path
            others = set(re.findall(r"https?://[\w.-]+", content)) - {"https://example.com"}
            # Only release notes may lead elsewhere.
            is_known = all("modelcontextprotocol" in other for other in others)
            assert is_known or path.name == "NOTES.md", (path, others)


check_all()
