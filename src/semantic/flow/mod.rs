//! Questions about a checked shader as a whole: what stands where, who calls whom, how often loops
//! turn, what work it is, what differs from pixel to pixel. Each answer is made once, when it is
//! asked for, and never changes.

mod bounds;
mod calls;
mod effects;
mod estimate;
pub(crate) mod lists;
mod loops;
mod mentions;
mod paths;
mod purity;
mod reach;
mod structure;
mod usage;
mod work;

pub use calls::{CallGraph, arguments};
pub use effects::{Effects, root, swizzled};
pub use estimate::Estimate;
pub use loops::{Loop, Loops};
pub use mentions::Mentions;
pub use paths::{Findings, Paths, Unset};
pub use purity::{Purity, each_written};
pub use reach::Reach;
pub use structure::{Structure, each_expr, each_inner, each_operand};
pub use usage::{Usage, is_dropped};
pub use work::{Nest, Work};
