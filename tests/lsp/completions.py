"""Completions, and that the completed code compiles."""

import re

from harness import contains, errors, everything, holds, same, test

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


@test
def members_of_a_struct(case):
    typed = Typed(case)
    same(sorted(typed.ask("ray.")), ["origin", "speed"], "the members")
    found = typed.ask("here = ray.sp;", back=1)
    typed.accept(found["speed"])
    contains(typed.client.text(typed.uri), "here = ray.speed;", "the text")
    same(typed.left(), [], "the errors")
    same(typed.ask("ray.")["origin"]["detail"], "vec3", "the type of a member")


@test
def components_of_a_vector(case):
    typed = Typed(case)
    found = typed.ask("ray.origin.")
    holds({"x", "xy", "xyz", "r", "rgb", "zyx"} <= set(found), "too few components", sorted(found))
    holds(not {"w", "a", "xyzw", "rgba", "speed", "mix"} & set(found), "what a vec3 has not", sorted(found))
    same(found["xy"]["detail"], "vec2", "the type of two components")
    found = typed.ask("here = texture(iChannel0, fragCoord).;", back=1)
    holds("w" in found and "xyzw" in found, "components of a call", sorted(found))
    typed.accept(found["w"])
    same(typed.left(), [], "the errors")
    same(sorted(typed.ask("list.")), ["length()"], "members of an array")
    same(typed.ask("here."), {}, "members of a number")
    same(typed.ask("here = 1."), {}, "completions after a decimal point")


@test
def names_that_are_in_scope(case):
    typed = Typed(case)
    found = typed.ask("here = ")
    for name in ("here", "ray", "fragCoord", "map", "LIMIT", "iTime", "mix", "Ray", "vec3"):
        holds(name in found, "«%s» is not completed" % name, sorted(found))
    for name in ("inner", "turn", "after", "later", "origin", "mainImage", "p", "gain"):
        holds(name not in found, "«%s» cannot be named here" % name)
    holds(found["here"]["sortText"] < found["iTime"]["sortText"] < found["mix"]["sortText"],
          "the nearest names come first", [found[n]["sortText"] for n in ("here", "iTime", "mix")])
    same(found["ray"]["detail"], "Ray", "the type of a variable")
    inside = typed.ask("for (int k = 0; k < 3; k++) { float deep = 1.0; here +=  }", back=2)
    holds("k" in inside and "deep" in inside, "names of the loop", sorted(inside))


@test
def calls_have_placeholders_for_arguments(case):
    typed = Typed(case)
    found = typed.ask("here = ma;", back=1)
    same(found["map"]["textEdit"]["newText"], "map(${1:p}, ${2:gain})", "a function of the shader")
    same(found["map"]["insertTextFormat"], 2, "its format")
    contains(found["mix"]["textEdit"]["newText"], "mix(${1:", "a function of the language")
    contains(found["mix"]["documentation"]["value"], "`a`", "its documentation")
    found = typed.ask("here = abs;", back=1)
    typed.accept(found["abs"])
    contains(typed.client.text(typed.uri), "here = abs(x);", "the text, with the name of the parameter")
    typed.client.write_all(typed.uri, typed.client.text(typed.uri).replace("abs(x)", "abs(here)"))
    same(typed.left(), [], "the errors")


@test
def clients_without_snippets_get_plain_text(case):
    capabilities = everything()
    capabilities["textDocument"]["completion"]["completionItem"]["snippetSupport"] = False
    typed = Typed(case, capabilities=capabilities)
    for label, item in typed.ask("here = ").items():
        holds("$" not in item["textEdit"]["newText"] and item.get("insertTextFormat") in (None, 1),
              "a snippet of %s" % label, item)


@test
def directives(case):
    typed = Typed(case)
    for words in ("#", "# ", "#inc"):
        found = typed.ask(words)
        holds({"define", "ifdef", "endif", "include"} <= set(found) and "mix" not in found,
              "other completions after «%s»" % words, sorted(found))
    typed.accept(typed.ask("#def LOCAL 1.0\nhere = LOCAL;", back=len(" LOCAL 1.0\nhere = LOCAL;"))["define"])
    contains(typed.client.text(typed.uri), "#define LOCAL 1.0\n", "the text")
    same(typed.left(), [], "the errors")


