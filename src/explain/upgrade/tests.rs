//! Conversions, and what is refused.

use super::*;
use crate::Checked;
use shaderlint_semantic::Stage;
use shaderlint_text::FileId;

fn checked(stage: Stage, text: &str) -> Checked {
    let mut sources = Sources::new();
    let file = sources.add("a", None, Role::User, text);
    let files: &[FileId] = file.as_slice();
    analyze(&Unit {
        sources: &Arc::new(sources),
        files,
        stage,
        dialect: Dialect::WebGl,
        infer_channels: false,
        completeness: Completeness::Complete,
    })
}

/// The converted text, or the text at the obstacle and its kind.
fn convert(stage: Stage, text: &str) -> String {
    let checked = checked(stage, text);
    match upgrade(&checked.program) {
        Ok(done) => apply_edits(text, 0, &done.edits).unwrap(),
        Err(obstacle) => {
            let kind = format!("{:?}", obstacle.kind);
            let kind = kind.split(['(', ' ']).next().unwrap_or("");
            format!("{kind}: {}", checked.program.sources.text(obstacle.span))
        }
    }
}

#[track_caller]
fn fragment(text: &str, expected: &str) {
    assert_eq!(convert(Stage::Fragment, text), expected);
}

#[track_caller]
fn vertex(text: &str, expected: &str) {
    assert_eq!(convert(Stage::Vertex, text), expected);
}

#[test]
fn shaders_are_converted() {
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (text, expected) = case.split_once(" ⇒ ").unwrap();
        let [text, expected] = [text, expected].map(|text| text.replace('↵', "\n"));
        match text.strip_prefix("vertex: ") {
            Some(text) => vertex(text, &expected),
            None => fragment(text.strip_prefix("fragment: ").unwrap(), &expected),
        }
    }
}

#[test]
fn outputs_are_declared() {
    let head = "precision highp float;\n";
    fragment(
        &format!("{head}void main() {{ gl_FragData[0] = vec4(1.0); }}\n"),
        "#version 300 es\nprecision highp float;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(1.0); }\n",
    );
    fragment(
        &format!(
            "#extension GL_EXT_draw_buffers : require\n{head}\
             void main() {{ gl_FragData[0] = vec4(1.0); gl_FragData[2] = vec4(0.5); }}\n"
        ),
        "#version 300 es\nprecision highp float;\nout vec4 fragData[3];\n\
         void main() { fragData[0] = vec4(1.0); fragData[2] = vec4(0.5); }\n",
    );
    // Without a default precision, the built-in output is `mediump`.
    fragment(
        "void main() { gl_FragColor = vec4(1.0); }\n",
        "#version 300 es\nout mediump vec4 fragColor;\nvoid main() { fragColor = vec4(1.0); }\n",
    );
    fragment(
        &format!(
            "#extension GL_EXT_draw_buffers : enable\n{head}void main() {{ gl_FragColor = vec4(1.0); }}\n"
        ),
        "Broadcast: gl_FragColor",
    );
}

#[test]
fn reserved_and_built_in_names_are_replaced() {
    let head = "precision highp float;\nuniform sampler2D t;\nvarying vec2 v;\n";
    let new = "#version 300 es\nprecision highp float;\nout vec4 fragColor;\nuniform sampler2D t;\nin vec2 v;\n";
    let check = |code: &str, expected: &str| {
        fragment(&format!("{head}{code}"), &format!("{new}{expected}"));
    };
    // Reserved words, also of members.
    check(
        "struct S { float patch; };\nvoid main() { S s; s.patch = 1.0; float sample = s.patch; gl_FragColor = vec4(sample); }\n",
        "struct S { float myPatch; };\nvoid main() { S s; s.myPatch = 1.0; float mySample = s.myPatch; fragColor = vec4(mySample); }\n",
    );
    // Functions that are built-in now; a variable may have the same name.
    check(
        "float round(float x) { return floor(x + 0.5); }\nvoid main() { float trunc = round(v.x); gl_FragColor = vec4(trunc); }\n",
        "float myRound(float x) { return floor(x + 0.5); }\nvoid main() { float trunc = myRound(v.x); fragColor = vec4(trunc); }\n",
    );
    // Overloads of a built-in function, which is called as well.
    check(
        "int mod(int a, int b) { return a - a / b * b; }\nvoid main() { gl_FragColor = vec4(mod(v.x, 2.0) + float(mod(3, 2))); }\n",
        "int myMod(int a, int b) { return a - a / b * b; }\nvoid main() { fragColor = vec4(mod(v.x, 2.0) + float(myMod(3, 2))); }\n",
    );
    // Calls with arguments that only GLSL ES 3.00 or an extension accepts.
    check(
        "float round(float x) { return x; }\nvoid main() { gl_FragColor = vec4(round(fwidth(v.x))); }\n",
        "float myRound(float x) { return x; }\nvoid main() { fragColor = vec4(myRound(fwidth(v.x))); }\n",
    );
    fragment(
        &format!(
            "{head}int mod(int a, int b) {{ return a; }}\nvoid main() {{ gl_FragColor = vec4(mod(fwidth(v.x), 2.0)); }}\n"
        ),
        "UnknownCall: mod(fwidth(v.x), 2.0)",
    );
    // Names that hide the new functions.
    check(
        "void main() { vec4 texture = texture2D(t, v); gl_FragColor = texture; }\n",
        "void main() { vec4 myTexture = texture(t, v); fragColor = myTexture; }\n",
    );
    // Own functions with names of old ones.
    check(
        "vec4 texture2DLod(vec2 p) { return vec4(p, 0.0, 1.0); }\nvoid main() { gl_FragColor = texture2DLod(v); }\n",
        "vec4 texture2DLod(vec2 p) { return vec4(p, 0.0, 1.0); }\nvoid main() { fragColor = texture2DLod(v); }\n",
    );
}

#[test]
fn a_renamed_uniform_is_listed() {
    let text = "precision highp float;\nuniform sampler2D texture;\nvarying vec2 v;\n\
                void main() { gl_FragColor = texture2D(texture, v); }\n";
    let checked = checked(Stage::Fragment, text);
    let done = upgrade(&checked.program).unwrap();
    let renamed = [("texture".to_string(), "myTexture".to_string())];
    assert_eq!(done.renamed, renamed);
}

#[test]
fn shaders_that_cannot_be_converted_are_refused() {
    let main = "void main() { gl_FragColor = vec4(1.0); }\n";
    fragment(
        &format!("#if __VERSION__ < 300\nprecision highp float;\n#endif\n{main}"),
        "VersionTest: __VERSION__",
    );
    fragment(
        &format!("#ifdef GL_OES_standard_derivatives\nfloat a;\n#endif\n{main}"),
        "ExtensionTest: GL_OES_standard_derivatives",
    );
    fragment(
        "precision highp float;\nvoid f(float a) { float a = 1.0; }\nvoid main() { gl_FragColor = vec4(1.0); }\n",
        "Error: a",
    );
}
