"""Formatting: whole texts, ranges and on typing; by configuration and by editor settings."""

from harness import errors, refusal

UGLY = """void  mainImage( out vec4 fragColor,in vec2 fragCoord ){
«first»  vec2 uv=fragCoord/iResolution.xy ; // é𝄞   stays
«loop»for(int i=0;i<3;i++){uv*=1.1 ;
uv+=0.1;«close»}
   float a=1.0;«semicolon»
      fragColor=vec4( uv,a , 1.0 );
}
"""
NEAT = """void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy; // é𝄞   stays
    for (int i = 0; i < 3; i++) {
        uv *= 1.1;
        uv += 0.1;
    }
    float a = 1.0;
    fragColor = vec4(uv, a, 1.0);
}
"""
FOUR = {"tabSize": 4, "insertSpaces": True}


def edited(client, source, edits):
    client.apply({"changes": {source.uri: edits or []}})
    return client.text(source.uri)


def test_a_text_is_formatted(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    assert edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR)) == NEAT
    assert client.of(source.uri, "textDocument/formatting", options=FOUR) == [], "the edits of a formatted text"


def test_indentation_follows_the_editor(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    edits = client.of(source.uri, "textDocument/formatting", options={"tabSize": 2, "insertSpaces": True})
    expected = NEAT.replace("        ", "\t\t").replace("    ", "\t")
    assert edited(client, source, edits) == expected.replace("\t", "  "), "the text, indented by two spaces"
    edits = client.of(source.uri, "textDocument/formatting", options={"tabSize": 4, "insertSpaces": False})
    assert edited(client, source, edits) == expected, "the text, indented by tabs"


def test_the_configuration_overrides_the_editor(case):
    case.write("shaderlint.toml", '[format]\nindent = 3\nbrace = "next"\n')
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    text = edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR))
    assert "fragCoord)\n{\n   vec2 uv" in text, f"another style: {text}"


def test_range_formatting_keeps_the_rest(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    start, end = source["loop"] + 2, source["close"]
    edits = client.of(source.uri, "textDocument/rangeFormatting", options=FOUR,
                      range=client.lines(source.uri).range(start, end))
    text = edited(client, source, edits)
    before, after = source.text[:source["loop"]], source.text[source["close"] + 1:]
    assert text.startswith(before), f"code before the range changes: {text}"
    assert text.endswith(after), f"code after the range changes: {text}"
    assert (
        text[len(before):len(text) - len(after)] == "    for (int i = 0; i < 3; i++) {\n        uv *= 1.1;\n        uv += 0.1;\n    }"
    ), "the range"


def test_a_formatted_range_has_no_edits(case):
    client = case.client()
    source = case.write("a.glsl", NEAT).open(client)
    for start, end in ((0, 0), (0, len(NEAT)), (60, 200)):
        range_ = client.lines(source.uri).range(start, end)
        assert client.of(source.uri, "textDocument/rangeFormatting", options=FOUR, range=range_) == [], "the edits"


def test_a_block_is_formatted_when_it_is_closed(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    at = source["close"] + 1
    edits = client.at(source.uri, at, "textDocument/onTypeFormatting", ch="}", options=FOUR)
    text = edited(client, source, edits)
    assert "    for (int i = 0; i < 3; i++) {\n        uv *= 1.1;\n        uv += 0.1;\n    }\n" in text
    assert text.startswith(source.text[:source["loop"]]), f"code before the block changes: {text}"
    assert text.endswith(source.text[at:]), f"code after the block changes: {text}"


def test_a_line_is_formatted_when_it_ends(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    at = source["semicolon"]
    edits = client.at(source.uri, at, "textDocument/onTypeFormatting", ch=";", options=FOUR)
    text = edited(client, source, edits)
    assert text == source.text.replace("   float a=1.0;", "    float a = 1.0;"), "the text"


def test_unmatched_brackets_are_rejected(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    client.replace(source.uri, source["first"], source["first"], "((")
    error = refusal(lambda: client.of(source.uri, "textDocument/formatting", options=FOUR))
    assert error.message, f"no reason is given: {error}"


def test_only_shaders_of_a_page_are_formatted(case):
    client = case.client()
    body = '<p>é𝄞   two</p>\n<script type="x-shader/x-fragment">#version 300 es\nprecision highp float;\n' \
           "out vec4 color;\nvoid main( ){color=vec4( 1.0 ) ;}\n</script>\n<script>const a   = 1;</script>\n"
    source = case.write("page.html", body).open(client, "html")
    text = edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR))
    assert "color = vec4(1.0);" in text, f"it is not formatted: {text}"
    assert (
        (text[:text.index("#version")], text[text.index("</script>"):]) == (body[:body.index("#version")], body[body.index("</script>"):])
    ), "the code around it"
    assert errors(client.published(source.uri)) == [], "the errors"


def test_line_breaks_are_preserved(case):
    client = case.client()
    source = case.write("a.glsl", UGLY.replace("\n", "\r\n")).open(client)
    text = edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR))
    assert text == NEAT.replace("\n", "\r\n"), "the text"
