"""Formatting: whole texts, ranges and on typing; by configuration and by editor settings."""

from harness import errors, holds, refusal, same, test

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


@test
def a_text_is_formatted(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    same(edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR)), NEAT, "the text")
    same(client.of(source.uri, "textDocument/formatting", options=FOUR), [], "the edits of a formatted text")


@test
def indentation_follows_the_editor(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    edits = client.of(source.uri, "textDocument/formatting", options={"tabSize": 2, "insertSpaces": True})
    expected = NEAT.replace("        ", "\t\t").replace("    ", "\t")
    same(edited(client, source, edits), expected.replace("\t", "  "), "the text, indented by two spaces")
    edits = client.of(source.uri, "textDocument/formatting", options={"tabSize": 4, "insertSpaces": False})
    same(edited(client, source, edits), expected, "the text, indented by tabs")


@test
def the_configuration_overrides_the_editor(case):
    case.write("shaderlint.toml", '[format]\nindent = 3\nbrace = "next"\n')
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    text = edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR))
    holds("fragCoord)\n{\n   vec2 uv" in text, "another style:", text)


@test
def range_formatting_keeps_the_rest(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    start, end = source["loop"] + 2, source["close"]
    edits = client.of(source.uri, "textDocument/rangeFormatting", options=FOUR,
                      range=client.lines(source.uri).range(start, end))
    text = edited(client, source, edits)
    before, after = source.text[:source["loop"]], source.text[source["close"] + 1:]
    holds(text.startswith(before), "code before the range changes:", text)
    holds(text.endswith(after), "code after the range changes:", text)
    same(text[len(before):len(text) - len(after)],
         "    for (int i = 0; i < 3; i++) {\n        uv *= 1.1;\n        uv += 0.1;\n    }", "the range")


@test
def a_formatted_range_has_no_edits(case):
    client = case.client()
    source = case.write("a.glsl", NEAT).open(client)
    for start, end in ((0, 0), (0, len(NEAT)), (60, 200)):
        same(client.of(source.uri, "textDocument/rangeFormatting", options=FOUR,
                       range=client.lines(source.uri).range(start, end)), [], "the edits")


@test
def a_block_is_formatted_when_it_is_closed(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    at = source["close"] + 1
    edits = client.at(source.uri, at, "textDocument/onTypeFormatting", ch="}", options=FOUR)
    text = edited(client, source, edits)
    holds("    for (int i = 0; i < 3; i++) {\n        uv *= 1.1;\n        uv += 0.1;\n    }\n" in text,
          "the loop is not formatted:", text)
    holds(text.startswith(source.text[:source["loop"]]), "code before the block changes:", text)
    holds(text.endswith(source.text[at:]), "code after the block changes:", text)


@test
def a_line_is_formatted_when_it_ends(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    at = source["semicolon"]
    edits = client.at(source.uri, at, "textDocument/onTypeFormatting", ch=";", options=FOUR)
    text = edited(client, source, edits)
    same(text, source.text.replace("   float a=1.0;", "    float a = 1.0;"), "the text")


@test
def unmatched_brackets_are_rejected(case):
    client = case.client()
    source = case.write("a.glsl", UGLY).open(client)
    client.replace(source.uri, source["first"], source["first"], "((")
    error = refusal(lambda: client.of(source.uri, "textDocument/formatting", options=FOUR))
    holds(error.message, "no reason is given", error)


@test
def only_shaders_of_a_page_are_formatted(case):
    client = case.client()
    body = '<p>é𝄞   two</p>\n<script type="x-shader/x-fragment">#version 300 es\nprecision highp float;\n' \
           "out vec4 color;\nvoid main( ){color=vec4( 1.0 ) ;}\n</script>\n<script>const a   = 1;</script>\n"
    source = case.write("page.html", body).open(client, "html")
    text = edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR))
    holds("color = vec4(1.0);" in text, "it is not formatted:", text)
    same((text[:text.index("#version")], text[text.index("</script>"):]),
         (body[:body.index("#version")], body[body.index("</script>"):]), "the code around it")
    same(errors(client.published(source.uri)), [], "the errors")


@test
def line_breaks_are_preserved(case):
    client = case.client()
    source = case.write("a.glsl", UGLY.replace("\n", "\r\n")).open(client)
    text = edited(client, source, client.of(source.uri, "textDocument/formatting", options=FOUR))
    same(text, NEAT.replace("\n", "\r\n"), "the text")
