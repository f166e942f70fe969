"""Hovers: types, ranges, constants, loops, images, documentation; and signature help."""

import base64
import re
import struct

from client import everything

SHADER = """// Noise of a point.
// It is cheap.
float «fn»noise(vec2 p, float «par»gain) { return fract(sin(dot(p, vec2(12.9, 78.2))) * gain); }
struct Ray {
    vec3 «origin»origin; // where it starts
    vec3 direction;
};
const int STEPS = 4 * 2;
const vec3 SKY = vec3(0.2, 0.4, 0.8);
#define SQUARE(x) ((x) * (x))
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    Ray ray = Ray(vec3(0.0), vec3(uv, 1.0));
    float total = 0.0;
    «loop»for (int «i»i = 0; i < «steps»STEPS; i++) {
        float wave = 0.5 + 0.5 * «sin»sin(uv.x + «time»iTime);
        total += «wave»wave * ray.«field»direction.«xy»xy.x;
        if (total > 2.0) break;
    }
    vec3 col = «sky»SKY * «macro»SQUARE(total) + «call»noise(uv, 3.0);
    fragColor = vec4(«col»col, 1.0) * «texture»texture(iChannel0, uv).x;
}
"""


def opened(case, **settings):
    client = case.client(**settings)
    return client, case.write("a.glsl", SHADER).open(client)


def said(client, source, place):
    """The hover text at a position, and the code at its range."""
    found = client.at(source.uri, source[place], "textDocument/hover")
    assert found, "no hover at «%s»" % place
    return found["contents"]["value"], client.lines(source.uri).at(found["range"])


def test_a_hover_has_the_declaration(case):
    client, source = opened(case)
    expected = {
        "fn": ("noise", "float noise(vec2 p, float gain)"), "call": ("noise", "float noise(vec2 p, float gain)"),
        "par": ("gain", "float gain"), "wave": ("wave", "float wave"),
        "field": ("direction", "vec3 Ray.direction"), "col": ("col", "vec3 col"),
        "macro": ("SQUARE", "#define SQUARE(x) ((x) * (x))"), "i": ("i", "int i"),
        "origin": ("origin", "vec3 Ray.origin"), "steps": ("STEPS", "const int STEPS"),
    }
    for place, (word, declaration) in expected.items():
        text, about = said(client, source, place)
        assert about == word, "the range of the hover at «%s»" % place
        assert "```glsl\n%s\n```" % declaration in text, "the hover"
    assert "vec2" in said(client, source, "xy")[0], "the hover of components"
    assert client.at(source.uri, source.text.index("{"), "textDocument/hover") is None, "a hover of a bracket"


def test_a_hover_has_the_comment_of_the_declaration(case):
    client, source = opened(case)
    for place in ("fn", "call"):
        assert "Noise of a point.\nIt is cheap." in said(client, source, place)[0], "the hover"
    assert "where it starts" in said(client, source, "origin")[0], "the hover"
    assert "Noise of a point" not in said(client, source, "par")[0], (
        "the comment of the function is shown for its parameter", said(client, source, "par")
    )


def test_a_hover_has_ranges_and_constants(case):
    client, source = opened(case)
    assert "here: 0.0..=1.0" in said(client, source, "wave")[0], "the hover"
    assert "constant: `8`" in said(client, source, "steps")[0], "the hover"
    text = said(client, source, "sky")[0]
    assert "(0.2, 0.4, 0.8)" in text, "the hover"
    assert "#3366cc" in text, "the hover, as a colour"
    assert "data:image/svg+xml," in text, "the hover, as a square of that colour"
    assert "((total)*(total))" in said(client, source, "macro")[0].replace(" ", ""), "the hover"


def test_a_hover_has_static_and_sampled_iteration_counts(case):
    client, source = opened(case)
    assert "at most 8 iterations" in said(client, source, "loop")[0], "the hover"
    client.asked_for("workspace/inlayHint/refresh")
    text = said(client, source, "loop")[0]
    turns = re.search(r"sample run: at most (\d+) iterations, ([\d.]+) on average", text)
    assert turns, f"no sampled loop counts: {text}"
    assert 1 <= float(turns.group(2)) <= int(turns.group(1)) <= 8, f"impossible iteration counts: {text}"


def test_a_hover_has_an_image(case):
    client, source = opened(case)
    text = said(client, source, "wave")[0]
    found = re.search(r"\(data:image/png;base64,([A-Za-z0-9+/=]+)\)", text)
    assert found, f"no image: {text}"
    data = base64.b64decode(found.group(1), validate=True)
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "the signature"
    assert data[-8:-4] == b"IEND", "the last chunk"
    width, height = struct.unpack(">II", data[16:24])
    assert 16 <= width <= 1024 and 9 <= height <= 1024, f"its size: {width}, {height}"
    # There is no image for a constant value or for code that is not a variable.
    for place in ("steps", "fn", "macro", "field"):
        assert "image/png" not in said(client, source, place)[0], "an image for «%s»" % place


