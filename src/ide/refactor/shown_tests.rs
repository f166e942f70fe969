//! Values that are drawn.

use super::*;
use crate::run::image_of;
use crate::symbol::Symbol;
use shaderlint_engine::inputs::{Moment, Scene};
use shaderlint_engine::{Analysis, Options};
use shaderlint_exec::{CompileOptions, draw};
use shaderlint_play::RenderedImage;
use shaderlint_project::NoFiles;
use shaderlint_text::LineIndex;
use std::sync::Arc;

/// The document of a text without its marks, and the selection.
fn marked(name: &str, text: &str) -> (Document, Span) {
    let plain = text.replace(['«', '»', '|'], "");
    let start = text.find(['«', '|']).expect("a mark");
    let end = text.find('»').map_or(start, |end| end - '«'.len_utf8());
    let document = Document::new(name, plain.into(), Arc::new(Options::default()), &NoFiles);
    (document, Span::new(start as u32, end as u32))
}

/// The colours of a shader in a small image.
fn colors(analysis: &Analysis) -> Vec<[f32; 3]> {
    let module = analysis.module();
    let options = CompileOptions::default();
    let scene = Scene::of(&analysis.program, analysis.host, module, &options).unwrap();
    let drawing = scene.draw([64, 36], &Moment::at(1.0));
    let drawn = draw(&drawing, 1).unwrap();
    let image = RenderedImage::of(&scene.code, &drawn, 0);
    image.pixels.iter().map(|p| [p[0], p[1], p[2]]).collect()
}

/// The document of the shader that draws the value between the bars.
fn shown(text: &str) -> Option<(Document, ShownValue)> {
    let (document, span) = marked("/a.glsl", text);
    let value = shown_value(&document, &NoFiles, span, WITHIN)?;
    Some((document, value))
}

/// Checks that the variable at the bar is drawn as the probe of a run sees it on this line.
#[track_caller]
fn check_shown(text: &str) {
    let (document, value) = shown(text).expect("a value");
    let at = value.span.start;
    let line = LineIndex::new(&document.text).bounds(at, document.text.len() as u32);
    let spot = document.spot(at).unwrap();
    let Some(Symbol::Variable(id)) = spot.name().map(|n| n.symbol) else {
        panic!("no variable");
    };
    let base = document.report.address(0).unwrap();
    let within = Span::new(base + line.0, base + line.1);
    let expected = image_of(spot.analysis, id, within).expect("an image");
    let ty = spot.program().variable(id).unwrap().ty;
    let lanes = ty.components().max(1) as usize;
    let expected = expected.pixels.iter().map(|p| {
        let rgb = [p[0], p[1], p[2]];
        std::array::from_fn(|n| if lanes > 1 && n >= lanes { 0.0 } else { rgb[n] })
    });
    let expected: Vec<[f32; 3]> = expected.collect();
    let shown = colors(&value.document.report.analyses[value.shader]);
    let mut pairs = shown.iter().zip(&expected);
    let other = pairs.find(|(own, expected)| own != expected);
    assert_eq!(other, None, "{text}");
}

/// Each case is a shader with a bar at a variable.
#[test]
fn previewed_values_equal_those_of_a_run() {
    let cases = include_str!("shown.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        check_shown(&case.replace('↵', "\n"));
    }
}

#[test]
fn expressions_are_previewed_by_their_type() {
    let middle = |body: &str| {
        let text = format!("void mainImage(out vec4 fragColor, in vec2 fragCoord) {{ {body} }}");
        let (_, value) = shown(&text)?;
        Some(colors(&value.document.report.analyses[value.shader])[0])
    };
    assert_eq!(middle("fragColor = vec4(«0.5 + 0.25»);"), Some([0.75; 3]));
    assert_eq!(
        middle("fragColor = «vec4(0.5, 0.25, 0.0, 0.3)»;"),
        Some([0.5, 0.25, 0.0])
    );
    assert_eq!(
        middle("ivec2 p = «ivec2(0, 0)»; fragColor = vec4(p, p);"),
        Some([0.0; 3])
    );
    let [one, two] =
        ["1", "2"].map(|n| middle(&format!("int p = «{n} * 1»; fragColor = vec4(p);")).unwrap());
    assert_ne!(one, two);
    // Matrices, constants of the language, and code without a value.
    assert_eq!(middle("mat2 m = «mat2(1.0)»; fragColor = vec4(m);"), None);
    assert_eq!(
        middle("float a[«2 + 1»]; a[0] = 1.0; fragColor = vec4(a[0]);"),
        None
    );
    assert_eq!(
        middle("const float a = «2.0 + 1.0»; fragColor = vec4(a);"),
        None
    );
    assert_eq!(middle("«fragColor = vec4(1.0);»"), None);
}

#[test]
fn values_outside_of_the_colour_range_are_scaled() {
    let text = "void mainImage(out vec4 fragColor, in vec2 fragCoord) { vec2 |p = fragCoord - 32.0; fragColor = vec4(p, p); }";
    let (document, span) = marked("/a.glsl", text);
    let own = |limits: [f32; 2]| {
        let value = shown_value(&document, &NoFiles, span, limits).unwrap();
        let analysis = &value.document.report.analyses[value.shader];
        (crate::run::limits(analysis).unwrap(), colors(analysis)[0])
    };
    let (limits, _) = own(WITHIN);
    // Without the 5 % at each end.
    assert_eq!(limits, [-28.5, 22.5]);
    let (_, first) = own([-31.5, 31.5]);
    assert_eq!(first, [0.0, 0.0, 0.0]);
}
