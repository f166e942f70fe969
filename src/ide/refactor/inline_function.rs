//! Replaces calls of a function that only returns an expression with that expression.

use super::inline_variable::with_line;
use super::place::RefactorPlace;
use super::proposal::{ProposedRefactoring, RefactorKind};
use crate::index::NameUse;
use crate::symbol::Symbol;
use shaderlint_semantic::{FunctionRef, Resolution, starts_a_shader};
use shaderlint_syntax::ast::*;
use shaderlint_text::{Edit, apply_edits};

pub(super) fn propose(place: &RefactorPlace) -> Option<ProposedRefactoring> {
    let name = place.name()?;
    let Symbol::Function(id) = name.symbol else {
        return None;
    };
    let program = place.program;
    let called = program.names.text(program.function(id)?.name);
    let calls = program.exprs.iter().zip(0..);
    let calls = calls.filter(|(info, _)| info.resolution == Resolution::Function(id));
    let calls: Vec<ExprId> = calls.map(|(_, expr)| ExprId(expr)).collect();
    let body = InlinedBody::of(place, id)?;
    if name.access == NameUse::Read {
        let is_here = |e: &&ExprId| {
            let span = program.expr_span(**e);
            span.start == name.span.start
        };
        let call = calls.iter().find(is_here)?;
        let title = format!("Inline call of `{called}`");
        let edits = vec![body.replace(place, *call)?];
        return Some(ProposedRefactoring::new(RefactorKind::Inline, title, edits));
    }
    if calls.is_empty() || starts_a_shader(called) {
        return None;
    }
    let mut edits = vec![Edit::delete(with_line(
        place,
        program.span(body.function.extent),
    )?)];
    for call in calls {
        edits.push(body.replace(place, call)?);
    }
    let title = format!("Inline function `{called}`");
    Some(ProposedRefactoring::new(RefactorKind::Inline, title, edits))
}

/// A function whose body returns an expression.
struct InlinedBody<'p> {
    function: &'p FunctionDecl,
    value: ExprId,
    /// The uses of each parameter.
    parameters: Vec<Vec<ExprId>>,
}

impl<'p> InlinedBody<'p> {
    fn of(place: &RefactorPlace<'p>, id: FunctionRef) -> Option<InlinedBody<'p>> {
        let (program, tree) = (place.program, &place.program.tree);
        let function = place.definition(id)?;
        let StmtKind::Block(list) = tree.stmt(function.body?).kind else {
            return None;
        };
        let &[only] = tree.block(list) else {
            return None;
        };
        let StmtKind::Return(Some(value)) = tree.stmt(only).kind else {
            return None;
        };
        let extent = tree.expr(value).extent;
        let mut parameters = Vec::new();
        for at in function.params.start..function.params.start + function.params.len {
            let variable = program
                .declared_params
                .get(at as usize)
                .copied()
                .flatten()?;
            let uses = place.facts.mentions().all(variable).to_vec();
            let mut extents = uses.iter().map(|e| tree.expr(*e).extent);
            if !extents.all(|e| program.is_direct(e)) {
                return None;
            }
            parameters.push(uses);
        }
        place.is_exact(extent).then_some(InlinedBody {
            function,
            value,
            parameters,
        })
    }

    /// The edit that replaces a call with the body.
    fn replace(&self, place: &RefactorPlace, call: ExprId) -> Option<Edit> {
        let (program, tree) = (place.program, &place.program.tree);
        let found = tree.expr(call);
        let ExprKind::Call(_, args) = found.kind else {
            return None;
        };
        let args = tree.args(args);
        if !program.is_direct(Extent::token(found.extent.first)) || !place.is_exact(found.extent) {
            return None;
        }
        let mut edits = Vec::new();
        for (uses, arg) in self.parameters.iter().zip(args) {
            let text = place.text_of(tree.expr(*arg).extent)?;
            edits.extend(uses.iter().map(|e| {
                let text = place.in_place_of(*e, *arg, text);
                Edit::replace(program.expr_span(*e), text)
            }));
        }
        let value = program.expr_span(self.value);
        let text = apply_edits(place.text(value)?, value.start, &edits).ok()?;
        let text = place.in_place_of(call, self.value, &text);
        Some(Edit::replace(program.span(found.extent), text))
    }
}
