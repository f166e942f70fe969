"""Shaders inside other languages: positions of diagnostics and edits refer to the containing
file."""

import json

from harness import by_rule, errors

SHADER = """#version 300 es
precision highp float;
in vec2 vUv;
uniform float gain;
out vec4 color;
void main() {
    float «var»unused = gain;
    color = vec4(vUv, vUv.«bad»nope, 1.0);
}
"""

WRAPPED = {
    "page.html": ("html", '<!doctype html>\n<p>é𝄞</p>\n<script id="f" type="x-shader/x-fragment">'
                          "%s</script>\n"),
    "shader.js": ("javascript", "// é𝄞\nexport const fragment = `%s`;\n"),
    "shader.ts": ("typescript", "const fragment: string = /* glsl */ `%s`;\nexport { fragment };\n"),
    "Shader.vue": ("vue", "<template><canvas/></template>\n<script setup>\nconst f = `%s`\n</script>\n"),
    "Shader.svelte": ("svelte", "<script>\n  const f = `%s`;\n</script>\n<canvas></canvas>\n"),
    "Shader.astro": ("astro", "---\nconst title = 'é';\n---\n<script>\nconst f = `%s`;\n</script>\n"),
    "notes.md": ("markdown", "# é𝄞\n\n```glsl\n%s```\n\nText.\n"),
}


def judged(case, name):
    """Checks diagnostics and a renaming for a shader inside another file."""
    language, around = WRAPPED[name]
    client = case.client()
    source = case.write(name, around % SHADER).open(client, language)
    lines = client.lines(source.uri)
    found = client.published(source.uri)
    assert [lines.span(d["range"])[0] for d in errors(found)] == [source["bad"]], "the error"
    assert "float unused" in client.at(source.uri, source["var"], "textDocument/hover")["contents"]["value"]
    client.apply(client.at(source.uri, source["var"], "textDocument/rename", newName="other"))
    assert client.text(source.uri) == source.text.replace("unused", "other"), "the text afterwards"
    client.replace(source.uri, client.text(source.uri).index("nope"), client.text(source.uri).index("nope") + 4, "x")
    client.published(source.uri)
    names = [s["name"] for s in client.of(source.uri, "textDocument/documentSymbol")]
    assert "main" in names and "gain" in names, f"the outline is incomplete: {names}"


def test_shaders_in_pages_are_edited_in_place(case):
    judged(case, "page.html")


def test_shaders_in_scripts_are_edited_in_place(case):
    judged(case, "shader.js")


def test_shaders_in_typescript_are_edited_in_place(case):
    judged(case, "shader.ts")


def test_shaders_in_vue_are_edited_in_place(case):
    judged(case, "Shader.vue")


def test_shaders_in_svelte_are_edited_in_place(case):
    judged(case, "Shader.svelte")


def test_shaders_in_astro_are_edited_in_place(case):
    judged(case, "Shader.astro")


def test_shaders_in_markdown_are_edited_in_place(case):
    judged(case, "notes.md")


def test_a_script_without_shaders_has_no_diagnostics(case):
    client = case.client()
    source = case.write("plain.js", "const a = `b ${1 + 1}`;\nfor (;;) { if (a) break; }\n")
    source.open(client, "javascript")
    assert client.published(source.uri) == [], "the diagnostics"
    for method in ("documentSymbol", "foldingRange", "documentColor"):
        assert (client.of(source.uri, "textDocument/" + method) or []) == [], method


def export(image, common):
    """A ShaderToy export as the website writes it: on one line."""
    def one(name, kind, code):
        output = [{"id": 37, "channel": 0}] if kind == "image" else []
        return {"inputs": [], "outputs": output, "code": code, "name": name, "description": "",
                "type": kind}

    shader = {"ver": "0.1", "info": {"id": "abcdef", "name": "é", "username": "a", "description": "",
                                     "tags": []},
              "renderpass": [one("Image", "image", image), one("Common", "common", common)]}
    return json.dumps(shader)


def test_shaders_in_exports_are_edited_in_place(case):
    client = case.client()
    image = ("// \u00e9\tquote \" and \\\\ \nvoid mainImage(out vec4 fragColor, in vec2 fragCoord) {\n"
             "    fragColor = vec4(fragCoord / iResolution.xy, wave(iTime), missing);\n}\n")
    common = "float wave(float x) {\n    return sin(x);\n}\n"
    source = case.write("shader.json", export(image, common)).open(client, "json")
    lines = client.lines(source.uri)
    found = client.published(source.uri)
    assert [lines.at(d["range"]) for d in errors(found)] == ["missing"], "the error"
    use = source.text.index("wave(iTime)")
    location = client.at(source.uri, use, "textDocument/definition")
    assert lines.span(location["range"])[0] == source.text.index("wave(float x)"), "the definition"
    # A name is renamed in all passes of an export; its strings stay escaped.
    client.apply(client.at(source.uri, use, "textDocument/rename", newName="ripple"))
    assert client.text(source.uri) == source.text.replace("wave(", "ripple("), "the text afterwards"
    json.loads(client.text(source.uri))


def test_an_edit_in_an_export_is_escaped(case):
    client = case.client()
    image = ("void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n"
             "    float unused = 2.0;\n"
             "    fragColor = vec4(fragCoord / iResolution.xy, wave(iTime), 1.0);\n}\n")
    common = "float wave(float x) {\n    return sin(x);\n}\n"
    source = case.write("shader.json", export(image, common)).open(client, "json")
    finding = by_rule(client.published(source.uri), "unused-variable")
    actions = client.of(source.uri, "textDocument/codeAction", range=finding["range"],
                        context={"diagnostics": [finding]})
    allow = [a for a in actions if a["title"].startswith("Allow")]
    assert len(allow) == 1, "the actions that allow it"
    client.apply(allow[0]["edit"])
    passes = json.loads(client.text(source.uri))["renderpass"]
    assert "    // shaderlint: allow(unused-variable)\n    float unused" in passes[0]["code"], "the pass"
    found = client.published(source.uri)
    assert [d for d in found if d["code"] == "unused-variable"] == [], "the remaining diagnostics"
