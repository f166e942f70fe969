//! VertexShaderArt: a vertex shader that runs for numbered vertices, drawn as points, lines or
//! triangles.
//!
//! Source: `src/js/shaders.js` and `src/js/main.js` of greggman/vertexshaderart. The website puts
//! its declarations before the text, and `gl_PointSize = 1.0` at the start of `main`. By default
//! 10,000 vertices (at most 100,000) are drawn as lines on black, with a depth test and alpha
//! blending. The mouse ranges from -1 to 1, y up; `sound` holds the spectra of the last 240 frames
//! in all components, the newest at v = 0. A JSON header may set the number of vertices:
//! `vertexCount` and `vertexMode` as in VEDA, `POINT_COUNT`, `PRIMITIVE_MODE` and
//! `BACKGROUND_COLOR` as in ossia score (see their manuals).

use super::complete::{best, declarations, defaults, modern};
use super::isf::{head, object};
use super::{Clues, Completion, HostCode, Plan, Sign, sampled};
use crate::{ControlChoice, ControlKind, Input, InputKind, PassDraw, SignalForm, UniformControl};
use serde_json::{Map, Value};
use shaderlint_host::{OWN, preset};
use shaderlint_syntax::Version;
use std::sync::Arc;

pub(super) static CODE: HostCode = HostCode {
    host: "vertexshaderart",
    signs,
    plan: Some(plan),
    declare: None,
};

fn signs(clues: &Clues) -> Vec<Sign> {
    match clues.has_word("vertexId") && clues.has_word("gl_Position") {
        true => vec![Sign::new("`vertexId`", 8 * OWN)],
        false => Vec::new(),
    }
}

/// The fragment shader of the website.
const FRAGMENT: &str = "precision mediump float;\nvarying vec4 v_color;\nvoid main() {\n    gl_FragColor = v_color;\n}\n";

const FRAGMENT_300: &str = "#version 300 es\nprecision mediump float;\nin vec4 v_color;\nout vec4 \
    color;\nvoid main() {\n    color = v_color;\n}\n";

fn plan(clues: &Clues) -> Plan {
    let mut notes = Vec::new();
    let settings = match head(clues.text).map(object) {
        Some(Ok(settings)) => settings,
        Some(Err(note)) => {
            notes.push(note);
            Map::new()
        }
        None => Map::new(),
    };
    let candidates = vec![
        completion(clues, defaults(Version::Es100)),
        completion(
            clues,
            modern(clues) + "#define attribute in\n#define varying out\n",
        ),
    ];
    let taken: Vec<Completion> = best(candidates).into_iter().collect();
    let is_new = taken.iter().any(|c| c.before.starts_with("#version 300"));
    let mut plan = Plan {
        notes,
        controls: controls(&settings),
        draws: vec![PassDraw {
            partner: Some(Arc::from(if is_new { FRAGMENT_300 } else { FRAGMENT })),
            has_vertices: true,
            ..PassDraw::default()
        }],
        ..Plan::image(taken)
    };
    if clues.has_word("floatSound") {
        let note =
            "`floatSound` holds the spectrum from 0 to 1, as `sound` does, instead of decibels";
        plan.notes.push(note.to_string());
    }
    for pass in &mut plan.passes {
        pass.inputs = ["sound", "floatSound", "volume"].map(history).to_vec();
        pass.inputs
            .push(sampled("touch", InputKind::Buffer, ("nearest", "clamp")));
    }
    plan
}

/// The text after the declarations that it does not contain itself. Another `main` calls its
/// `main`.
fn completion(clues: &Clues, mut before: String) -> Completion {
    if let Some(host) = preset("vertexshaderart") {
        before.push_str(&declarations(host, clues, true));
    }
    before.push_str("#define main port_main\n");
    Completion::after(before, clues.text)
        .with_end("\n#undef main\nvoid main() {\n    gl_PointSize = 1.0;\n    port_main();\n}\n")
        .for_vertices()
}

