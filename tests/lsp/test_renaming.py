"""Renaming: all uses are changed, and a renaming that would change the meaning is rejected."""

import json
import os
import re

from client import CHANGED, changes_of, path_of
from test_embedded import export
from harness import errors, refusal


def renamed(client, source, offset, new):
    """Renames; returns the texts of all changed files."""
    edit = client.at(source.uri, offset, "textDocument/rename", newName=new)
    client.apply(edit)
    return {uri: client.lines(uri).text for uri, _ in changes_of(edit)}


def test_prepare_rename_returns_the_range(case):
    client = case.client()
    source = case.write("a.glsl", "/* é𝄞 */ float «fn»wave(float x) { return sin(x); }\n").open(client)
    found = client.at(source.uri, source["fn"] + 2, "textDocument/prepareRename")
    assert found["placeholder"] == "wave", "the placeholder"
    assert client.lines(source.uri).span(found["range"]) == (source["fn"], source["fn"] + 4), "the range"


def test_renaming_covers_macros(case):
    client = case.client()
    text = """float wave(float x) { return sin(x); }
#define CALL(x) wave(x) * «in»gain
#define TWICE(name) name + name
const float «def»gain = 2.0;
#if 0
float unseen = gain;
#endif
void mainImage(out vec4 c, in vec2 p) {
    float gained = 1.0;
    c = vec4(CALL(p.x), TWICE(gain), gained, wave(iTime)); // gain
}
"""
    source = case.write("a.glsl", text).open(client)
    for place in ("def", "in"):
        after = renamed(client, source, source[place], "power")[source.uri]
        expected = re.sub(r"\bgain\b(?! *\n    float gained)", "power", source.text)
        expected = expected.replace("// power", "// gain")
        assert after == expected, "the text"
        assert errors(client.published(source.uri)) == [], "the errors"
        client.write_all(source.uri, source.text)
    after = renamed(client, source, source.text.index("wave"), "ripple")[source.uri]
    assert after == source.text.replace("wave", "ripple"), "the text"


BRANCHES = """#define MODE 1
#if MODE == 1
float «one»shape(vec3 p) { return length(p); }
#elif MODE == 2
float «two»shape(vec3 p) { float «local»far = p.y; return far; }
#endif
struct Ray { vec3 «field»from; float far; };
#ifdef FAST
const float «steps»LIMIT = 8.0;
#else
#define LIMIT 64.0
#endif
vec3 shade(Ray ray, float «param»amount) {
    #ifdef GLOW
    vec3 «glow»color = ray.from * amount;
    #else
    vec3 color = vec3(amount);
    #if MODE == 2
    color += ray.from + shape(ray.from);
    #endif
    #endif
    return color * LIMIT;
}
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(shade(Ray(vec3(p, 1.0), 2.0), shape(vec3(p, 0.0))), 1.0);
}
"""


def test_renaming_reaches_code_that_is_not_compiled(case):
    client = case.client()
    source = case.write("a.glsl", BRANCHES).open(client)
    whole = {"one": "shape", "two": "shape", "field": "from", "steps": "LIMIT", "glow": "color", "param": "amount"}
    for place, name in whole.items():
        after = renamed(client, source, source[place], "other")[source.uri]
        assert after == re.sub(r"\b%s\b" % name, "other", source.text), "the text after renaming " + name
        client.write_all(source.uri, source.text)
    # A local of a branch and a member have the same name.
    after = renamed(client, source, source["local"], "other")[source.uri]
    assert after == source.text.replace("float far = p.y; return far;", "float other = p.y; return other;")
    client.write_all(source.uri, source.text)
    places = client.at(source.uri, source["glow"], "textDocument/documentHighlight")
    assert len(places) == 4, "the highlights"
    target = client.at(source.uri, source.text.index("color += "), "textDocument/definition")
    assert client.lines(source.uri).span(target["range"])[0] == source.text.index("color = vec3")


def test_a_name_that_another_branch_would_hide_is_rejected(case):
    client = case.client()
    source = case.write("a.glsl", """float «fn»gain(float x) { return x; }
float f(float x) {
    #ifdef LOUD
    float power = 2.0;
    x *= gain(power);
    #endif
    return gain(x);
}
""").open(client)
    error = refusal(lambda: client.at(source.uri, source["fn"], "textDocument/rename", newName="power"))
    assert "line 5" in error.message, "the reason"


