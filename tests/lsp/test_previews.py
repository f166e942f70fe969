"""Previews: the page of a shader, its channels and its values; costs of lines."""

from client import everything, path_of
from harness import errors, refusal
from test_actions import GOOD, QUIET


def test_a_page_is_returned_to_the_client(case):
    client = case.client(options=QUIET)
    source = case.write("a.glsl", GOOD).open(client)
    first = client.of(source.uri, "shaderlint/page")["html"]
    assert "bent" in first, "the page"
    # It is the text in the editor, not the file on disk.
    client.write_all(source.uri, client.text(source.uri).replace("bent", "curved"))
    second = client.of(source.uri, "shaderlint/page")["html"]
    assert "curved" in second and "bent" not in second, "an old page"
    client.write_all(source.uri, client.text(source.uri).replace("= 1.0;", "= vec2(1.0);"))
    refused = refusal(lambda: client.of(source.uri, "shaderlint/page"))
    assert refused.message, f"no reason is given: {refused}"


def test_the_page_of_a_folder_contains_all_passes(case):
    client = case.client(options=QUIET)
    case.write("common.glsl", "float wave(float x) { return sin(x); }\n").open(client)
    case.write("bufferA.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x)); }\n")
    image = case.write("image.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                       "    c = texture(iChannel0, p / iResolution.xy) * wave(iTime);\n}\n").open(client)
    page = client.of(image.uri, "shaderlint/page")["html"]
    for part in ("vec4(wave(p.x))", "float wave(float x)", "* wave(iTime)"):
        assert part in page, "the page"


STAGES = """const vertex = `#version 300 es
in vec4 position; out vec2 vUv; uniform float amount;
void main() { vUv = position.xy * amount; gl_Position = position; }`;
const water = `#version 300 es
precision highp float;
in vec2 vUv; uniform float uTime; out vec4 color;
void main() { float «water»ripple = sin(uTime); color = vec4(vUv, ripple, 1.0); }`;
const fire = `#version 300 es
precision highp float;
in vec2 vUv; uniform float uTime; out vec4 color;
void main() { float «fire»flame = 0.375 * uTime; color = vec4(vUv, flame, 1.0); }`;
"""


def test_previews_show_the_shader_at_a_position(case):
    client = case.client(options=QUIET)
    source = case.write("scene.js", STAGES).open(client, "javascript")
    assert errors(client.published(source.uri)) == [], "the errors"
    lenses = client.of(source.uri, "textDocument/codeLens")
    shown = [lens["command"]["arguments"] for lens in lenses if "Preview" in lens["command"]["title"]]
    assert shown == [[source.uri, 1], [source.uri, 2]], "the lenses of shaders that can be played"
    pages = [client.of(source.uri, "shaderlint/page", shader=shader) for _, shader in shown]
    assert "ripple" in pages[0]["html"] and "ripple" not in pages[1]["html"], "the first page"
    assert "flame" in pages[1]["html"], "the second page"
    place = client.lines(source.uri).position(source["water"])
    assert client.of(source.uri, "shaderlint/page", position=place)["shader"] == 1, "the shader at a position"
    # The vertex shader cannot be played: the first that can.
    place = client.lines(source.uri).position(source.text.index("amount"))
    assert client.of(source.uri, "shaderlint/page", position=place)["shader"] == 1


def test_previews_include_what_checks_include(case):
    client = case.client(options=QUIET)
    case.write("lib/constants.glsl", "#define STEEP 0.375\n")
    case.write("lib/flame.glsl", '#include "constants.glsl"\nfloat flame(float x) { return x * STEEP; }\n')
    source = case.write("in/a.glsl", '#include "../lib/flame.glsl"\nvoid mainImage(out vec4 c, in vec2 p) '
                        "{ c = vec4(flame(p.x)); }\n").open(client)
    assert errors(client.published(source.uri)) == [], "the errors"
    page = client.of(source.uri, "shaderlint/page")["html"]
    assert "0.375" in page and "flame" in page, "the page lacks included code"


def creating():
    """The capabilities of an editor that can create files."""
    capabilities = everything()
    capabilities["workspace"]["workspaceEdit"] = {"documentChanges": True, "resourceOperations": ["create"]}
    return capabilities


IMAGE = "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p) + texture(iChannel1, vec3(p, 1.0)); }\n"


def test_assumed_channels_are_listed_and_written(case):
    client = case.client(options=QUIET, capabilities=creating())
    case.write("bufferA.glsl", "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n")
    image = case.write("image.glsl", IMAGE).open(client)
    page = client.of(image.uri, "shaderlint/page")
    channels = [(a["pass"], a["channel"], a["shows"]) for a in page["assumed"]]
    assert channels == [
        ("image", "iChannel0", "buffer"), ("image", "iChannel1", "generated cube map"),
        ("buffer_a", "iChannel0", "buffer"),
    ], "the assumed channels"
    assert page["channels"] == {"uri": case.uri("channels.toml"), "exists": False}, "the file"
    client.request("workspace/executeCommand",
                   {"command": "shaderlint.writeChannels", "arguments": [image.uri]})
    client.asked_for("workspace/applyEdit")
    written = open(path_of(case.uri("channels.toml")), encoding="utf-8").read()
    assert '\n[image]\n0 = "buffer_a" # buffer\n1 = "stand-in" # cubemap\n' in written, "channels.toml"
    again = client.of(image.uri, "shaderlint/page")
    assert (again["assumed"], again["channels"]["exists"]) == ([], True), "the channels after it"
    assert again["html"] == page["html"], "the page after it"
    # What is there stays.
    refused = refusal(lambda: client.request(
        "workspace/executeCommand", {"command": "shaderlint.writeChannels", "arguments": [image.uri]}))
    assert "channels.toml exists" in refused.message, "the reason"
    case.write("channels.toml", '[image]\n0 = "buffer_a"\n')
    rest = client.of(image.uri, "shaderlint/page")
    assert [a["channel"] for a in rest["assumed"]] == ["iChannel1", "iChannel0"], "the rest"
    assert rest["html"] != page["html"], "the page does not read the file"
    case.write("channels.toml", '[image]\n0 = "keybord"\n')
    refused = refusal(lambda: client.of(image.uri, "shaderlint/page"))
    assert "channels.toml:2:1: file" in refused.message, "the reason"


