"""Findings: pushed, pulled, of the workspace, and what is told with them."""

import os

from client import path_of
from harness import (
    by_rule, contains, errors, everything, holds, pulling, rules, same, test, without,
)

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


@test
def findings_are_told_with_their_version(case):
    client = case.client()
    source = case.write("a.glsl", UNUSED).open(client)
    found = by_rule(client.published(source.uri), "unused-variable")
    same(client.lines(source.uri).span(found["range"]), (source["var"], source["var"] + 6), "where")
    same(found["source"], "shaderlint", "the source")
    same(found["tags"], [1], "the tags, of which 1 is unnecessary")
    holds(found["severity"] in (2, 3), "something that compiles is no error", found)
    for number in range(5):
        client.replace(source.uri, 0, 0, "// %d\n" % number)
    client.published(source.uri, 6)
    versions = [p["version"] for p in client.told("textDocument/publishDiagnostics")]
    same(versions, sorted(versions), "the versions, in the order in which they were told")


@test
def a_finding_says_which_places_belong_to_it(case):
    client = case.client()
    source = case.write("a.glsl", MACRO).open(client)
    found = by_rule(client.published(source.uri), "faulty-macro")
    same(client.lines(source.uri).span(found["range"]), (source["bad"], source["bad"] + 1), "where")
    same(found["severity"], 1, "the severity")
    related = [client.lines(r["location"]["uri"]).span(r["location"]["range"])
               for r in found["relatedInformation"]]
    holds((source["use"], source["use"] + 5) in related, "its use is not among the places", found)
    contains(found["message"], "note: a directive ends with its line", "the message")


@test
def a_client_without_related_places_gets_none(case):
    capabilities = without(everything(), "textDocument", "publishDiagnostics", "relatedInformation")
    client = case.client(capabilities=capabilities)
    source = case.write("a.glsl", MACRO).open(client)
    found = by_rule(client.published(source.uri), "faulty-macro")
    holds("relatedInformation" not in found, "nobody asked for this", found)


@test
def pages_of_rules_are_there_as_long_as_the_server(case):
    client = case.client()
    first = case.write("a.glsl", MACRO).open(client)
    second = case.write("b.glsl", UNUSED).open(client)
    found = client.published(first.uri) + client.published(second.uri)
    holds(len(found) >= 2, "too few findings", found)
    paths = []
    for diagnostic in found:
        path = path_of(diagnostic["codeDescription"]["href"])
        with open(path, encoding="utf-8") as file:
            contains(file.read(), diagnostic["code"], "the page of %s" % diagnostic["code"])
        paths.append(path)
    client.stop()
    same([p for p in paths if os.path.exists(p)], [], "the pages that are left")
    same(os.listdir(case.temp()), [], "what is left of the server")


@test
def what_only_a_run_shows_comes_after_a_pause(case):
    client = case.client()
    source = case.write("a.glsl", BLACK).open(client)
    quick = client.published(source.uri)
    same(errors(quick), [], "errors")
    found = client.published_when(source.uri, lambda d: "dark-frame" in rules(d),
                                  "nobody says that the picture is black")
    # While somebody types elsewhere it stays, at the same words.
    where = client.lines(source.uri).at(by_rule(found, "dark-frame")["range"])
    client.replace(source.uri, 0, 0, "// é𝄞\n\n")
    moved = by_rule(client.published(source.uri), "dark-frame")
    same(client.lines(source.uri).at(moved["range"]), where, "what it is about")


@test
def runs_can_be_turned_off(case):
    client = case.client(options={"run": False})
    source = case.write("a.glsl", BLACK).open(client)
    client.published(source.uri)
    # A server that was started later has run the same text.
    other = case.client()
    source.open(other)
    other.published_when(source.uri, lambda d: "dark-frame" in rules(d), "it is not run")
    client.settle()
    found = client.told("textDocument/publishDiagnostics")
    holds(not any("dark-frame" in rules(p["diagnostics"]) for p in found), "it was run", found)


@test
def findings_are_pulled_and_unchanged_while_they_are(case):
    client = case.client(capabilities=pulling(), settings={"shaderlint": {"run": False}})
    source = case.write("a.glsl", UNUSED).open(client)
    full = client.of(source.uri, "textDocument/diagnostic")
    same(full["kind"], "full", "the first answer")
    by_rule(full["items"], "unused-variable")
    again = client.of(source.uri, "textDocument/diagnostic", previousResultId=full["resultId"])
    same((again["kind"], again["resultId"]), ("unchanged", full["resultId"]), "the second answer")
    holds("items" not in again, "unchanged findings have no items", again)
    # A change that moves a finding is one, even where its words are the same.
    client.replace(source.uri, 0, 0, "\n")
    moved = client.of(source.uri, "textDocument/diagnostic", previousResultId=full["resultId"])
    same(moved["kind"], "full", "the answer after a change")
    start = client.lines(source.uri).span(by_rule(moved["items"], "unused-variable")["range"])[0]
    same(start, source["var"] + 1, "where it is now")
    same(client.told("textDocument/publishDiagnostics"), [], "what is pushed to one who pulls")


