"""Options and fixtures of all tests in Python.

    tests/python -m pytest tests/lsp --programs target/debug -k rename
"""

import os
import pathlib
import re

import pytest

HERE = pathlib.Path(__file__).parent


def pytest_addoption(parser):
    parser.addoption("--programs", default=HERE.parent / "target/debug", help="folder of the programs")
    parser.addoption("--all", action="store_true", help="all inputs instead of a sample")
    parser.addoption("--seed", type=int, default=1, help="seed of the first session of random edits")
    parser.addoption("--bursts", type=int, help="number of bursts of random edits")


def pytest_collection_modifyitems(session):
    """Tests wait for events, never for a time."""
    for path in HERE.glob("*/*.py"):
        if re.search(r"\bsleep\b *\(", path.read_text()):
            raise pytest.UsageError(f"{path} waits for a time, not for an event")


@pytest.fixture(scope="session")
def programs(request):
    """The folder of the programs."""
    return pathlib.Path(request.config.option.programs).absolute()


@pytest.fixture(scope="session")
def shaderlint(programs):
    """The program."""
    program = programs / "shaderlint"
    assert os.access(program, os.X_OK), f"{program} is not a program"
    return str(program)