def test_a_single_shader_gets_channels_of_its_own(case):
    client = case.client(options=QUIET, capabilities=creating())
    source = case.write("sea.glsl", IMAGE).open(client)
    assert (
        client.of(source.uri, "shaderlint/page")["channels"] == {"uri": case.uri("sea.channels.toml"), "exists": False}
    ), "the file"
    case.write("channels.toml", '0 = "keyboard"\n')
    page = client.of(source.uri, "shaderlint/page")
    assert page["channels"] == {"uri": case.uri("channels.toml"), "exists": True}, "the file of the folder"
    assert [a["channel"] for a in page["assumed"]] == ["iChannel1"], "the assumed channels"
    # A shader in a script has no file beside it.
    script = case.write("scene.js", "const sea = /* glsl */ `%s`;\n" % IMAGE).open(client, "javascript")
    page = client.of(script.uri, "shaderlint/page")
    assert (page["channels"], len(page["assumed"])) == (None, 2), "the channels of a script"


VALUES = """float wave(float x) {
    float y = x;
    for (int i = 0; i < 3; i++) {
        «loop»y = sin(«sum»y + 0.625«end»);
    }
    return y;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    mat2 «matrix»turn = mat2(1.0);
    fragColor = vec4(turn * «coordinate»fragCoord, wave(fragCoord.x), 1.0);
}
"""


def test_values_are_previewed(case):
    client = case.client(options={"run": False, "previewCommand": "editor.preview"})
    source = case.write("a.glsl", VALUES).open(client)
    lines = client.lines(source.uri)

    def offered(start, end):
        context = {"diagnostics": [], "triggerKind": 1, "only": ["refactor"]}
        found = client.of(source.uri, "textDocument/codeAction", range=lines.range(start, end), context=context)
        return [a["command"] for a in found if a["title"] == "Preview this value"]

    chosen = lines.range(source["sum"], source["end"])
    [command] = offered(source["sum"], source["end"])
    assert (command["command"], command["arguments"]) == ("editor.preview", [source.uri, chosen]), "the command"
    page = client.of(source.uri, "shaderlint/page", value=chosen)
    assert page["value"] == {"text": "y + 0.625", "limits": [0.0, 1.0]}, "the value"
    assert "showValue(y + 0.625)" in page["html"], "the page"
    [command] = offered(source["loop"], source["loop"])
    assert client.of(source.uri, "shaderlint/page", value=command["arguments"][1])["value"]["text"] == "y"
    # With sample runs, the limits are those of the image.
    runs = case.client()
    source.open(runs)
    place = lines.range(source["coordinate"], source["coordinate"])
    [least, most] = runs.of(source.uri, "shaderlint/page", value=place)["value"]["limits"]
    assert least == 0.0 and 30.0 < most < 70.0, f"the limits: {least}, {most}"
    assert "showValue" not in client.of(source.uri, "shaderlint/page")["html"], "the shader shows a value"
    assert offered(source["matrix"], source["matrix"]) == [], "the value of a matrix"
    place = lines.range(source["matrix"], source["matrix"])
    refused = refusal(lambda: client.of(source.uri, "shaderlint/page", value=place))
    assert "cannot be shown" in refused.message, "the reason"


COSTLY = """#include "lib/wave.glsl"
#define TWICE(x) ((x) * 2.0 + 1.0)

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float s = TWICE(fragCoord.x);
    for (int i = 0; i < 10; i++) {
        s += wave(s);
    }
    fragColor = vec4(s);
}
"""


def test_costs_of_lines_are_those_of_the_lens(case):
    client = case.client()
    case.write("lib/wave.glsl", "float half_of(float x) { return x * 0.5; }\n"
               "float wave(float x) { return half_of(x) * half_of(x); }\n")
    source = case.write("a.glsl", COSTLY).open(client)
    [costs] = client.of(source.uri, "shaderlint/costs")
    assert (costs["shader"], costs["per"], costs["source"]) == (0, "pixel", "sampleRun"), "the shader"
    # An included function costs where it is called, a macro where it is used.
    lines = [(line["line"], line["operations"]) for line in costs["lines"]]
    assert lines == [(4, 2.0), (5, 21.0), (6, 40.0)], "the lines"
    # ShaderToy's own code around the shader costs 4.
    assert costs["operations"] == 67.0, "the sum"
    assert [round(line["share"], 3) for line in costs["lines"]] == [0.03, 0.313, 0.597], "the shares"

    def title():
        lenses = client.of(source.uri, "textDocument/codeLens")
        return next(t for t in (lens["command"]["title"] for lens in lenses) if "per pixel" in t)

    client.wait_until(lambda: "sample run" in title(), "the lens has no sample run")
    assert "sample run: 67 operations per pixel" in title(), "the lens"
    # Without a run, an estimate.
    quiet = case.client(options=QUIET)
    source.open(quiet)
    [estimate] = quiet.of(source.uri, "shaderlint/costs")
    assert estimate["source"] == "bound", "the source"
    assert [(line["line"], line["operations"]) for line in estimate["lines"]] == lines, "the estimated lines"
