"""Definitions, references, highlights and call hierarchies across files."""

import re

from harness import errors, pulling

LIBRARY = """struct «struct»Ray { vec3 «member»origin; vec3 direction; };
float «proto»shape(vec3 p);
float «def»shape(vec3 p) { return length(p) - 1.0; }
"""
MAIN = """#include "«path»lib.glsl"
#define «macro»FAR 20.0
float march(Ray «param»ray) {
    float «local»t = 0.0;
    for (int i = 0; i < 32; i++) {
        «write»t += «call»shape(«use»ray.«field»origin + ray.direction * «read»t);
        if (t > «expand»FAR) break;
    }
    return t;
}
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    Ray «variable»primary = Ray(vec3(0.0), vec3(fragCoord / iResolution.xy, 1.0));
    fragColor = vec4(march(primary) * 0.1 + shape(vec3(«host»iTime)));
}
"""


def opened(case):
    client = case.client()
    library = case.write("lib.glsl", LIBRARY)
    return client, case.write("a.glsl", MAIN).open(client), library


def place(client, found):
    """A location as URI and start offset."""
    assert found, "no location"
    found = found[0] if isinstance(found, list) else found
    return found["uri"], client.lines(found["uri"]).span(found["range"])[0]


def test_definitions_are_found_in_this_file_and_in_others(case):
    client, source, library = opened(case)
    for name, target, mark in (
        ("call", library, "def"), ("field", library, "member"), ("expand", source, "macro"),
        ("read", source, "local"), ("use", source, "param"), ("local", source, "local"),
    ):
        found = client.at(source.uri, source[name], "textDocument/definition")
        assert place(client, found) == (target.uri, target[mark]), "the definition of «%s»" % name
    found = client.at(source.uri, source["call"], "textDocument/declaration")
    assert place(client, found) == (library.uri, library["proto"]), "the declaration"
    found = client.at(source.uri, source["path"], "textDocument/definition")
    assert place(client, found) == (library.uri, 0), "the file that is included"
    assert client.at(source.uri, source["host"], "textDocument/definition") is None
    for name in ("variable", "use"):
        found = client.at(source.uri, source[name], "textDocument/typeDefinition")
        assert place(client, found) == (library.uri, library["struct"]), "the type of «%s»" % name
    assert client.at(source.uri, source["read"], "textDocument/typeDefinition") is None, "the type of a number"


def test_definitions_use_unsaved_texts(case):
    client, source, library = opened(case)
    library.open(client)
    client.replace(library.uri, 0, 0, "// é\n// 𝄞\n")
    found = client.at(source.uri, source["call"], "textDocument/definition")
    assert place(client, found) == (library.uri, library["def"] + len("// é\n// 𝄞\n")), "the definition"


def test_the_definition_of_an_include_path_is_the_file(case):
    client = case.client()
    case.write("one/lib.glsl", "float one() { return 1.0; }\n")
    case.write("two/lib.glsl", "float two() { return 2.0; }\n")
    source = case.write("a.glsl", '#include "one/lib.glsl"\n#include "«path»two/lib.glsl"\n'
                        "float both() { return one() + two(); }\n").open(client)
    found = client.at(source.uri, source["path"], "textDocument/definition")
    assert place(client, found)[0] == case.uri("two/lib.glsl"), "the file"


def references(client, source, offset, declaration=True):
    found = client.at(source.uri, offset, "textDocument/references",
                      context={"includeDeclaration": declaration})
    return sorted((l["uri"], client.lines(l["uri"]).span(l["range"])[0]) for l in found)


def every(source, word):
    """All occurrences of a word in a text."""
    return [m.start() for m in re.finditer(r"\b%s\b" % word, source.text)]


