//! Colours: constructors of vectors with constant components.

use super::document::Document;
use shaderlint_semantic::Scalar;
use shaderlint_syntax::ast::{ExprId, ExprKind};
use shaderlint_text::{Edit, Span};

/// A colour with optional alpha.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Color {
    /// Red, green and blue, from 0 to 1.
    pub rgb: [f32; 3],
    /// Alpha, from 0 to 1.
    pub alpha: Option<f32>,
}

/// A colour in a document.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ColorSpan {
    /// Span of the constructor.
    pub span: Span,
    /// The colour.
    pub color: Color,
}

/// The constructors of a text that probably are colours: three or four literals from 0 to 1 that
/// are not all zero or one.
pub fn colors(document: &Document) -> Vec<ColorSpan> {
    let mut found: Vec<ColorSpan> = Vec::new();
    for (program, _) in document.shaders() {
        for (expr, id) in program.tree.exprs.iter().zip(0..) {
            let ExprKind::Construct(_, list) = expr.kind else {
                continue;
            };
            let ty = program.ty(ExprId(id));
            let is_vector = ty.is_vector() && ty.scalar_kind() == Some(Scalar::Float);
            let args = program.tree.args(list);
            let is_literal = |arg: &ExprId| {
                matches!(
                    program.tree.expr(*arg).kind,
                    ExprKind::Float(_) | ExprKind::Int(_)
                )
            };
            let is_written = is_vector && args.iter().all(is_literal);
            if !is_written || args.len() < 3 || !program.is_direct(expr.extent) {
                continue;
            }
            let lanes: Vec<f32> = program
                .values(ExprId(id))
                .iter()
                .map(|v| v.as_float())
                .collect();
            let color = color(&lanes);
            let span = document.report.in_input(program.expr_span(ExprId(id)));
            if let (Some(color), Some(span)) = (color, span) {
                found.push(ColorSpan { span, color });
            }
        }
    }
    found.sort_by_key(|c| c.span);
    found.dedup_by_key(|c| c.span);
    found
}

fn color(lanes: &[f32]) -> Option<Color> {
    let (rgb, alpha) = match *lanes {
        [r, g, b] => ([r, g, b], None),
        [r, g, b, a] => ([r, g, b], Some(a)),
        _ => return None,
    };
    let is_shown = |lane: &f32| (0.0..=1.0).contains(lane);
    let is_mixed = rgb.iter().any(|lane| *lane > 0.0 && *lane < 1.0);
    (lanes.iter().all(is_shown) && is_mixed).then_some(Color { rgb, alpha })
}

/// The ways to write a colour in place of the constructor at a span.
pub fn presentations(document: &Document, span: Span, color: Color) -> Vec<Edit> {
    let old = document
        .text
        .get(span.start as usize..span.end as usize)
        .unwrap_or("");
    let number = |lane: f32| {
        // Colour pickers use steps of 1/255, for which three digits are sufficient.
        format!("{:?}", (lane.clamp(0.0, 1.0) * 1e3).round() / 1e3)
    };
    let [r, g, b] = color.rgb.map(number);
    let has_alpha = old.trim_start().starts_with("vec4");
    let text = match has_alpha {
        true => format!(
            "vec4({r}, {g}, {b}, {})",
            number(color.alpha.unwrap_or(1.0))
        ),
        false => format!("vec3({r}, {g}, {b})"),
    };
    vec![Edit::replace(span, text)]
}
