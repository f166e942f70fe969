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
mod origins;
mod places;
#[cfg(test)]
mod tests;

pub use evaluate::Evaluator;
pub use interval::{Bound, Range, Reach};
pub use places::{Components, root as root_variable, swizzle};

use crate::semantic::Program;
use crate::semantic::flow::Structure;
use guards::Guards;
use places::Places;
use rustc_hash::FxHashMap;
use std::cell::RefCell;

/// What the analysis has found out so far.
pub struct Ranges {
    places: Places,
    guards: Guards,
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
            exprs: RefCell::default(),
            places_known: RefCell::default(),
            results: RefCell::default(),
        }
    }
}

/// Whether two expressions are written alike and give the same value, as far as a short look tells.
pub fn is_same(
    program: &Program,
    a: crate::syntax::ast::ExprId,
    b: crate::syntax::ast::ExprId,
) -> bool {
    origins::is_same(program, a, b, &mut 48)
}