def test_references_are_found_in_all_files(case):
    client, source, library = opened(case)
    other = case.write("b.glsl", '#include "lib.glsl"\nvoid mainImage(out vec4 c, in vec2 p) {\n'
                       "    float shapes = 1.0;\n    c = vec4(shape(vec3(p, shapes)));\n}\n")
    # This file has its own function with the same name.
    case.write("c.glsl", "float shape(vec3 p) { return 1.0; }\nvoid mainImage(out vec4 c, in vec2 p) "
               "{ c = vec4(shape(vec3(p, 1.0))); }\n")
    everywhere = sorted([(s.uri, at) for s in (source, library, other) for at in every(s, "shape")])
    assert references(client, source, source["call"]) == everywhere, "from a call"
    library.open(client)
    assert references(client, library, library["def"]) == everywhere, "from the definition"
    calls = [(u, at) for u, at in everywhere if u != library.uri]
    assert references(client, source, source["call"], declaration=False) == calls, "without declarations"
    assert references(client, source, source["read"]) == [(source.uri, at) for at in every(source, "t")]


def test_highlights_distinguish_reads_and_writes(case):
    client, source, _ = opened(case)
    found = client.at(source.uri, source["read"], "textDocument/documentHighlight")
    kinds = {client.lines(source.uri).span(h["range"])[0]: h["kind"] for h in found}
    assert sorted(kinds) == every(source, "t"), "the places"
    assert kinds[source["write"]] == 3, "the kind of `t +=`, where 3 is a write"
    assert kinds[source["read"]] == 2, "the kind of a use, where 2 is a read"
    found = client.at(source.uri, source["expand"], "textDocument/documentHighlight")
    assert sorted(client.lines(source.uri).at(h["range"]) for h in found) == ["FAR", "FAR"], "of a macro"
    assert (client.at(source.uri, source.text.index("{"), "textDocument/documentHighlight") or []) == []


def test_passes_of_a_folder_use_their_common_code(case):
    client = case.client()
    common = case.write("common.glsl", "float «def»wave(float x) { return sin(x); }\n")
    image = case.write("image.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                       "    c = texture(iChannel0, p / iResolution.xy) * «use»wave(iTime);\n}\n").open(client)
    buffer = case.write("bufferA.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                        "    c = vec4(p / iResolution.xy, «use»wave(iTime), 1.0);\n}\n").open(client)
    for source in (image, buffer):
        assert errors(client.published(source.uri)) == [], "the errors of a pass"
        found = client.at(source.uri, source["use"], "textDocument/definition")
        assert place(client, found) == (common.uri, common["def"]), "the definition"
    expected = sorted([(common.uri, common["def"]), (image.uri, image["use"]), (buffer.uri, buffer["use"])])
    assert references(client, image, image["use"]) == expected, "from a pass"
    common.open(client)
    assert references(client, common, common["def"]) == expected, "from the common code"


def test_calls_are_followed_both_ways(case):
    client, source, library = opened(case)
    item = client.at(source.uri, source["call"], "textDocument/prepareCallHierarchy")[0]
    assert (item["name"], item["uri"]) == ("shape", library.uri), "the function"
    lines = client.lines(item["uri"])
    outer, inner = lines.span(item["range"]), lines.span(item["selectionRange"])
    assert outer[0] <= inner[0] and inner[1] <= outer[1], f"its selection range is outside its range: {item}"
    march = client.at(source.uri, source.text.index("march(Ray"), "textDocument/prepareCallHierarchy")[0]
    calls = client.request("callHierarchy/outgoingCalls", {"item": march})
    assert [c["to"]["name"] for c in calls] == ["shape"], "what march calls"
    assert [client.lines(source.uri).at(r) for r in calls[0]["fromRanges"]] == ["shape"], "where it calls"
    calls = client.request("callHierarchy/incomingCalls", {"item": march})
    assert [c["from"]["name"] for c in calls] == ["mainImage"], "who calls march"
    assert [client.lines(source.uri).at(r) for r in calls[0]["fromRanges"]] == ["march"], "where it is called"
    assert client.at(source.uri, source["local"], "textDocument/prepareCallHierarchy") is None, "of a variable"


def test_callers_are_found_in_other_files(case):
    client, source, library = opened(case)
    library.open(client)
    item = client.at(library.uri, library["def"], "textDocument/prepareCallHierarchy")[0]
    calls = client.request("callHierarchy/incomingCalls", {"item": item})
    found = sorted((c["from"]["name"], c["from"]["uri"]) for c in calls)
    assert found == [("mainImage", source.uri), ("march", source.uri)], "who calls shape"


