//! Reaching definitions: an SSA form of the scalar components of all variables.
//!
//! One walk over the regions of a function, in order, keeps the current definition of each
//! component (Braun et al., *Simple and Efficient Construction of Static Single Assignment Form*,
//! 2013, on structured control flow). Components that differ where paths join get a merge (phi),
//! those that a loop writes get one at the loop head, and the operands of a condition get a
//! refinement where the condition holds (e-SSA; Bodík et al., *ABCD: Eliminating Array Bounds
//! Checks on Demand*, 2000). The analysis is intraprocedural: a parameter may hold the argument of
//! any call, a global the value of any write.

pub mod condition;
mod def;
mod globals;
mod place;
mod state;
mod walk;

pub use def::{Def, DefId, Guard, Hop, Passed, Premise, ReachingDefinitions, Refinement, Slot};

use super::calls::Calls;
use shaderlint_ir::Module;
use shaderlint_semantic::Program;

impl ReachingDefinitions {
    /// Computes the reaching definitions of a shader.
    pub fn of(program: &Program, module: &Module, calls: &Calls) -> ReachingDefinitions {
        walk::walk(program, module, calls)
    }
}
