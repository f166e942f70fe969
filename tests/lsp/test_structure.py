"""Document structure: symbols, semantic tokens, inlay hints, folding, selection ranges, code
lenses."""

import re

from client import RpcError, everything
from harness import errors, without

SHADER = """// é𝄞 the first line
// of a comment

#define «steps»STEPS 8
#if STEPS > 100
float unseen(float x) {
    return x;
}
#else
const float seen = 1.0;
#endif
struct «ray»Ray {
    vec3 origin;
    float speed;
};
uniform float gain; // 0..2
const vec3 SKY = «sky»vec3(0.2, 0.4, 0.8);
float shape(vec3 place, float radius) { return length(place) - radius; }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float «total»total = 0.0;
    for (int i = 0; i < STEPS; i++)«turns» {
        «write»total += shape(«arg»vec3(uv, 1.0), «arg2»0.5 * gain);
    }
    vec3 col = SKY * total + «red»vec4(1.0, 0.5, 0.25, 1.0).rgb * vec3(0.0) + vec3(1.0);
    fragColor = vec4(«deep»sqrt(col * seen), 1.0);
}
"""


def opened(case, **settings):
    client = case.client(**settings)
    return client, case.write("a.glsl", SHADER).open(client)


def inside(lines, outer, inner):
    (start, end), (low, high) = lines.span(outer), lines.span(inner)
    return start <= low and high <= end


