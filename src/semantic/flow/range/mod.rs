//! What numbers a shader's expressions may take: an interval analysis.
//!
//! A variable may hold what any write puts there, whatever the order of the writes; conditions
//! around its use narrow that down. Parameters take what any caller passes. Every answer is kept,
//! so that all answers together take time linear in the size of the shader; where the way to an
//! answer is too long, or leads back to its own question, nothing is known.

mod builtins;
mod evaluate;
mod guards;
mod interval;
mod narrow;
mod origins;
mod places;
#[cfg(test)]
mod tests;

pub use evaluate::Evaluator;
pub use interval::{Bound, Range, Reach};
pub use places::{Components, root as root_variable, swizzle};

use crate::semantic::flow::Structure;
use crate::semantic::{Program, VariableId};
use crate::syntax::ast::*;
use guards::Guards;
use places::Places;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::RefCell;

/// What the analysis has found out so far.
pub struct Ranges {
    places: Places,
    guards: Guards,
    /// Variables that count the turns of a `for` loop, one by one, and nothing else.
    counters: FxHashSet<VariableId>,
    /// By expression and component.
    exprs: RefCell<FxHashMap<(u32, u8), Range>>,
    /// By place and component; `None` while the answer is being made.
    places_known: RefCell<FxHashMap<(u32, u8), Option<Range>>>,
    /// By function and component of its result; `None` while the answer is being made.
    results: RefCell<FxHashMap<(u32, u8), Option<Range>>>,
}

impl Ranges {
    /// Prepares the analysis of a shader.
    pub fn of(program: &Program, structure: &Structure) -> Ranges {
        Ranges {
            places: Places::of(program, |stmt| structure.function_of(stmt)),
            guards: Guards::of(program),
            counters: counters(program),
            exprs: RefCell::default(),
            places_known: RefCell::default(),
            results: RefCell::default(),
        }
    }
}

/// Whether two expressions are written alike and give the same value, as far as a short look tells.
pub fn is_same(program: &Program, a: ExprId, b: ExprId) -> bool {
    origins::is_same(program, a, b, &mut 48)
}

/// Finds the variables that are declared in the head of a `for` loop and changed by its step alone,
/// by one.
fn counters(program: &Program) -> FxHashSet<VariableId> {
    let tree = &program.tree;
    let mut found = FxHashSet::default();
    let mut changes: FxHashMap<VariableId, u32> = FxHashMap::default();
    for expr in &tree.exprs {
        let target = match expr.kind {
            ExprKind::Assign(_, target, _) | ExprKind::Postfix(_, target) => target,
            ExprKind::Unary(op, target) if op.assigns() => target,
            _ => continue,
        };
        if let Some(variable) = root_variable(program, target) {
            *changes.entry(variable).or_default() += 1;
        }
    }
    for stmt in &tree.stmts {
        let StmtKind::For {
            init,
            step: Some(step),
            ..
        } = stmt.kind
        else {
            continue;
        };
        let (ExprKind::Postfix(_, target) | ExprKind::Unary(_, target)) = tree.expr(step).kind
        else {
            continue;
        };
        let Some(variable) = program.variable_of(target) else {
            continue;
        };
        let is_declared = matches!(tree.stmt(init).kind, StmtKind::Decl(_));
        if is_declared && changes.get(&variable) == Some(&1) {
            found.insert(variable);
        }
    }
    found
}
