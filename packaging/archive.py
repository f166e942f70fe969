"""Archives with the same bytes for the same content: entries are sorted, and belong to root at one time."""

import gzip
import io
import tarfile
import time
import zipfile
from dataclasses import dataclass

from project import LICENSES, ROOT, project, timestamp


# Of deflate and xz; none where packages are only tested.
COMPRESSION = 9


@dataclass(frozen=True, order=True)
class Entry:
    """A file in an archive."""

    path: str
    data: bytes
    is_program: bool = False

    @property
    def mode(self):
        """Its permissions."""
        return 0o755 if self.is_program else 0o644


def text(path, content):
    """An entry with text."""
    return Entry(path, content.encode())


def write_tar(path, entries):
    """Writes a `.tar.gz`."""
    with open(path, "wb") as file, gzip.GzipFile("", "wb", COMPRESSION, file, timestamp()) as compressed:
        with tarfile.open(fileobj=compressed, mode="w", format=tarfile.USTAR_FORMAT) as out:
            for entry in sorted(entries):
                info = tarfile.TarInfo(entry.path)
                info.size = len(entry.data)
                info.mode = entry.mode
                info.mtime = timestamp()
                info.uname = info.gname = "root"
                out.addfile(info, io.BytesIO(entry.data))
    return path


def write_zip(path, entries, is_sorted=False):
    """Writes a `.zip`; `is_sorted` keeps the order of the entries."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=COMPRESSION) as out:
        for entry in entries if is_sorted else sorted(entries):
            info = zipfile.ZipInfo(entry.path, time.gmtime(timestamp())[:6])
            info.compress_type = zipfile.ZIP_DEFLATED
            # Unix, whatever system writes the archive: it has the permissions.
            info.create_system = 3
            info.external_attr = (0o100000 | entry.mode) << 16
            out.writestr(info, entry.data, compresslevel=COMPRESSION)
    return path


def licenses(folder):
    """The licences as entries."""
    return [Entry(f"{folder}/{name}", (ROOT / name).read_bytes()) for name in LICENSES]


def name(target):
    """The file name of the archive of a target."""
    extension = "zip" if target.is_windows else "tar.gz"
    return f"{folder(target)}.{extension}"


def folder(target):
    """The only folder in the archive of a target."""
    return f"shaderlint-{project().version}-{target.triple}"


def write(target, programs, extras, out):
    """Writes the archive of a target: programs, man pages, completions, README, licences."""
    inside = folder(target)
    entries = [Entry(f"{inside}/{p.name}", p.read_bytes(), True) for p in programs]
    entries += [Entry(f"{inside}/{path}", data) for path, data in extras.items()]
    entries += [text(f"{inside}/README.md", project().readme), *licenses(inside)]
    return (write_zip if target.is_windows else write_tar)(out / name(target), entries)