def test_macros_and_members_are_renamed(case):
    client = case.client()
    source = case.write("a.glsl", """#define «macro»LIMIT(x) min(x, 4.0)
#ifdef LIMIT
struct Ray { vec3 «member»start; float start2; };
#endif
float «over»start(Ray r) { return LIMIT(r.start.x) + r.start2; }
void mainImage(out vec4 c, in vec2 p) {
    Ray ray = Ray(vec3(p, 1.0), 2.0);
    ray.start.xy += 1.0;
    c = vec4(LIMIT(start(ray)));
}
""").open(client)
    after = renamed(client, source, source["macro"], "BOUND")[source.uri]
    assert after == source.text.replace("LIMIT", "BOUND"), "the text"
    client.write_all(source.uri, source.text)
    after = renamed(client, source, source["member"], "origin")[source.uri]
    expected = source.text.replace("vec3 start;", "vec3 origin;").replace("r.start.x", "r.origin.x")
    assert after == expected.replace("ray.start.xy", "ray.origin.xy"), "the text"


def test_renaming_covers_includes(case):
    client = case.client()
    library = case.write("lib.glsl", "float «fn»wave(float x) { return sin(x); }\n")
    first = case.write("a.glsl", '#include "lib.glsl"\nvoid mainImage(out vec4 c, in vec2 p) '
                       "{ c = vec4(«use»wave(p.x)); }\n").open(client)
    second = case.write("inner/b.glsl", '#include "../lib.glsl"\nvoid mainImage(out vec4 c, in vec2 p) '
                        "{ c = vec4(wave(p.y)); }\n")
    apart = case.write("c.glsl", "float wave(float x) { return x; }\n")
    after = renamed(client, first, first["use"], "ripple")
    assert sorted(after) == sorted([library.uri, first.uri, second.uri]), "the files"
    for source in (library, first, second):
        assert after[source.uri] == source.text.replace("wave", "ripple"), "the text"
    with open(path_of(apart.uri), encoding="utf-8") as file:
        assert file.read() == apart.text, "the text of an unrelated file"


def test_renaming_reaches_branches_after_includes_with_branches(case):
    """The included files have branches that are not compiled, too, before those of the text."""
    client = case.client()
    guard = "#ifdef %s\nfloat %s(float x) { return x; }\n#endif\n"
    case.write("one.glsl", guard % ("ONE", "one"))
    lights = case.write("lights.glsl", "struct Sun { vec3 way; float «def»power; };\n"
                        "struct Lamp { vec3 place; float power; };\n" + guard % ("TWO", "two"))
    user = case.write("user.glsl", """#include "one.glsl"
#include "lights.glsl"
float read(Sun sun) { return sun.«use»power; }
float shade() {
    #if defined(DAY)
    Sun light;
    #else
    Lamp light;
    #endif
    #if defined(SOFT)
    #if defined(DAY)
    light.«day»power *= 0.5;
    #else
    light.«night»power *= 0.5;
    #endif
    #endif
    return light.place.x;
}
""").open(client)
    for place in ("use", "day"):
        after = renamed(client, user, user[place], "strength")
        text = user.text.replace("sun.power", "sun.strength")
        text = text.replace("light.power", "light.strength", 1)
        assert after[user.uri] == text, "the text"
        assert after[lights.uri] == lights.text.replace("power", "strength", 1), "the included text"
        client.write_all(user.uri, user.text)
        case.write("lights.glsl", lights.text)
        client.watched((lights.uri, CHANGED))


def test_renaming_covers_the_passes_of_a_folder(case):
    client = case.client()
    body = "void mainImage(out vec4 c, in vec2 p) { c = vec4(«%s»wave(p.x)); }\n"
    common = case.write("common.glsl", "float «def»wave(float x) { return sin(x); }\n").open(client)
    image = case.write("image.glsl", body % "use").open(client)
    buffer = case.write("bufferA.glsl", body % "use")
    for source, place in ((image, "use"), (common, "def")):
        after = renamed(client, source, source[place], "ripple")
        assert sorted(after) == sorted([common.uri, image.uri, buffer.uri]), "the files"
        for each in (common, image, buffer):
            assert after[each.uri] == each.text.replace("wave", "ripple"), "the text"
            # Restored for the next test.
            if each.uri in client.documents:
                client.write_all(each.uri, each.text)
        case.write("bufferA.glsl", body % "use")
        client.watched((buffer.uri, CHANGED))