def test_overloads_are_distinguished(case):
    client = case.client()
    source = case.write("a.glsl", """float «one»size(vec2 p) { return length(p); }
float «two»size(vec3 p) { return length(p) * 2.0; }
void mainImage(out vec4 c, in vec2 p) { c = vec4(«first»size(p), «second»size(vec3(p, 1.0)), 0.0, 1.0); }
""").open(client)
    for use, target in (("first", "one"), ("second", "two")):
        found = client.at(source.uri, source[use], "textDocument/definition")
        assert place(client, found)[1] == source[target], "the definition of the %s call" % use
        assert references(client, source, source[use]) == sorted((source.uri, source[n]) for n in (use, target))


def test_slow_requests_leave_no_stale_state(case):
    """A request over all files takes time; the state read for it is not kept for a newer text."""
    capabilities = pulling()
    for number in range(200):
        case.write("a%03d.glsl" % number, "float f(float x) { return x; }\n" * 60)
    library = case.write("lib.glsl", "float «fn»wave(float x) { return x; }\n")
    source = case.write("z.glsl", '#include "lib.glsl"\nvoid mainImage(out vec4 c, in vec2 p) '
                        "{ c = vec4(wave(p.x)); }\n")
    client = case.client(capabilities=capabilities, settings={"shaderlint": {"run": False}})
    library.open(client)
    source.open(client)
    assert client.of(source.uri, "textDocument/diagnostic")["items"] == [], "at first"
    for count in (0, 10, 30, 100, 300):
        client.replace(source.uri, 0, 0, "\n")
        number = client.send("workspace/symbol", {"query": "nowhere"})
        # The responses to quick requests measure the progress of the slow one.
        for _ in range(count):
            client.of(library.uri, "textDocument/foldingRange")
        client.replace(library.uri, library["fn"], library["fn"] + 4, "ripp")
        client.wait(number)
        found = client.of(source.uri, "textDocument/diagnostic")["items"]
        assert len(errors(found)) == 1, "the errors after `wave` was renamed"
        client.write_all(library.uri, library.text)
        client.replace(source.uri, 0, 0, "\n")
        assert errors(client.of(source.uri, "textDocument/diagnostic")["items"]) == [], "with the old name"


SEA = {
    "sea.vert": "uniform float «vertex»uTime;\nvoid main() { gl_Position = vec4(position * uTime, 1.0); }\n",
    "sea.frag": "uniform float «fragment»uTime;\nvoid main() { gl_FragColor = vec4(uTime); }\n",
    "main.ts": """import { ShaderMaterial } from 'three';
import vertexShader from './sea.vert';
import fragmentShader from './sea.frag';
const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms: { «key»uTime: { value: 0.5 } } });
export function update(time: number) { material.uniforms.«later»uTime.value = time; }
""",
}


def test_uniforms_lead_from_scripts_to_shaders_and_back(case):
    client = case.client()
    vertex, fragment, script = [case.write(name, text) for name, text in SEA.items()]
    script.open(client, "typescript")
    shaders = {(vertex.uri, 0), (fragment.uri, 0)}
    for place in ("key", "later"):
        found = client.at(script.uri, script[place] + 2, "textDocument/definition")
        assert {(at["uri"], at["range"]["start"]["line"]) for at in found} == shaders, place
        text = client.at(script.uri, script[place], "textDocument/hover")["contents"]["value"]
        assert "uniform float uTime" in text and "set to `0.5` in `main.ts:4`" in text, text
        found = client.at(script.uri, script[place], "textDocument/references", context={"includeDeclaration": True})
        assert len(found) == 6, found
        edit = client.at(script.uri, script[place], "textDocument/rename", newName="uClock")
        assert len(edit["changes"]) == 3, edit
    found = client.at(script.uri, script["later"], "textDocument/prepareRename")
    assert found["placeholder"] == "uTime" and found["range"]["start"]["line"] == 4, found
    fragment.open(client)
    found = client.at(fragment.uri, fragment["fragment"], "textDocument/hover")["contents"]["value"]
    assert "changed in `main.ts:5`" in found, found
