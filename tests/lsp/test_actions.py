"""Code actions for diagnostics, and the commands of the server."""

import os

from client import INVALID_PARAMS, everything, path_of
from harness import by_rule, errors, refusal, rules, without

SHADER = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float «int»wave = 1;
    float «pow»bent = pow(iTime - 9.0, 2.0);
    «unused»float unused = 2.0;
    fragColor = vec4(uv * wave, bent, 1.0);
}
"""
GOOD = SHADER.replace("= 1;", "= 1.0;")
QUIET = {"run": False}


def asked(client, source, finding, only=None):
    """The actions that are offered for a diagnostic."""
    context = {"diagnostics": [finding], "triggerKind": 1}
    if only:
        context["only"] = only
    return client.of(source.uri, "textDocument/codeAction", range=finding["range"], context=context)


def titled(actions, words):
    found = [a for a in actions if a["title"].lower().startswith(words.lower())]
    assert len(found) == 1, ("one action that is called «%s …», not %d:" % (words, len(found)), actions)
    return found[0]


def test_a_fix_removes_only_its_diagnostic(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", SHADER).open(client)
    before = client.published(source.uri)
    finding = errors(before)[0]
    actions = asked(client, source, finding)
    fixes = [a for a in actions if a.get("isPreferred")]
    assert len(fixes) == 1, "the preferred actions"
    fix = fixes[0]
    assert fix["kind"] == "quickfix", "its kind"
    assert [d["code"] for d in fix["diagnostics"]] == [finding["code"]], "the diagnostics of the action"
    client.apply(fix["edit"])
    assert client.text(source.uri) == source.text.replace("= 1;", "= 1.0;"), "the text"
    after = client.published(source.uri)
    assert errors(after) == [], "the errors that are left"


def test_each_of_many_fixes_removes_its_diagnostic(case):
    broken = [
        "float a = 1; c = vec4(a, p, 1.0);", "vec3 a = vec3(1, 1, 1) * 2; c = vec4(a, 1.0);",
        "float a = 1.0f; c = vec4(a);", "c = vec4(p, 0.0, 1.0)", "c = texture2D(iChannel0, p);",
        "c = vec4(fragCoord, 0.0, 1.0);", "c = vec4(saturate(p.x));", "c = vec4(float(p)); int i = 1.0;",
        "c = vec4(lerp(p.x, p.y, 0.5));", "c.rgb = vec3(1.0) c.a = 1.0;",
    ]
    client = case.client(options=QUIET)
    mended = 0
    for number, body in enumerate(broken):
        uri = case.uri("broken%d.glsl" % number)
        text = "void mainImage(out vec4 c, in vec2 p) {\n    %s\n}\n" % body
        client.open(uri, text)
        count = len(errors(client.published(uri)))
        for finding in errors(client.published(uri)):
            actions = client.of(uri, "textDocument/codeAction", range=finding["range"],
                                context={"diagnostics": [finding]})
            for action in [a for a in actions if a.get("isPreferred")]:
                client.apply(action["edit"])
                left = errors(client.published(uri))
                assert len(left) < count, (
                    "a fix of «%s» that does not remove it:" % body, client.text(uri), left
                )
                mended += 1
                client.write_all(uri, text)
                client.published(uri)
    assert mended >= 6, "only %d of them have a fix" % mended


def test_a_comment_suppresses_a_diagnostic(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", GOOD).open(client)
    finding = by_rule(client.published(source.uri), "unused-variable")
    action = titled(asked(client, source, finding), "Allow `unused-variable`")
    client.apply(action["edit"])
    assert "\n    // shaderlint: allow(unused-variable)\n    float unused = 2.0;\n" in client.text(source.uri)
    left = client.published(source.uri)
    assert [r for r in rules(left) if r in ("unused-variable", "unused-suppression")] == []


def test_errors_cannot_be_suppressed(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", SHADER).open(client)
    finding = errors(client.published(source.uri))[0]
    assert [a["title"] for a in asked(client, source, finding) if a["title"].startswith("Allow")] == []


def test_a_diagnostic_can_be_explained(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", GOOD).open(client)
    finding = by_rule(client.published(source.uri), "unused-variable")
    command = titled(asked(client, source, finding), "Explain")["command"]
    assert command["command"] in client.initialized["capabilities"]["executeCommandProvider"]["commands"]
    page = client.request("workspace/executeCommand", command)
    assert "unused-variable" in page, "the page of the rule"
    shown = client.asked_for("window/showDocument")
    with open(path_of(shown["uri"]), encoding="utf-8") as file:
        assert file.read() == page, "the page that is shown"


def test_explanations_are_messages_without_show_document(case):
    client = case.client(capabilities=without(everything(), "window"), options=QUIET)
    client.request("workspace/executeCommand",
                   {"command": "shaderlint.explain", "arguments": ["unused-variable"]})
    messages = client.wait_until(lambda: client.told("window/showMessage"), "no message is shown")
    assert "unused-variable" in messages[0]["message"], "the message"
    assert [m["method"] for m in client.asked if m["method"] == "window/showDocument"] == [], "documents"


def test_unknown_rules_are_not_explained(case):
    client = case.client()
    refusal(lambda: client.request("workspace/executeCommand", {
        "command": "shaderlint.explain", "arguments": ["no-such-rule"]}), INVALID_PARAMS)


def test_actions_are_filtered_by_kind(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", SHADER).open(client)
    finding = errors(client.published(source.uri))[0]
    assert asked(client, source, finding, ["refactor"]) == [], "refactorings"
    kinds = {a["kind"] for a in asked(client, source, finding, ["quickfix"])}
    assert kinds == {"quickfix"}, "quick fixes"
    for only in ("source", "source.fixAll", "source.fixAll.shaderlint"):
        kinds = {a["kind"] for a in asked(client, source, finding, [only])}
        assert kinds == {"source.fixAll.shaderlint"}, "the actions of kind %s" % only
    nowhere = client.lines(source.uri).range(0, 0)
    context = {"diagnostics": []}
    assert client.of(source.uri, "textDocument/codeAction", range=nowhere, context=context) == []


PARTS = """// A wave.
float wave(float x) {
    return sin(x) * 0.5;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float bright = «sum»uv.x * 2.0«end» + wave(uv.y);
    fragColor = vec4(bright);
}
"""


def refactorings(client, source, start, end, only="refactor", trigger=1):
    """The refactorings of a range."""
    context = {"diagnostics": [], "triggerKind": trigger, "only": [only]}
    chosen = client.lines(source.uri).range(start, end)
    return client.of(source.uri, "textDocument/codeAction", range=chosen, context=context)


def test_expressions_are_extracted_and_variables_inlined(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", PARTS).open(client)
    found = refactorings(client, source, source["sum"], source["end"])
    kinds = {a["title"]: a["kind"] for a in found}
    assert kinds == {
        "Extract to variable": "refactor.extract.variable",
        "Extract to function": "refactor.extract.function",
        "Preview this value": "refactor",
    }, "the refactorings"
    assert set(kinds.values()) < set(client.initialized["capabilities"]["codeActionProvider"]["codeActionKinds"])
    # A server whose client has no command for it does not ask for a name.
    commands = [a["command"]["command"] for a in found if "command" in a]
    assert commands == ["shaderlint.openPreview"], "the commands"
    functions = refactorings(client, source, source["sum"], source["end"], "refactor.extract.function")
    assert [a["title"] for a in functions] == ["Extract to function"], "the refactorings of a kind"
    client.apply(titled(found, "Extract to variable")["edit"])
    assert "\n    float value = uv.x * 2.0;\n    float bright = value + wave(uv.y);\n" in client.text(source.uri)
    assert errors(client.published(source.uri)) == [], "the errors"
    at = client.text(source.uri).index("value")
    client.apply(titled(refactorings(client, source, at, at), "Inline variable")["edit"])
    assert "\n    float bright = uv.x * 2.0 + wave(uv.y);\n" in client.text(source.uri), "the text"


def test_new_names_are_renamed_by_the_client(case):
    client = case.client(options={"run": False, "renameCommand": "editor.rename"})
    source = case.write("a.glsl", PARTS).open(client)
    found = refactorings(client, source, source["sum"], source["end"])
    for action in found:
        if "edit" not in action:
            continue
        text = client.text(source.uri)
        client.apply(action["edit"])
        uri, position = action["command"]["arguments"]
        assert (action["command"]["command"], uri) == ("editor.rename", source.uri), "the command"
        at = client.lines(uri).offset(position)
        name = {"Extract to variable": "value ", "Extract to function": "extracted("}[action["title"]]
        assert client.text(uri)[at:].startswith(name), ("another name at the position", client.text(uri)[at:])
        client.write_all(source.uri, text)


def test_functions_move_to_new_files(case):
    capabilities = everything()
    capabilities["workspace"]["workspaceEdit"] = {"documentChanges": True, "resourceOperations": ["create"]}
    client = case.client(capabilities=capabilities, options=QUIET)
    source = case.write("a.glsl", PARTS).open(client)
    at = source.text.index("wave(float")
    client.apply(titled(refactorings(client, source, at, at), "Move `wave`")["edit"])
    assert "#include \"wave.glsl\"\n\nvoid mainImage" in client.text(source.uri), "the text"
    with open(os.path.join(case.folder, "wave.glsl"), encoding="utf-8") as file:
        assert file.read() == "// A wave.\nfloat wave(float x) {\n    return sin(x) * 0.5;\n}\n", "the file"
    assert errors(client.published(source.uri)) == [], "the errors"
    # Other clients cannot create files.
    client = case.client(options=QUIET)
    other = case.write("b.glsl", PARTS.replace("wave", "ripple")).open(client)
    found = refactorings(client, other, at, at)
    assert [a for a in found if a["kind"] == "refactor.move"] == [], "without files"


def test_a_cursor_that_moves_gets_no_refactorings(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", PARTS).open(client)
    at = source.text.index("bright")
    assert refactorings(client, source, at, at), "none on request"
    assert refactorings(client, source, at, at, trigger=2) == [], "without a request"
    # Code with errors is not refactored.
    client.write_all(source.uri, source.text.replace("bright);", "bright + 1);"))
    assert refactorings(client, source, at, at) == [], "with an error"


def test_fix_all_applies_safe_fixes(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", SHADER).open(client)
    finding = errors(client.published(source.uri))[0]
    actions = asked(client, source, finding, ["source.fixAll"])
    assert len(actions) == 1, "the actions"
    client.apply(actions[0]["edit"])
    found = client.published(source.uri)
    assert errors(found) == [], "the errors that are left"
    # A second run has nothing left to fix.
    assert asked(client, source, found[0], ["source.fixAll"]) == [], "after the second run"


def test_a_command_fixes_all(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", SHADER).open(client)
    client.published(source.uri)
    client.request("workspace/executeCommand",
                   {"command": "shaderlint.fixAll", "arguments": [source.uri]})
    params = client.asked_for("workspace/applyEdit")
    assert "fix" in params["label"].lower(), "the label"
    found = client.wait_until(lambda: client.documents[source.uri].version > 1, "no edit is applied")
    assert found, "no edit is applied"
    assert errors(client.published(source.uri)) == [], "the errors that are left"
    refusal(lambda: client.request("workspace/executeCommand", {
        "command": "shaderlint.fixAll", "arguments": ["file:///nowhere.glsl"]}), INVALID_PARAMS)


def test_a_shader_is_shown_in_a_browser(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", GOOD).open(client)
    client.request("workspace/executeCommand",
                   {"command": "shaderlint.openPreview", "arguments": [source.uri]})
    shown = client.asked_for("window/showDocument")
    assert shown.get("external") is True, "external"
    path = path_of(shown["uri"])
    assert path.endswith(".html"), f"no page is shown: {shown}"
    with open(path, encoding="utf-8") as file:
        assert "<canvas" in file.read().lower(), "the page"
    client.stop()
    assert not os.path.exists(path), f"the page was not deleted: {path}"
