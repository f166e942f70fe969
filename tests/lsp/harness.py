"""Shared by the tests: test registration, a workspace on disk, and checks with informative
failures."""

import os
import shutil
import tempfile
import time
import traceback

from client import Client, RpcError, everything, uri_of
from text import marked

TESTS = []


def test(function):
    """Registers a function as a test; its name states the property."""
    TESTS.append(function)
    return function


class Case:
    """The environment of a test: the program, a temporary folder, and the clients that it starts."""

    def __init__(self, program):
        self.program = program
        self.folder = os.path.realpath(tempfile.mkdtemp(prefix="lsp test "))
        self.clients = []

    def client(self, **settings):
        """Starts an editor on the folder of the test."""
        settings.setdefault("folder", self.folder)
        # The server writes pages below the folder, so that the test can check that they are deleted.
        environment = {"TMPDIR": self.temp()}
        client = Client([self.program, "lsp"], environment=environment, **settings)
        self.clients.append(client)
        return client

    def temp(self):
        """The folder for files written by the server."""
        path = self.folder + ".temp"
        os.makedirs(path, exist_ok=True)
        return path

    def write(self, name, text):
        """Writes a file without its marks; returns URI, text and marks."""
        text, places = marked(text)
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        return Source(uri_of(path), text, places, path)

    def uri(self, name):
        """The URI of a file that need not exist."""
        return uri_of(os.path.join(self.folder, name))

    def end(self):
        """Shuts down the servers that are still running."""
        try:
            for client in self.clients:
                if client.process.poll() is None and not client.is_closed:
                    client.stop()
                elif client.violations:
                    raise AssertionError("; ".join(client.violations[:5]))
        finally:
            self.clear()

    def clear(self):
        """Kills the remaining processes and deletes the folder."""
        for client in self.clients:
            client.kill()
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.rmtree(self.temp(), ignore_errors=True)


class Source:
    """A text with named positions."""

    def __init__(self, uri, text, places, path=None):
        self.uri = uri
        self.text = text
        self.places = places
        self.path = path

    def __getitem__(self, name):
        return self.places[name]

    def open(self, client, language="glsl"):
        """Opens it in an editor."""
        client.open(self.uri, self.text, language)
        return self


def without(capabilities, *path):
    """Capabilities without one of them."""
    inner = capabilities
    for name in path[:-1]:
        inner = inner[name]
    del inner[path[-1]]
    return capabilities


def pulling():
    """The capabilities of a client that pulls diagnostics."""
    capabilities = everything()
    capabilities["textDocument"]["diagnostic"] = {"relatedDocumentSupport": True}
    return capabilities


def same(found, expected, what=""):
    """Asserts that two values are equal."""
    if found != expected:
        raise AssertionError("%s is\n    %r\n  but expected\n    %r" % (what or "this", found, expected))


def holds(condition, what, *seen):
    """Asserts a condition."""
    if not condition:
        shown = "".join("\n    %.1500r" % (each,) for each in seen)
        raise AssertionError(what + shown)


def contains(text, part, what="the text"):
    """Asserts that a text contains a part."""
    holds(part in text, "%s does not have %r:" % (what, part), text)


def rules(diagnostics):
    """The rules of diagnostics, in order."""
    return [d["code"] for d in diagnostics]


def errors(diagnostics):
    """The diagnostics that are errors."""
    return [d for d in diagnostics if d["severity"] == 1]


def by_rule(diagnostics, rule):
    """The only diagnostic of a rule."""
    found = [d for d in diagnostics if d["code"] == rule]
    holds(len(found) == 1, "expected one diagnostic of %s, found %d:" % (rule, len(found)), diagnostics)
    return found[0]


def refusal(ask, code=None):
    """The error that a request is answered with."""
    try:
        found = ask()
    except RpcError as error:
        if code is not None:
            same(error.code, code, "the code of «%s»" % error.message)
        return error
    raise AssertionError("expected an error, got a result:\n    %.800r" % (found,))


def run_tests(program, only=None):
    """Runs all tests and prints a line for each; returns the numbers of passed and failed tests."""
    passed, failed = 0, 0
    for function in TESTS:
        name = function.__name__
        if only and only not in name and only not in function.__module__:
            continue
        begun = time.monotonic()
        case = Case(program)
        try:
            function(case)
            case.end()
        except Exception:
            failed += 1
            print("FAILED %s" % name)
            print("  " + "  ".join(traceback.format_exc(limit=-4).splitlines(keepends=True)))
            case.clear()
            continue
        passed += 1
        print("ok     %s (%.1f s)" % (name, time.monotonic() - begun), flush=True)
    return passed, failed
