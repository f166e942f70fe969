"""What programs need from the system that they run on, read from the files themselves."""

import hashlib
import re
import struct
import subprocess
from dataclasses import dataclass

from targets import GLIBC, MACOS

MACH_O = 0xFEEDFACF
# The architectures in the heads of Mach-O and PE files.
MACH_O_CPUS = {"x86_64": 0x0100_0007, "aarch64": 0x0100_000C}
PE_X86_64 = 0x8664
# Commands in the head of a Mach-O file: a signature, and the oldest system, in its two forms.
CODE_SIGNATURE = 0x1D
OLDEST_SYSTEM = {0x32: 12, 0x24: 8}
# The signature's blob of all parts, the part that names the code, and its flag for "signed by nobody".
SIGNATURE, CODE_DIRECTORY, AD_HOC = 0xFADE_0CC0, 0xFADE_0C02, 0x2
# The only kind of checksum that is in use.
SHA256 = 2
# Libraries that manylinux allows; all systems with glibc have them.
ALLOWED = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libgcc_s.so.1"}
ALLOWED |= {"ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
# Libraries that every Windows has.
OF_WINDOWS = re.compile(r"(kernel32|ntdll|user32|ws2_32|advapi32|bcrypt\w*|userenv|shell32|ole32|msvcrt|ucrtbase)\.dll")
OF_WINDOWS_RUNTIME = re.compile(r"api-ms-win-[\w-]+\.dll")


class Unfit(Exception):
    """A program that does not run on every system that its package is for."""


@dataclass(frozen=True)
class Needs:
    """What a program needs."""

    # Shared libraries, without the loader.
    libraries: frozenset = frozenset()
    # The oldest version of glibc that has all its symbols.
    glibc: tuple = ()
    summary: str = ""


def read(path):
    """What an ELF file needs."""
    dynamic = readelf("--dynamic", path)
    libraries = frozenset(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic))
    versions = re.findall(r"Name: GLIBC_([\d.]+)", readelf("--version-info", path))
    glibc = max((tuple(map(int, v.split("."))) for v in versions), default=())
    loader = {name for name in libraries if name.startswith("ld-linux")}
    if glibc:
        summary = f"glibc {'.'.join(map(str, glibc))}, " + " ".join(sorted(libraries - loader))
    else:
        summary = "static" if not libraries else " ".join(sorted(libraries))
    return Needs(libraries - loader, glibc, summary)


def readelf(option, path):
    """What `readelf` prints, for any architecture."""
    return subprocess.check_output(["readelf", "--wide", option, path], text=True)


def check(target, path):
    """What a program for a release needs; fails if a system of the target does not have it."""
    if target.is_linux:
        needs = read(path)
        if target.triple.endswith("-musl"):
            if needs.libraries or "INTERP" in readelf("--program-headers", path):
                raise Unfit(f"{path} is not static: {needs.summary}")
        elif needs.glibc > GLIBC:
            raise Unfit(f"{path} needs {needs.summary}; at most glibc {GLIBC[0]}.{GLIBC[1]} is allowed")
        elif not needs.libraries <= ALLOWED:
            raise Unfit(f"{path} needs {' '.join(sorted(needs.libraries - ALLOWED))}")
        return needs
    if target.is_windows:
        return Needs(summary=check_windows(path))
    return Needs(summary=check_macos(target.architecture, path))


def check_windows(path):
    """Summary of a PE file for x86-64 that needs only libraries of Windows."""
    data = path.read_bytes()
    head = struct.unpack_from("<I", data, 0x3C)[0]
    if data[:2] != b"MZ" or struct.unpack_from("<4sH", data, head) != (b"PE\0\0", PE_X86_64):
        raise Unfit(f"{path} is not a program for Windows on x86-64")
    printed = subprocess.check_output(["objdump", "--private-headers", path], text=True)
    libraries = {name.lower() for name in re.findall(r"DLL Name: (\S+)", printed)}
    others = {n for n in libraries if not (OF_WINDOWS.fullmatch(n) or OF_WINDOWS_RUNTIME.fullmatch(n))}
    if others or not libraries:
        raise Unfit(f"{path} needs {' '.join(sorted(others)) or 'no library at all'}")
    return f"{len(libraries)} libraries of Windows"


def check_macos(architecture, path):
    """Summary of a Mach-O file that runs on the oldest system, and is signed if the processor requires it."""
    data = path.read_bytes()
    magic, cpu, _, _, count, _, _, _ = struct.unpack_from("<8I", data)
    if (magic, cpu) != (MACH_O, MACH_O_CPUS[architecture]):
        raise Unfit(f"{path} is not a program for macOS on {architecture}")
    at, oldest, signature = 32, None, None
    for _ in range(count):
        command, size = struct.unpack_from("<2I", data, at)
        if command in OLDEST_SYSTEM:
            version = struct.unpack_from("<I", data, at + OLDEST_SYSTEM[command])[0]
            oldest = (version >> 16, version >> 8 & 255)
        if command == CODE_SIGNATURE:
            signature = struct.unpack_from("<I", data, at + 8)[0]
        at += size
    if oldest is None or oldest > tuple(map(int, MACOS.split("."))):
        raise Unfit(f"{path} needs macOS {'.'.join(map(str, oldest or ('of any version',)))}")
    is_signed = signature is not None and is_ad_hoc(data, signature)
    if architecture == "aarch64" and not is_signed:
        raise Unfit(f"{path} is not signed, so macOS does not start it")
    return f"macOS {oldest[0]}.{oldest[1]}, {'ad-hoc signed' if is_signed else 'not signed'}"


def is_ad_hoc(data, at):
    """Whether the signature at this offset is made without a certificate, and is that of the file: whatever
    changes a program after it was linked makes it invalid."""
    magic, _, count = struct.unpack_from(">3I", data, at)
    for index in range(count if magic == SIGNATURE else 0):
        part = at + struct.unpack_from(">I", data, at + 12 + 8 * index + 4)[0]
        magic, _, _, flags, hashes, _, _, slots, end = struct.unpack_from(">9I", data, part)
        if magic == CODE_DIRECTORY:
            size, kind, _, page = struct.unpack_from("4B", data, part + 36)
            for slot in range(slots):
                start = slot << page
                digest = hashlib.sha256(data[start : min(start + (1 << page), end)]).digest()
                at = part + hashes + slot * size
                if kind != SHA256 or data[at : at + size] != digest:
                    return False
            return bool(flags & AD_HOC)
    return False
