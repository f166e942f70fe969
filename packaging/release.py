"""What completes a release: checksums, their signature, release notes, and a report."""

import hashlib
import subprocess

from project import changes, project

SUMS = "SHA256SUMS"


def write(out, key):
    """Writes release notes, checksums and, with a key, their signature; gives the checksums by file name."""
    (out / "NOTES.md").write_text(f"# {project().name} {project().version}\n\n{changes()}")
    files = sorted(path for path in out.iterdir() if path.is_file() and path.name != SUMS)
    checksums = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in files}
    sums = out / SUMS
    sums.write_text("".join(f"{checksum}  {name}\n" for name, checksum in checksums.items()))
    if key:
        comment = f"{project().name} {project().version}"
        subprocess.run(["minisign", "-S", "-s", key, "-m", sums, "-t", comment], check=True)
    return checksums


def table(out, report):
    """The targets with what they need, and the packages with their sizes."""
    lines = [f"{triple:28} {state:12} {needs}" for triple, needs, state in report]
    lines.append("")
    for path in sorted(out.iterdir()):
        if path.is_file():
            lines.append(f"{path.stat().st_size:>12,}  {path.name}")
    return "\n".join(lines)
