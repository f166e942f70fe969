"""A client that speaks the language server protocol to a real process.

It keeps the state of an editor: the open texts, the published diagnostics and the requests of the
server. All messages of the server are checked against the protocol; violations are collected in
`violations`, which `stop` raises.
"""

import collections
import fcntl
import json
import os
import pathlib
import select
import subprocess
import tempfile
import threading
import time
from urllib.parse import unquote, urlparse

from text import Lines, apply_change, apply_edits

CANCELLED = -32800
CONTENT_MODIFIED = -32801
REQUEST_FAILED = -32803
INVALID_REQUEST = -32600
METHOD_NOT_FOUND = -32601
INVALID_PARAMS = -32602

# File change types of the protocol.
CREATED, CHANGED, DELETED = 1, 2, 3

# Timeout in seconds for an expected event. No test relies on it: a busy machine is slow, not wrong.
PATIENCE = 300


def uri_of(path):
    """The URI of a file."""
    return pathlib.Path(path).absolute().as_uri()


def everything():
    """The capabilities of an editor that supports everything; tests remove some of them."""
    dynamic = {"dynamicRegistration": True}
    return {
        "general": {"positionEncodings": ["utf-16"]},
        "window": {"showDocument": {"support": True}, "workDoneProgress": True, "showMessage": {}},
        "workspace": {
            "applyEdit": True,
            "configuration": True,
            "workspaceFolders": True,
            "workspaceEdit": {"documentChanges": True},
            "didChangeConfiguration": dynamic,
            "didChangeWatchedFiles": dynamic,
            "diagnostics": {"refreshSupport": True},
            "inlayHint": {"refreshSupport": True},
            "codeLens": {"refreshSupport": True},
            "semanticTokens": {"refreshSupport": True},
        },
        "textDocument": {
            "synchronization": {"didSave": True},
            "publishDiagnostics": {
                "relatedInformation": True,
                "versionSupport": True,
                "codeDescriptionSupport": True,
                "tagSupport": {"valueSet": [1, 2]},
            },
            "completion": {
                "completionItem": {
                    "snippetSupport": True,
                    "documentationFormat": ["markdown", "plaintext"],
                }
            },
            "hover": {"contentFormat": ["markdown", "plaintext"]},
            "signatureHelp": {},
            "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
            "codeAction": {
                "codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix", "source"]}}
            },
            "rename": {"prepareSupport": True},
            "foldingRange": {"lineFoldingOnly": True},
            "semanticTokens": {
                "requests": {"range": True, "full": {"delta": True}},
                "tokenTypes": [],
                "tokenModifiers": [],
                "formats": ["relative"],
            },
        },
    }


class RpcError(Exception):
    """A response that is an error."""

    def __init__(self, method, error):
        super().__init__("%s: %s (%d)" % (method, error.get("message"), error.get("code", 0)))
        self.code = error.get("code")
        self.message = error.get("message", "")


class Violation(Exception):
    """The server violated the protocol."""


class Document:
    """An open text, as known to the client."""

    def __init__(self, uri, text, version):
        self.uri = uri
        self.text = text
        self.version = version


