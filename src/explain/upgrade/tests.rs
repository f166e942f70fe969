//! Conversions, and what is refused.

use super::*;
use crate::Checked;
use shaderlint_semantic::Stage;
use shaderlint_text::each_case;

fn checked(stage: Stage, text: &str) -> Checked {
    let mut sources = Sources::new();
    let file = sources.add("a", None, Role::User, text);
    let sources = Arc::new(sources);
    analyze(&Unit::complete(&sources, file.as_slice(), stage))
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

#[test]
fn shaders_are_converted() {
    each_case(include_str!("cases.txt"), |text, expected| {
        let found = match text.strip_prefix("vertex: ") {
            Some(text) => convert(Stage::Vertex, text),
            None => convert(Stage::Fragment, text.strip_prefix("fragment: ").unwrap()),
        };
        assert_eq!(found, expected, "{text}");
    });
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
