"""Diagnostics: pushed, pulled, for the workspace, and their related information."""

import os

from client import everything, path_of
from harness import by_rule, errors, pulling, rules, without

UNUSED = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float «var»unused = 2.0;
    fragColor = vec4(fragCoord / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);
}
"""
MACRO = """#define STEPS 64«bad»;
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float t = 0.0;
    for (int i = 0; i < «use»STEPS; i++) { t += 0.01; }
    fragColor = vec4(t * fragCoord / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);
}
"""
BLACK = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float d = length(uv) - 9.0;
    fragColor = vec4(vec3(max(d, 0.0)), 1.0);
}
"""


def test_diagnostics_have_a_version(case):
    client = case.client()
    source = case.write("a.glsl", UNUSED).open(client)
    found = by_rule(client.published(source.uri), "unused-variable")
    assert client.lines(source.uri).span(found["range"]) == (source["var"], source["var"] + 6), "where"
    assert found["source"] == "shaderlint", "the source"
    assert found["tags"] == [1], "the tags, of which 1 is unnecessary"
    assert found["severity"] in (2, 4), f"valid code has an error: {found}"
    for number in range(5):
        client.replace(source.uri, 0, 0, "// %d\n" % number)
    client.published(source.uri, 6)
    versions = [p["version"] for p in client.told("textDocument/publishDiagnostics")]
    assert versions == sorted(versions), "the versions, in the order of publication"


def test_diagnostics_have_related_information(case):
    client = case.client()
    source = case.write("a.glsl", MACRO).open(client)
    found = by_rule(client.published(source.uri), "faulty-macro")
    assert client.lines(source.uri).span(found["range"]) == (source["bad"], source["bad"] + 1), "where"
    assert found["severity"] == 1, "the severity"
    related = [client.lines(r["location"]["uri"]).span(r["location"]["range"])
               for r in found["relatedInformation"]]
    assert (source["use"], source["use"] + 5) in related, f"its use is not among the related locations: {found}"
    assert "note: preprocessor directives do not end with `;`" in found["message"], "the message"


def test_clients_without_related_information_get_none(case):
    capabilities = without(everything(), "textDocument", "publishDiagnostics", "relatedInformation")
    client = case.client(capabilities=capabilities)
    source = case.write("a.glsl", MACRO).open(client)
    found = by_rule(client.published(source.uri), "faulty-macro")
    assert "relatedInformation" not in found, f"unrequested related information: {found}"


def test_rule_pages_are_deleted_when_the_server_exits(case):
    client = case.client()
    first = case.write("a.glsl", MACRO).open(client)
    second = case.write("b.glsl", UNUSED).open(client)
    found = client.published(first.uri) + client.published(second.uri)
    assert len(found) >= 2, f"too few findings: {found}"
    paths = []
    for diagnostic in found:
        path = path_of(diagnostic["codeDescription"]["href"])
        with open(path, encoding="utf-8") as file:
            assert diagnostic["code"] in file.read(), "the page of %s" % diagnostic["code"]
        paths.append(path)
    client.stop()
    assert [p for p in paths if os.path.exists(p)] == [], "the remaining pages"
    assert os.listdir(case.temp) == [], "the remaining files of the server"


def test_diagnostics_from_sampling_arrive_later(case):
    client = case.client()
    source = case.write("a.glsl", BLACK).open(client)
    quick = client.published(source.uri)
    assert errors(quick) == [], "errors"
    found = client.published_when(source.uri, lambda d: "dark-frame" in rules(d),
                                  "the dark frame is not reported")
    # While another place is edited, the finding stays at the same code.
    where = client.lines(source.uri).at(by_rule(found, "dark-frame")["range"])
    client.replace(source.uri, 0, 0, "// é𝄞\n\n")
    moved = by_rule(client.published(source.uri), "dark-frame")
    assert client.lines(source.uri).at(moved["range"]) == where, "the code of the finding"


def test_sampling_can_be_turned_off(case):
    client = case.client(options={"run": False})
    source = case.write("a.glsl", BLACK).open(client)
    client.published(source.uri)
    # A server that was started later has sampled the same text.
    other = case.client()
    source.open(other)
    other.published_when(source.uri, lambda d: "dark-frame" in rules(d), "diagnostics without sampling")
    client.settle()
    found = client.told("textDocument/publishDiagnostics")
    assert not any("dark-frame" in rules(p["diagnostics"]) for p in found)


def test_pulled_diagnostics_can_be_unchanged(case):
    client = case.client(capabilities=pulling(), settings={"shaderlint": {"run": False}})
    source = case.write("a.glsl", UNUSED).open(client)
    full = client.of(source.uri, "textDocument/diagnostic")
    assert full["kind"] == "full", "the first answer"
    by_rule(full["items"], "unused-variable")
    again = client.of(source.uri, "textDocument/diagnostic", previousResultId=full["resultId"])
    assert (again["kind"], again["resultId"]) == ("unchanged", full["resultId"]), "the second answer"
    assert "items" not in again, f"unchanged findings have no items: {again}"
    # A change that moves a diagnostic changes the result, even if its message stays the same.
    client.replace(source.uri, 0, 0, "\n")
    moved = client.of(source.uri, "textDocument/diagnostic", previousResultId=full["resultId"])
    assert moved["kind"] == "full", "the answer after a change"
    start = client.lines(source.uri).span(by_rule(moved["items"], "unused-variable")["range"])[0]
    assert start == source["var"] + 1, "its new position"
    assert client.told("textDocument/publishDiagnostics") == [], "diagnostics pushed to a pulling client"


