//! Questions about a checked shader as a whole: what stands where, who calls whom, how often loops
//! turn, what work it is, what differs from pixel to pixel. Each answer is made once, when it is
//! asked for, and never changes.

mod calls;
mod effects;
pub(crate) mod lists;
mod mentions;
mod paths;
mod purity;
mod reach;
mod structure;
mod usage;
mod work;

pub use calls::{CallGraph, arguments};
pub use effects::{Effects, root, swizzled};
pub use mentions::Mentions;
pub use paths::{Findings, Paths, Unset};
pub use purity::{Purity, each_written};
pub use reach::Reach;
pub use structure::{Structure, each_expr, each_inner, each_operand};
pub use usage::{Usage, is_dropped};
pub use work::{LoopTurns, Nest, Work};
