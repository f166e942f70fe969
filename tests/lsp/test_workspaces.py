"""Files on disk: changes, configurations, added and removed folders, workspace symbols."""

import os

from client import CHANGED, CREATED, DELETED, changes_of, everything, path_of, uri_of
from harness import errors, pulling, rules, without
from text import Lines, apply_edits

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


def test_configuration_changes_are_applied(case):
    client = case.client(options={"run": False})
    source = case.write("a.glsl", UNUSED).open(client)
    assert rules(client.published(source.uri)) == ["unused-variable"], "before the configuration"
    config = case.write("shaderlint.toml", '[rules]\nunused-variable = "off"\n')
    client.watched((config.uri, CREATED))
    client.published_when(source.uri, lambda d: d == [], "the new configuration has no effect")
    case.write("shaderlint.toml", '[rules]\nunused-variable = "warning"\n')
    client.watched((config.uri, CHANGED))
    found = client.published_when(source.uri, lambda d: d, "the changed configuration has no effect")
    assert found[0]["severity"] == 2, "the configured severity"
    os.remove(config.path)
    client.watched((config.uri, DELETED))
    client.published_when(source.uri, lambda d: d and d[0]["severity"] == 4, "removing the configuration has no effect")


def test_configurations_can_exclude_files(case):
    case.write("shaderlint.toml", 'exclude = ["third_party"]\n')
    client = case.client(options={"run": False})
    inside = case.write("third_party/a.glsl", UNUSED).open(client)
    outside = case.write("a.glsl", UNUSED).open(client)
    assert client.published(inside.uri) == [], "an excluded file"
    assert rules(client.published(outside.uri)) == ["unused-variable"], "another"


def test_an_invalid_configuration_does_not_stop_the_server(case):
    case.write("shaderlint.toml", "[rules\nnonsense")
    client = case.client(options={"run": False})
    source = case.write("a.glsl", UNUSED.replace("sin(iTime)", "missing")).open(client)
    assert rules(errors(client.published(source.uri))) == ["undeclared-name"], "the errors"


def test_changed_files_are_read_again(case):
    client = case.client(options={"run": False})
    source = case.write("a.glsl", USER).open(client)
    library = case.write("lib.glsl", "float wave(float x) { return sin(x); }\n")
    client.watched((library.uri, CREATED))
    client.published_when(source.uri, lambda d: not errors(d), "a new file is not read")
    case.write("lib.glsl", "float ripple(float x) { return sin(x); } // longer\n")
    client.watched((library.uri, CHANGED))
    found = client.published_when(source.uri, lambda d: errors(d), "a changed file is not read")
    assert [client.lines(source.uri).at(d["range"]) for d in errors(found)] == ["wave"], "the error"
    case.write("lib.glsl", "float wave(float x) { return cos(x); }\n")
    client.watched((library.uri, CHANGED))
    client.published_when(source.uri, lambda d: not errors(d), "a fixed file is not read")


def test_deleted_files_are_noticed(case):
    client = case.client(options={"run": False})
    library = case.write("lib.glsl", "float wave(float x) { return undeclared; }\n")
    source = case.write("a.glsl", USER).open(client)
    assert errors(client.published(source.uri)), "no error of the file"
    os.remove(library.path)
    client.watched((library.uri, DELETED))
    # A missing include is assumed to be resolved by the bundler.
    client.published_when(source.uri, lambda d: not errors(d), "a deleted file is still read")


def test_files_do_not_replace_open_texts(case):
    client = case.client(options={"run": False})
    library = case.write("lib.glsl", "float wave(float x) { return sin(x); }\n").open(client)
    source = case.write("a.glsl", USER).open(client)
    assert errors(client.published(source.uri)) == [], "at first"
    case.write("lib.glsl", "float gone(float x) { return sin(x); }\n")
    client.watched((library.uri, CHANGED))
    client.replace(source.uri, 0, 0, "\n")
    assert errors(client.published(source.uri)) == [], "with the text that is open"


