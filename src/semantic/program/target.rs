//! Targets of assignments.

use crate::{Program, VariableId};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::*;

/// The variable that an assignment to `target` modifies, fully or in part.
pub fn root(program: &Program, target: ExprId) -> Option<VariableId> {
    let mut at = target;
    while let ExprKind::Paren(inner) | ExprKind::Member(inner, _) | ExprKind::Index(inner, _) =
        program.tree.expr(at).kind
    {
        at = inner;
    }
    program.variable_of(at)
}

/// Bit mask of the vector components that a member expression selects; `None` for a member of a
/// struct.
pub fn swizzled(program: &Program, object: ExprId, name: Name) -> Option<u8> {
    let text = program.names.text(name);
    let number = |c| {
        let mut sets = ["xyzw", "rgba", "stpq"].iter();
        sets.find_map(|set| set.find(c))
    };
    let is_vector = program.ty(object).is_vector();
    let numbers = text.chars().map(|c| number(c).filter(|_| is_vector));
    numbers
        .into_iter()
        .try_fold(0, |mask, n| Some(mask | 1 << n?))
}
