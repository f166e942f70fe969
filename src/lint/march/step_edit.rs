//! Edits of the steps of a marching loop.

use super::loops::March;
use crate::facts::Facts;
use shaderlint_ir::Provenance;
use shaderlint_semantic::Program;
use shaderlint_syntax::ast::{BinaryOp, ExprId, ExprKind, UnaryOp};
use shaderlint_text::number::significant;
use shaderlint_text::{Edit, Span};

/// Significant digits of a factor.
pub(super) const DIGITS: i32 = 4;

/// The edits that multiply the steps of a loop; `None` where the text of a step comes from a macro.
pub fn step_edits(facts: &Facts, march: &March, factor: f64) -> Option<Vec<Edit>> {
    let program = facts.program();
    let terms = step_terms(facts, march)?;
    let edits = terms
        .into_iter()
        .map(|term| multiplied(program, term, factor));
    edits.collect()
}

/// The literal factor that shortens all steps of a loop; `None` where they have none, or several.
pub fn step_factor(facts: &Facts, march: &March) -> Option<f64> {
    let program = facts.program();
    let mut all = step_terms(facts, march)?.into_iter().map(|term| {
        let own = factors(program, term).into_iter();
        own.fold(1.0, |product, factor| match factor.divides {
            true => product / factor.value,
            false => product * factor.value,
        })
    });
    let first = all.next()?;
    let is_shorter = first > 0.0 && first < 1.0;
    (is_shorter && all.all(|other| other == first)).then_some(first)
}

/// The edits that give the steps of a loop another literal factor than that of [`step_factor`].
pub fn factor_edits(facts: &Facts, march: &March, [from, to]: [f64; 2]) -> Option<Vec<Edit>> {
    let program = facts.program();
    let edits = step_terms(facts, march)?.into_iter().map(|term| {
        let shortens = |f: &LiteralFactor| f.divides == (f.value > 1.0) && f.value != 1.0;
        let factor = factors(program, term).into_iter().find(shortens)?;
        let value = match factor.divides {
            true => factor.value * from / to,
            false => factor.value * to / from,
        };
        let span = program.expr_span(factor.expr);
        let text = significant(value, DIGITS);
        Some(match factor.rest.filter(|_| text == "1.0") {
            Some(rest) => {
                let rest = program.expr_span(rest);
                Edit::delete(match rest.start < span.start {
                    true => Span::new(rest.end, span.end),
                    false => Span::new(span.start, rest.start),
                })
            }
            None => Edit::replace(span, text),
        })
    });
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
        let text = significant(value * factor, DIGITS);
        return Some(Edit::replace(program.expr_span(known), text));
    }
    let span = program.expr_span(expr);
    let (text, factor) = (program.expr_text(expr), significant(factor, DIGITS));
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
    let mut all = factors(program, expr).into_iter();
    let factor = all.find(|factor| !factor.divides)?;
    Some((factor.expr, factor.value))
}

/// A literal that multiplies or divides an expression.
#[derive(Clone, Copy)]
struct LiteralFactor {
    expr: ExprId,
    value: f64,
    divides: bool,
    /// What is left of the product without it.
    rest: Option<ExprId>,
}

/// The literals that multiply or divide an expression, from left to right.
fn factors(program: &Program, expr: ExprId) -> Vec<LiteralFactor> {
    let mut found = Vec::new();
    let mut todo = vec![(expr, false, None)];
    while let Some((expr, divides, rest)) = todo.pop() {
        match program.tree.expr(expr).kind {
            ExprKind::Float(value) => found.push(LiteralFactor {
                expr,
                value: f64::from(value),
                divides,
                rest,
            }),
            ExprKind::Paren(inner) | ExprKind::Unary(UnaryOp::Minus | UnaryOp::Plus, inner)
                if !divides =>
            {
                todo.push((inner, divides, None));
            }
            ExprKind::Binary(BinaryOp::Mul, left, right) if !divides => {
                todo.extend([(right, false, Some(left)), (left, false, Some(right))]);
            }
            ExprKind::Binary(BinaryOp::Div, left, right) if !divides => {
                todo.extend([(right, true, Some(left)), (left, false, None)]);
            }
            _ => {}
        }
    }
    found
}
