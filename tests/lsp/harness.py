"""Shared by the tests: a workspace on disk, and the parts of answers."""

import os

import pytest

from client import Client, RpcError, everything, uri_of
from text import marked


class Case:
    """The environment of a test: the program, a temporary folder, and the clients that it starts."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = os.path.join(folder, "a workspace")
        # The server writes pages here, so that a test can check that they are deleted.
        self.temp = os.path.join(folder, "temp")
        os.mkdir(self.folder)
        os.mkdir(self.temp)
        self.clients = []

    def client(self, **settings):
        """Starts an editor on the folder of the test."""
        settings.setdefault("folder", self.folder)
        client = Client([self.program, "lsp"], environment={"TMPDIR": self.temp}, **settings)
        self.clients.append(client)
        return client

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
        for client in self.clients:
            if client.process.poll() is None and not client.is_closed:
                client.stop()
            assert not client.violations, client.violations[:5]


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


def rules(diagnostics):
    """The rules of diagnostics, in order."""
    return [d["code"] for d in diagnostics]


def errors(diagnostics):
    """The diagnostics that are errors."""
    return [d for d in diagnostics if d["severity"] == 1]


def by_rule(diagnostics, rule):
    """The only diagnostic of a rule."""
    (found,) = [d for d in diagnostics if d["code"] == rule]
    return found


def refusal(ask, code=None):
    """The error that a request is answered with."""
    with pytest.raises(RpcError) as caught:
        ask()
    assert code in (None, caught.value.code), caught.value.message
    return caught.value
