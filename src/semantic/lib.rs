//! Semantic analysis: types, scopes and the checks of the browser's compiler.
//!
//! [`check`] takes a parsed shader and returns a [`Program`], which later layers only read, and the
//! errors. The rules follow GLSL ES 3.00 and 1.00 as implemented by ANGLE, the compiler used by
//! browsers.
#![cfg_attr(test, allow(clippy::string_slice))]

mod analyze;
pub mod builtins;
mod calls;
mod channels;
mod checker;
mod chunk;
mod constant;
mod corrections;
mod dialect;
mod explain;
mod fold;
mod host;
mod infer_channels;
mod late_values;
pub mod link;
pub mod lists;
mod mentions;
mod parsed;
mod program;
mod reach;
mod root_cause;
mod scope;
mod single_pass;
pub mod snippet;
mod structure;
mod target;
pub mod tunable;
mod tunable_mark;
mod types;
mod typing;
mod undefined;
mod unit;
mod upgrade;

pub use analyze::{
    analyze, analyze_alone, analyze_chunk, analyze_fragment, analyze_within, confirm_unknown,
};
pub use builtins::{BuiltinId, Stage};
pub use calls::CallGraph;
pub use channels::needed_channels;
pub use chunk::{Completeness, Open};
pub use constant::{Constant, Pool, Value};
pub use dialect::first_of_300;
pub use dialect::{
    CHUNK_OUTPUT, Channels, Dialect, Guess, GuessedKind, Pass, chunk_declarations, guess, needs_300,
};
pub use host::{EntryPoint, EntryResult, Host, channel, starts_a_shader};
pub use late_values::{globals, late_values};
pub use mentions::Mentions;
pub use program::{
    Call, Direction, ExprInfo, Function, FunctionRef, Parameter, Program, Resolution, Storage,
    Variable, VariableId,
};
pub use reach::Reachability;
pub use structure::{Structure, each_expr, each_inner, each_operand, is_dropped};
pub use target::{root, swizzled};
pub use types::{Base, Field, Inside, Sampler, Scalar, Struct, Type, type_name};
pub use undefined::{ComparedWith, Comparing, OperandTest, Undefined};
pub use unit::{Checked, Unit};
pub use upgrade::{CORE_EXTENSIONS, ObstacleKind, Upgrade, UpgradeObstacle, upgrade};
