"""Writes the wheel for programs that are already built, as `maturin build` would build it from
source.

    wheel.py FOLDER OUT     FOLDER contains the programs; prints the path of the wheel in OUT
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

PROGRAMS = ("shaderlint", "shaderport")


def main():
    folder, out = (pathlib.Path(arg).resolve() for arg in sys.argv[1:])
    version = subprocess.check_output([folder / PROGRAMS[0], "--version"], text=True).split()[1]
    tag = "py3-none-" + re.sub("[-.]", "_", sysconfig.get_platform())
    info = f"shaderlint-{version}.dist-info"
    files = {f"shaderlint-{version}.data/scripts/{name}": (folder / name).read_bytes() for name in PROGRAMS}
    files |= {
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: shaderlint\nVersion: {version}\n".encode(),
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: tests\nRoot-Is-Purelib: false\nTag: {tag}\n".encode(),
    }
    record = f"{info}/RECORD"
    lines = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(data)}\n")
    files[record] = "".join([*lines, f"{record},,\n"]).encode()

    out.mkdir(parents=True, exist_ok=True)
    path = out / f"shaderlint-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w") as wheel:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name)
            entry.external_attr = (0o100755 if "/scripts/" in name else 0o100644) << 16
            wheel.writestr(entry, data)
    print(path)


main()