def test_images_can_be_turned_off(case):
    client, source = opened(case, options={"pictures": False})
    assert "image/png" not in said(client, source, "wave")[0], "an image although images are off"


def test_a_hover_documents_built_ins_and_host_names(case):
    client, source = opened(case)
    for place, words in (("sin", "sine of `angle`"), ("time", "seconds since the start"),
                         ("texture", "texture")):
        assert words.lower() in said(client, source, place)[0].lower(), "the hover"
    assert "uniform float iTime" in said(client, source, "time")[0], "the hover"


def test_clients_without_markdown_get_plain_text(case):
    capabilities = everything()
    capabilities["textDocument"]["hover"]["contentFormat"] = ["plaintext"]
    client, source = opened(case, capabilities=capabilities)
    found = client.at(source.uri, source["wave"], "textDocument/hover")
    assert found["contents"]["kind"] == "plaintext", "the kind"
    text = found["contents"]["value"]
    assert "float wave" in text, "the hover"
    assert "```" not in text and "data:image" not in text, f"Markdown for a client without Markdown: {text}"


def test_a_hover_of_a_suppression_describes_the_rule(case):
    client = case.client()
    source = case.write("a.glsl", SHADER.replace(
        "    Ray ray", "    // shaderlint: allow(«rule»unused-variable)\n    Ray ray")).open(client)
    text, about = said(client, source, "rule")
    assert about == "unused-variable", "the range of the hover"
    assert len(text) > 30, f"too short: {text}"


def help_at(client, source, offset):
    return client.at(source.uri, offset, "textDocument/signatureHelp")


def active(found):
    """The label of the active parameter."""
    signature = found["signatures"][found.get("activeSignature") or 0]
    number = signature.get("activeParameter", found.get("activeParameter"))
    start, end = signature["parameters"][number]["label"]
    return signature["label"][start:end]


def test_signature_help_follows_the_argument(case):
    client = case.client()
    source = case.write("a.glsl", """float shade(vec3 normal, float gain, out vec3 color) { color = normal * gain; return gain; }
struct Ray { vec3 origin; float speed; };
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec3 c;
    float a = shade(«one»vec3(1.0, «deep»2.0, 3.0), «two»mix(0.0, 1.0, «third»0.5), «three»c);
    Ray ray = Ray(vec3(0.0), «speed»1.0);
    vec4 d = texture(iChannel0, «coord»fragCoord);
    fragColor = vec4(c * a * ray.speed, 1.0) + d;
    «out»
}
""").open(client)
    for place, parameter in (("one", "vec3 normal"), ("two", "float gain"), ("three", "out vec3 color"),
                             ("speed", "float speed")):
        assert active(help_at(client, source, source[place])) == parameter, "the parameter at «%s»" % place
    found = help_at(client, source, source["one"])
    assert found["signatures"][0]["label"] == "float shade(vec3 normal, float gain, out vec3 color)"
    assert "a" in active(help_at(client, source, source["third"])), "the third parameter of mix"
    assert "mix(" in help_at(client, source, source["third"])["signatures"][0]["label"], "the signature of mix"
    labels = [s["label"] for s in help_at(client, source, source["coord"])["signatures"]]
    assert all("texture(" in label for label in labels), f"other functions: {labels}"
    assert "texture" in help_at(client, source, source["coord"])["signatures"][0]["documentation"]["value"]
    assert help_at(client, source, source["out"]) is None, "outside of calls"


def test_signature_help_works_while_typing(case):
    client = case.client()
    text = "float wave(vec2 place, float gain) { return place.x * gain; }\n" \
           "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    float a = \n}\n"
    source = case.write("a.glsl", text).open(client)
    at = text.index("\n}\n")
    steps = [("wave(", "vec2 place"), ("fragCoord", "vec2 place"), (", ", "float gain"), ("max(1.0", None)]
    for typed, parameter in steps:
        client.replace(source.uri, at, at, typed)
        at += len(typed)
        found = help_at(client, source, at)
        if parameter:
            assert active(found) == parameter, "the parameter after «%s»" % typed
        else:
            assert "max(" in found["signatures"][0]["label"], "the signature of the inner call"


def test_shaders_that_a_host_composes_have_hovers(case):
    client = case.client(options={"run": False})
    inputs = '/*{\n    "INPUTS": [{ "NAME": "gain", "TYPE": "float" }]\n}*/\n'
    source = case.write("a.fs", inputs + "void main() {\n    vec2 «uv»uv = isf_FragNormCoord * gain;\n"
                        "    gl_FragColor = vec4(uv, 0.0, 1.0);\n}\n").open(client)
    hover = client.at(source.uri, source["uv"], "textDocument/hover")
    assert "vec2 uv" in hover["contents"]["value"], "the hover"
    place = source.text.rindex("uv")
    found = client.at(source.uri, place, "textDocument/definition")
    assert found["range"]["start"]["line"] == 4, "the definition"
