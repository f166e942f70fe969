"""Completions, and that the completed code compiles."""

import re

from client import everything
from harness import errors

SHADER = """struct Ray { vec3 origin; float speed; };
#define LIMIT 4.0
float map(vec3 p, float gain) { return length(p) * gain; }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    Ray ray = Ray(vec3(0.0), 1.0);
    float list[3];
    for (int turn = 0; turn < 3; turn++) { float inner = 1.0; ray.speed += inner; }
    float here = 1.0;
    «at»
    float after = 2.0;
    fragColor = vec4(here, after, ray.speed, 1.0);
}
float later(float x) { return x; }
"""
PLACE = re.compile(r"\$\{\d+:([^}]*)\}|\$\d")


class Typed:
    """A shader in which something is typed."""

    def __init__(self, case, **settings):
        self.client = case.client(**settings)
        self.source = case.write("a.glsl", SHADER).open(self.client)
        self.uri = self.source.uri

    def ask(self, typed, back=0):
        """The completions after the typed text, or `back` characters before its end."""
        at = self.source["at"]
        self.client.write_all(self.uri, self.source.text[:at] + typed + self.source.text[at:])
        found = self.client.at(self.uri, at + len(typed) - back, "textDocument/completion")
        items = found["items"] if isinstance(found, dict) else found
        return {item["label"]: item for item in items}

    def accept(self, item):
        """Inserts a completion, including its placeholders."""
        edit = dict(item["textEdit"])
        if item.get("insertTextFormat") == 2:
            edit["newText"] = PLACE.sub(lambda place: place.group(1) or "", edit["newText"])
        lines = self.client.lines(self.uri)
        start, end = lines.span(edit["range"])
        self.client.replace(self.uri, start, end, edit["newText"])
        return edit["newText"]

    def left(self):
        """The errors of the current text."""
        return [d["message"] for d in errors(self.client.published(self.uri))]


def test_members_of_a_struct_are_completed(case):
    typed = Typed(case)
    assert sorted(typed.ask("ray.")) == ["origin", "speed"], "the members"
    found = typed.ask("here = ray.sp;", back=1)
    typed.accept(found["speed"])
    assert "here = ray.speed;" in typed.client.text(typed.uri), "the text"
    assert typed.left() == [], "the errors"
    assert typed.ask("ray.")["origin"]["detail"] == "vec3", "the type of a member"


def test_components_of_a_vector_are_completed(case):
    typed = Typed(case)
    found = typed.ask("ray.origin.")
    assert {"x", "xy", "xyz", "r", "rgb", "zyx"} <= set(found), ("too few components", sorted(found))
    assert not {"w", "a", "xyzw", "rgba", "speed", "mix"} & set(found), ("what a vec3 has not", sorted(found))
    assert found["xy"]["detail"] == "vec2", "the type of two components"
    found = typed.ask("here = texture(iChannel0, fragCoord).;", back=1)
    assert "w" in found and "xyzw" in found, ("components of a call", sorted(found))
    typed.accept(found["w"])
    assert typed.left() == [], "the errors"
    assert sorted(typed.ask("list.")) == ["length()"], "members of an array"
    assert typed.ask("here.") == {}, "members of a number"
    assert typed.ask("here = 1.") == {}, "completions after a decimal point"


def test_names_in_scope_are_completed(case):
    typed = Typed(case)
    found = typed.ask("here = ")
    for name in ("here", "ray", "fragCoord", "map", "LIMIT", "iTime", "mix", "Ray", "vec3"):
        assert name in found, ("«%s» is not completed" % name, sorted(found))
    for name in ("inner", "turn", "after", "later", "origin", "mainImage", "p", "gain"):
        assert name not in found, "«%s» cannot be named here" % name
    assert found["here"]["sortText"] < found["iTime"]["sortText"] < found["mix"]["sortText"], (
        "the nearest names come first", [found[n]["sortText"] for n in ("here", "iTime", "mix")]
    )
    assert found["ray"]["detail"] == "Ray", "the type of a variable"
    inside = typed.ask("for (int k = 0; k < 3; k++) { float deep = 1.0; here +=  }", back=2)
    assert "k" in inside and "deep" in inside, ("names of the loop", sorted(inside))


def test_calls_have_placeholders_for_arguments(case):
    typed = Typed(case)
    found = typed.ask("here = ma;", back=1)
    assert found["map"]["textEdit"]["newText"] == "map(${1:p}, ${2:gain})", "a function of the shader"
    assert found["map"]["insertTextFormat"] == 2, "its format"
    assert "mix(${1:" in found["mix"]["textEdit"]["newText"], "a function of the language"
    assert "`a`" in found["mix"]["documentation"]["value"], "its documentation"
    found = typed.ask("here = abs;", back=1)
    typed.accept(found["abs"])
    assert "here = abs(x);" in typed.client.text(typed.uri), "the text, with the name of the parameter"
    typed.client.write_all(typed.uri, typed.client.text(typed.uri).replace("abs(x)", "abs(here)"))
    assert typed.left() == [], "the errors"


def test_clients_without_snippets_get_plain_text(case):
    capabilities = everything()
    capabilities["textDocument"]["completion"]["completionItem"]["snippetSupport"] = False
    typed = Typed(case, capabilities=capabilities)
    for label, item in typed.ask("here = ").items():
        assert "$" not in item["textEdit"]["newText"] and item.get("insertTextFormat") in (None, 1), (
            "a snippet of %s" % label, item
        )


