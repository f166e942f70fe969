"""Debian packages, written by `dpkg-deb`."""

import email.utils
import gzip
import hashlib
import os
import re
import subprocess
import tempfile
from pathlib import Path

import archive
from project import PROGRAMS, ROOT, project, timestamp

# Debian's packages of the libraries that programs may need.
LIBRARIES = {"libgcc_s.so.1": "libgcc-s1 (>= 4.2)"}
OF_GLIBC = ("libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1")

# Where completions are found, by their names in the archive.
COMPLETIONS = {
    "{}.bash": "usr/share/bash-completion/completions/{}",
    "_{}": "usr/share/zsh/vendor-completions/_{}",
    "{}.fish": "usr/share/fish/vendor_completions.d/{}.fish",
}


def write(target, programs, extras, needs, out):
    """Writes the package of a target; `needs` is what the programs need of the system."""
    path = out / f"{project().name}_{revision()}_{target.deb}.deb"
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        files = content(programs, extras)
        for name, data in files.items():
            put(root / name, data, name.startswith("usr/bin/"))
        put(root / "DEBIAN/control", control(target, files, needs).encode())
        sums = [f"{hashlib.md5(data).hexdigest()}  {name}\n" for name, data in sorted(files.items())]
        put(root / "DEBIAN/md5sums", "".join(sums).encode())
        for each in [root, *root.rglob("*")]:
            if each.is_dir():
                each.chmod(0o755)
            os.utime(each, (timestamp(), timestamp()))
        # Of xz, which all versions of Debian and Ubuntu read; with one thread, for the same bytes.
        options = ["--root-owner-group", "-Zxz", f"-z{archive.COMPRESSION}"]
        command = ["dpkg-deb", *options, "--build", folder, path]
        environment = os.environ | {"SOURCE_DATE_EPOCH": str(timestamp()), "DPKG_DEB_THREADS_MAX": "1"}
        subprocess.run(command, check=True, env=environment, stdout=subprocess.DEVNULL)
    return path


def revision():
    """The version of the package: the first of this version."""
    return f"{project().version}-1"


def put(path, data, is_program=False):
    """Writes a file with the permissions that it has in the package."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    path.chmod(0o755 if is_program else 0o644)


def content(programs, extras):
    """The files of the package by path."""
    name = project().name
    files = {f"usr/bin/{p.name}": p.read_bytes() for p in programs}
    for program in PROGRAMS:
        files[f"usr/share/man/man1/{program}.1.gz"] = compressed(extras[f"man/{program}.1"])
        for source, path in COMPLETIONS.items():
            files[path.format(program)] = extras[f"completions/{source.format(program)}"]
    documents = f"usr/share/doc/{name}"
    files[f"{documents}/copyright"] = copyright().encode()
    files[f"{documents}/changelog.gz"] = compressed((ROOT / "CHANGELOG.md").read_bytes())
    files[f"{documents}/changelog.Debian.gz"] = compressed(changelog().encode())
    return files


def compressed(data):
    """As `gzip -9n`."""
    return gzip.compress(data, 9, mtime=0)


def control(target, files, needs):
    """The control file."""
    about = project()
    size = sum(-(-len(data) // 1024) for data in files.values())
    glibc = "libc6 (>= {}.{})".format(*needs.glibc)
    depends = ", ".join(sorted({glibc if n in OF_GLIBC else LIBRARIES[n] for n in needs.libraries}))
    return (
        f"Package: {about.name}\nVersion: {revision()}\nArchitecture: {target.deb}\n"
        f"Maintainer: {about.maintainer}\nInstalled-Size: {size}\nDepends: {depends}\n"
        f"Section: devel\nPriority: optional\nHomepage: {about.repository}\n"
        f"Description: linter for GLSL shaders, and a porter of ShaderToy code\n"
        f" shaderlint finds mistakes in GLSL shaders for WebGL2 and ShaderToy: everything\n"
        f" that the browser's compiler rejects, and code that compiles but goes wrong.\n"
        f" .\n"
        f" shaderport ports ShaderToy shaders to WebGL2: a page that plays them, a module,\n"
        f" or plain GLSL.\n"
    )


def copyright():
    """The licences as plain text, which Debian accepts; Apache's is on every system."""
    mit = (ROOT / "LICENSE").read_text()
    holder = re.search(r"^Copyright \(c\) (.*)$", mit, re.MULTILINE)
    start = mit.index("Permission is hereby granted")
    return (
        f"{project().name} comes from {project().repository}.\n\n"
        f"Copyright: {holder.group(1)}\n\n"
        "License: MIT or Apache-2.0, at your option. On Debian systems, the text of the latter is in\n"
        f"/usr/share/common-licenses/Apache-2.0. The former:\n\n{mit[start:].strip()}\n"
    )


def changelog():
    """The changelog of the package, which names the version."""
    date = email.utils.formatdate(timestamp())
    return (
        f"{project().name} ({revision()}) unstable; urgency=medium\n\n  * Version {project().version}.\n\n"
        f" -- {project().maintainer}  {date}\n"
    )