@test
def paths_of_includes(case):
    case.write("lib.glsl", "float lib() { return 1.0; }\n")
    case.write("inner/deep.glsl", "float deep() { return 1.0; }\n")
    case.write("picture.png", "no image file")
    typed = Typed(case)
    same(sorted(typed.ask('#include "')), ["inner", "lib.glsl"], "the files")
    same(sorted(typed.ask('#include "inner/')), ["deep.glsl"], "the files of a folder")
    # Includes are completed at the start of a line, where directives are allowed; the inserted path
    # resolves.
    head = '#include "lib.'
    typed.client.write_all(typed.uri, head + '"\n' + typed.source.text.replace("here = 1.0", "here = lib()"))
    found = typed.client.at(typed.uri, len(head), "textDocument/completion")["items"]
    typed.accept([i for i in found if i["label"] == "lib.glsl"][0])
    contains(typed.client.text(typed.uri), '#include "lib.glsl"\n', "the text")
    same(typed.left(), [], "the errors")


@test
def names_of_rules(case):
    typed = Typed(case)
    found = typed.ask("// shaderlint: allow(unus")
    holds({"unused-variable", "float-equality"} <= set(found) and "mix" not in found, "others", sorted(found)[:9])
    holds(len(found["unused-variable"]["detail"]) > 10, "no rule summary", found["unused-variable"])
    typed.accept(found["unused-variable"])
    contains(typed.client.text(typed.uri), "// shaderlint: allow(unused-variable", "the text")
    found = typed.ask("// shaderlint: allow(float-equality, unused-v")
    typed.accept(found["unused-variable"])
    contains(typed.client.text(typed.uri), "allow(float-equality, unused-variable", "the second rule")
    same(typed.ask("// any other comm"), {}, "completions in an ordinary comment")
    same(typed.ask("/* here = ma */", back=3), {}, "completions in an ordinary comment")


@test
def snippets(case):
    typed = Typed(case)
    inside = typed.ask("")
    loops = [i for i in inside.values() if i["kind"] == 15 and i["textEdit"]["newText"].startswith("for (")]
    same(len(loops), 1, "the snippets of a loop")
    typed.accept(loops[0])
    same(typed.left(), [], "the errors of a loop as it is written")
    # Outside functions there are other snippets.
    client = typed.client
    client.write_all(typed.uri, "\n")
    items = client.at(typed.uri, 0, "textDocument/completion")["items"]
    written = [i["textEdit"]["newText"] for i in items if i["kind"] == 15]
    holds(any("mainImage(" in text for text in written), "no snippet of mainImage", written)
    holds(any(text.startswith("struct ${1") for text in written), "no snippet of a struct", written)
    main = [i for i in items if i["kind"] == 15 and "mainImage(" in i["textEdit"]["newText"]]
    typed.accept(main[0])
    same(typed.left(), [], "the errors of an empty mainImage")


@test
def a_word_is_replaced_up_to_the_cursor(case):
    typed = Typed(case)
    found = typed.ask("float copy = hexyz;", back=4)
    start, end = typed.client.lines(typed.uri).span(found["here"]["textEdit"]["range"])
    same(typed.client.text(typed.uri)[start:end], "he", "the replaced range")


@test
def complete_webgl_shaders_have_other_names(case):
    client = case.client()
    source = case.write("a.frag", "#version 300 es\nprecision highp float;\nin vec2 vUv;\nuniform float gain;\n"
                        "out vec4 color;\nvoid main() {\n    color = vec4(vUv, «at»gain, 1.0);\n}\n").open(client)
    items = client.at(source.uri, source["at"], "textDocument/completion")["items"]
    labels = {i["label"] for i in items}
    holds({"vUv", "gain", "gl_FragCoord", "texture", "dFdx"} <= labels, "missing names", sorted(labels))
    holds(not {"iTime", "texture2D", "gl_Position", "gl_FragColor"} & labels, "names that are not declared", sorted(labels))
    layout = case.write("b.frag", "#version 300 es\nprecision highp float;\nlayout(«at») out vec4 color;\n"
                        "void main() { color = vec4(1.0); }\n").open(client)
    labels = {i["label"] for i in client.at(layout.uri, layout["at"], "textDocument/completion")["items"]}
    holds(any(label.startswith("location") for label in labels) and "mix" not in labels, "others", sorted(labels))


@test
def completions_replace_a_range_of_one_line(case):
    typed = Typed(case)
    for words in ("", "he", "ray.", "here = map(", "#", "// shaderlint: allow(", "vec3(", "else", "}"):
        for item in typed.ask(words).values():
            range_ = item["textEdit"]["range"]
            same(range_["start"]["line"], range_["end"]["line"], "the line of %r" % (item,))
