"""The platforms of the packages, as data: how each is built, what its packages are called, and how its
programs run on the machine that builds them."""

import os
import platform
import shutil
import subprocess
from dataclasses import dataclass

# The oldest glibc and macOS that the programs run on.
GLIBC = (2, 17)
MACOS = "11.0"
# Where Debian's package `libc6-arm64-cross` has the libraries of the other architecture.
ARM64_LIBRARIES = "/usr/aarch64-linux-gnu"


@dataclass(frozen=True)
class Target:
    """A platform."""

    # Rust's name of it, which archives have too.
    triple: str
    # Platform tags of the wheel.
    wheel: tuple
    # `os`, `cpu` and `libc` of the npm package.
    npm: tuple
    # Architecture of the Debian package, and of the container image.
    deb: str = ""
    docker: str = ""

    @property
    def zig(self):
        """The target of `cargo zigbuild`, with the version of glibc."""
        suffix = ".{}.{}".format(*GLIBC) if self.triple.endswith("-gnu") and self.is_linux else ""
        return self.triple + suffix

    @property
    def architecture(self):
        """The processor."""
        return self.triple.split("-")[0]

    @property
    def is_linux(self):
        """Whether the programs are ELF files."""
        return "linux" in self.triple

    @property
    def is_windows(self):
        """Whether programs have the extension `.exe`, and the archive is a zip file."""
        return "windows" in self.triple

    @property
    def npm_package(self):
        """The npm package with the programs of this platform."""
        system, cpu, libc = self.npm
        libc = {"": "", "glibc": "-gnu", "musl": "-musl"}[libc]
        return f"@shaderlint/{system}-{cpu}{libc}"

    @property
    def vscode(self):
        """What VS Code calls it; for musl, after the one system that uses it."""
        system, cpu, libc = self.npm
        return f"{'alpine' if libc == 'musl' else system}-{cpu}"

    def runner(self):
        """The command before a program to run it here; `None` if that is not possible."""
        if not self.is_linux or platform.system() != "Linux":
            return [] if self.triple == host() else None
        if self.architecture == platform.machine():
            return []
        emulator = shutil.which(f"qemu-{self.architecture}-static")
        if not emulator:
            return None
        if self.triple.endswith("-musl"):
            return [emulator]
        has_libraries = os.path.isdir(ARM64_LIBRARIES)
        return [emulator, "-L", ARM64_LIBRARIES] if has_libraries else None


TARGETS = (
    Target(
        "x86_64-unknown-linux-gnu",
        ("manylinux_2_17_x86_64", "manylinux2014_x86_64"),
        ("linux", "x64", "glibc"),
        deb="amd64",
    ),
    Target(
        "aarch64-unknown-linux-gnu",
        ("manylinux_2_17_aarch64", "manylinux2014_aarch64"),
        ("linux", "arm64", "glibc"),
        deb="arm64",
    ),
    Target("x86_64-unknown-linux-musl", ("musllinux_1_2_x86_64",), ("linux", "x64", "musl"), docker="amd64"),
    Target("aarch64-unknown-linux-musl", ("musllinux_1_2_aarch64",), ("linux", "arm64", "musl"), docker="arm64"),
    Target("x86_64-apple-darwin", ("macosx_11_0_x86_64",), ("darwin", "x64", "")),
    Target("aarch64-apple-darwin", ("macosx_11_0_arm64",), ("darwin", "arm64", "")),
    Target("x86_64-pc-windows-gnu", ("win_amd64",), ("win32", "x64", "")),
)


def without_programs():
    """The platforms that no target fits, as `os` and `cpu` of npm packages by a name; `!` excludes."""
    cpus = {}
    for target in TARGETS:
        system, cpu, _ = target.npm
        cpus.setdefault(system, set()).add(cpu)
    systems = {}
    for system, known in sorted(cpus.items()):
        systems.setdefault(tuple(sorted(known)), []).append(system)
    rest = {"-".join(same): (same, [f"!{cpu}" for cpu in known]) for known, same in systems.items()}
    return rest | {"other": ([f"!{system}" for system in sorted(cpus)], [])}


def host():
    """Rust's name of the machine that builds."""
    lines = subprocess.check_output(["rustc", "-vV"], text=True).splitlines()
    return next(line.removeprefix("host: ") for line in lines if line.startswith("host: "))


def find(triple):
    """The target of this name."""
    for target in TARGETS:
        if target.triple == triple:
            return target
    known = "\n  ".join(t.triple for t in TARGETS)
    raise SystemExit(f"packaging/build: {triple} is not a target; targets:\n  {known}")
