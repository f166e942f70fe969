//! Questions about a checked shader as a whole: what stands where, who calls whom, how often loops
//! turn. Each answer is made once, when it is asked for, and never changes.

mod calls;
mod estimate;
mod loops;
mod paths;
pub mod range;
mod structure;

pub use calls::CallGraph;
pub use loops::{Loop, Loops};
pub use paths::{Findings, Paths, Unset};
pub use structure::{Structure, each_expr, each_inner, each_operand};