def found(client, query):
    return sorted(s["name"] for s in client.request("workspace/symbol", {"query": query}))


def test_workspace_symbols_cover_all_files(case):
    client = case.client()
    case.write("a.glsl", "float waveHeight(float x) { return x; }\nstruct Wave { float height; };\n")
    case.write("inner/b.frag", "#version 300 es\nprecision highp float;\nout vec4 c;\n"
                               "void main() { c = vec4(1.0); }\n")
    open_one = case.write("c.glsl", "float oldName(float x) { return x; }\n").open(client)
    client.replace(open_one.uri, 6, 13, "newWave")
    assert found(client, "wave") == ["Wave", "newWave", "waveHeight"], "symbols similar to wave"
    assert found(client, "wvh") == ["waveHeight"], "symbols with the letters"
    assert found(client, "oldName") == [], "symbols of files that are not open"
    everything_ = found(client, "")
    assert {"Wave", "main", "waveHeight", "newWave"} <= set(everything_), f"all symbols: {everything_}"
    for symbol in client.request("workspace/symbol", {"query": "waveHeight"}):
        place = symbol["location"]
        assert client.lines(place["uri"]).at(place["range"]) == "waveHeight", "its location"


def test_folders_can_be_added_and_removed(case):
    first, second = (os.path.join(case.folder, name) for name in ("first", "second"))
    case.write("first/a.glsl", "float one(float x) { return x; }\n")
    case.write("second/b.glsl", "float two(float x) { return x; }\n")
    client = case.client(folders=[first])
    assert found(client, "") == ["one"], "of the first folder"
    folder = {"uri": uri_of(second), "name": "second"}
    client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [folder], "removed": []}})
    assert found(client, "") == ["one", "two"], "of both folders"
    folder = {"uri": uri_of(first), "name": "first"}
    client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [], "removed": [folder]}})
    assert found(client, "") == ["two"], "of the second folder"
    # Files of a folder that was added twice are listed once.
    folder = {"uri": uri_of(second), "name": "second"}
    client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [folder], "removed": []}})
    assert found(client, "") == ["two"], "of a folder that was added twice"


def test_clients_without_a_folder_get_symbols_of_open_texts(case):
    case.write("a.glsl", "float one(float x) { return x; }\n")
    client = case.client(folder=None)
    assert found(client, "") == [], "without an open text"
    other = case.write("b.glsl", "float two(float x) { return x; }\n").open(client)
    assert found(client, "") == ["two"], "with one"
    assert errors(client.published(other.uri)) == [], "the errors"


def test_file_names_may_contain_any_characters(case):
    client = case.client(capabilities=without(everything(), "workspace", "configuration"))
    name = "a b#c%20ü+[1]&é.glsl"
    source = case.write(name, UNUSED.replace("sin(iTime)", "missing")).open(client)
    assert rules(errors(client.published(source.uri))) == ["undeclared-name"], "the errors"
    # Another spelling of the same URI, as some editors send it.
    other = source.uri.replace("+", "%2B").replace("&", "%26")
    assert client.request("textDocument/documentSymbol", {"textDocument": {"uri": other}})[0]["name"] == "mainImage"


def test_pulled_diagnostics_include_new_files(case):
    client = case.client(capabilities=pulling(), settings={"shaderlint": {"run": False}})
    assert client.request("workspace/diagnostic", {"previousResultIds": []})["items"] == [], "an empty folder"
    source = case.write("a.glsl", UNUSED)
    client.watched((source.uri, CREATED))
    items = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
    assert [i["uri"] for i in items] == [source.uri], "the files"
    case.write("a.glsl", UNUSED.replace("unused", "used").replace("sin(iTime)", "used"))
    client.watched((source.uri, CHANGED))
    items = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
    assert items[0]["items"] == [], "the diagnostics of the fixed file"