def test_new_passes_are_found_without_file_events(case):
    client = case.client()
    common = case.write("common.glsl", "float wave(float x) { return sin(x); }\n").open(client)
    # The folder is old when it is read, and new after a pass was added.
    os.utime(case.folder, (1_000_000_000, 1_000_000_000))
    client.of(common.uri, "textDocument/documentSymbol")
    client.write_all(common.uri, common.text + "// more\n")
    client.of(common.uri, "textDocument/documentSymbol")
    body = "void mainImage(out vec4 c, in vec2 p) { c = vec4(«%s»wave(p.x)); }\n"
    buffer = case.write("bufferA.glsl", body % "use")
    image = case.write("image.glsl", body % "use").open(client)
    after = renamed(client, image, image["use"], "ripple")
    assert sorted(after) == sorted([common.uri, image.uri, buffer.uri]), "the files"


def test_renaming_covers_the_passes_of_an_export(case):
    client = case.client()
    image = "void mainImage(out vec4 c, in vec2 p) {\n\tc = vec4(wave(p.x)); // \"wave\"\n}\n"
    source = case.write("s.json", export(image, "float wave(float x) { return sin(x); }\n"))
    source.open(client, "json")
    after = renamed(client, source, source.text.index("wave(float"), "ripple")[source.uri]
    assert after == source.text.replace("wave(", "ripple("), "the text"
    json.loads(after)


HEAD = "#version 300 es\nprecision highp float;\n"
VERTEX = HEAD + "in vec4 position;\nout vec2 «v»vUv;\nuniform float gain;\n" \
    "void main() { vUv = position.xy * gain; gl_Position = position; }\n"
FRAGMENT = HEAD + "in vec2 «f»vUv;\nuniform float gain;\nout vec4 color;\n" \
    "void main() { color = vec4(vUv * gain, 0.0, 1.0); }\n"


def test_a_varying_is_renamed_in_both_stages_of_a_page(case):
    client = case.client()
    text = '<script type="x-shader/x-vertex">%s</script>\n<script type="x-shader/x-fragment">%s</script>\n'
    source = case.write("page.html", text % (VERTEX, FRAGMENT)).open(client, "html")
    assert errors(client.published(source.uri)) == [], "the errors"
    for place in ("v", "f"):
        after = renamed(client, source, source[place], "vPlace")[source.uri]
        assert after == source.text.replace("vUv", "vPlace"), "the text"
        assert errors(client.published(source.uri)) == [], "the errors"
        client.write_all(source.uri, source.text)


def test_a_varying_is_renamed_in_both_files_of_a_pair(case):
    client = case.client()
    vertex = case.write("a.vert", VERTEX).open(client)
    fragment = case.write("a.frag", FRAGMENT)
    for source, place in ((vertex, "v"), (fragment, "f")):
        if source is fragment:
            fragment.open(client)
        after = renamed(client, source, source[place], "vPlace")
        assert sorted(after) == sorted([vertex.uri, fragment.uri]), "the files"
        for each in (vertex, fragment):
            assert after[each.uri] == each.text.replace("vUv", "vPlace"), "the text"
        case.write("a.vert", VERTEX)
        case.write("a.frag", FRAGMENT)
        for each in (vertex, fragment):
            if each.uri in client.documents:
                client.write_all(each.uri, each.text)


def test_a_uniform_is_renamed_in_both_files_of_a_pair(case):
    client = case.client()
    vertex = case.write("a.vert", VERTEX).open(client)
    fragment = case.write("a.frag", FRAGMENT).open(client)
    after = renamed(client, fragment, fragment.text.index("gain"), "power")
    assert after == {s.uri: s.text.replace("gain", "power") for s in (vertex, fragment)}, "the texts"