@test
def who_pulls_is_told_when_a_run_has_shown_more(case):
    client = case.client(capabilities=pulling())
    source = case.write("a.glsl", BLACK).open(client)
    client.asked_for("workspace/diagnostic/refresh")
    found = client.of(source.uri, "textDocument/diagnostic")["items"]
    by_rule(found, "dark-frame")


@test
def the_workspace_is_judged_open_or_not(case):
    client = case.client(capabilities=pulling(), settings={"shaderlint": {"run": False}})
    case.write("one.glsl", UNUSED)
    case.write("inner/two.frag", "#version 300 es\nprecision highp float;\nout vec4 c;\n"
                                 "void main() { c = vec4(missing); }\n")
    case.write("notes.txt", "no shader\n")
    case.write("node_modules/x/bad.glsl", MACRO)
    third = case.write("three.glsl", "no shader yet\n")
    client.open(third.uri, UNUSED.replace("«var»", ""))
    # A text that is open and on no disk belongs to the workspace, too.
    client.open(case.uri("four.glsl"), MACRO.replace("«bad»", "").replace("«use»", ""))
    report = client.request("workspace/diagnostic", {"previousResultIds": []})
    found = {item["uri"]: item for item in report["items"]}
    same(sorted(os.path.basename(u) for u in found),
         ["four.glsl", "one.glsl", "three.glsl", "two.frag"], "the files")
    by_rule(found[case.uri("one.glsl")]["items"], "unused-variable")
    same(rules(errors(found[case.uri("inner/two.frag")]["items"])), ["undeclared-name"], "two.frag")
    by_rule(found[third.uri]["items"], "unused-variable")
    same(found[third.uri]["version"], 1, "the version of what is open")
    same(found[case.uri("one.glsl")].get("version"), None, "the version of what is not")
    previous = [{"uri": u, "value": i["resultId"]} for u, i in found.items()]
    client.replace(third.uri, 0, 0, "\n")
    again = client.request("workspace/diagnostic", {"previousResultIds": previous})
    kinds = {os.path.basename(i["uri"]): i["kind"] for i in again["items"]}
    same(kinds, {"four.glsl": "unchanged", "one.glsl": "unchanged", "two.frag": "unchanged",
                 "three.glsl": "full"}, "what has changed")


@test
def an_include_is_read_from_the_buffer(case):
    client = case.client(capabilities=everything())
    library = case.write("lib.glsl", "float «fn»wave(float x) { return sin(x); }\n")
    source = case.write("a.glsl", """#include "lib.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, «use»wave(iTime), 1.0);
}
""").open(client)
    same(errors(client.published(source.uri)), [], "with the file on the disk")
    library.open(client)
    client.replace(library.uri, library["fn"], library["fn"] + 4, "ripple")
    # Nothing is written to the disk, and nothing changes in the text that includes.
    found = client.published_when(source.uri, lambda d: errors(d))
    same([client.lines(source.uri).at(d["range"]) for d in errors(found)], ["wave"], "the error")
    client.close(library.uri)
    client.published_when(source.uri, lambda d: not errors(d), "the disk has the old text")


@test
def errors_of_an_included_file_stand_at_the_directive(case):
    client = case.client()
    case.write("lib.glsl", "float wave(float x) { return missing; }\n")
    source = case.write("a.glsl", """«line»#include "lib.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, wave(iTime), 1.0);
}
""").open(client)
    found = by_rule(client.published(source.uri), "undeclared-name")
    same(client.lines(source.uri).at(found["range"]), '#include "lib.glsl"', "where it is told")
    place = found["relatedInformation"][0]["location"]
    same((place["uri"], client.lines(place["uri"]).at(place["range"])),
         (case.uri("lib.glsl"), "missing"), "where it is")


@test
def a_shader_and_its_partner_are_linked(case):
    client = case.client()
    head = "#version 300 es\nprecision highp float;\n"
    vertex = case.write("a.vert", head + "in vec4 position;\nout vec2 «v»vUv;\n"
                        "void main() { vUv = position.xy; gl_Position = position; }\n").open(client)
    fragment = case.write("a.frag", head + "in vec2 vUv;\nout vec4 color;\n"
                          "void main() { color = vec4(vUv, 0.0, 1.0); }\n").open(client)
    same(errors(client.published(vertex.uri)), [], "the vertex shader")
    same(errors(client.published(fragment.uri)), [], "the fragment shader")
    client.write_all(vertex.uri, vertex.text.replace("vUv", "vPlace"))
    found = client.published_when(fragment.uri, lambda d: errors(d),
                                  "the fragment shader reads what nobody gives, and nobody says so")
    holds(errors(found), "it reads what nobody gives")


@test
def a_directive_without_a_name_has_a_place(case):
    client = case.client()
    source = case.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(p, 1.0, 1.0);\n"
                                  "    «hash»#    }\n").open(client)
    found = by_rule(client.published(source.uri), "bad-directive")
    same(client.lines(source.uri).span(found["range"])[0], source["hash"], "where it starts")
