"""Runs shaderlint on packages and compares its errors with expected.txt in this folder.

usage: compare.py SHADERLINT FOLDER LIST

FOLDER/node_modules contains the packages in LIST. Each line of expected.txt is `PACKAGE FILE:LINE
RULE | true or false: why`.
"""
import json
import pathlib
import subprocess
import sys


def errors(binary, root, folders):
    """The errors in a package as `FILE:LINE RULE`, and the numbers of files and shaders."""
    command = [binary, "--format", "json", ".", *folders]
    ran = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    if ran.returncode not in (0, 1):
        sys.exit(f"{root}: exit code {ran.returncode}\n{ran.stderr[-2000:]}")
    report = json.loads(ran.stdout)
    found = {
        f"{d['file']}:{d['start']['line']} {d['rule']}"
        for d in report["diagnostics"]
        if d["severity"] == "error"
    }
    return found, report["summary"]


def main():
    binary, folder, names = sys.argv[1:]
    expected = {}
    for line in (pathlib.Path(__file__).parent / "expected.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            place, why = line.split(" | ")
            package, place = place.split(" ", 1)
            expected.setdefault(package, {})[place] = why
    wrong, total, files, shaders = [], 0, 0, 0
    false = 0
    for line in pathlib.Path(names).read_text().splitlines():
        package, _, *folders = line.split()
        root = pathlib.Path(folder) / "node_modules" / package
        found, summary = errors(binary, root, folders)
        files += summary["files"]
        shaders += summary["shaders"]
        known = expected.get(package, {})
        wrong += [f"new:  {package} {place}" for place in sorted(found - known.keys())]
        wrong += [f"gone: {package} {place}" for place in sorted(known.keys() - found)]
        total += len(found)
        false += sum(known.get(place, "").startswith("false") for place in found)
    print(f"{shaders} shaders in {files} files: {total} errors, {false} of them false")
    print("\n".join(wrong))
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
