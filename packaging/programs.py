"""Builds the programs of targets, and generates what they print about themselves."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from project import PROGRAMS, ROOT
from targets import MACOS

# One machine links for all platforms with these, from PyPI; `cargo zigbuild` calls zig as the linker.
TOOLS = ("ziglang==0.17.1", "cargo-zigbuild==0.24.1")

# All that the programs can do: the default features, and WGSL, SPIR-V, HLSL and MSL.
FEATURES = "naga"
PROFILE = "dist"


def target_folder():
    """Where Cargo builds."""
    return Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target").resolve()


def installed_tools():
    """The folder with the commands of TOOLS; installs them once."""
    venv = target_folder() / "packaging"
    expected = " ".join(TOOLS)
    # Written last, so that an interrupted installation is repeated.
    installed = venv / "installed"
    if not installed.is_file() or installed.read_text() != expected:
        subprocess.run([sys.executable, "-m", "venv", "--clear", venv], check=True)
        pip = [venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*pip, *TOOLS], check=True)
        installed.write_text(expected)
    return venv / "bin"


def build(targets):
    """Builds the programs of targets for a release; gives their paths by target."""
    tools = installed_tools()
    # The standard libraries of the targets, unless they are installed.
    triples = [target.triple for target in targets]
    subprocess.run(["rustup", "--quiet", "target", "add", *triples], check=True, cwd=ROOT)
    environment = os.environ | {
        "PATH": f"{tools}{os.pathsep}{os.environ['PATH']}",
        "CARGO_TARGET_DIR": str(target_folder()),
        "CARGO_INCREMENTAL": "0",
        "MACOSX_DEPLOYMENT_TARGET": MACOS,
        "RUSTFLAGS": remapping(),
    }
    command = ["cargo", "zigbuild", "--locked", "--profile", PROFILE, "--features", FEATURES, "--bins"]
    # All at once: while the program of one target is linked, which uses one core, others are compiled.
    for target in targets:
        command += ["--target", target.zig]
    subprocess.run(command, check=True, cwd=ROOT, env=environment)
    return {target: built(target_folder() / target.triple / PROFILE, target) for target in targets}


def build_modules():
    """Builds the WebAssembly modules for a release; gives the folder of the package."""
    out = target_folder() / "packaging-modules"
    # Files of an earlier version would be packed too.
    shutil.rmtree(out, ignore_errors=True)
    environment = os.environ | {"CARGO_TARGET_DIR": str(target_folder()), "REMAP": remapping()}
    subprocess.run([ROOT / "src/wasm/build", out], check=True, env=environment)
    for path in out.glob("*.wasm"):
        check_names(path)
    return out


def remapping():
    """The flags of rustc that replace paths of this machine."""
    return " ".join(f"--remap-path-prefix={path}={name}" for path, name in names_of_sources().items())


def names_of_sources():
    """What programs call the folders of sources instead of their paths, which differ between machines."""
    home = os.environ.get("CARGO_HOME") or Path.home() / ".cargo"

    def rustc(*arguments):
        return subprocess.check_output(["rustc", *arguments], text=True, cwd=ROOT)

    commit = re.search("^commit-hash: (.*)$", rustc("-vV"), re.MULTILINE).group(1)
    # Where the sources of the standard library are installed, they have a path of this machine too.
    library = Path(rustc("--print", "sysroot").strip()) / "lib/rustlib/src/rust"
    return {home: "cargo", ROOT: ".", library: f"/rustc/{commit}"}


def check_names(path):
    """Fails if a program contains a path of this machine."""
    data = path.read_bytes()
    for folder in names_of_sources():
        if str(folder).encode() in data:
            raise SystemExit(f"packaging/build: {path} contains the path {folder}")


def built(folder, target):
    """The programs of a target in a folder."""
    extension = ".exe" if target.is_windows else ""
    paths = [folder / (name + extension) for name in PROGRAMS]
    for path in paths:
        if not path.is_file():
            raise SystemExit(f"packaging/build: {path} does not exist")
    return paths


def stripped(folder, target):
    """The programs in a folder without what debuggers read, in a folder for packages."""
    out = target_folder() / "packaging-programs"
    out.mkdir(parents=True, exist_ok=True)
    for path in built(folder, target):
        subprocess.run(["strip", "-o", out / path.name, path], check=True)
    return built(out, target)


def extras(linter):
    """Man pages and completions by their paths in archives; `linter` is the command that prints them."""

    def printed(*arguments):
        return subprocess.check_output([*linter, *arguments])

    files = {}
    for name in PROGRAMS:
        files[f"man/{name}.1"] = printed("man", name)
        for shell, path in (("bash", "{}.bash"), ("zsh", "_{}"), ("fish", "{}.fish"), ("powershell", "_{}.ps1")):
            files[f"completions/{path.format(name)}"] = printed("completions", shell, name)
    return files


def run(target, programs):
    """Runs both programs of a target, if that is possible here; whether it was."""
    runner = target.runner()
    if runner is None:
        return False
    mistake = ROOT / "corpus/mistakes/define_with_semicolon.glsl"
    linted = subprocess.run([*runner, programs[0], "--no-cache", mistake], capture_output=True, text=True)
    expected = "error[faulty-macro]"
    if linted.returncode != 1 or not linted.stdout.startswith(expected):
        raise SystemExit(f"{target.triple}: {programs[0]} does not report {expected}:\n{linted.stderr}")
    export = ROOT / "tests/fixtures/clean.glsl"
    ported = subprocess.run([*runner, programs[1], export, "--target", "wgsl"], capture_output=True, text=True)
    if ported.returncode != 0 or "@fragment" not in ported.stdout:
        raise SystemExit(f"{target.triple}: {programs[1]} does not write WGSL:\n{ported.stderr}")
    return True
