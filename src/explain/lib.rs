//! Messages: what is wrong in a shader, in words, with its fixes.
//!
//! [`analyze`] checks a shader with `semantic`, writes the message of each problem, and finds the
//! root causes of errors. [`link`](link::link) does so for two stages, and [`upgrade`] converts a
//! shader to GLSL ES 3.00. Layers that only need the checked program do not depend on this one.
#![cfg_attr(test, allow(clippy::string_slice))]

mod analyze;
mod checked;
mod chunk;
pub mod library;
pub mod link;
mod messages;
mod root_cause;
mod single_pass;
mod upgrade;

pub use analyze::{
    analyze, analyze_alone, analyze_chunk, analyze_fragment, analyze_within, confirm_unknown,
};
pub use checked::Checked;
pub use chunk::{OTHER_OVERLOAD, Open};
pub use upgrade::{ObstacleKind, Upgrade, UpgradeObstacle, upgrade};
