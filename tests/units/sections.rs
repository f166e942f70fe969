//! Texts with several shaders.

use crate::scratch::Scratch;
use shaderlint::detect::embed::{DocumentLanguage, extract};

#[test]
fn shaders_are_found_between_lines_that_name_a_stage() {
    let vertex = "attribute vec4 a;\nvoid main() { gl_Position = a; }\n";
    let fragment = "void main() { gl_FragColor = vec4(1.0); }\n";
    for (first, second, end) in [
        ("[vertex]\n", "[fragment]\n", ""),
        ("<vertex>\n", "</vertex>\n<fragment>\n", "</fragment>\n"),
        ("{\"a\": 1}\n<Vertex>\n", "<\\Vertex>\n<Fragment>\n", ""),
        ("#type vertex\n", "#type fragment\n", ""),
        ("-- Sky.Vertex\n", "-- Sky.Fragment\n", ""),
        ("// vertex shader\n", "//@fragment\n", ""),
        ("// vertex\n", "== 2 ==\n// fragment\n", ""),
    ] {
        let text = [first, vertex, second, fragment, end].concat();
        let found = extract(DocumentLanguage::Sections, &text);
        let found: Vec<_> = found
            .iter()
            .map(|s| (s.code.trim_end(), s.stage.is_some()))
            .collect();
        let expected = [(vertex.trim_end(), true), (fragment.trim_end(), false)];
        assert_eq!(found, expected, "{text}");
    }
    let both = |line: &str| [line, vertex, line, fragment].concat();
    assert_eq!(
        extract(DocumentLanguage::Sections, &both("#version 300 es\n")).len(),
        2
    );
    assert_eq!(
        extract(DocumentLanguage::Sections, &both("#version 450\n")),
        []
    );
    assert_eq!(
        extract(
            DocumentLanguage::Sections,
            &both("#ifdef A\n// vertex\n#endif\n")
        ),
        []
    );
    assert_eq!(
        extract(
            DocumentLanguage::Sections,
            &["// vertex\n", vertex, "// fragment\n"].concat()
        ),
        []
    );
}
#[test]
fn chunks_are_found_between_export_and_end() {
    let text =
        "x\n@export a.b.vertex\n#define N 4;\nuniform vec2 c : [1, 2];\n@import a.c.d\n@end\n";
    let code = "#define N 4 \nuniform vec2 c         ;\n#import a.c.d\n";
    let [chunk] = &extract(DocumentLanguage::Sections, text)[..] else {
        panic!()
    };
    assert_eq!(
        (chunk.start, &*chunk.code, chunk.stage.is_some()),
        (21, code, true)
    );
    assert_eq!(
        extract(DocumentLanguage::Sections, "@import a.b.c\nfloat x;\n").len(),
        1
    );
    assert_eq!(
        extract(DocumentLanguage::Sections, "@import 'a.b.c'\nfloat x;\n").len(),
        0
    );
}

#[test]
fn each_shader_of_a_text_is_checked_at_its_place() {
    let vertex = "precision highp float;\nattribute vec3 a;\nvarying vec2 v;\nvoid main() {\n    gl_Position = vec4(a, 1);\n}\n";
    let fragment = "precision highp float;\nvarying vec3 v;\nvoid main() {\n    gl_FragColor = vec4(v, 1.0);\n    float x = 1;\n}\n";
    let text = ["[vertex]\n", vertex, "[fragment]\n", fragment].concat();
    let folder = Scratch::new(&[("a.glsl", &text)]);
    let found = folder.places(&["a.glsl"]);
    assert_eq!(found, ["13:15 int-float-mix"]);
    let fixed = text.replace("x = 1;", "x = 1.0;");
    folder.write("a.glsl", &fixed);
    // The stages do not match.
    let found = folder.places(&["a.glsl"]);
    assert!(found.iter().any(|f| f.contains("link")), "{found:?}");
    assert_eq!(folder.run(&["fmt", "--check", "a.glsl"]).code, 0);
}

#[test]
fn chunks_of_a_library_are_checked() {
    let text = "@export a.b.fragment\n#define N 4;\nuniform float size : 1.0;\n@import a.c.d\nvoid main() {\n    float x = 1;\n    gl_FragColor = vec4(size * float(N));\n}\n@end\n\n@export a.c.d\nfloat half_of(float x) { return x / 2; }\n@end\n";
    let folder = Scratch::new(&[("a.glsl", text)]);
    let found = folder.places(&["a.glsl"]);
    assert_eq!(found, ["6:15 int-float-mix", "12:37 int-float-mix"]);
}

#[test]
fn imported_chunks_are_those_of_the_whole_repository() {
    let text = "@export a.b.fragment\nuniform vec3 color = vec3(1.0), other : [1, 2, 3]; // x: y\n@import a.c.d\nvoid main() {\n    gl_FragColor = twice(color);\n    other = missing + absent * COUNT;\n}\n@end\n\n@export a.c.e\nfloat part(float x) { return x / 2; }\n@import a.c.d\n@end\n";
    let script = "export default \"\\n@export a.c.d\\n@import a.c.e\\nvec3 twice(vec3 x) { return x * 2; }\\n@end\\n@export a.c.f\\nuniform mat4 m : WORLD;\\nvoid main() {\\n gl_FragColor = vec3(m[0]);\\n}\\n@end\";\n";
    let folder = Scratch::new(&[("x/a.glsl", text), ("y/chunks.glsl.js", script)]);
    // Each is reported once, although the chunks import each other.
    let found = folder.places(&["x/a.glsl"]);
    let expected = [
        "5:5 vector-size",
        "6:5 not-assignable",
        "6:13 undeclared-name",
        "6:23 undeclared-name",
        "11:34 int-float-mix",
    ];
    assert_eq!(found, expected);
    let found = folder.places(&["y/chunks.glsl.js"]);
    assert_eq!(found, ["1:81 int-float-mix", "1:149 vector-size"]);
    // The cache notices other files.
    folder.write(
        "y/chunks.glsl.js",
        script.replace("vec3 twice", "vec4 twice"),
    );
    assert_eq!(folder.places(&["x/a.glsl"])[0], "6:5 not-assignable");
    // A package has the chunks that the repository does not have.
    let import =
        "uniform float a : 0.5;\n@import clay.util.f\nvoid main() { gl_FragColor = f(a); }\n";
    let package = "@export clay.util.f\nfloat f(float x) { return x; }\n@end\n";
    let files = [
        ("a.glsl", import),
        ("node_modules/claygl/src/f.glsl", package),
    ];
    assert_eq!(
        Scratch::new(&files).places(&["a.glsl"]),
        ["3:15 vector-size"]
    );
    let script = format!("const text = `{import}`;");
    let files = [
        ("a.js", &*script),
        ("node_modules/claygl/src/f.glsl", package),
    ];
    assert_eq!(Scratch::new(&files).places(&["a.js"]), ["3:15 vector-size"]);
}

#[test]
fn annotations_are_removed_where_a_library_does_so() {
    let page = |uses: &str| {
        format!(
            "<script type=\"x-shader/x-vertex\">\nattribute vec3 at: POSITION;\nvoid main() {{ float a; gl_Position = vec4(at, 1.0); }}\n</script>\n<script>{uses}</script>\n"
        )
    };
    let folder = Scratch::new(&[("a.html", &page("new clay.Shader(a)"))]);
    // The rules run.
    assert_eq!(folder.places(&["a.html"]), ["3:21 unused-variable"]);
    folder.write("a.html", page("f(a)"));
    assert_eq!(folder.places(&["a.html"]), ["2:18 foreign-syntax"]);
}
