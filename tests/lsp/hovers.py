"""Hovers: types, ranges, constants, loops, images, documentation; and signature help."""

import base64
import re
import struct

from harness import contains, everything, holds, same, test

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
    holds(found, "no hover at «%s»" % place)
    return found["contents"]["value"], client.lines(source.uri).at(found["range"])


@test
def a_hover_has_the_declaration(case):
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
        same(about, word, "the range of the hover at «%s»" % place)
        contains(text, "```glsl\n%s\n```" % declaration, "the hover")
    contains(said(client, source, "xy")[0], "vec2", "the hover of components")
    same(client.at(source.uri, source.text.index("{"), "textDocument/hover"), None, "a hover of a bracket")


@test
def a_hover_has_the_comment_of_the_declaration(case):
    client, source = opened(case)
    for place in ("fn", "call"):
        contains(said(client, source, place)[0], "Noise of a point.\nIt is cheap.", "the hover")
    contains(said(client, source, "origin")[0], "where it starts", "the hover")
    holds("Noise of a point" not in said(client, source, "par")[0],
          "the comment of the function is shown for its parameter", said(client, source, "par"))


@test
def a_hover_has_ranges_and_constants(case):
    client, source = opened(case)
    contains(said(client, source, "wave")[0], "here: 0.0..=1.0", "the hover")
    contains(said(client, source, "steps")[0], "constant: `8`", "the hover")
    text = said(client, source, "sky")[0]
    contains(text, "(0.2, 0.4, 0.8)", "the hover")
    contains(text, "#3366cc", "the hover, as a colour")
    contains(text, "data:image/svg+xml,", "the hover, as a square of that colour")
    contains(said(client, source, "macro")[0].replace(" ", ""), "((total)*(total))", "the hover")


@test
def a_hover_has_static_and_sampled_iteration_counts(case):
    client, source = opened(case)
    contains(said(client, source, "loop")[0], "at most 8 iterations", "the hover")
    client.asked_for("workspace/inlayHint/refresh")
    text = said(client, source, "loop")[0]
    turns = re.search(r"sample run: at most (\d+) iterations, ([\d.]+) on average", text)
    holds(turns, "no sampled loop counts:", text)
    holds(1 <= float(turns.group(2)) <= int(turns.group(1)) <= 8, "impossible iteration counts:", text)


@test
def a_hover_has_an_image(case):
    client, source = opened(case)
    text = said(client, source, "wave")[0]
    found = re.search(r"\(data:image/png;base64,([A-Za-z0-9+/=]+)\)", text)
    holds(found, "no image:", text)
    data = base64.b64decode(found.group(1), validate=True)
    same(data[:8], b"\x89PNG\r\n\x1a\n", "the signature")
    same(data[-8:-4], b"IEND", "the last chunk")
    width, height = struct.unpack(">II", data[16:24])
    holds(16 <= width <= 1024 and 9 <= height <= 1024, "its size", width, height)
    # There is no image for a constant value or for code that is not a variable.
    for place in ("steps", "fn", "macro", "field"):
        holds("image/png" not in said(client, source, place)[0], "an image for «%s»" % place)


@test
def images_can_be_turned_off(case):
    client, source = opened(case, options={"pictures": False})
    holds("image/png" not in said(client, source, "wave")[0], "an image although images are off")


@test
def a_hover_documents_built_ins_and_host_names(case):
    client, source = opened(case)
    for place, words in (("sin", "sine of `angle`"), ("time", "seconds since the start"),
                         ("texture", "texture")):
        contains(said(client, source, place)[0].lower(), words.lower(), "the hover")
    contains(said(client, source, "time")[0], "uniform float iTime", "the hover")


@test
def clients_without_markdown_get_plain_text(case):
    capabilities = everything()
    capabilities["textDocument"]["hover"]["contentFormat"] = ["plaintext"]
    client, source = opened(case, capabilities=capabilities)
    found = client.at(source.uri, source["wave"], "textDocument/hover")
    same(found["contents"]["kind"], "plaintext", "the kind")
    text = found["contents"]["value"]
    contains(text, "float wave", "the hover")
    holds("```" not in text and "data:image" not in text, "Markdown for a client without Markdown", text)


@test
def a_hover_of_a_suppression_describes_the_rule(case):
    client = case.client()
    source = case.write("a.glsl", SHADER.replace(
        "    Ray ray", "    // shaderlint: allow(«rule»unused-variable)\n    Ray ray")).open(client)
    text, about = said(client, source, "rule")
    same(about, "unused-variable", "the range of the hover")
    holds(len(text) > 30, "too short", text)


def help_at(client, source, offset):
    return client.at(source.uri, offset, "textDocument/signatureHelp")


def active(found):
    """The label of the active parameter."""
    signature = found["signatures"][found.get("activeSignature") or 0]
    number = signature.get("activeParameter", found.get("activeParameter"))
    start, end = signature["parameters"][number]["label"]
    return signature["label"][start:end]


@test
def signature_help_follows_the_argument(case):
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
        same(active(help_at(client, source, source[place])), parameter, "the parameter at «%s»" % place)
    found = help_at(client, source, source["one"])
    same(found["signatures"][0]["label"], "float shade(vec3 normal, float gain, out vec3 color)", "the signature")
    contains(active(help_at(client, source, source["third"])), "a", "the third parameter of mix")
    contains(help_at(client, source, source["third"])["signatures"][0]["label"], "mix(", "the signature of mix")
    labels = [s["label"] for s in help_at(client, source, source["coord"])["signatures"]]
    holds(all("texture(" in label for label in labels), "other functions", labels)
    contains(help_at(client, source, source["coord"])["signatures"][0]["documentation"]["value"], "texture",
             "its documentation")
    same(help_at(client, source, source["out"]), None, "outside of calls")


@test
def signature_help_works_while_typing(case):
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
            same(active(found), parameter, "the parameter after «%s»" % typed)
        else:
            contains(found["signatures"][0]["label"], "max(", "the signature of the inner call")


@test
def shaders_that_a_host_composes_have_hovers(case):
    client = case.client(options={"run": False})
    inputs = '/*{\n    "INPUTS": [{ "NAME": "gain", "TYPE": "float" }]\n}*/\n'
    source = case.write("a.fs", inputs + "void main() {\n    vec2 «uv»uv = isf_FragNormCoord * gain;\n"
                        "    gl_FragColor = vec4(uv, 0.0, 1.0);\n}\n").open(client)
    hover = client.at(source.uri, source["uv"], "textDocument/hover")
    contains(hover["contents"]["value"], "vec2 uv", "the hover")
    place = source.text.rindex("uv")
    found = client.at(source.uri, place, "textDocument/definition")
    same(found["range"]["start"]["line"], 4, "the definition")
