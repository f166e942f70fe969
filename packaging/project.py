"""What every package says about the project, read from `Cargo.toml` and git."""

import functools
import json
import os
import pathlib
import posixpath
import re
import subprocess
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ("shaderlint", "shaderport")
LICENSES = ("LICENSE", "LICENSE-APACHE")


@dataclass(frozen=True)
class Project:
    """The fields of the manifest that packages repeat."""

    name: str
    version: str
    summary: str
    license: str
    repository: str
    keywords: tuple

    @property
    def releases(self):
        """The folder that holds the files of this version, as `cargo binstall` expects it."""
        return f"{self.repository}/releases/download/v{self.version}"

    @property
    def host(self):
        """The host of the repository; names of servers and addresses of mails contain it."""
        return self.repository.split("/")[2]

    @property
    def maintainer(self):
        """Whom `.deb` packages name."""
        return f"The {self.name} authors <{self.name}@{self.host}>"

    @property
    def readme(self):
        """The README for pages outside the repository."""
        return self.page("README.md")

    def page(self, path):
        """A page for places outside the repository: links and images are absolute."""
        text = (ROOT / path).read_text()

        def absolute(match):
            image, label, target = match.groups()
            kind = "raw" if image else "blob"
            target = posixpath.normpath(posixpath.join(posixpath.dirname(path), target))
            return f"{image}[{label}]({self.repository}/{kind}/v{self.version}/{target})"

        return re.sub(r"(!?)\[([^]\n]*)\]\((?!https?:|#)([^)\s]+)\)", absolute, text)


@functools.cache
def project():
    """The project of this repository."""
    command = ["cargo", "metadata", "--no-deps", "--offline", "--format-version", "1"]
    packages = json.loads(subprocess.check_output(command, cwd=ROOT))["packages"]
    package = next(p for p in packages if p["name"] == "shaderlint")
    return Project(
        package["name"],
        package["version"],
        package["description"],
        package["license"],
        package["repository"],
        tuple(package["keywords"]),
    )


@functools.cache
def timestamp():
    """The time of every file in a package: that of the last commit, so that packages can be reproduced."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    if not given:
        given = subprocess.check_output(["git", "log", "-1", "--format=%ct"], cwd=ROOT, text=True)
    return int(given)


def changes():
    """The newest section of the changelog, without its title."""
    text = (ROOT / "CHANGELOG.md").read_text()
    sections = re.split(r"^## .*\n", text, flags=re.MULTILINE)
    return sections[1].strip() + "\n"
