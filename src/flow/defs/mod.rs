//! Which write each read sees: definitions of the scalar lanes of variables, found once.
//!
//! One walk over the regions of a function, in order, keeps the definition that each lane has at the
//! moment (Braun and others, *Simple and Efficient Construction of Static Single Assignment Form*,
//! 2013, on structured control flow). Where ways come together lanes that differ get a merge, at the
//! head of a loop what the loop writes gets one too, and where a condition holds, what the condition
//! is made of gets a refinement (e-SSA; Bodík and others, *ABCD*, 2000). Functions are seen apart:
//! parameters take what any call passes, globals what anything writes to them.

pub mod condition;
mod def;
mod globals;
mod place;
mod state;
mod walk;

pub use def::{Def, DefId, Defs, Guard, Hop, Passed, Premise, Refinement, Slot};

use super::calls::Calls;
use shaderlint_ir::Module;
use shaderlint_semantic::Program;

impl Defs {
    /// Finds the definitions of a shader.
    pub fn of(program: &Program, module: &Module, calls: &Calls) -> Defs {
        walk::walk(program, module, calls)
    }
}
