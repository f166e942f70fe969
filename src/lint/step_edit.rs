//! Edits of the steps of a marching loop.

use super::facts::Facts;
use super::march::March;
use shaderlint_ir::Provenance;
use shaderlint_semantic::Program;
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind, UnaryOp};
use shaderlint_text::Edit;

/// Significant digits of a factor.
const DIGITS: i32 = 4;

/// The edits that multiply the steps of a loop; `None` where the text of a step comes from a macro.
pub fn step_edits(facts: &Facts, march: &March, factor: f64) -> Option<Vec<Edit>> {
    let program = facts.program();
    let terms = step_terms(facts, march)?;
    let edits = terms
        .into_iter()
        .map(|term| multiplied(program, term, factor));
    edits.collect()
}

/// The expressions that are added to the ray parameter or point.
fn step_terms(facts: &Facts, march: &March) -> Option<Vec<ExprId>> {
    let (program, module) = (facts.program(), facts.module());
    let mut terms = Vec::new();
    for step in &march.ray.motion.steps {
        let Provenance::Expr(expr) = module.provenance(step.term) else {
            return None;
        };
        if !program.is_direct(program.tree.expr(expr).extent) {
            return None;
        }
        terms.push(expr);
    }
    terms.sort_unstable();
    terms.dedup();
    (!terms.is_empty()).then_some(terms)
}

/// The edit that multiplies an expression: a literal factor changes, or there is a new one.
fn multiplied(program: &Program, expr: ExprId, factor: f64) -> Option<Edit> {
    if let Some((known, value)) = literal_factor(program, expr) {
        let text = literal(value * factor);
        return Some(Edit::replace(program.expr_span(known), text));
    }
    let span = program.expr_span(expr);
    let (text, factor) = (program.expr_text(expr), literal(factor));
    let is_product = match program.tree.expr(expr).kind {
        ExprKind::Binary(op, ..) => matches!(op, BinaryOp::Mul | BinaryOp::Div),
        ExprKind::Ternary(..) | ExprKind::Comma(..) | ExprKind::Assign(..) => false,
        _ => true,
    };
    Some(match is_product {
        true => Edit::insert(span.end, format!(" * {factor}")),
        false => Edit::replace(span, format!("({text}) * {factor}")),
    })
}

/// The first literal that multiplies an expression.
fn literal_factor(program: &Program, expr: ExprId) -> Option<(ExprId, f64)> {
    let mut todo = vec![expr];
    while let Some(expr) = todo.pop() {
        match program.tree.expr(expr).kind {
            ExprKind::Float(value) => return Some((expr, f64::from(value))),
            ExprKind::Paren(inner) | ExprKind::Unary(UnaryOp::Minus | UnaryOp::Plus, inner) => {
                todo.push(inner);
            }
            ExprKind::Binary(BinaryOp::Mul, left, right) => todo.extend([right, left]),
            ExprKind::Binary(BinaryOp::Div, left, _) => todo.push(left),
            _ => {}
        }
    }
    None
}

/// A float literal with a few significant digits.
pub(super) fn literal(value: f64) -> String {
    let digits = DIGITS - 1 - value.abs().log10().floor() as i32;
    let scale = 10_f64.powi(digits.clamp(0, 12));
    let text = ((value * scale).round() / scale).to_string();
    match text.contains('.') {
        true => text,
        false => format!("{text}.0"),
    }
}
