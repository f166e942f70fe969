"""Manifests for other package managers and registries, which name the archives and their checksums."""

import json
import re

import archive
from project import ROOT, project
from targets import GLIBC, TARGETS, find
from wheel import server_name

TEMPLATES = ROOT / "packaging/templates"
WINDOWS = find("x86_64-pc-windows-gnu")
# In a dry run for one platform the other archives do not exist. No file has this checksum.
MISSING = "0" * 64


def fill(name, values):
    """A template with its values."""

    def value(match):
        return values[match.group(1)]

    return re.sub(r"\{\{([\w-]+)\}\}", value, (TEMPLATES / name).read_text())


def values(checksums):
    """The values in templates; `checksums` by file name."""
    about = project()
    found = {t.triple: checksums.get(archive.name(t), MISSING) for t in TARGETS}
    return found | {
        "version": about.version,
        "summary": about.summary,
        "license": about.license,
        "repository": about.repository,
        "releases": about.releases,
        "glibc_minor": str(GLIBC[1]),
        "windows_archive": archive.name(WINDOWS),
        "windows_folder": archive.folder(WINDOWS),
        "WINDOWS_CHECKSUM": found[WINDOWS.triple].upper(),
    }


def write(checksums, out):
    """Writes all manifests into `out`."""
    filled = values(checksums)
    identifier = "shaderlint.shaderlint"
    files = {
        "homebrew/shaderlint.rb": fill("shaderlint.rb", filled),
        "scoop/shaderlint.json": as_json(scoop(filled)),
        f"winget/{identifier}.yaml": fill("winget.yaml", filled),
        f"winget/{identifier}.installer.yaml": fill("winget.installer.yaml", filled),
        f"winget/{identifier}.locale.en-US.yaml": fill("winget.locale.en-US.yaml", filled),
        "mason/packages/shaderlint/package.yaml": fill("mason.yaml", filled),
        "mcp/server.json": as_json(server()),
    }
    put(files, out)


def write_mirror(out):
    """Writes the repository whose hooks install the wheel."""
    filled = values({})
    hooks = (ROOT / ".pre-commit-hooks.yaml").read_text()
    files = {
        ".pre-commit-hooks.yaml": hooks,
        "pyproject.toml": fill("pre-commit.toml", filled),
        "backend.py": fill("backend.py", filled),
        "README.md": fill("pre-commit.md", filled),
    }
    put(files, out)


def write_docker(images, out):
    """Writes the folder that a container image is built in; `images` are programs by architecture."""
    put({"Dockerfile": fill("Dockerfile", values({}))}, out)
    for architecture, programs in images.items():
        folder = out / "linux" / architecture
        folder.mkdir(parents=True)
        for program in programs:
            (folder / program.name).write_bytes(program.read_bytes())
            (folder / program.name).chmod(0o755)


def write_installer(out):
    """Writes the script that installs an archive."""
    path = out / "install.sh"
    path.write_text(fill("install.sh", values({})))
    path.chmod(0o755)


def put(files, out):
    """Writes texts by path."""
    for path, content in files.items():
        (out / path).parent.mkdir(parents=True, exist_ok=True)
        (out / path).write_text(content)


def as_json(value):
    """A text of JSON."""
    return json.dumps(value, indent=2) + "\n"


def scoop(filled):
    """The manifest for Scoop."""
    return {
        "version": filled["version"],
        "description": filled["summary"],
        "homepage": filled["repository"],
        "license": filled["license"].replace(" OR ", "|"),
        "architecture": {
            "64bit": {
                "url": f"{filled['releases']}/{filled['windows_archive']}",
                "hash": filled[WINDOWS.triple],
                "extract_dir": filled["windows_folder"],
            }
        },
        "bin": ["shaderlint.exe", "shaderport.exe"],
    }


def server():
    """The entry in the registry of MCP servers: how clients start `shaderlint mcp`."""
    about = project()

    def package(registry, command):
        return {
            "registryType": registry,
            "identifier": about.name,
            "version": about.version,
            "runtimeHint": command,
            "transport": {"type": "stdio"},
            "packageArguments": [{"type": "positional", "value": "mcp"}],
        }

    return {
        "$schema": "https://static.modelcontextprotocol.io/schemas/2025-12-11/server.schema.json",
        "name": server_name(),
        "title": about.name,
        "description": "Checks, fixes, draws and ports GLSL shaders for WebGL2 and ShaderToy",
        "version": about.version,
        "websiteUrl": about.repository,
        "packages": [package("npm", "npx"), package("pypi", "uvx")],
    }
