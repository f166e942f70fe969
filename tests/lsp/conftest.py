"""Fixtures of the tests of the language server."""

import os

import pytest

from harness import Case

# Sessions are long enough that growing memory shows; each has the next seed.
LONGEST = 600


def pytest_generate_tests(metafunc):
    if "bursts" in metafunc.fixturenames:
        option = metafunc.config.option
        total = option.bursts if option.bursts is not None else 2000 if option.all else 15
        counts = [min(LONGEST, total - done) for done in range(0, total, LONGEST)]
        sessions = [(option.seed + index, count) for index, count in enumerate(counts)]
        metafunc.parametrize(["seed", "bursts"], sessions)


@pytest.fixture
def case(shaderlint, tmp_path):
    """A workspace; its servers must not violate the protocol."""
    case = Case(shaderlint, os.path.realpath(tmp_path))
    try:
        yield case
        case.end()
    finally:
        for client in case.clients:
            client.kill()
