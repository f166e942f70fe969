"""Checks action.yml, and runs the scripts of its steps as a runner does.

    action.py ACTION MISTAKE FOLDER     in an empty folder; MISTAKE is a shader
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import yaml


def script(step, inputs, folder):
    """Runs the script of a step; gives its exit code, output, and what it passed on."""
    contexts = {f"inputs.{name}": value for name, value in inputs.items()} | {"runner.temp": str(folder)}

    def filled(text):
        return re.sub(r"\$\{\{ (.*?) \}\}", lambda match: contexts[match[1]], text)

    # A script that contains an input would run code in it.
    assert "${{" not in step["run"], step["name"]
    file = folder / "script"
    file.write_text("#!/usr/bin/env bash\n" + step["run"])
    subprocess.run(["shellcheck", file], check=True)
    passed = {name: folder / name for name in ("GITHUB_PATH", "GITHUB_OUTPUT")}
    for path in passed.values():
        path.write_text("")
    environment = os.environ | {name: filled(text) for name, text in step["env"].items()}
    environment |= {name: str(path) for name, path in passed.items()}
    ran = subprocess.run(
        ["bash", "--noprofile", "--norc", "-eo", "pipefail", file],
        cwd=folder / "checkout",
        env=environment,
        capture_output=True,
        text=True,
    )
    return ran.returncode, ran.stdout + ran.stderr, {name: path.read_text() for name, path in passed.items()}


def main():
    action, mistake, folder = map(pathlib.Path, sys.argv[1:])
    manifest = yaml.safe_load(action.read_text())
    steps = {step["name"]: step for step in manifest["runs"]["steps"]}
    inputs = {name: value["default"] for name, value in manifest["inputs"].items()}
    (folder / "checkout").mkdir()
    shutil.copy(mistake, folder / "checkout/a.glsl")

    code, printed, passed = script(steps["Install shaderlint"], inputs, folder)
    assert code == 0, printed
    os.environ["PATH"] = passed["GITHUB_PATH"].strip() + os.pathsep + os.environ["PATH"]

    code, printed, passed = script(steps["Check shaders"], inputs, folder)
    assert code == 1 and printed.startswith("::error file=a.glsl,line=1"), printed
    assert passed["GITHUB_OUTPUT"] == "exit-code=1\n", passed
    # The next run restores this folder.
    assert (folder / "checkout/.shaderlint_cache").is_dir()

    chosen = inputs | {"paths": "none.glsl", "args": "--deny-warnings --no-cache", "sarif": "out.sarif"}
    code, printed, passed = script(steps["Check shaders"], chosen, folder)
    assert code == 2, printed
    chosen["paths"] = "a.glsl"
    code, printed, passed = script(steps["Check shaders"], chosen, folder)
    assert code == 1 and (folder / "checkout/out.sarif").read_text().startswith("{"), printed


main()
