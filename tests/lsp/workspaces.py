"""Files on the disk: what changes there, configurations, folders that come and go, symbols of all."""

import os

from client import CHANGED, CREATED, DELETED, uri_of
from harness import errors, everything, holds, pulling, rules, same, test, without

UNUSED = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float unused = 2.0;
    fragColor = vec4(fragCoord / iResolution.xy, 0.5 + 0.5 * sin(iTime), 1.0);
}
"""
USER = """#include "lib.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, wave(iTime), 1.0);
}
"""


@test
def a_configuration_that_changes_turns_a_rule_off(case):
    client = case.client(options={"run": False})
    source = case.write("a.glsl", UNUSED).open(client)
    same(rules(client.published(source.uri)), ["unused-variable"], "at first")
    config = case.write("shaderlint.toml", '[rules]\nunused-variable = "off"\n')
    client.watched((config.uri, CREATED))
    client.published_when(source.uri, lambda d: d == [], "the new configuration has no effect")
    case.write("shaderlint.toml", '[rules]\nunused-variable = "warning"\n')
    client.watched((config.uri, CHANGED))
    found = client.published_when(source.uri, lambda d: d, "the changed configuration has no effect")
    same(found[0]["severity"], 2, "the severity, as it is configured")
    os.remove(config.path)
    client.watched((config.uri, DELETED))
    client.published_when(source.uri, lambda d: d and d[0]["severity"] == 3, "it has gone without effect")


@test
def a_configuration_leaves_files_out(case):
    case.write("shaderlint.toml", 'exclude = ["third_party"]\n')
    client = case.client(options={"run": False})
    inside = case.write("third_party/a.glsl", UNUSED).open(client)
    outside = case.write("a.glsl", UNUSED).open(client)
    same(client.published(inside.uri), [], "a file that is left out")
    same(rules(client.published(outside.uri)), ["unused-variable"], "another")


@test
def a_wrong_configuration_does_not_stop_it(case):
    case.write("shaderlint.toml", "[rules\nnonsense")
    client = case.client(options={"run": False})
    source = case.write("a.glsl", UNUSED.replace("sin(iTime)", "missing")).open(client)
    same(rules(errors(client.published(source.uri))), ["undeclared-name"], "the errors")


@test
def a_file_that_changes_is_read_again(case):
    client = case.client(options={"run": False})
    source = case.write("a.glsl", USER).open(client)
    library = case.write("lib.glsl", "float wave(float x) { return sin(x); }\n")
    client.watched((library.uri, CREATED))
    client.published_when(source.uri, lambda d: not errors(d), "a new file is not read")
    case.write("lib.glsl", "float ripple(float x) { return sin(x); } // longer\n")
    client.watched((library.uri, CHANGED))
    found = client.published_when(source.uri, lambda d: errors(d), "a changed file is not read")
    same([client.lines(source.uri).at(d["range"]) for d in errors(found)], ["wave"], "the error")
    case.write("lib.glsl", "float wave(float x) { return cos(x); }\n")
    client.watched((library.uri, CHANGED))
    client.published_when(source.uri, lambda d: not errors(d), "a mended file is not read")


@test
def a_file_that_goes_is_missed(case):
    client = case.client(options={"run": False})
    library = case.write("lib.glsl", "float wave(float x) { return undeclared; }\n")
    source = case.write("a.glsl", USER).open(client)
    holds(errors(client.published(source.uri)), "no error of the file")
    os.remove(library.path)
    client.watched((library.uri, DELETED))
    # What is not found is taken for the bundler's.
    client.published_when(source.uri, lambda d: not errors(d), "a file that is gone is still read")


@test
def the_disk_does_not_replace_an_open_text(case):
    client = case.client(options={"run": False})
    library = case.write("lib.glsl", "float wave(float x) { return sin(x); }\n").open(client)
    source = case.write("a.glsl", USER).open(client)
    same(errors(client.published(source.uri)), [], "at first")
    case.write("lib.glsl", "float gone(float x) { return sin(x); }\n")
    client.watched((library.uri, CHANGED))
    client.replace(source.uri, 0, 0, "\n")
    same(errors(client.published(source.uri)), [], "with the text that is open")


def found(client, query):
    return sorted(s["name"] for s in client.request("workspace/symbol", {"query": query}))


@test
def symbols_of_all_files_are_found(case):
    client = case.client()
    case.write("a.glsl", "float waveHeight(float x) { return x; }\nstruct Wave { float height; };\n")
    case.write("inner/b.frag", "#version 300 es\nprecision highp float;\nout vec4 c;\n"
                               "void main() { c = vec4(1.0); }\n")
    open_one = case.write("c.glsl", "float oldName(float x) { return x; }\n").open(client)
    client.replace(open_one.uri, 6, 13, "newWave")
    same(found(client, "wave"), ["Wave", "newWave", "waveHeight"], "what is like wave")
    same(found(client, "wvh"), ["waveHeight"], "what has the letters")
    same(found(client, "oldName"), [], "what is only on the disk")
    everything_ = found(client, "")
    holds({"Wave", "main", "waveHeight", "newWave"} <= set(everything_), "all of them", everything_)
    for symbol in client.request("workspace/symbol", {"query": "waveHeight"}):
        place = symbol["location"]
        same(client.lines(place["uri"]).at(place["range"]), "waveHeight", "its place")


@test
def folders_come_and_go(case):
    first, second = (os.path.join(case.folder, name) for name in ("first", "second"))
    case.write("first/a.glsl", "float one(float x) { return x; }\n")
    case.write("second/b.glsl", "float two(float x) { return x; }\n")
    client = case.client(folders=[first])
    same(found(client, ""), ["one"], "of the first folder")
    folder = {"uri": uri_of(second), "name": "second"}
    client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [folder], "removed": []}})
    same(found(client, ""), ["one", "two"], "of both folders")
    folder = {"uri": uri_of(first), "name": "first"}
    client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [], "removed": [folder]}})
    same(found(client, ""), ["two"], "of the second folder")
    # Added twice, its files are there once.
    folder = {"uri": uri_of(second), "name": "second"}
    client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [folder], "removed": []}})
    same(found(client, ""), ["two"], "of a folder that was added twice")


@test
def without_a_folder_there_are_only_open_texts(case):
    case.write("a.glsl", "float one(float x) { return x; }\n")
    client = case.client(folder=None)
    same(found(client, ""), [], "without an open text")
    other = case.write("b.glsl", "float two(float x) { return x; }\n").open(client)
    same(found(client, ""), ["two"], "with one")
    same(errors(client.published(other.uri)), [], "the errors")


@test
def names_of_files_may_be_any(case):
    client = case.client(capabilities=without(everything(), "workspace", "configuration"))
    name = "a b#c%20ü+[1]&é.glsl"
    source = case.write(name, UNUSED.replace("sin(iTime)", "missing")).open(client)
    same(rules(errors(client.published(source.uri))), ["undeclared-name"], "the errors")
    # Another spelling of the same address, as some editors have it.
    other = source.uri.replace("+", "%2B").replace("&", "%26")
    same(client.request("textDocument/documentSymbol", {"textDocument": {"uri": other}})[0]["name"],
         "mainImage", "the outline under another spelling")


@test
def a_file_is_found_by_who_pulls_after_it_was_written(case):
    client = case.client(capabilities=pulling(), settings={"shaderlint": {"run": False}})
    same(client.request("workspace/diagnostic", {"previousResultIds": []})["items"], [], "an empty folder")
    source = case.write("a.glsl", UNUSED)
    client.watched((source.uri, CREATED))
    items = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
    same([i["uri"] for i in items], [source.uri], "the files")
    case.write("a.glsl", UNUSED.replace("unused", "used").replace("sin(iTime)", "used"))
    client.watched((source.uri, CHANGED))
    items = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
    same(items[0]["items"], [], "the findings of the mended file")