def test_externally_defined_names_cannot_be_renamed(case):
    client = case.client()
    source = case.write("a.glsl", """void «entry»mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 «own»uv = fragCoord / «host»iResolution.xy;
    fragColor = vec4(«builtin»sin(uv), uv.«swizzle»xy) + gl_FragCoord.«blank»    x;
    «keyword»return;
}
""").open(client)
    for place, words in (("entry", "mainImage"), ("host", "iResolution"), ("builtin", "sin")):
        for method, more in (("rename", {"newName": "other"}), ("prepareRename", {})):
            error = refusal(lambda: client.at(source.uri, source[place], "textDocument/" + method, **more))
            assert "`%s`" % words in error.message, "the reason"
    for place in ("keyword", "swizzle"):
        error = refusal(lambda: client.at(source.uri, source[place] + 1, "textDocument/rename", newName="other"))
        assert len(error.message) > 10, f"no reason is given: {error}"


def test_invalid_names_are_rejected(case):
    client = case.client()
    source = case.write("a.glsl", "float «fn»wave(float x) { return x; }\n").open(client)
    for new in ("float", "1x", "a b", "", "for", "gl_wave", "a__b", "é", "sample", "wave()"):
        error = refusal(lambda: client.at(source.uri, source["fn"], "textDocument/rename", newName=new))
        assert len(error.message) > 10, f"no reason is given: {error}"
    assert changes_of(client.at(source.uri, source["fn"], "textDocument/rename", newName="wave")) == []


def test_renamings_that_change_the_meaning_are_rejected(case):
    client = case.client()
    cases = {
        "a parameter that a local of an inner block hides":
            ("float f(float «x»p) { { float q = 2.0; q += p; } return p; }", "q"),
        "a local that would hide a used global":
            ("const float q = 1.0;\nfloat f() { float «x»p = 2.0; return p * q; }", "q"),
        "a global that a parameter would hide":
            ("const float «x»p = 1.0;\nfloat f(float q) { return p * q; }", "q"),
        "two locals of one scope": ("float f() { float «x»p = 2.0; float q = 1.0; return p * q; }", "q"),
        "a function that would be another's overload, with the same parameters":
            ("float q(float a) { return a; }\nfloat «x»p(float a) { return a * q(a); }", "q"),
        "a function that would take the place of a built-in that is used":
            ("float «x»p(float a) { return a; }\nfloat f(float a) { return p(a) + sin(a); }", "sin"),
        "two members of one struct": ("struct S { float «x»p; float q; };", "q"),
        "a name that a macro replaces": ("#define q 2.0\nfloat f(float «x»p) { return p * q; }", "q"),
    }
    for number, (what, (text, new)) in enumerate(cases.items()):
        source = case.write("case%d.glsl" % number, text + "\n").open(client)
        error = refusal(lambda: client.at(source.uri, source["x"], "textDocument/rename", newName=new))
        assert "`%s`" % new in error.message, "the reason for %s" % what
    # Allowed: another scope, another struct, another number of parameters.
    fine = [
        ("float f(float «x»p) { return p; }\nfloat g(float q) { return q; }", "q"),
        ("struct S { float «x»p; };\nfloat q = 1.0;\nfloat f(S s) { return s.p * q; }", "q"),
        ("float q(float a) { return a; }\nfloat «x»p(vec2 a) { return q(a.x); }\n"
         "float f() { return p(vec2(1.0)); }", "q"),
    ]
    for number, (text, new) in enumerate(fine):
        source = case.write("fine%d.glsl" % number, text + "\n").open(client)
        after = renamed(client, source, source["x"], new)[source.uri]
        assert after == re.sub(r"\bp\b", new, source.text), "the text"


SCRIPT = """import fragment from './water.frag';
import vertex from './water.vert';
const gain = 1; // gain
const at = gl.getUniformLocation(program, '«name»gain');
const material = { fragment, uniforms: { gain: { value: gain } } };
const all = { uniforms: { gain, other: gain } };
material.uniforms.gain.value = gain;
"""