def test_sampling_requests_a_diagnostic_refresh(case):
    client = case.client(capabilities=pulling())
    source = case.write("a.glsl", BLACK).open(client)
    client.asked_for("workspace/diagnostic/refresh")
    found = client.of(source.uri, "textDocument/diagnostic")["items"]
    by_rule(found, "dark-frame")


def test_workspace_diagnostics_include_closed_files(case):
    client = case.client(capabilities=pulling(), settings={"shaderlint": {"run": False}})
    case.write("one.glsl", UNUSED)
    case.write("inner/two.frag", "#version 300 es\nprecision highp float;\nout vec4 c;\n"
                                 "void main() { c = vec4(missing); }\n")
    case.write("notes.txt", "no shader\n")
    case.write("node_modules/x/bad.glsl", MACRO)
    third = case.write("three.glsl", "no shader yet\n")
    client.open(third.uri, UNUSED.replace("«var»", ""))
    # An open text without a file belongs to the workspace, too.
    client.open(case.uri("four.glsl"), MACRO.replace("«bad»", "").replace("«use»", ""))
    report = client.request("workspace/diagnostic", {"previousResultIds": []})
    found = {item["uri"]: item for item in report["items"]}
    assert sorted(os.path.basename(u) for u in found) == ["four.glsl", "one.glsl", "three.glsl", "two.frag"]
    by_rule(found[case.uri("one.glsl")]["items"], "unused-variable")
    assert rules(errors(found[case.uri("inner/two.frag")]["items"])) == ["undeclared-name"], "two.frag"
    by_rule(found[third.uri]["items"], "unused-variable")
    assert found[third.uri]["version"] == 1, "the version of the open text"
    assert found[case.uri("one.glsl")].get("version") is None, "the version of the closed text"
    previous = [{"uri": u, "value": i["resultId"]} for u, i in found.items()]
    client.replace(third.uri, 0, 0, "\n")
    again = client.request("workspace/diagnostic", {"previousResultIds": previous})
    kinds = {os.path.basename(i["uri"]): i["kind"] for i in again["items"]}
    assert kinds == {
        "four.glsl": "unchanged", "one.glsl": "unchanged", "two.frag": "unchanged", "three.glsl": "full",
    }, "the changed documents"


def test_includes_are_read_from_open_texts(case):
    client = case.client(capabilities=everything())
    library = case.write("lib.glsl", "float «fn»wave(float x) { return sin(x); }\n")
    source = case.write("a.glsl", """#include "lib.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, «use»wave(iTime), 1.0);
}
""").open(client)
    assert errors(client.published(source.uri)) == [], "with the file on the disk"
    library.open(client)
    client.replace(library.uri, library["fn"], library["fn"] + 4, "ripple")
    # Nothing is written to disk, and the including text does not change.
    found = client.published_when(source.uri, lambda d: errors(d))
    assert [client.lines(source.uri).at(d["range"]) for d in errors(found)] == ["wave"], "the error"
    client.close(library.uri)
    client.published_when(source.uri, lambda d: not errors(d), "the file on disk was changed")


def test_errors_of_included_files_are_reported_at_the_directive(case):
    client = case.client()
    case.write("lib.glsl", "float wave(float x) { return missing; }\n")
    source = case.write("a.glsl", """«line»#include "lib.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, wave(iTime), 1.0);
}
""").open(client)
    found = by_rule(client.published(source.uri), "undeclared-name")
    assert client.lines(source.uri).at(found["range"]) == '#include "lib.glsl"', "the position of the error"
    place = found["relatedInformation"][0]["location"]
    assert (place["uri"], client.lines(place["uri"]).at(place["range"])) == (case.uri("lib.glsl"), "missing")


def test_vertex_and_fragment_shaders_are_linked(case):
    client = case.client()
    head = "#version 300 es\nprecision highp float;\n"
    vertex = case.write("a.vert", head + "in vec4 position;\nout vec2 «v»vUv;\n"
                        "void main() { vUv = position.xy; gl_Position = position; }\n").open(client)
    fragment = case.write("a.frag", head + "in vec2 vUv;\nout vec4 color;\n"
                          "void main() { color = vec4(vUv, 0.0, 1.0); }\n").open(client)
    assert errors(client.published(vertex.uri)) == [], "the vertex shader"
    assert errors(client.published(fragment.uri)) == [], "the fragment shader"
    client.write_all(vertex.uri, vertex.text.replace("vUv", "vPlace"))
    found = client.published_when(fragment.uri, lambda d: errors(d),
                                  "the missing output is not reported in the fragment shader")
    assert errors(found), "the link error"


def test_a_directive_without_a_name_has_a_position(case):
    client = case.client()
    source = case.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(p, 1.0, 1.0);\n"
                                  "    «hash»#    }\n").open(client)
    found = by_rule(client.published(source.uri), "bad-directive")
    assert client.lines(source.uri).span(found["range"])[0] == source["hash"], "the start position"
