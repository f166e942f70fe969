"""Document structure: symbols, semantic tokens, inlay hints, folding, selection ranges, code
lenses."""

import re

from client import RpcError, everything
from harness import contains, errors, holds, same, test, without

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


@test
def symbols_contain_their_members(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/documentSymbol")
    same([s["name"] for s in found],
         ["STEPS", "seen", "Ray", "gain", "SKY", "shape", "mainImage"], "the outline, in the order of the text")
    for symbol in found + [m for s in found for m in s.get("children", [])]:
        holds(inside(lines, symbol["range"], symbol["selectionRange"]), "a name outside of its range", symbol)
        same(lines.at(symbol["selectionRange"]), symbol["name"], "the code at the name")
    ray = found[2]
    same([m["name"] for m in ray["children"]], ["origin", "speed"], "the members")
    holds(all(inside(lines, ray["range"], m["range"]) for m in ray["children"]), "members outside their parent", ray)
    kinds = {s["name"]: s["kind"] for s in found}
    same((kinds["shape"], kinds["Ray"], kinds["SKY"]), (12, 23, 14), "function, struct, constant")
    contains(lines.at(found[-1]["range"]), "fragColor = vec4(sqrt", "the range of a function")


@test
def clients_without_hierarchy_get_flat_symbols(case):
    client, source = opened(case, capabilities=without(
        everything(), "textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport"))
    found = client.of(source.uri, "textDocument/documentSymbol")
    same([s["location"]["uri"] for s in found if s["location"]["uri"] != source.uri], [], "other files")
    names = [s["name"] for s in found]
    holds({"Ray", "shape", "mainImage"} <= set(names), "missing symbols", names)


def decoded(client, uri, data):
    """Semantic tokens: their text, type and modifiers, by offset."""
    legend = client.initialized["capabilities"]["semanticTokensProvider"]["legend"]
    lines = client.lines(uri)
    found, line, column, last = {}, 0, 0, 0
    holds(len(data) % 5 == 0, "not five numbers each", len(data))
    for at in range(0, len(data), 5):
        down, right, length, kind, bits = data[at:at + 5]
        line, column = line + down, right if down else column + right
        start = lines.offset({"line": line, "character": column})
        end = lines.offset({"line": line, "character": column + length})
        holds(start >= last and end > start, "tokens overlap or are empty", data[at:at + 5])
        holds(bits < 1 << len(legend["tokenModifiers"]), "unknown modifiers", bits)
        modifiers = {m for i, m in enumerate(legend["tokenModifiers"]) if bits >> i & 1}
        found[start] = (lines.text[start:end], legend["tokenTypes"][kind], modifiers)
        last = end
    return found


def colours(client, uri):
    return client.of(uri, "textDocument/semanticTokens/full")


@test
def semantic_tokens_reflect_the_meaning(case):
    client, source = opened(case)
    found = decoded(client, source.uri, colours(client, source.uri)["data"])
    same(found[source["steps"]][:2], ("STEPS", "macro"), "a macro")
    same(found[source["ray"]][:2], ("Ray", "struct"), "a struct")
    same(found[source["deep"]], ("sqrt", "function", {"defaultLibrary"}), "a built-in")
    same(found[source["total"]][:2], ("total", "variable"), "a local")
    holds("declaration" in found[source["total"]][2], "the declaration", found[source["total"]])
    holds("modification" in found[source["write"]][2], "a write", found[source["write"]])
    at = source.text.index("place) - radius")
    same(found[at][:2], ("place", "parameter"), "a parameter")
    same(found[source.text.index("origin")][:2], ("origin", "property"), "a member")
    holds("readonly" in found[source.text.index("SKY *")][2], "a constant", found[source.text.index("SKY *")])
    same(found[source.text.index("iResolution")][1:], ("variable", {"readonly", "defaultLibrary"}), "a uniform")
    # Code removed by the preprocessor is dimmed.
    same(found[source.text.index("unseen")][:2], ("unseen", "comment"), "the inactive code")


@test
def tokens_of_a_range_are_a_subset(case):
    client, source = opened(case)
    everywhere = decoded(client, source.uri, colours(client, source.uri)["data"])
    start, end = source.text.index("float shape"), source.text.index("    vec2 uv")
    range_ = client.lines(source.uri).range(start, end)
    some = decoded(client, source.uri, client.of(
        source.uri, "textDocument/semanticTokens/range", range=range_)["data"])
    same(some, {at: token for at, token in everywhere.items() if start <= at < end}, "the tokens of two lines")


@test
def token_deltas_update_old_tokens(case):
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
        same(data, full["data"], "the tokens after «%s»" % new)
        number = full["resultId"]
    unchanged = client.of(source.uri, "textDocument/semanticTokens/full/delta", previousResultId=number)
    same(unchanged.get("edits"), [], "an empty delta")
    unknown = client.of(source.uri, "textDocument/semanticTokens/full/delta", previousResultId="nonsense")
    same(unknown.get("data"), full["data"], "the response to an unknown result id")


def hints(client, source):
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/inlayHint", range=lines.range(0, len(lines.text)))
    return {lines.offset(h["position"]): h["label"] for h in found}


@test
def hints_show_parameters_and_iterations(case):
    client, source = opened(case, options={"run": False})
    found = hints(client, source)
    same(found.get(source["arg"]), "place:", "the first argument")
    same(found.get(source["arg2"]), "radius:", "the second argument")
    contains(found.get(source["turns"], ""), "8", "the iterations of the loop")
    same(len(found), 3, "the number of hints")
    # The hints of a range are only those inside it.
    lines = client.lines(source.uri)
    some = client.of(source.uri, "textDocument/inlayHint",
                     range=lines.range(source["arg"] - 5, source["arg"] + 3))
    same([h["label"] for h in some], ["place:"], "the hints of a range")


@test
def hints_show_sampled_counts(case):
    client, source = opened(case)
    client.published(source.uri)
    client.asked_for("workspace/inlayHint/refresh")
    contains(hints(client, source)[source["turns"]], "sampled: 8", "the iterations of the loop")


@test
def hints_follow_the_settings(case):
    client, source = opened(case, options={"run": False, "hints": {"parameters": False, "types": True}})
    found = hints(client, source)
    holds("place:" not in found.values(), "parameter hints although they are off", found)
    holds(any(label.startswith(": vec") for label in found.values()), "no types", found)
    # Changed settings, sent with the notification.
    client.notify("workspace/didChangeConfiguration", {"settings": {"shaderlint": {
        "run": False, "hints": {"parameters": False, "loopIterations": False, "types": False}}}})
    same(hints(client, source), {}, "the hints when all are off")


@test
def invalid_settings_are_reported_and_ignored(case):
    client, source = opened(case, options={"run": False, "hints": {"parameters": "never"}})
    messages = client.wait_until(lambda: client.told("window/showMessage"), "no message")
    contains(messages[0]["message"], "expected a boolean", "the message")
    holds("place:" in hints(client, source).values(), "the wrong settings are used")


@test
def settings_are_requested(case):
    off = {"hints": {"parameters": False, "loopIterations": False}, "run": False, "lenses": False}
    client, source = opened(case, settings={"shaderlint": off})
    client.asked_for("workspace/configuration")
    same(hints(client, source), {}, "the hints, which are off")
    same(client.of(source.uri, "textDocument/codeLens") or [], [], "the lenses, which are off")
    # The client announces a change without its content: the server requests the settings again.
    client.settings = {"shaderlint": {"run": False}}
    client.notify("workspace/didChangeConfiguration", {"settings": None})
    client.asked_for("workspace/configuration", count=2)
    holds(hints(client, source), "the new settings are not used")


@test
def folds_exclude_the_last_line(case):
    client, source = opened(case)
    found = client.of(source.uri, "textDocument/foldingRange")
    lines = SHADER.split("\n")

    def line(part):
        return next(i for i, text in enumerate(lines) if part in text)

    pairs = {(f["startLine"], f["endLine"]): f.get("kind") for f in found}
    same(pairs.get((0, 1)), "comment", "the fold of the comment")
    holds((line("mainImage("), len(lines) - 3) in pairs, "no fold of a body", pairs)
    holds((line("for (int"), line("«write»")) in pairs, "no fold of a loop", pairs)
    holds((line("Ray {"), line("speed;")) in pairs, "no fold of a struct", pairs)
    same(pairs.get((line("#if STEPS"), line("#else") - 1)), "region", "the fold of a group")
    same([f for f in found if "startCharacter" in f or "endCharacter" in f], [], "columns for a client of lines")
    for start, end in pairs:
        for other_start, other_end in pairs:
            crosses = start < other_start <= end < other_end
            holds(not crosses, "folds cross", (start, end), (other_start, other_end))


@test
def folds_can_start_within_a_line(case):
    capabilities = everything()
    capabilities["textDocument"]["foldingRange"]["lineFoldingOnly"] = False
    client, source = opened(case, capabilities=capabilities)
    lines = client.lines(source.uri)
    for fold in client.of(source.uri, "textDocument/foldingRange"):
        start = lines.offset({"line": fold["startLine"], "character": fold["startCharacter"]})
        end = lines.offset({"line": fold["endLine"], "character": fold["endCharacter"]})
        holds(start < end, "an empty fold", fold)


@test
def selection_ranges_grow(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    offsets = [source[name] for name in ("deep", "write", "arg2", "ray")] + [0, len(source.text)]
    found = client.of(source.uri, "textDocument/selectionRange",
                      positions=[lines.position(at) for at in offsets])
    same(len(found), len(offsets), "the answers")
    for at, selection in zip(offsets, found):
        start, end = lines.span(selection["range"])
        holds(start <= at <= end, "the innermost does not hold the place", selection)
        chain = [selection]
        while chain[-1].get("parent"):
            chain.append(chain[-1]["parent"])
        for inner, outer in zip(chain, chain[1:]):
            holds(inside(lines, outer["range"], inner["range"]) and inner["range"] != outer["range"],
                  "a parent that is not larger", inner["range"], outer["range"])
        same(lines.span(chain[-1]["range"]), (0, len(source.text)), "the outermost")
    words = []
    selection = found[0]
    while selection:
        words.append(lines.at(selection["range"]))
        selection = selection.get("parent")
    same(words[0], "sqrt", "the innermost")
    for part in ("sqrt(col * seen)", "vec4(sqrt(col * seen), 1.0)", "fragColor = vec4(sqrt(col * seen), 1.0)"):
        holds(part in words, "«%s» is not among them" % part, words)


@test
def colours_are_shown_and_edited(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/documentColor")
    same([lines.at(c["range"]) for c in found], ["vec3(0.2, 0.4, 0.8)", "vec4(1.0, 0.5, 0.25, 1.0)"], "the colours")
    for name, value in (("red", 0.2), ("green", 0.4), ("blue", 0.8), ("alpha", 1.0)):
        holds(abs(found[0]["color"][name] - value) < 1e-6, "the %s" % name, found[0])
    new = {"red": 1.0, "green": 0.5, "blue": 0.0, "alpha": 1.0}
    for place, written in ((0, "vec3(1.0, 0.5, 0.0)"), (1, "vec4(1.0, 0.5, 0.0, 1.0)")):
        offered = client.of(source.uri, "textDocument/colorPresentation",
                            color=new, range=found[place]["range"])
        holds(offered, "no presentation")
        edit = offered[0].get("textEdit") or {"range": found[place]["range"], "newText": offered[0]["label"]}
        client.apply({"changes": {source.uri: [edit]}})
        contains(client.text(source.uri), written, "the text")
        found = client.of(source.uri, "textDocument/documentColor")
        holds(abs(found[place]["color"]["green"] - 0.5) < 1e-6, "the written colour differs", found)
    same(errors(client.published(source.uri)), [], "the errors")


@test
def lenses_offer_server_commands(case):
    client, source = opened(case)
    lines = client.lines(source.uri)
    found = client.of(source.uri, "textDocument/codeLens")
    titles = [lens["command"]["title"] for lens in found]
    holds(any("Preview" in t for t in titles) and any("operations" in t for t in titles), "other lenses", titles)
    commands = client.initialized["capabilities"]["executeCommandProvider"]["commands"]
    for lens in found:
        contains(lines.at(lens["range"]), "mainImage", "the code below the lens")
        holds(lens["command"]["command"] in [""] + commands, "an unknown command", lens)
    preview = [lens for lens in found if "Preview" in lens["command"]["title"]][0]
    client.request("workspace/executeCommand", preview["command"])
    client.asked_for("window/showDocument")


@test
def a_lens_shows_the_sampled_cost(case):
    client, source = opened(case)
    client.published(source.uri)
    client.asked_for("workspace/codeLens/refresh")
    titles = [lens["command"]["title"] for lens in client.of(source.uri, "textDocument/codeLens")]
    cost = [re.search(r"sample run: (\d+) operations per pixel(?:, at most (\d+) operations)?; loops up to 8 iterations", t) for t in titles]
    cost = [c for c in cost if c]
    holds(len(cost) == 1 and 0 < int(cost[0].group(1)) <= int(cost[0].group(2) or cost[0].group(1)), "the cost", titles)
    holds(not any("estimated" in t for t in titles), "two costs", titles)


@test
def clients_with_views_get_lenses_for_numbers(case):
    client, source = opened(case, options={"previewCommand": "editor.preview"})
    tuned = case.write("b.glsl", "#define GAIN 0.5 // how bright (0~2)\nvoid mainImage(out vec4 c, in vec2 p) "
                       "{ c = vec4(GAIN * p.x / iResolution.x); }\n").open(client)
    found = client.of(tuned.uri, "textDocument/codeLens")
    commands = {lens["command"]["command"]: lens["command"] for lens in found}
    holds("editor.preview" in commands, "its own command is not used", found)
    tune = commands.get("shaderlint.tune")
    holds(tune, "no lens for the number", found)
    same(tune["title"], "Change GAIN: 0 … 2", "its title")
    uri, range_, value, low, high = tune["arguments"]
    same((uri, client.lines(tuned.uri).at(range_), value), (tuned.uri, "0.5", 0.5), "the tuned value")
    same((low, high), (0, 2), "its range")


@test
def invalid_code_keeps_its_structure(case):
    client, source = opened(case)
    client.replace(source.uri, source["write"], source["write"], "total = ((; {")
    for method in ("documentSymbol", "foldingRange", "documentColor", "codeLens", "semanticTokens/full"):
        try:
            client.of(source.uri, "textDocument/" + method)
        except RpcError as error:
            raise AssertionError("a broken text has no %s: %s" % (method, error))
    names = [s["name"] for s in client.of(source.uri, "textDocument/documentSymbol")]
    holds({"Ray", "shape"} <= set(names), "the outline before the error", names)


@test
def selection_ranges_have_limited_depth(case):
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
    holds(depth < 500, "too deep", depth)
    same(client.lines(uri).span(outermost["range"]), (0, len(text)), "the outermost")
