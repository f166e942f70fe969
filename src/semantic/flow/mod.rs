//! Questions about a checked shader as a whole: what stands where, who calls whom, how often loops
//! turn. Each answer is made once, when it is asked for, and never changes.

mod calls;
mod effects;
mod estimate;
mod loops;
mod reach;
mod structure;
mod usage;

pub use calls::CallGraph;
pub use effects::{Effects, root};
pub use loops::{Loop, Loops};
pub use reach::Reach;
pub use structure::{Structure, each_expr, each_inner, each_operand};
pub use usage::{Usage, is_dropped};
