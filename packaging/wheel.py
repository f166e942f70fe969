"""Wheels with the programs, as `maturin build` writes them from source."""

import base64
import hashlib

from archive import Entry, licenses, text, write_zip
from project import LICENSES, project

CLASSIFIERS = (
    "Development Status :: 4 - Beta",
    "Environment :: Console",
    "Intended Audience :: Developers",
    "Operating System :: MacOS",
    "Operating System :: Microsoft :: Windows",
    "Operating System :: POSIX :: Linux",
    "Programming Language :: Python :: 3",
    "Programming Language :: Rust",
    "Topic :: Multimedia :: Graphics :: 3D Rendering",
    "Topic :: Software Development :: Quality Assurance",
)


def write(tags, programs, out):
    """Writes a wheel for platforms, which are tags such as `win_amd64`."""
    version = project().version
    info = f"shaderlint-{version}.dist-info"
    scripts = f"shaderlint-{version}.data/scripts"
    entries = [Entry(f"{scripts}/{p.name}", p.read_bytes(), True) for p in programs]
    entries += licenses(f"{info}/licenses")
    entries += [text(f"{info}/METADATA", metadata()), text(f"{info}/WHEEL", about(tags))]
    entries.sort()
    record = f"{info}/RECORD"
    lines = [f"{e.path},sha256={digest(e.data)},{len(e.data)}\n" for e in entries]
    # The format recommends that the metadata is at the end of the file.
    entries.append(text(record, "".join([*lines, f"{record},,\n"])))
    path = out / f"shaderlint-{version}-py3-none-{'.'.join(tags)}.whl"
    return write_zip(path, entries, is_sorted=True)


def digest(data):
    """A checksum as RECORD has it."""
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def about(tags):
    """The file WHEEL."""
    lines = ["Wheel-Version: 1.0", "Generator: shaderlint", "Root-Is-Purelib: false"]
    return "\n".join(lines + [f"Tag: py3-none-{tag}" for tag in tags]) + "\n"


def metadata():
    """The file METADATA, with the README as the description."""
    about = project()
    fields = [
        ("Metadata-Version", "2.4"),
        ("Name", about.name),
        ("Version", about.version),
        ("Summary", about.summary),
        ("Description-Content-Type", "text/markdown; charset=UTF-8; variant=GFM"),
        ("Keywords", ",".join(about.keywords)),
        ("License-Expression", about.license),
        *(("License-File", name) for name in LICENSES),
        ("Requires-Python", ">=3.8"),
        *(("Classifier", classifier) for classifier in CLASSIFIERS),
        ("Project-URL", f"Source, {about.repository}"),
    ]
    head = "".join(f"{name}: {value}\n" for name, value in fields)
    # The registry of MCP servers recognises the package by this line.
    return f"{head}\n{about.readme}\n<!-- mcp-name: {server_name()} -->\n"


def server_name():
    """The name in the registry of MCP servers: the host backwards, and the project."""
    reversed_host = ".".join(reversed(project().host.split(".")))
    return f"{reversed_host}/{project().name}"
