//! Gives an expression a name: `f(a + b)` becomes `float value = a + b; f(value)`.

use super::place::{InsertionPoint, RefactorPlace};
use super::proposal::{ProposedRefactoring, RefactorKind};
use crate::symbol::typed;
use shaderlint_syntax::ast::*;
use shaderlint_text::Edit;

pub(super) fn propose(place: &RefactorPlace) -> Vec<ProposedRefactoring> {
    let found = place.expr().and_then(|expr| {
        let point = place.insertion_point(expr)?;
        let others = place.same_exprs(expr, point.scope);
        let one = proposal(place, expr, &point, &[]);
        let all = match others.is_empty() {
            true => None,
            false => proposal(place, expr, &point, &others),
        };
        Some(one.into_iter().chain(all).collect())
    });
    found.unwrap_or_default()
}

fn proposal(
    place: &RefactorPlace,
    expr: ExprId,
    point: &InsertionPoint,
    others: &[ExprId],
) -> Option<ProposedRefactoring> {
    let tree = &place.program.tree;
    let ty = place.program.ty(expr);
    let is_name = matches!(tree.expr(tree.unparen(expr)).kind, ExprKind::Name(_));
    let is_statement = matches!(tree.stmt(point.stmt).kind, StmtKind::Expr(root) if root == expr);
    if is_name || is_statement || ty.is_void() || ty.is_error() || ty.is_sampler() {
        return None;
    }
    let name = place.free_name("value");
    let text = format!(
        "{} = {};",
        typed(place.program, ty, &name),
        place.value_text(expr)?
    );
    let mut edits = place.insert_before(point, &text)?;
    for expr in others.iter().chain([&expr]) {
        edits.push(Edit::replace(place.program.expr_span(*expr), &name));
    }
    let title = match others.len() {
        0 => "Extract to variable".to_string(),
        more => format!("Extract {} occurrences to variable", more + 1),
    };
    Some(ProposedRefactoring::new(RefactorKind::ExtractVariable, title, edits).named(name))
}
