"""npm packages: a small one that people install, and one with the programs for each platform, of which
npm installs the one that fits."""

import json

import archive
from archive import Entry, licenses, text
from project import PROGRAMS, ROOT, project
from targets import TARGETS
from wheel import server_name

SOURCES = ROOT / "packaging/npm"


def write_platform(target, programs, out):
    """Writes the package with the programs for a platform."""
    system, cpu, libc = target.npm
    manifest = common(target.npm_package)
    manifest["description"] = f"The programs of {project().name} for {system} on {cpu}"
    manifest |= {"os": [system], "cpu": [cpu]}
    if libc:
        manifest["libc"] = [libc]
    # Package managers that keep packages in archives cannot start programs inside them.
    manifest["preferUnplugged"] = True
    note = f"The programs of `{project().name}` for this platform. Install `{project().name}` instead.\n"
    entries = [Entry(f"package/bin/{p.name}", p.read_bytes(), True) for p in programs]
    return pack(manifest, entries, note, out)


def write_main(out):
    """Writes the package that people install."""
    manifest = common(project().name)
    manifest |= {
        "keywords": list(project().keywords),
        # The registry of MCP servers recognises the package by it.
        "mcpName": server_name(),
        "bin": {name: f"bin/{name}.js" for name in PROGRAMS},
        "engines": {"node": ">=16"},
        "optionalDependencies": {t.npm_package: project().version for t in TARGETS},
    }
    entries = []
    for path in sorted(SOURCES.glob("*/*.js")):
        inside = path.relative_to(SOURCES).as_posix()
        entries.append(Entry(f"package/{inside}", path.read_bytes(), inside.startswith("bin/")))
    return pack(manifest, entries, project().readme, out)


def common(name):
    """The fields that all packages have."""
    about = project()
    return {
        "name": name,
        "version": about.version,
        "description": about.summary,
        "license": about.license,
        "homepage": about.repository,
        "repository": {"type": "git", "url": f"git+{about.repository}"},
    }


def pack(manifest, entries, readme, out):
    """Writes a package as `npm pack` does."""
    name = manifest["name"].removeprefix("@").replace("/", "-")
    entries += [text("package/package.json", json.dumps(manifest, indent=2) + "\n")]
    entries += [text("package/README.md", readme), *licenses("package")]
    return archive.write_tar(out / f"{name}-{manifest['version']}.tgz", entries)