def test_directives_are_completed(case):
    typed = Typed(case)
    for words in ("#", "# ", "#inc"):
        found = typed.ask(words)
        assert {"define", "ifdef", "endif", "include"} <= set(found) and "mix" not in found, (
            "other completions after «%s»" % words, sorted(found)
        )
    typed.accept(typed.ask("#def LOCAL 1.0\nhere = LOCAL;", back=len(" LOCAL 1.0\nhere = LOCAL;"))["define"])
    assert "#define LOCAL 1.0\n" in typed.client.text(typed.uri), "the text"
    assert typed.left() == [], "the errors"


def test_include_paths_are_completed(case):
    case.write("lib.glsl", "float lib() { return 1.0; }\n")
    case.write("inner/deep.glsl", "float deep() { return 1.0; }\n")
    case.write("picture.png", "no image file")
    typed = Typed(case)
    assert sorted(typed.ask('#include "')) == ["inner", "lib.glsl"], "the files"
    assert sorted(typed.ask('#include "inner/')) == ["deep.glsl"], "the files of a folder"
    # Includes are completed at the start of a line, where directives are allowed; the inserted path
    # resolves.
    head = '#include "lib.'
    typed.client.write_all(typed.uri, head + '"\n' + typed.source.text.replace("here = 1.0", "here = lib()"))
    found = typed.client.at(typed.uri, len(head), "textDocument/completion")["items"]
    typed.accept([i for i in found if i["label"] == "lib.glsl"][0])
    assert '#include "lib.glsl"\n' in typed.client.text(typed.uri), "the text"
    assert typed.left() == [], "the errors"


def test_names_of_rules_are_completed(case):
    typed = Typed(case)
    found = typed.ask("// shaderlint: allow(unus")
    assert {"unused-variable", "float-equality"} <= set(found) and "mix" not in found, (
        "others", sorted(found)[:9]
    )
    assert len(found["unused-variable"]["detail"]) > 10, ("no rule summary", found["unused-variable"])
    typed.accept(found["unused-variable"])
    assert "// shaderlint: allow(unused-variable" in typed.client.text(typed.uri), "the text"
    found = typed.ask("// shaderlint: allow(float-equality, unused-v")
    typed.accept(found["unused-variable"])
    assert "allow(float-equality, unused-variable" in typed.client.text(typed.uri), "the second rule"
    assert typed.ask("// any other comm") == {}, "completions in an ordinary comment"
    assert typed.ask("/* here = ma */", back=3) == {}, "completions in an ordinary comment"


def test_snippets_are_completed(case):
    typed = Typed(case)
    inside = typed.ask("")
    loops = [i for i in inside.values() if i["kind"] == 15 and i["textEdit"]["newText"].startswith("for (")]
    assert len(loops) == 1, "the snippets of a loop"
    typed.accept(loops[0])
    assert typed.left() == [], "the errors of a loop as it is written"
    # Outside functions there are other snippets.
    client = typed.client
    client.write_all(typed.uri, "\n")
    items = client.at(typed.uri, 0, "textDocument/completion")["items"]
    written = [i["textEdit"]["newText"] for i in items if i["kind"] == 15]
    assert any("mainImage(" in text for text in written), f"no snippet of mainImage: {written}"
    assert any(text.startswith("struct ${1") for text in written), f"no snippet of a struct: {written}"
    main = [i for i in items if i["kind"] == 15 and "mainImage(" in i["textEdit"]["newText"]]
    typed.accept(main[0])
    assert typed.left() == [], "the errors of an empty mainImage"


def test_a_word_is_replaced_up_to_the_cursor(case):
    typed = Typed(case)
    found = typed.ask("float copy = hexyz;", back=4)
    start, end = typed.client.lines(typed.uri).span(found["here"]["textEdit"]["range"])
    assert typed.client.text(typed.uri)[start:end] == "he", "the replaced range"


def test_complete_webgl_shaders_have_other_names(case):
    client = case.client()
    source = case.write("a.frag", "#version 300 es\nprecision highp float;\nin vec2 vUv;\nuniform float gain;\n"
                        "out vec4 color;\nvoid main() {\n    color = vec4(vUv, «at»gain, 1.0);\n}\n").open(client)
    items = client.at(source.uri, source["at"], "textDocument/completion")["items"]
    labels = {i["label"] for i in items}
    assert {"vUv", "gain", "gl_FragCoord", "texture", "dFdx"} <= labels, ("missing names", sorted(labels))
    assert not {"iTime", "texture2D", "gl_Position", "gl_FragColor"} & labels, (
        "names that are not declared", sorted(labels)
    )
    layout = case.write("b.frag", "#version 300 es\nprecision highp float;\nlayout(«at») out vec4 color;\n"
                        "void main() { color = vec4(1.0); }\n").open(client)
    labels = {i["label"] for i in client.at(layout.uri, layout["at"], "textDocument/completion")["items"]}
    assert any(label.startswith("location") for label in labels) and "mix" not in labels, (
        "others", sorted(labels)
    )


def test_completions_replace_a_range_of_one_line(case):
    typed = Typed(case)
    for words in ("", "he", "ray.", "here = map(", "#", "// shaderlint: allow(", "vec3(", "else", "}"):
        for item in typed.ask(words).values():
            range_ = item["textEdit"]["range"]
            assert range_["start"]["line"] == range_["end"]["line"], "the line of %r" % (item,)