fn history(name: &str) -> Input {
    Input {
        signal: SignalForm::History,
        ..sampled(name, InputKind::Music, ("linear", "clamp"))
    }
}

/// The primitive types, with WebGL's numbers.
const MODES: [(&str, f64); 7] = [
    ("POINTS", 0.0),
    ("LINES", 1.0),
    ("LINE_LOOP", 2.0),
    ("LINE_STRIP", 3.0),
    ("TRIANGLES", 4.0),
    ("TRI_STRIP", 5.0),
    ("TRI_FAN", 6.0),
];

/// The settings of the website.
fn controls(settings: &Map<String, Value>) -> Vec<UniformControl> {
    let given = |keys: [&str; 2]| keys.into_iter().find_map(|key| settings.get(key));
    let count = given(["vertexCount", "POINT_COUNT"]).and_then(Value::as_f64);
    let range = (
        1.0,
        count.unwrap_or(10_000.0).clamp(1.0, 100_000.0),
        100_000.0,
    );
    let mode = given(["vertexMode", "PRIMITIVE_MODE"]).and_then(Value::as_str);
    let mode = mode
        .map(|m| m.replace("TRIANGLE_", "TRI_"))
        .unwrap_or_default();
    let known = MODES.iter().find(|(name, _)| *name == mode);
    let background = settings.get("BACKGROUND_COLOR").and_then(Value::as_array);
    let lanes = background.into_iter().flatten().filter_map(Value::as_f64);
    let mut color = UniformControl::color("background", 4, 0);
    color.value = lanes.chain([0.0, 0.0, 0.0, 1.0]).take(4).collect();
    if background.is_none_or(|b| b.len() != 4) {
        color.value = vec![0.0, 0.0, 0.0, 1.0];
    }
    vec![
        UniformControl {
            label: "vertices".to_string(),
            ..UniformControl::even("vertexCount", ControlKind::Int, 1, range)
        },
        UniformControl {
            label: "primitive".to_string(),
            value: vec![known.map_or(1.0, |(_, number)| *number)],
            choices: MODES
                .iter()
                .map(|(label, value)| ControlChoice {
                    label: label.to_string(),
                    value: *value,
                })
                .collect(),
            ..UniformControl::even("port_mode", ControlKind::Choice, 1, (0.0, 1.0, 6.0))
        },
        color,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_semantic::Stage;

    #[test]
    fn added_code_has_the_version_that_the_shader_needs() {
        let draw = |text: &str| {
            let plan = plan(&Clues::of(text));
            let first = &plan.passes[0].candidates[0];
            let errors = first.check().unwrap().diagnostics;
            assert!(errors.is_empty(), "{errors:?}");
            assert_eq!(first.stage, Stage::Vertex);
            plan.draws[0].partner.as_deref() == Some(FRAGMENT_300)
        };
        assert!(!draw(
            "attribute float vertexId; varying vec4 v_color;\nvoid main() { gl_Position = vec4(vertexId); v_color = background; }"
        ));
        assert!(draw(
            "void main() { uint n = uint(vertexId); gl_Position = vec4(n & 3u); v_color = vec4(time); }"
        ));
    }

    #[test]
    fn headers_set_the_vertex_count_and_primitive() {
        let head = r#"{"POINT_COUNT": 3, "PRIMITIVE_MODE": "TRIANGLE_STRIP", "BACKGROUND_COLOR": [1, 0, 0, 1]}"#;
        let values = |object: &Map<String, Value>| -> Vec<Vec<f64>> {
            controls(object).into_iter().map(|c| c.value).collect()
        };
        let given = values(&object(head).unwrap());
        assert_eq!(given, [vec![3.0], vec![5.0], vec![1.0, 0.0, 0.0, 1.0]]);
        let usual = values(&Map::new());
        assert_eq!(usual, [vec![10_000.0], vec![1.0], vec![0.0, 0.0, 0.0, 1.0]]);
    }
}