class Connection:
    """A server process and its messages."""

    def __init__(self, command, folder=None, environment=None):
        self.violations = []
        self.documents = {}
        self.encoding = "utf-16"
        self.notifications = []
        self.asked = []
        self.pending = {}
        self.answers = {}
        self.answered = collections.Counter()
        self.last_id = 0
        self.is_closed = False
        self.changed = threading.Condition()
        self.writing = threading.Lock()
        self.errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.errors,
            cwd=folder,
            env=dict(os.environ, **(environment or {})),
        )
        self.reader = threading.Thread(target=self.read_all, daemon=True)
        self.reader.start()

    # Reading.

    def read_all(self):
        """Reads messages until the server closes its output."""
        try:
            while True:
                message = self.read()
                if message is None:
                    break
                self.take(message)
        except Exception as error:  # any error must reach the test
            self.violate("unreadable message: %r" % error)
        with self.changed:
            self.is_closed = True
            self.changed.notify_all()

    def read(self):
        """The next message; None at the end of the output."""
        length = None
        while True:
            line = self.process.stdout.readline()
            if not line:
                return None
            if not line.endswith(b"\r\n"):
                raise Violation("a header does not end with CR LF: %r" % line)
            line = line.strip()
            if not line:
                break
            name, _, value = line.partition(b":")
            if name.lower() == b"content-length":
                length = int(value)
            elif name.lower() != b"content-type":
                raise Violation("an unknown header: %r" % line)
        if length is None:
            raise Violation("a message without Content-Length")
        body = self.process.stdout.read(length)
        if len(body) < length:
            raise Violation("the output ends inside of a message")
        return json.loads(body.decode("utf-8"))

    def violate(self, message):
        """Records a protocol violation."""
        with self.changed:
            self.violations.append(message)
            self.changed.notify_all()

    def take(self, message):
        """Dispatches a message by its kind."""
        if not isinstance(message, dict) or message.get("jsonrpc") != "2.0":
            return self.violate("this is not JSON-RPC 2.0: %.200r" % (message,))
        about = message.get("method") or self.pending.get(message.get("id"))
        check_ranges(
            message.get("result", message.get("params")),
            lambda what: self.violate("%s (%s): %s" % (about, message.get("id"), what)),
        )
        if "method" in message:
            if "result" in message or "error" in message:
                return self.violate("a request and an answer in one: %.200r" % (message,))
            if "id" in message:
                return self.serve(message)
            with self.changed:
                self.notifications.append(message)
                self.changed.notify_all()
            return None
        return self.take_answer(message)

    def take_answer(self, message):
        """A response must belong to a request, arrive once, and be either a result or an error."""
        number = message.get("id")
        if ("result" in message) == ("error" in message):
            self.violate("neither or both of result and error: %.200r" % (message,))
        error = message.get("error")
        if error is not None and not (
            isinstance(error.get("code"), int) and isinstance(error.get("message"), str)
        ):
            self.violate("an error without code or message: %.200r" % (message,))
        with self.changed:
            if number is not None:
                self.answered[number] += 1
                if number not in self.pending:
                    self.violations.append("a response to unknown request %r" % (number,))
                elif self.answered[number] > 1:
                    self.violations.append("two responses to request %r" % (self.pending[number],))
            self.answers[number] = message
            self.changed.notify_all()

    def serve(self, message):
        """Answers a request of the server."""
        result, error = None, None
        try:
            result = self.answer(message["method"], message.get("params"))
        except KeyError:
            error = {"code": METHOD_NOT_FOUND, "message": "not known"}
        answer = {"jsonrpc": "2.0", "id": message["id"]}
        answer.update({"error": error} if error else {"result": result})
        self.write(answer)
        # A message that a test sends after it sees the request must arrive after the answer.
        with self.changed:
            self.asked.append(message)
            self.changed.notify_all()

    def answer(self, method, params):
        """The answer of a client without features; `Client` overrides this."""
        raise KeyError(method)

    # Writing.

    def write(self, message):
        """Writes a message."""
        body = json.dumps(message, ensure_ascii=False).encode("utf-8")
        self.write_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def write_bytes(self, data):
        """Writes raw bytes."""
        with self.writing:
            try:
                self.process.stdin.write(data)
                self.process.stdin.flush()
            except (BrokenPipeError, ValueError):
                # The server has exited; whoever waits for it gets an error.
                pass

    def write_separately(self, data):
        """Writes raw bytes after the server has read all earlier ones."""
        # A pipe of one page is writable when it is empty.
        fcntl.fcntl(self.process.stdin, fcntl.F_SETPIPE_SZ, select.PIPE_BUF)
        _, writable, _ = select.select([], [self.process.stdin], [], PATIENCE)
        assert writable, "the server does not read its input"
        self.write_bytes(data)

    def notify(self, method, params=None):
        """Sends a notification."""
        self.write({"jsonrpc": "2.0", "method": method, "params": params if params is not None else {}})

    def send(self, method, params=None):
        """Sends a request; returns its id."""
        with self.changed:
            self.last_id += 1
            number = self.last_id
            self.pending[number] = method
        message = {"jsonrpc": "2.0", "id": number, "method": method}
        if params is not None:
            message["params"] = params
        self.write(message)
        return number

    def wait_until(self, holds, what):
        """Waits until a condition holds; checks it after every message."""
        end = time.monotonic() + PATIENCE
        with self.changed:
            while True:
                found = holds()
                if found:
                    return found
                left = end - time.monotonic()
                if left <= 0:
                    raise TimeoutError("after %d s: %s" % (PATIENCE, what))
                if self.is_closed:
                    raise Violation("the server has exited: %s\n%s" % (what, self.said()))
                self.changed.wait(left)

    def wait(self, number):
        """The complete response to a request."""
        what = "no answer to %s" % self.pending[number]
        self.wait_until(lambda: number in self.answers, what)
        with self.changed:
            return self.answers[number]

    def request(self, method, params=None):
        """Sends a request and waits for the result. A request that is rejected because the text
        has changed is repeated, as in editors."""
        for _ in range(20):
            answer = self.wait(self.send(method, params))
            error = answer.get("error")
            if error is None:
                return answer["result"]
            if error["code"] != CONTENT_MODIFIED:
                break
        raise RpcError(method, error)

    def said(self):
        """The tail of the server's standard error."""
        self.errors.seek(0)
        return self.errors.read().decode("utf-8", "replace")[-4000:]

    def finish(self):
        """Waits for the process to exit; returns its exit code."""
        code = self.process.wait()
        self.reader.join(PATIENCE)
        return code

    def kill(self):
        """Kills the process if it is still running."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.reader.join(PATIENCE)
        for stream in (self.process.stdin, self.process.stdout, self.errors):
            try:
                stream.close()
            except BrokenPipeError:
                pass


class Client(Connection):
    """An editor."""

    def __init__(self, command, folder=None, capabilities=None, options=None, settings=None,
                 folders=None, environment=None, start=True):
        super().__init__(command, folder, environment)
        self.folder = folder
        self.capabilities = everything() if capabilities is None else capabilities
        self.options = options
        self.settings = {} if settings is None else settings
        self.folders = [folder] if folders is None and folder else (folders or [])
        self.applies_edits = True
        self.initialized = None
        if start:
            try:
                self.start()
            except BaseException:
                self.kill()
                raise

    def start(self):
        """Initializes the session."""
        params = {
            "processId": os.getpid(),
            "clientInfo": {"name": "tests"},
            "rootUri": uri_of(self.folders[0]) if self.folders else None,
            "capabilities": self.capabilities,
            "workspaceFolders": [
                {"uri": uri_of(f), "name": os.path.basename(f)} for f in self.folders
            ] or None,
        }
        if self.options is not None:
            params["initializationOptions"] = self.options
        self.initialized = self.request("initialize", params)
        self.encoding = self.initialized["capabilities"].get("positionEncoding", "utf-16")
        self.notify("initialized")

    def answer(self, method, params):
        if method == "workspace/configuration":
            return [self.settings.get(item.get("section"), None) for item in params["items"]]
        if method == "window/showDocument":
            return {"success": True}
        if method == "workspace/applyEdit":
            if self.applies_edits:
                self.apply(params["edit"])
            return {"applied": self.applies_edits}
        if method in ("client/registerCapability", "client/unregisterCapability"):
            return None
        if method == "window/workDoneProgress/create":
            return None
        if method.startswith("workspace/") and method.endswith("/refresh"):
            return None
        raise KeyError(method)

    # Texts.

    def open(self, uri, text, language="glsl", version=1):
        """Opens a text."""
        self.documents[uri] = Document(uri, text, version)
        item = {"uri": uri, "languageId": language, "version": version, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})

    def change(self, uri, changes):
        """Changes a text; `changes` are content changes of the protocol, applied in order."""
        document = self.documents[uri]
        for change in changes:
            document.text = apply_change(document.text, change, self.encoding)
        document.version += 1
        identifier = {"uri": uri, "version": document.version}
        self.notify(
            "textDocument/didChange", {"textDocument": identifier, "contentChanges": changes}
        )
        return document.version

    def replace(self, uri, start, end, new):
        """Replaces a range, as when typing."""
        lines = self.lines(uri)
        return self.change(uri, [{"range": lines.range(start, end), "text": new}])

    def write_all(self, uri, text):
        """Replaces the whole text."""
        return self.change(uri, [{"text": text}])

    def close(self, uri):
        """Closes a text."""
        del self.documents[uri]
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri}})

    def apply(self, edit):
        """Applies a workspace edit to the open texts and to the files that are not open, and
        notifies the server."""
        for change in edit.get("documentChanges") or []:
            if change.get("kind") == "create":
                with open(path_of(change["uri"]), "x", encoding="utf-8"):
                    pass
        for uri, edits in changes_of(edit):
            if uri in self.documents:
                text = apply_edits(self.documents[uri].text, edits, self.encoding)
                self.write_all(uri, text)
                continue
            path = path_of(uri)
            with open(path, encoding="utf-8", newline="") as file:
                text = file.read()
            with open(path, "w", encoding="utf-8", newline="") as file:
                file.write(apply_edits(text, edits, self.encoding))
            self.watched((uri, CHANGED))

    def watched(self, *events):
        """Notifies about changed files: URIs, and the type of each change."""
        changes = [{"uri": uri, "type": kind} for uri, kind in events]
        self.notify("workspace/didChangeWatchedFiles", {"changes": changes})

    def text(self, uri):
        """The open text, as known to the client."""
        return self.documents[uri].text

    def lines(self, uri):
        """A text with its lines, open or not."""
        if uri in self.documents:
            return Lines(self.documents[uri].text, self.encoding)
        with open(path_of(uri), encoding="utf-8", newline="") as file:
            return Lines(file.read(), self.encoding)

    # Requests.

    def at(self, uri, offset, method, **more):
        """Sends a request for a position."""
        params = {"textDocument": {"uri": uri}, "position": self.lines(uri).position(offset)}
        params.update(more)
        return self.request(method, params)

    def of(self, uri, method, **more):
        """Sends a request for a text."""
        return self.request(method, dict({"textDocument": {"uri": uri}}, **more))

    def published(self, uri, version=None):
        """The diagnostics published last for a text, for its current version by default; waits
        for them."""
        wanted = self.documents[uri].version if version is None else version

        def newest():
            for message in reversed(self.notifications):
                params = message.get("params")
                if message["method"] == "textDocument/publishDiagnostics" and params["uri"] == uri:
                    return params if params.get("version") == wanted else None
            return None

        return self.wait_until(newest, "no diagnostics of %s, version %s" % (uri, wanted))[
            "diagnostics"
        ]

    def published_when(self, uri, holds, what="diagnostics stay as they are"):
        """The diagnostics of a text, once they satisfy a condition."""

        def newest():
            for message in reversed(self.notifications):
                params = message.get("params")
                if message["method"] == "textDocument/publishDiagnostics" and params["uri"] == uri:
                    return params if holds(params["diagnostics"]) else None
            return None

        return self.wait_until(newest, what)["diagnostics"]

    def asked_for(self, method, count=1):
        """The parameters of the server's first request of a method, once it has been answered
        `count` times."""

        def requests():
            found = [m for m in self.asked if m["method"] == method]
            return found if len(found) >= count else None

        found = self.wait_until(requests, "the server does not ask for %s" % method)
        return found[0].get("params")

    def settle(self):
        """Returns once the server has answered all earlier messages: slow requests are answered
        one after the other, and this is the last of them."""
        self.request("workspace/symbol", {"query": "settle"})

    def told(self, method):
        """All notifications of a method so far."""
        with self.changed:
            return [m["params"] for m in self.notifications if m["method"] == method]

    def stop(self):
        """Shuts the server down; raises the violations that were recorded."""
        self.request("shutdown")
        self.notify("exit")
        code = self.finish()
        if code != 0:
            raise Violation("the exit code is %d\n%s" % (code, self.said()))
        missing = [m for n, m in self.pending.items() if not self.answered[n]]
        if missing:
            raise Violation("requests without a response: %r" % missing)
        if self.violations:
            raise Violation("; ".join(self.violations[:5]))


def path_of(uri):
    """The path of a file URI on this machine."""
    parsed = urlparse(uri)
    if parsed.scheme != "file":
        raise ValueError("%s is not a file URI" % uri)
    return unquote(parsed.path)


def changes_of(edit):
    """The edits of a workspace edit, by URI."""
    if "documentChanges" in edit:
        texts = [c for c in edit["documentChanges"] if "kind" not in c]
        return [(c["textDocument"]["uri"], c["edits"]) for c in texts]
    return sorted((edit.get("changes") or {}).items())


def check_ranges(value, violate):
    """Reports invalid ranges anywhere in a message."""
    if isinstance(value, list):
        for each in value:
            check_ranges(each, violate)
    elif isinstance(value, dict):
        start, end = value.get("start"), value.get("end")
        if isinstance(start, dict) and isinstance(end, dict) and "line" in start:
            places = [(p.get("line"), p.get("character")) for p in (start, end)]
            numbers = [n for place in places for n in place]
            if not all(isinstance(n, int) and 0 <= n < 2**31 for n in numbers):
                violate("not a range: %r" % value)
            elif places[0] > places[1]:
                violate("a range that ends before it starts: %r" % value)
        for each in value.values():
            check_ranges(each, violate)
