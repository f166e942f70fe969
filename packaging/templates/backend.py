"""Builds the empty package for pip. A build system would have to be downloaded first."""

import pathlib
import zipfile

VERSION = "{{version}}"
INFO = f"shaderlint_pre_commit-{VERSION}.dist-info"
METADATA = f"""\
Metadata-Version: 2.1
Name: shaderlint-pre-commit
Version: {VERSION}
Requires-Python: >=3.8
Requires-Dist: shaderlint=={VERSION}
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: backend\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
RECORD = f"{INFO}/METADATA,,\n{INFO}/WHEEL,,\n{INFO}/RECORD,,\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """The function that pip calls; gives the name of the file."""
    name = f"shaderlint_pre_commit-{VERSION}-py3-none-any.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w") as wheel:
        for file, text in (("METADATA", METADATA), ("WHEEL", WHEEL), ("RECORD", RECORD)):
            wheel.writestr(f"{INFO}/{file}", text)
    return name
