//! What a text is written for.

use shaderlint::semantic::{GuessedKind, Pass, Stage, guess};

#[track_caller]
fn check(text: &str, kind: Option<GuessedKind>) {
    assert_eq!(guess(text).kind, kind, "{text}");
}

#[test]
fn the_names_of_a_text_show_its_dialect() {
    check(
        "#version 300 es\nvoid mainImage(){} void main(){}",
        Some(GuessedKind::Versioned),
    );
    check("\n  # version 100\n", Some(GuessedKind::Versioned));
    check(
        "void mainImage(out vec4 c, vec2 f){}",
        Some(GuessedKind::ShaderToy(Pass::Image)),
    );
    check("// mainImage\nfloat f(){return 1.;}", None);
    check(
        "vec4 mainImage(out vec4 c, vec2 f){}",
        Some(GuessedKind::ShaderToy(Pass::Image)),
    );
    check("vec4 mainImage(vec2 uv){}", None);
    check("void mainImage(in vec4 a, in vec2 b, out vec4 c){}", None);
    check(
        "void main(){ gl_FragColor = vec4(1); }",
        Some(GuessedKind::WebGl1),
    );
    check(
        "out vec4 c; void main(){ c = vec4(1); }",
        Some(GuessedKind::WebGl2),
    );
    check("float f(float x) { return x; }", None);
    for name in ["mainimage", "MainImage", "main"] {
        check(
            &format!("void {name}(out vec4 c, in vec2 p) {{}}"),
            Some(GuessedKind::ShaderToy(Pass::Image)),
        );
    }
    check("void mainimage(out vec4 c, in vec2 p, float t) {}", None);
    // What a directive skips or defines is not what the text is for.
    let image = "void mainImage(out vec4 c, vec2 f){}\n";
    let main = "void main(){ mainImage(c, gl_FragCoord.xy); }\n";
    for open in ["#if 0", "#ifdef STANDALONE"] {
        check(
            &format!("{image}{open}\n{main}#endif\n"),
            Some(GuessedKind::ShaderToy(Pass::Image)),
        );
    }
    check(
        &format!("{image}#ifdef GL_ES\n{main}#endif\n"),
        Some(GuessedKind::WebGl2),
    );
    let found = guess("#define attribute in\nvoid main(){ gl_FragColor = vec4(1); }");
    assert_eq!(found.stage, Some(Stage::Fragment));
    assert_eq!(
        guess("void main(){gl_Position=vec4(0);}").stage,
        Some(Stage::Vertex)
    );
}
