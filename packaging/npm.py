"""npm packages: a small one that people install, one with the programs for each platform, of which npm
installs the one that fits, and the WebAssembly module, which it installs where none fits.

The module is not a dependency of the package that people install: npm would download all of it (6 MB)
everywhere, also where a program fits. It is a dependency of small packages that are, like those with
programs, optional dependencies, and whose `os` and `cpu` are the platforms without programs.
"""

import json

import archive
from archive import Entry, licenses, text
from project import PROGRAMS, ROOT, project
from targets import TARGETS, without_programs
from wheel import server_name

SOURCES = ROOT / "packaging/npm"
MODULE = "shaderlint-wasm"


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
        "optionalDependencies": {name: project().version for name in optional()},
    }
    entries = []
    for path in sorted(SOURCES.glob("*/*.js")):
        inside = path.relative_to(SOURCES).as_posix()
        entries.append(Entry(f"package/{inside}", path.read_bytes(), inside.startswith("bin/")))
    return pack(manifest, entries, project().readme, out)


def optional():
    """The packages of which npm installs those for the platform."""
    return [*(t.npm_package for t in TARGETS), *(f"@shaderlint/wasm-{name}" for name in without_programs())]


def write_module(folder, out):
    """Writes the package with the WebAssembly modules in a folder, and those that install it."""
    manifest = json.loads((folder / "package.json").read_text())
    manifest = common(MODULE) | manifest | {"version": project().version}
    files = [path for path in sorted(folder.iterdir()) if path.suffix in (".js", ".ts", ".wasm")]
    # A test may pack fewer modules than a release has.
    exported = manifest["exports"]
    missing = [name for name in exported if name.endswith(".wasm") and not (folder / name).is_file()]
    manifest["exports"] = {name: target for name, target in exported.items() if name not in missing}
    entries = [Entry(f"package/{path.name}", path.read_bytes()) for path in files]
    pack(manifest, entries, project().page("docs/javascript.md"), out)
    for name, (systems, cpus) in without_programs().items():
        manifest = common(f"@shaderlint/wasm-{name}")
        manifest["description"] = f"Installs {MODULE} where {project().name} has no programs"
        manifest["os"] = systems
        if cpus:
            manifest["cpu"] = cpus
        # A name of its own for each: npm before 10 removes what a package that does not fit depends on, unless
        # another package depends on it as well.
        alias = f"{MODULE}-{name}"
        manifest |= {"main": "index.js", "dependencies": {alias: f"npm:{MODULE}@{project().version}"}}
        note = f"Installs `{MODULE}` for `{project().name}`. Install `{project().name}` instead.\n"
        # Package managers with strict folders find the module from the package that depends on it only.
        entry = text("package/index.js", f'"use strict";\n\nmodule.exports = () => import("{alias}");\n')
        pack(manifest, [entry], note, out)


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
