"""Start, course and end of a session; answers to invalid requests."""

import json
import os
import subprocess

from client import (
    CANCELLED, Connection, CONTENT_MODIFIED, INVALID_PARAMS, INVALID_REQUEST, METHOD_NOT_FOUND, everything,
)
from harness import errors, pulling, refusal, rules, without
from text import Lines

GOOD = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);
}
"""
BROKEN = GOOD.replace("fragCoord / iResolution.xy", "«use»missing")

PROVIDERS = {
    "completionProvider", "hoverProvider", "signatureHelpProvider", "declarationProvider",
    "definitionProvider", "typeDefinitionProvider", "referencesProvider", "documentHighlightProvider",
    "documentSymbolProvider", "workspaceSymbolProvider", "codeActionProvider", "codeLensProvider",
    "colorProvider", "documentFormattingProvider", "documentRangeFormattingProvider",
    "documentOnTypeFormattingProvider", "renameProvider", "foldingRangeProvider",
    "selectionRangeProvider", "executeCommandProvider", "callHierarchyProvider",
    "semanticTokensProvider", "inlayHintProvider",
}


def test_all_features_are_announced(case):
    client = case.client()
    told = client.initialized["capabilities"]
    missing = [name for name in sorted(PROVIDERS) if told.get(name) in (None, False)]
    assert missing == [], "features that are not announced"
    assert told["textDocumentSync"]["change"] == 2, "the kind of changes"
    assert told["textDocumentSync"]["openClose"] is True, "openClose"
    assert client.initialized["serverInfo"]["name"] == "shaderlint", "the server's name"
    assert told["renameProvider"]["prepareProvider"], f"prepareRename is not announced: {told}"
    commands = told["executeCommandProvider"]["commands"]
    assert (
        sorted(commands) == ["shaderlint.explain", "shaderlint.fixAll", "shaderlint.openPreview", "shaderlint.writeChannels"]
    ), "the commands"
    assert "quickfix" in told["codeActionProvider"]["codeActionKinds"], f"no quick fixes: {told}"
    folders = told["workspace"]["workspaceFolders"]
    assert folders["supported"] and folders["changeNotifications"], f"no workspace folders: {told}"
    assert "diagnosticProvider" not in told


def test_pull_diagnostics_are_announced(case):
    provider = case.client(capabilities=pulling()).initialized["capabilities"]["diagnosticProvider"]
    assert provider["interFileDependencies"] and provider["workspaceDiagnostics"], f"both: {provider}"


def test_watched_files_are_registered(case):
    params = case.client().asked_for("client/registerCapability")
    methods = [r["method"] for r in params["registrations"]]
    assert methods == ["workspace/didChangeWatchedFiles"], "the registered methods"
    patterns = [w["globPattern"] for w in params["registrations"][0]["registerOptions"]["watchers"]]
    assert "**/shaderlint.toml" in patterns, f"the configuration is not watched: {patterns}"


def test_clients_without_capabilities_are_supported(case):
    client = case.client(capabilities={})
    source = case.write("a.frag.glsl", BROKEN).open(client)
    found = client.published(source.uri)
    assert rules(found) == ["undeclared-name"], "the rules"
    assert "relatedInformation" not in found[0], f"unrequested related information: {found}"
    assert client.asked == [], "requests to a client without capabilities"


def encoded(case, offered, chosen):
    """A position after characters of two and four bytes, in the negotiated encoding."""
    capabilities = everything()
    if offered is None:
        del capabilities["general"]
    else:
        capabilities["general"]["positionEncodings"] = offered
    client = case.client(capabilities=capabilities)
    assert client.encoding == chosen, "the encoding for %r" % (offered,)
    source = case.write(
        "a.glsl",
        "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\r\n"
        "    float «var»wave = 0.5;\r\n"
        "    /* é𝄞 */ fragColor = vec4(«use»wave, «bad»waves, 0.0, /* 𝄞é */ «again»wave);\r\n"
        "}\r\n",
    ).open(client)
    found = client.published(source.uri)
    assert [client.lines(source.uri).at(d["range"]) for d in errors(found)] == ["waves"], "the error"
    for place in ("use", "again"):
        location = client.at(source.uri, source[place], "textDocument/definition")
        assert client.lines(source.uri).span(location["range"])[0] == source["var"], "the definition"
    found = client.at(source.uri, source["again"], "textDocument/documentHighlight")
    starts = sorted(client.lines(source.uri).span(h["range"])[0] for h in found)
    assert starts == sorted(source[p] for p in ("var", "use", "again")), "the highlights"
    # A change after wide characters of the same line is applied at the correct position.
    client.replace(source.uri, source["bad"], source["bad"] + 5, "wave")
    assert errors(client.published(source.uri)) == [], "the remaining errors"


def test_columns_are_utf_16_units_by_default(case):
    encoded(case, None, "utf-16")


def test_columns_can_be_bytes(case):
    encoded(case, ["utf-16", "utf-8"], "utf-8")


def test_columns_can_be_utf_16_units(case):
    encoded(case, ["utf-16", "utf-32"], "utf-16")


def test_columns_can_be_utf_32_units(case):
    encoded(case, ["utf-32"], "utf-32")


def test_texts_change_incrementally_and_completely(case):
    client = case.client()
    source = case.write("a.glsl", BROKEN).open(client)
    assert rules(errors(client.published(source.uri))) == ["undeclared-name"], "at first"
    lines = client.lines(source.uri)
    start = source["use"]
    # Several changes in one message: each refers to the text that results from the previous one.
    client.change(source.uri, [
        {"range": lines.range(start, start + len("missing")), "text": ""},
        {"range": lines.range(start, start), "text": "vec2(0.0)"},
        {"range": lines.range(start + 4, start + 4), "text": "\n\n/* 𝄞 */ "},
    ])
    assert errors(client.published(source.uri)) == [], "after three ranges"
    client.write_all(source.uri, "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, q, 1.0); }")
    found = errors(client.published(source.uri))
    assert [client.lines(source.uri).at(d["range"]) for d in found] == ["q"], "after a full replacement"
    # Line breaks of all three kinds.
    client.write_all(source.uri, "// a\r// b\r\n// c\n" + GOOD.replace("iTime", "time9"))
    found = errors(client.published(source.uri))
    assert [client.lines(source.uri).at(d["range"]) for d in found] == ["time9"], "after line breaks"


def test_invalid_requests_are_errors(case):
    client = case.client()
    source = case.write("a.glsl", GOOD).open(client)
    place = {"textDocument": {"uri": source.uri}}
    refusal(lambda: client.request("textDocument/nonsense", {}), METHOD_NOT_FOUND)
    refusal(lambda: client.request("textDocument/hover", place), INVALID_PARAMS)
    refusal(lambda: client.request("textDocument/hover", {"textDocument": 7, "position": []}),
            INVALID_PARAMS)
    refusal(lambda: client.request("textDocument/completion", [1, 2]), INVALID_PARAMS)
    refusal(lambda: client.request("textDocument/foldingRange"), INVALID_PARAMS)
    refusal(lambda: client.of(case.uri("never-opened.glsl"), "textDocument/foldingRange"))
    refusal(lambda: client.request("workspace/executeCommand", {"command": "no.such"}),
            INVALID_PARAMS)
    refusal(lambda: client.request("workspace/executeCommand", {"arguments": 3}), INVALID_PARAMS)
    # Invalid notifications have no response and do no harm.
    client.notify("textDocument/didOpen", {"textDocument": {"uri": 5}})
    client.notify("textDocument/nonsense", {"a": 1})
    client.notify("$/cancelRequest", {"id": None})
    client.notify("$/cancelRequest", {"id": 12345})
    client.notify("$/cancelRequest", {})
    client.notify("$/setTrace", {"value": "verbose"})
    # A position after the end of a line or of the text means the end.
    for line, character in ((0, 9999), (9999, 0), (2, 9999)):
        client.request("textDocument/hover", dict(
            place, position={"line": line, "character": character}))
    assert client.of(source.uri, "textDocument/documentSymbol")[0]["name"] == "mainImage", "a symbol"


def test_changes_of_unknown_texts_are_ignored(case):
    client = case.client()
    uri = case.uri("nobody.glsl")
    client.notify("textDocument/didChange", {
        "textDocument": {"uri": uri, "version": 2}, "contentChanges": [{"text": "float x = 1;"}]})
    client.notify("textDocument/didClose", {"textDocument": {"uri": uri}})
    client.notify("textDocument/didSave", {"textDocument": {"uri": uri}})
    source = case.write("a.glsl", GOOD).open(client)
    assert errors(client.published(source.uri)) == [], "the findings"
    told = [p for p in client.told("textDocument/publishDiagnostics")
            if p["uri"] == uri and p["diagnostics"]]
    assert told == [], "diagnostics of a text that is not open"


def test_closing_clears_diagnostics(case):
    client = case.client()
    source = case.write("a.glsl", BROKEN).open(client)
    assert client.published(source.uri), "no diagnostics are published"
    client.close(source.uri)
    client.published_when(source.uri, lambda found: found == [])
    refusal(lambda: client.of(source.uri, "textDocument/foldingRange"))
    # Opened again, the text is treated like any other, whatever its version.
    client.open(source.uri, source.text, version=1)
    client.published_when(source.uri, lambda found: rules(errors(found)) == ["undeclared-name"])


def test_untitled_texts_are_checked(case):
    client = case.client()
    uri = "untitled:Untitled-1"
    client.open(uri, BROKEN.replace("«use»", ""))
    assert rules(errors(client.published(uri))) == ["undeclared-name"], "the rules"
    at = client.text(uri).index("fragColor =")
    location = client.at(uri, at, "textDocument/definition")
    assert (location["uri"], client.lines(uri).at(location["range"])) == (uri, "fragColor"), "the position"
    edit = client.at(uri, at, "textDocument/rename", newName="color")
    client.apply(edit)
    assert client.text(uri).count("color") == 2, "the new names"
    client.close(uri)
    client.published_when(uri, lambda found: found == [])


def test_cancelled_requests_have_one_response_each(case):
    client = case.client()
    body = "".join(
        "float f%d(float x) { return sin(x * %d.0) + f%d(x); }\n" % (i, i, i - 1) for i in range(1, 300))
    source = case.write("a.glsl", "float f0(float x) { return x; }\n" + body + GOOD).open(client)
    position = Lines(source.text, client.encoding).position(source.text.index("f7("))
    place = {"textDocument": {"uri": source.uri}, "position": position}
    questions = [
        ("workspace/symbol", {"query": "f"}),
        ("textDocument/hover", place),
        ("textDocument/semanticTokens/full", {"textDocument": {"uri": source.uri}}),
        ("textDocument/references", dict(place, context={"includeDeclaration": True})),
        ("textDocument/completion", place),
    ]
    cancelled = 0
    # A server that is faster than its client may have answered all of them: then they are repeated.
    for _ in range(100):
        sent = []
        for number in range(60):
            sent.append(client.send(*questions[number % 5]))
            if number % 2:
                client.notify("$/cancelRequest", {"id": sent[-1]})
            if number % 7 == 0:
                client.notify("$/cancelRequest", {"id": sent[number // 2]})
        for number in sent:
            error = client.wait(number).get("error")
            if error:
                assert error["code"] in (CANCELLED, CONTENT_MODIFIED), f"another error: {error}"
                cancelled += error["code"] == CANCELLED
        if cancelled:
            break
    assert cancelled > 0, "no question was cancelled in time"
    client.settle()
    assert all(client.answered[n] == 1 for n in sent), "more than one answer"


def test_the_server_exits_after_shutdown(case):
    client = case.client()
    client.request("shutdown")
    client.notify("exit")
    assert client.finish() == 0, "the exit code"


def test_exit_without_shutdown_is_a_failure(case):
    client = case.client()
    client.notify("exit")
    assert client.finish() == 1, "the exit code"


def test_the_server_exits_with_its_client(case):
    client = case.client()
    case.write("a.glsl", GOOD).open(client)
    client.process.stdin.close()
    assert client.finish() == 1, "the exit code after the client exited"


def test_requests_after_shutdown_are_errors(case):
    client = case.client()
    source = case.write("a.glsl", GOOD).open(client)
    client.request("shutdown")
    refusal(lambda: client.of(source.uri, "textDocument/foldingRange"), INVALID_REQUEST)
    refusal(lambda: client.request("shutdown"), INVALID_REQUEST)
    client.notify("exit")
    assert client.finish() == 0, "the exit code"


def test_requests_before_initialize_are_errors(case):
    client = case.client(start=False)
    refusal(lambda: client.request("textDocument/hover", {}), -32002)
    client.notify("textDocument/didOpen", {})
    client.start()
    source = case.write("a.glsl", BROKEN).open(client)
    assert rules(errors(client.published(source.uri))) == ["undeclared-name"], "the rules"


def test_exit_before_initialize_ends_the_server(case):
    client = case.client(start=False)
    client.notify("exit")
    assert client.finish() == 1, "the exit code"


def test_a_second_initialize_is_rejected(case):
    client = case.client()
    refusal(lambda: client.request("initialize", {"capabilities": {}, "processId": None}))


def test_messages_may_be_split_or_batched(case):
    # The server sends no requests to a client without capabilities, so no response arrives between the
    # pieces.
    client = case.client(capabilities={})
    source = case.write("a.glsl", GOOD).open(client)
    messages = b""
    numbers = []
    for _ in range(20):
        with client.changed:
            client.last_id += 1
            client.pending[client.last_id] = "textDocument/foldingRange"
        numbers.append(client.last_id)
        body = json.dumps({
            "jsonrpc": "2.0", "id": client.last_id, "method": "textDocument/foldingRange",
            "params": {"textDocument": {"uri": source.uri}}}).encode()
        messages += b"Content-Type: application/vscode-jsonrpc; charset=utf-8\r\n"
        messages += b"Content-Length: %d\r\n\r\n" % len(body) + body
    client.settle()
    for piece in (messages[:11], messages[11:777], messages[777:]):
        client.write_separately(piece)
    for number in numbers:
        assert "result" in client.wait(number), "an error"


def test_request_ids_may_be_strings(case):
    client = case.client()
    source = case.write("a.glsl", GOOD).open(client)
    with client.changed:
        client.pending["a question"] = "textDocument/foldingRange"
    client.write({"jsonrpc": "2.0", "id": "a question", "method": "textDocument/foldingRange",
                  "params": {"textDocument": {"uri": source.uri}}})
    assert "result" in client.wait("a question"), "an error"


def test_root_uri_is_supported(case):
    case.write("lib.glsl", "float lib() { return 1.0; }\n")
    client = case.client(start=False, capabilities=without(everything(), "workspace"))
    params = {"processId": None, "capabilities": client.capabilities,
              "rootUri": case.uri("").rstrip("/")}
    client.initialized = client.request("initialize", params)
    client.notify("initialized", {})
    found = client.request("workspace/symbol", {"query": "lib"})
    assert [s["name"] for s in found] == ["lib"], "the symbols"


def raw(data):
    return b"Content-Length: %d\r\n\r\n" % len(data) + data


def test_invalid_messages_are_answered(case):
    client = case.client()
    for data, code in ((b'{"a":', -32700), (b"[1, 2]", -32600), (b'{"jsonrpc": "2.0"}', -32600)):
        client.write_bytes(raw(data))
        answer = client.wait_until(lambda: client.answers.pop(None, None), "no answer to %r" % data)
        assert answer["error"]["code"] == code, "the code of the answer to %r" % data
    source = case.write("a.glsl", GOOD).open(client)
    assert client.published(source.uri) == [], "the findings afterwards"


def test_an_invalid_header_ends_the_server(case):
    headers = {
        b"Content-Length: 99999999999999\r\n\r\n{}": "99999999999999 bytes",
        b"Content-Length: -5\r\n\r\n{}": "not a number",
        b"Length: 2\r\n\r\n{}": "no `Content-Length`",
        b"hello\n": "no `:`",
        b"x" * 100_000 + b"\n": "no end",
    }
    for header, reason in headers.items():
        client = case.client()
        client.write_bytes(header)
        assert client.finish() == 2, "the exit code after %r" % header[:40]
        assert reason in client.said(), "the reason"
        assert client.answers[None]["error"]["code"] == -32700, "the answer"


def test_the_server_ends_with_its_client(case):
    client = subprocess.Popen(["sleep", "60"])
    server = Connection([case.program, "lsp"], environment={"TMPDIR": case.temp})
    try:
        params = {"processId": client.pid, "rootUri": None, "capabilities": {}}
        server.request("initialize", params)
        server.notify("initialized")
        text = BROKEN.replace("«use»", "")
        item = {"uri": "file:///a.glsl", "languageId": "glsl", "version": 1, "text": text}
        server.notify("textDocument/didOpen", {"textDocument": item})
        server.wait_until(lambda: server.notifications, "no findings")
        assert len(os.listdir(case.temp)) == 1, "the folders of pages"
        client.kill()
        client.wait()
        # The input stays open.
        server.finish()
        assert os.listdir(case.temp) == [], "the folders that are left"
    finally:
        client.kill()
        server.kill()


def test_folders_of_servers_that_were_killed_are_removed(case):
    folders = []
    for _ in range(2):
        client = case.client()
        source = case.write("a.glsl", BROKEN.replace("«use»", "")).open(client)
        client.published(source.uri)
        folders.append(os.listdir(case.temp))
        client.kill()
    assert [len(found) for found in folders] == [1, 1], "the number of folders"
    assert folders[0] != folders[1], f"the folder is the same: {folders}"