def test_uniforms_are_renamed_in_scripts(case):
    client = case.client()
    shaders = [case.write("water." + stage, text.replace("«v»", "").replace("«f»", "").replace(
        "uniform float gain", "uniform float «u»gain")) for stage, text in (("vert", VERTEX), ("frag", FRAGMENT))]
    script = case.write("scene.js", SCRIPT)
    elsewhere = case.write("other.js", "import x from './fire.frag';\ngl.getUniformLocation(p, 'gain');\n")
    fire = case.write("fire.frag", FRAGMENT.replace("«f»", ""))
    source = shaders[1].open(client)
    after = renamed(client, source, source["u"], "power")
    assert sorted(after) == sorted(s.uri for s in shaders + [script]), "the files"
    expected = script.text.replace("'gain'", "'power'").replace("{ gain: ", "{ power: ")
    expected = expected.replace("{ gain, ", "{ power: gain, ").replace("uniforms.gain", "uniforms.power")
    assert after[script.uri] == expected, "the script"
    for other in (elsewhere, fire):
        with open(path_of(other.uri), encoding="utf-8") as file:
            assert file.read() == other.text, "the text of another program"


def test_names_that_a_script_may_use_cannot_be_renamed(case):
    client = case.client()
    fragment = case.write("water.frag", FRAGMENT.replace("«f»", "")).open(client)
    case.write("scene.js", "import water from './water.frag';\nconst { gain } = settings;\n")
    place = fragment.text.index("gain")
    error = refusal(lambda: client.at(fragment.uri, place, "textDocument/rename", newName="power"))
    assert "line 2 of `scene.js`" in error.message, "the reason"


def test_names_in_the_edited_text_of_a_shader_are_renamed(case):
    client = case.client()
    text = "const f = `%s`.replace('vUv', 'vUv * 2.0').replace(/\\bvUv\\b/g, 'vUv');\nlog('vUv');\n"
    source = case.write("s.js", text % FRAGMENT).open(client, "javascript")
    after = renamed(client, source, source["f"], "vPlace")[source.uri]
    assert after == source.text.replace("vUv", "vPlace").replace("log('vPlace')", "log('vUv')"), "the text"


def test_renaming_covers_the_project_of_the_file_only(case):
    for mark in ("package.json", "shaderlint.toml", ".git/HEAD"):
        folder = "of " + mark.replace("/", " ")
        case.write(folder + "/" + mark, "{}" if mark.endswith("json") else "")
        library = case.write(folder + "/lib/wave.glsl", "float «fn»wave(float x) { return sin(x); }\n")
        user = case.write(folder + "/shaders/a.glsl", '#include "../lib/wave.glsl"\nvoid mainImage(out vec4 c, '
                          "in vec2 p) { c = vec4(wave(p.x)); }\n")
        client = case.client(folder=os.path.dirname(path_of(library.uri)))
        library.open(client)
        after = renamed(client, library, library["fn"], "ripple")
        assert sorted(after) == sorted([library.uri, user.uri]), "the files"


def test_a_varying_is_renamed_in_stages_that_are_paired_by_name(case):
    client = case.client()
    vertex = case.write("vertex.glsl", VERTEX).open(client)
    fragment = case.write("fragment.glsl", FRAGMENT)
    after = renamed(client, vertex, vertex["v"], "vPlace")
    assert after == {s.uri: s.text.replace("vUv", "vPlace") for s in (vertex, fragment)}, "the texts"


def test_names_that_a_fragment_may_use_cannot_be_renamed(case):
    client = case.client()
    first = case.write("noise.glsl", "float «fn»noise2(vec2 p) { return fract(p.x * seed); }\n").open(client)
    case.write("clouds.glsl", "float clouds(vec2 p) {\n    return noise2(p) * 2.0;\n}\n")
    error = refusal(lambda: client.at(first.uri, first["fn"], "textDocument/rename", newName="grain"))
    assert "line 2 of `clouds.glsl` may refer to `noise2`" in error.message, "the reason"
    # Nobody completes a complete shader.
    own = case.write("whole.frag", HEAD + "out vec4 color;\nfloat «fn»noise2(vec2 p) { return p.x; }\n"
                     "void main() { color = vec4(noise2(vec2(1.0))); }\n").open(client)
    after = renamed(client, own, own["fn"], "grain")
    assert after == {own.uri: own.text.replace("noise2", "grain")}, "the texts"