def test_symbols_contain_their_members(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/documentSymbol")
    assert [s["name"] for s in found] == ["STEPS", "seen", "Ray", "gain", "SKY", "shape", "mainImage"]
    for symbol in found + [m for s in found for m in s.get("children", [])]:
        assert inside(lines, symbol["range"], symbol["selectionRange"])
        assert lines.at(symbol["selectionRange"]) == symbol["name"], "the code at the name"
    ray = found[2]
    assert [m["name"] for m in ray["children"]] == ["origin", "speed"], "the members"
    assert all(inside(lines, ray["range"], m["range"]) for m in ray["children"])
    kinds = {s["name"]: s["kind"] for s in found}
    assert (kinds["shape"], kinds["Ray"], kinds["SKY"]) == (12, 23, 14), "function, struct, constant"
    assert "fragColor = vec4(sqrt" in lines.at(found[-1]["range"]), "the range of a function"


def test_clients_without_hierarchy_get_flat_symbols(case):
    client, source = opened(case, capabilities=without(
        everything(), "textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport"))
    found = client.of(source.uri, "textDocument/documentSymbol")
    assert [s["location"]["uri"] for s in found if s["location"]["uri"] != source.uri] == [], "other files"
    names = [s["name"] for s in found]
    assert {"Ray", "shape", "mainImage"} <= set(names), f"missing symbols: {names}"


def decoded(client, uri, data):
    """Semantic tokens: their text, type and modifiers, by offset."""
    legend = client.initialized["capabilities"]["semanticTokensProvider"]["legend"]
    lines = client.lines(uri)
    found, line, column, last = {}, 0, 0, 0
    assert len(data) % 5 == 0, ("not five numbers each", len(data))
    for at in range(0, len(data), 5):
        down, right, length, kind, bits = data[at:at + 5]
        line, column = line + down, right if down else column + right
        start = lines.offset({"line": line, "character": column})
        end = lines.offset({"line": line, "character": column + length})
        assert start >= last and end > start, ("tokens overlap or are empty", data[at:at + 5])
        assert bits < 1 << len(legend["tokenModifiers"]), f"unknown modifiers: {bits}"
        modifiers = {m for i, m in enumerate(legend["tokenModifiers"]) if bits >> i & 1}
        found[start] = (lines.text[start:end], legend["tokenTypes"][kind], modifiers)
        last = end
    return found


def colours(client, uri):
    return client.of(uri, "textDocument/semanticTokens/full")


def test_semantic_tokens_reflect_the_meaning(case):
    client, source = opened(case)
    found = decoded(client, source.uri, colours(client, source.uri)["data"])
    assert found[source["steps"]][:2] == ("STEPS", "macro"), "a macro"
    assert found[source["ray"]][:2] == ("Ray", "struct"), "a struct"
    assert found[source["deep"]] == ("sqrt", "function", {"defaultLibrary"}), "a built-in"
    assert found[source["total"]][:2] == ("total", "variable"), "a local"
    assert "declaration" in found[source["total"]][2], ("the declaration", found[source["total"]])
    assert "modification" in found[source["write"]][2], ("a write", found[source["write"]])
    at = source.text.index("place) - radius")
    assert found[at][:2] == ("place", "parameter"), "a parameter"
    assert found[source.text.index("origin")][:2] == ("origin", "property"), "a member"
    assert "readonly" in found[source.text.index("SKY *")][2], ("a constant", found[source.text.index("SKY *")])
    assert found[source.text.index("iResolution")][1:] == ("variable", {"readonly", "defaultLibrary"})
    # Code removed by the preprocessor is dimmed.
    assert found[source.text.index("unseen")][:2] == ("unseen", "comment"), "the inactive code"


def test_tokens_of_a_range_are_a_subset(case):
    client, source = opened(case)
    everywhere = decoded(client, source.uri, colours(client, source.uri)["data"])
    start, end = source.text.index("float shape"), source.text.index("    vec2 uv")
    range_ = client.lines(source.uri).range(start, end)
    some = decoded(client, source.uri, client.of(
        source.uri, "textDocument/semanticTokens/range", range=range_)["data"])
    assert some == {at: token for at, token in everywhere.items() if start <= at < end}


def test_token_deltas_update_old_tokens(case):
    client, source = opened(case)
    known = colours(client, source.uri)
    data, number = known["data"], known["resultId"]
    edits = [
        ("total", 5, "summed"), ("struct", 0, "float before = 1.0;\n"), ("vec2 uv", 0, "\n\n// 𝄞\n"),
        ("    vec3 col", 0, "    total *= gain; total -= 1.0;\n"), ("#if STEPS > 100", 15, "#if STEPS > 1"),
        ("// é", 0, " "),
    ]
    for word, length, new in edits:
        at = client.text(source.uri).index(word)
        client.replace(source.uri, at, at + length, new)
        told = client.of(source.uri, "textDocument/semanticTokens/full/delta", previousResultId=number)
        if "edits" in told:
            # From last to first, so that offsets stay valid.
            for edit in sorted(told["edits"], key=lambda e: -e["start"]):
                data[edit["start"]:edit["start"] + edit["deleteCount"]] = edit.get("data", [])
        else:
            data = told["data"]
        number = told["resultId"]
        full = colours(client, source.uri)
        assert data == full["data"], "the tokens after «%s»" % new
        number = full["resultId"]
    unchanged = client.of(source.uri, "textDocument/semanticTokens/full/delta", previousResultId=number)
    assert unchanged.get("edits") == [], "an empty delta"
    unknown = client.of(source.uri, "textDocument/semanticTokens/full/delta", previousResultId="nonsense")
    assert unknown.get("data") == full["data"], "the response to an unknown result id"


def hints(client, source):
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/inlayHint", range=lines.range(0, len(lines.text)))
    return {lines.offset(h["position"]): h["label"] for h in found}


def test_hints_show_parameters_and_iterations(case):
    client, source = opened(case, options={"run": False})
    found = hints(client, source)
    assert found.get(source["arg"]) == "place:", "the first argument"
    assert found.get(source["arg2"]) == "radius:", "the second argument"
    assert "8" in found.get(source["turns"], ""), "the iterations of the loop"
    assert len(found) == 3, "the number of hints"
    # The hints of a range are only those inside it.
    lines = client.lines(source.uri)
    some = client.of(source.uri, "textDocument/inlayHint",
                     range=lines.range(source["arg"] - 5, source["arg"] + 3))
    assert [h["label"] for h in some] == ["place:"], "the hints of a range"


def test_hints_show_sampled_counts(case):
    client, source = opened(case)
    client.published(source.uri)
    client.asked_for("workspace/inlayHint/refresh")
    assert "sampled: 8" in hints(client, source)[source["turns"]], "the iterations of the loop"


def test_hints_follow_the_settings(case):
    client, source = opened(case, options={"run": False, "hints": {"parameters": False, "types": True}})
    found = hints(client, source)
    assert "place:" not in found.values(), f"parameter hints although they are off: {found}"
    assert any(label.startswith(": vec") for label in found.values()), f"no types: {found}"
    # Changed settings, sent with the notification.
    client.notify("workspace/didChangeConfiguration", {"settings": {"shaderlint": {
        "run": False, "hints": {"parameters": False, "loopIterations": False, "types": False}}}})
    assert hints(client, source) == {}, "the hints when all are off"


def test_invalid_settings_are_reported_and_ignored(case):
    client, source = opened(case, options={"run": False, "hints": {"parameters": "never"}})
    messages = client.wait_until(lambda: client.told("window/showMessage"), "no message")
    assert "expected a boolean" in messages[0]["message"], "the message"
    assert "place:" in hints(client, source).values(), "the wrong settings are used"


def test_settings_are_requested(case):
    off = {"hints": {"parameters": False, "loopIterations": False}, "run": False, "lenses": False}
    client, source = opened(case, settings={"shaderlint": off})
    client.asked_for("workspace/configuration")
    assert hints(client, source) == {}, "the hints, which are off"
    assert (client.of(source.uri, "textDocument/codeLens") or []) == [], "the lenses, which are off"
    # The client announces a change without its content: the server requests the settings again.
    client.settings = {"shaderlint": {"run": False}}
    client.notify("workspace/didChangeConfiguration", {"settings": None})
    client.asked_for("workspace/configuration", count=2)
    assert hints(client, source), "the new settings are not used"


def test_folds_exclude_the_last_line(case):
    client, source = opened(case)
    found = client.of(source.uri, "textDocument/foldingRange")
    lines = SHADER.split("\n")

    def line(part):
        return next(i for i, text in enumerate(lines) if part in text)

    pairs = {(f["startLine"], f["endLine"]): f.get("kind") for f in found}
    assert pairs.get((0, 1)) == "comment", "the fold of the comment"
    assert (line("mainImage("), len(lines) - 3) in pairs, f"no fold of a body: {pairs}"
    assert (line("for (int"), line("«write»")) in pairs, f"no fold of a loop: {pairs}"
    assert (line("Ray {"), line("speed;")) in pairs, f"no fold of a struct: {pairs}"
    assert pairs.get((line("#if STEPS"), line("#else") - 1)) == "region", "the fold of a group"
    assert [f for f in found if "startCharacter" in f or "endCharacter" in f] == []
    for start, end in pairs:
        for other_start, other_end in pairs:
            crosses = start < other_start <= end < other_end
            assert not crosses, ("folds cross", (start, end), (other_start, other_end))


def test_folds_can_start_within_a_line(case):
    capabilities = everything()
    capabilities["textDocument"]["foldingRange"]["lineFoldingOnly"] = False
    client, source = opened(case, capabilities=capabilities)
    lines = client.lines(source.uri)
    for fold in client.of(source.uri, "textDocument/foldingRange"):
        start = lines.offset({"line": fold["startLine"], "character": fold["startCharacter"]})
        end = lines.offset({"line": fold["endLine"], "character": fold["endCharacter"]})
        assert start < end, f"an empty fold: {fold}"


def test_selection_ranges_grow(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    offsets = [source[name] for name in ("deep", "write", "arg2", "ray")] + [0, len(source.text)]
    found = client.of(source.uri, "textDocument/selectionRange",
                      positions=[lines.position(at) for at in offsets])
    assert len(found) == len(offsets), "the answers"
    for at, selection in zip(offsets, found):
        start, end = lines.span(selection["range"])
        assert start <= at <= end, f"the innermost does not hold the place: {selection}"
        chain = [selection]
        while chain[-1].get("parent"):
            chain.append(chain[-1]["parent"])
        for inner, outer in zip(chain, chain[1:]):
            assert inside(lines, outer["range"], inner["range"]) and inner["range"] != outer["range"], (
                "a parent that is not larger", inner["range"], outer["range"]
            )
        assert lines.span(chain[-1]["range"]) == (0, len(source.text)), "the outermost"
    words = []
    selection = found[0]
    while selection:
        words.append(lines.at(selection["range"]))
        selection = selection.get("parent")
    assert words[0] == "sqrt", "the innermost"
    for part in ("sqrt(col * seen)", "vec4(sqrt(col * seen), 1.0)", "fragColor = vec4(sqrt(col * seen), 1.0)"):
        assert part in words, ("«%s» is not among them" % part, words)


def test_colours_are_shown_and_edited(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/documentColor")
    assert [lines.at(c["range"]) for c in found] == ["vec3(0.2, 0.4, 0.8)", "vec4(1.0, 0.5, 0.25, 1.0)"]
    for name, value in (("red", 0.2), ("green", 0.4), ("blue", 0.8), ("alpha", 1.0)):
        assert abs(found[0]["color"][name] - value) < 1e-6, ("the %s" % name, found[0])
    new = {"red": 1.0, "green": 0.5, "blue": 0.0, "alpha": 1.0}
    for place, written in ((0, "vec3(1.0, 0.5, 0.0)"), (1, "vec4(1.0, 0.5, 0.0, 1.0)")):
        offered = client.of(source.uri, "textDocument/colorPresentation",
                            color=new, range=found[place]["range"])
        assert offered, "no presentation"
        edit = offered[0].get("textEdit") or {"range": found[place]["range"], "newText": offered[0]["label"]}
        client.apply({"changes": {source.uri: [edit]}})
        assert written in client.text(source.uri), "the text"
        found = client.of(source.uri, "textDocument/documentColor")
        assert abs(found[place]["color"]["green"] - 0.5) < 1e-6, f"the written colour differs: {found}"
    assert errors(client.published(source.uri)) == [], "the errors"


def test_lenses_offer_server_commands(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/codeLens")
    titles = [lens["command"]["title"] for lens in found]
    assert any("Preview" in t for t in titles) and any("operations" in t for t in titles)
    commands = client.initialized["capabilities"]["executeCommandProvider"]["commands"]
    for lens in found:
        assert "mainImage" in lines.at(lens["range"]), "the code below the lens"
        assert lens["command"]["command"] in [""] + commands, f"an unknown command: {lens}"
    preview = [lens for lens in found if "Preview" in lens["command"]["title"]][0]
    client.request("workspace/executeCommand", preview["command"])
    client.asked_for("window/showDocument")


def test_a_lens_shows_the_sampled_cost(case):
    client, source = opened(case)
    client.published(source.uri)
    client.asked_for("workspace/codeLens/refresh")
    titles = [lens["command"]["title"] for lens in client.of(source.uri, "textDocument/codeLens")]
    cost = [re.search(r"sample run: (\d+) operations per pixel(?:, at most (\d+) operations)?; loops up to 8 iterations", t) for t in titles]
    cost = [c for c in cost if c]
    assert len(cost) == 1 and 0 < int(cost[0].group(1)) <= int(cost[0].group(2) or cost[0].group(1))
    assert not any("estimated" in t for t in titles), f"two costs: {titles}"


def test_clients_with_views_get_lenses_for_numbers(case):
    client, source = opened(case, options={"previewCommand": "editor.preview"})
    tuned = case.write("b.glsl", "#define GAIN 0.5 // how bright (0~2)\nvoid mainImage(out vec4 c, in vec2 p) "
                       "{ c = vec4(GAIN * p.x / iResolution.x); }\n").open(client)
    found = client.of(tuned.uri, "textDocument/codeLens")
    commands = {lens["command"]["command"]: lens["command"] for lens in found}
    assert "editor.preview" in commands, f"its own command is not used: {found}"
    tune = commands.get("shaderlint.tune")
    assert tune, f"no lens for the number: {found}"
    assert tune["title"] == "Change GAIN: 0 … 2", "its title"
    uri, range_, value, low, high = tune["arguments"]
    assert (uri, client.lines(tuned.uri).at(range_), value) == (tuned.uri, "0.5", 0.5), "the tuned value"
    assert (low, high) == (0, 2), "its range"


def test_invalid_code_keeps_its_structure(case):
    client, source = opened(case)
    client.replace(source.uri, source["write"], source["write"], "total = ((; {")
    for method in ("documentSymbol", "foldingRange", "documentColor", "codeLens", "semanticTokens/full"):
        try:
            client.of(source.uri, "textDocument/" + method)
        except RpcError as error:
            raise AssertionError("a broken text has no %s: %s" % (method, error))
    names = [s["name"] for s in client.of(source.uri, "textDocument/documentSymbol")]
    assert {"Ray", "shape"} <= set(names), f"the outline before the error: {names}"


def test_selection_ranges_have_limited_depth(case):
    """In the response each selection range contains its parent: a sum of many terms nests as deep
    as it is long."""
    client = case.client(options={"run": False})
    uri = case.uri("sum.glsl")
    text = "void mainImage(out vec4 c, in vec2 p) { c = vec4(%s); }\n" % "+".join(["p.x"] * 20_000)
    client.open(uri, text)
    client.published(uri)
    selection = client.of(uri, "textDocument/selectionRange",
                          positions=[client.lines(uri).position(text.index("p.x"))])[0]
    depth = 0
    while selection:
        outermost, selection = selection, selection.get("parent")
        depth += 1
    assert depth < 500, f"too deep: {depth}"
    assert client.lines(uri).span(outermost["range"]) == (0, len(text)), "the outermost"