def test_moving_a_file_updates_its_include_paths(case):
    client = case.client()
    main = "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x)); }\n"
    library = case.write("lib/wave.glsl", '#include "./base.glsl"\n#include "more"\nfloat wave(float x) '
                         "{ return base(x) + more(x); }\n")
    base = case.write("lib/base.glsl", "float base(float x) { return x; }\n")
    case.write("lib/more.glsl", "float more(float x) { return x; }\n")
    user = case.write("a.glsl", '#include "lib/wave.glsl"\n' + main).open(client)
    module = case.write("b.glsl", "#pragma glslify: wave = require(./lib/wave)\n" + main)
    script = case.write("scene.js", "import a from './a.glsl?raw';\nconst f = `#include \"lib/wave.glsl\"\n%s`;\n" % main)

    def moved(*pairs):
        files = [{"oldUri": case.uri(old), "newUri": case.uri(new)} for old, new in pairs]
        edit = client.request("workspace/willRenameFiles", {"files": files})
        texts = {}
        for uri, edits in changes_of(edit or {}):
            with open(path_of(uri), encoding="utf-8") as file:
                texts[uri] = apply_edits(file.read(), edits, client.encoding)
        return texts

    assert moved(("lib/wave.glsl", "noise/ripple.glsl")) == {
        library.uri: library.text.replace("./base", "../lib/base").replace("more\"", "../lib/more\""),
        user.uri: user.text.replace("lib/wave", "noise/ripple"),
        module.uri: module.text.replace("./lib/wave", "./noise/ripple"),
        script.uri: script.text.replace("lib/wave", "noise/ripple"),
    }, "the texts after moving a file"
    assert moved(("lib", "shared/lib")) == {
        user.uri: user.text.replace("lib/wave", "shared/lib/wave"),
        module.uri: module.text.replace("./lib/wave", "./shared/lib/wave"),
        script.uri: script.text.replace("lib/wave", "shared/lib/wave"),
    }, "the texts after moving a folder"
    assert moved(("a.glsl", "in/b.frag")) == {
        user.uri: user.text.replace("lib/wave", "../lib/wave"),
        script.uri: script.text.replace("./a.glsl?raw", "./in/b.frag?raw"),
    }, "the texts after moving a user"
    assert moved(("other.txt", "other2.txt")) == {}, "the texts after moving another file"
    assert base.uri not in moved(("lib/base.glsl", "lib/basis.glsl")), f"the moved file changes: {base.uri}"


def shown_messages(client):
    client.settle()
    return [n["message"] for n in client.told("window/showMessage")]


def test_an_invalid_configuration_is_reported_and_the_last_valid_one_used(case):
    client = case.client(options={"run": False})
    valid = '[rules]\nunused-variable = "off"\n'
    config = case.write("shaderlint.toml", valid)
    source = case.write("a.glsl", UNUSED).open(client)
    assert client.published(source.uri) == [], "with a valid configuration"
    text = '[rules]\nunused-variable = "off"\nunused-variabel = "off"\n'
    case.write("shaderlint.toml", text)
    client.watched((config.uri, CHANGED))
    found = client.published_when(config.uri, lambda d: d, "the configuration has no finding")
    lines = Lines(text, client.encoding)
    assert lines.at(found[0]["range"]).startswith("unused-variabel"), f"the range: {found}"
    assert "unused-variable" in found[0]["message"], f"the message: {found}"
    assert len(shown_messages(client)) == 1, "the messages"
    assert "shaderlint.toml:3: " in shown_messages(client)[0], ("the message", shown_messages(client))
    # Another file, and a change of the first one, still use the valid configuration.
    other = case.write("b.glsl", UNUSED).open(client)
    assert client.published(other.uri) == [], "with an invalid configuration"
    client.write_all(source.uri, source.text + "// more\n")
    client.settle()
    assert client.published(source.uri) == [], "with an invalid configuration"
    assert len(shown_messages(client)) == 1, "the messages"
    case.write("shaderlint.toml", "")
    client.watched((config.uri, CHANGED))
    client.published_when(config.uri, lambda d: not d, "the finding stays")
    found = client.published_when(source.uri, lambda d: d, "the new configuration has no effect")
    assert rules(found) == ["unused-variable"], "the findings"
