"""What the tests share: how they are found, a workspace on the disk, and checks that say what they saw."""

import os
import shutil
import tempfile
import time
import traceback

from client import Client, RpcError, everything, uri_of
from text import marked

TESTS = []


def test(function):
    """Makes a function a test; its name says what holds."""
    TESTS.append(function)
    return function


class Case:
    """What a test has: the program, a folder of its own, and the clients that it starts."""

    def __init__(self, program):
        self.program = program
        self.folder = os.path.realpath(tempfile.mkdtemp(prefix="lsp test "))
        self.clients = []

    def client(self, **settings):
        """Starts an editor on the folder of the test."""
        settings.setdefault("folder", self.folder)
        # Pages are written below the folder, so that the test sees them come and go.
        environment = {"TMPDIR": self.temp()}
        client = Client([self.program, "lsp"], environment=environment, **settings)
        self.clients.append(client)
        return client

    def temp(self):
        """The folder for what the server writes."""
        path = self.folder + ".temp"
        os.makedirs(path, exist_ok=True)
        return path

    def write(self, name, text):
        """Writes a file, whose marks are taken out; gives its address, text and marks."""
        text, places = marked(text)
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        return Source(uri_of(path), text, places, path)

    def uri(self, name):
        """The address of a file that need not be there."""
        return uri_of(os.path.join(self.folder, name))

    def end(self):
        """Says goodbye to the servers that are still there."""
        try:
            for client in self.clients:
                if client.process.poll() is None and not client.is_closed:
                    client.stop()
                elif client.violations:
                    raise AssertionError("; ".join(client.violations[:5]))
        finally:
            self.clear()

    def clear(self):
        """Ends whatever is left."""
        for client in self.clients:
            client.kill()
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.rmtree(self.temp(), ignore_errors=True)


class Source:
    """A text with named places."""

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
    """The capabilities of a client that asks for diagnostics itself."""
    capabilities = everything()
    capabilities["textDocument"]["diagnostic"] = {"relatedDocumentSupport": True}
    return capabilities


def same(found, expected, what=""):
    """Two things that must be equal."""
    if found != expected:
        raise AssertionError("%s is\n    %r\n  and should be\n    %r" % (what or "this", found, expected))


def holds(condition, what, *seen):
    """Something that must hold."""
    if not condition:
        shown = "".join("\n    %.1500r" % (each,) for each in seen)
        raise AssertionError(what + shown)


def contains(text, part, what="the text"):
    """A text that must say something."""
    holds(part in text, "%s does not have %r:" % (what, part), text)


def rules(diagnostics):
    """The rules of findings, in their order."""
    return [d["code"] for d in diagnostics]


def errors(diagnostics):
    """The findings that are errors."""
    return [d for d in diagnostics if d["severity"] == 1]


def by_rule(diagnostics, rule):
    """The only finding of a rule."""
    found = [d for d in diagnostics if d["code"] == rule]
    holds(len(found) == 1, "one finding of %s, not %d:" % (rule, len(found)), diagnostics)
    return found[0]


def refusal(ask, code=None):
    """The error that a question is answered with."""
    try:
        found = ask()
    except RpcError as error:
        if code is not None:
            same(error.code, code, "the code of «%s»" % error.message)
        return error
    raise AssertionError("this is answered, and should be refused:\n    %.800r" % (found,))


def run_tests(program, only=None):
    """Runs all tests, a line each; how many passed and failed."""
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
