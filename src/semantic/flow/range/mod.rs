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
use origins::Origins;
use places::{PlaceId, Places};
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::RefCell;
use std::rc::Rc;

/// What the analysis has found out so far.
pub struct Ranges {
    places: Places,
    guards: Guards,
    /// Variables that count the turns of a `for` loop, one by one, and nothing else.
    counters: FxHashSet<VariableId>,
    /// What is known of expressions.
    exprs: RefCell<Known>,
    /// By place and component: what its value may be a copy of.
    origins: RefCell<FxHashMap<(PlaceId, u8), Rc<Origins>>>,
    /// By place and component; `None` while the answer is being made.
    places_known: RefCell<FxHashMap<(u32, u8), Option<Range>>>,
    /// By function and component of its result; `None` while the answer is being made.
    results: RefCell<FxHashMap<(u32, u8), Option<Range>>>,
    /// By place: whether code that is not understood may write to it.
    hidden_places: Vec<bool>,
    /// By function: whether nobody knows what it returns, and what it is given.
    hidden_functions: Vec<bool>,
}

impl Ranges {
    /// Prepares the analysis of a shader.
    pub fn of(program: &Program, structure: &Structure) -> Ranges {
        Ranges {
            places: Places::of(program, |stmt| structure.function_of(stmt)),
            guards: Guards::of(program),
            counters: counters(program),
            exprs: RefCell::new(Known::of(program.tree.exprs.len())),
            origins: RefCell::default(),
            places_known: RefCell::default(),
            results: RefCell::default(),
            hidden_places: Vec::new(),
            hidden_functions: Vec::new(),
        }
    }

    /// Forgets what is known of globals, of parameters of functions and of what functions return,
    /// where code that is not understood may name them.
    pub fn forget(&mut self, program: &Program, is_named: impl Fn(&str) -> bool) {
        self.hidden_places = self.places.hidden(program, &is_named);
        let functions = program.functions.iter();
        let is_hidden = functions.map(|f| is_named(program.names.text(f.name)));
        self.hidden_functions = is_hidden.collect();
    }
}

/// Ranges by expression and component.
struct Known {
    /// By expression, then component: the number of its range, plus one; 0 where none is known.
    slots: Vec<u32>,
    ranges: Vec<Range>,
}

impl Known {
    /// The components of a vector, and its length.
    const PARTS: usize = evaluate::LENGTH as usize + 1;

    fn of(exprs: usize) -> Known {
        Known {
            slots: vec![0; exprs * Known::PARTS],
            ranges: Vec::new(),
        }
    }

    fn slot(expr: ExprId, component: u8) -> usize {
        expr.0 as usize * Known::PARTS + component as usize
    }

    fn get(&self, expr: ExprId, component: u8) -> Option<Range> {
        let number = self.slots.get(Known::slot(expr, component))?;
        self.ranges.get(number.checked_sub(1)? as usize).copied()
    }

    fn insert(&mut self, expr: ExprId, component: u8, range: Range) {
        if let Some(slot) = self.slots.get_mut(Known::slot(expr, component)) {
            self.ranges.push(range);
            *slot = self.ranges.len() as u32;
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
