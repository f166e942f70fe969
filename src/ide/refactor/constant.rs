//! Gives a constant expression a global name, which may have a slider.

use super::place::RefactorPlace;
use super::proposal::{ProposedRefactoring, RefactorKind};
use crate::symbol::typed;
use shaderlint_semantic::Value;
use shaderlint_syntax::ast::*;
use shaderlint_text::Edit;

pub(super) fn propose(place: &RefactorPlace) -> Vec<ProposedRefactoring> {
    let found = place.expr().map(|expr| {
        let everywhere = Extent::new(0, place.program.tokens.tokens.len() as u32);
        let title = "Extract to constant".to_string();
        let one = proposal(place, expr, &[], title, "");
        let others = later(place, place.same_exprs(expr, everywhere), expr);
        let title = format!("Extract {} occurrences to constant", others.len() + 1);
        let all = match others.is_empty() {
            true => None,
            false => proposal(place, expr, &others, title, ""),
        };
        one.into_iter().chain(all).collect()
    });
    found.unwrap_or_default()
}

/// The expressions in the same text that follow the declaration of a constant for one of them.
fn later(place: &RefactorPlace, others: Vec<ExprId>, expr: ExprId) -> Vec<ExprId> {
    let start = place.program.expr_span(expr).start;
    let Some((_, item)) = place.item_at(start) else {
        return Vec::new();
    };
    let (from, code) = (place.program.span(item).start, place.code());
    let is_later = |e: &ExprId| {
        let at = place.program.expr_span(*e).start;
        at >= from && code.is_some_and(|c| at < c.base + c.text.len() as u32)
    };
    others.into_iter().filter(is_later).collect()
}

fn proposal(
    place: &RefactorPlace,
    expr: ExprId,
    others: &[ExprId],
    title: String,
    comment: &str,
) -> Option<ProposedRefactoring> {
    let (program, tree) = (place.program, &place.program.tree);
    let info = program.expr(expr);
    let is_name = matches!(tree.expr(tree.unparen(expr)).kind, ExprKind::Name(_));
    if is_name || !info.is_const || info.ty.is_void() || info.ty.is_error() {
        return None;
    }
    let name = place.free_name("VALUE");
    let (_, item) = place.item_at(place.selection.start)?;
    let at = place.before_item(program.span(item).start)?;
    let (declared, line) = (typed(program, info.ty, &name), place.line_break());
    let value = place.value_text(expr)?;
    let text = format!("const {declared} = {value};{comment}{line}");
    let mut edits = vec![Edit::insert(at, text)];
    for expr in others.iter().chain([&expr]) {
        edits.push(Edit::replace(program.expr_span(*expr), &name));
    }
    Some(ProposedRefactoring::new(RefactorKind::ExtractConstant, title, edits).named(name))
}

/// A number, and a range for its slider: from zero to twice the value.
pub(super) struct NumberRange {
    pub expr: ExprId,
    pub value: Value,
    pub low: f64,
    pub high: f64,
}

/// The number at the selection.
pub(super) fn number(place: &RefactorPlace) -> Option<NumberRange> {
    let expr = place.expr().or_else(|| literal_at(place))?;
    let value = place.program.scalar(expr)?;
    let (low, high) = match value {
        Value::Float(value) if value != 0.0 => {
            let twice = f64::from(value) * 2.0;
            (twice.min(0.0), twice.max(0.0))
        }
        Value::Int(value) if value != 0 => {
            let twice = f64::from(value) * 2.0;
            (twice.min(0.0), twice.max(0.0))
        }
        Value::Float(_) => (-1.0, 1.0),
        Value::Int(_) => (0.0, 10.0),
        _ => return None,
    };
    let digits = |end: f64| (end * 1e6).round() / 1e6;
    Some(NumberRange {
        expr,
        value,
        low: digits(low),
        high: digits(high),
    })
}

/// A literal as a constant with a slider, from zero to twice the value.
pub(super) fn propose_slider(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let NumberRange {
        expr, low, high, ..
    } = number(place)?;
    let comment = format!(" // ({low}~{high})");
    let title = "Extract to constant with slider".to_string();
    let proposal = proposal(place, expr, &[], title, &comment)?;
    Some(ProposedRefactoring {
        kind: RefactorKind::Rewrite,
        slider: proposal.name.clone(),
        ..proposal
    })
}

/// The literal at an empty selection.
fn literal_at(place: &RefactorPlace) -> Option<ExprId> {
    let is_literal = |e: &Expr| matches!(e.kind, ExprKind::Int(_) | ExprKind::Float(_));
    let mut all = place.program.tree.exprs.iter().zip(0..);
    let found = all.find(|(e, _)| {
        is_literal(e)
            && place.program.is_direct(e.extent)
            && place.program.span(e.extent).contains(place.selection)
    });
    found.map(|(_, id)| ExprId(id))
}
