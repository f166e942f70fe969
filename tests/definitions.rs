//! The definitions that are inserted for functions that a shader does not declare: the unsafe fix of a call
//! inserts one, and what it computes is what mathematics says.

use shaderlint::engine::inputs::{Moment, Scene};
use shaderlint::engine::{DialectChoice, Options, analyze, fix_text};
use shaderlint::exec::{CompileOptions, draw};
use shaderlint::lint::{Allow, Settings};
use shaderlint::project::NoFiles;
use std::collections::BTreeSet;

const PROPERTIES: &str = include_str!("../src/explain/library/tests.txt");

/// Largest difference to the expected number.
const MARGIN: f32 = 0.001;

/// The value of an expression whose functions a fix defines, in GLSL ES 1.00 or 3.00.
fn value(expression: &str, is_old: bool) -> [f32; 4] {
    let (head, output) = match is_old {
        true => ("precision highp float;\n", "gl_FragColor"),
        false => (
            "#version 300 es\nprecision highp float;\nout vec4 color;\n",
            "color",
        ),
    };
    let text = format!("{head}void main() {{\n    {output} = {expression};\n}}\n");
    let options = Options::new(DialectChoice::Auto, Settings::of_rules(&[]));
    let fixed = fix_text("a.frag", &text, &options, &NoFiles, Allow::Unsafe).text;
    let report = analyze("a.frag", &fixed, &options, &NoFiles);
    let analysis = &report.analyses[0];
    assert!(!analysis.has_errors, "{expression}\n{fixed}");
    let compiled = CompileOptions::default();
    let (program, module) = (&analysis.program, analysis.module());
    let scene = Scene::of(program, analysis.host, module, &compiled)
        .ok()
        .unwrap();
    let drawn = draw(&scene.draw([1, 1], &Moment::at(0.0)), 1).ok().unwrap();
    drawn.outputs[0][0].map(f32::from_bits)
}

#[test]
fn inserted_definitions_compute_the_expected_values() {
    for (line, number) in PROPERTIES.lines().zip(1..) {
        let (expression, expected) = line.split_once(" => ").unwrap();
        let expected: Vec<f32> = expected.split(' ').map(|n| n.parse().unwrap()).collect();
        let rest = ", 0.0".repeat(4 - expected.len());
        let found = value(&format!("vec4({expression}{rest})"), number % 2 == 0);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() <= MARGIN, "{line}: {found}");
        }
    }
}

#[test]
fn every_definition_has_a_test() {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words: BTreeSet<&str> = PROPERTIES.split(|c| !is_letter(c)).collect();
    for name in shaderlint::explain::library::function_names() {
        assert!(words.contains(name), "{name}");
    }
}

/// The value of a global variable may read those before it.
#[test]
fn values_that_only_a_function_computes_are_assigned_in_their_order() {
    let head = "vec2 size = iResolution.xy;\nfloat ratio = size.x / size.y;\n";
    let body = "void mainImage(out vec4 o, in vec2 p) {\n    o = vec4(p / size, ratio, 1.0);\n}\n";
    let options = Options::new(DialectChoice::Auto, Settings::of_rules(&[]));
    let text = format!("{head}{body}");
    let fixed = fix_text("a.glsl", &text, &options, &NoFiles, Allow::Safe).text;
    let assigned = "{\n    size = iResolution.xy;\n    ratio = size.x / size.y;\n    o =";
    assert!(fixed.contains(assigned), "{fixed}");
}
