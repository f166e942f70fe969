//! Semantic analysis: types, scopes and the checks of the browser's compiler.
//!
//! [`check_shader`] returns a [`Program`], which later layers only read, and the problems in it as
//! data, which `explain` turns into messages. The rules follow GLSL ES 3.00 and 1.00 as implemented
//! by ANGLE, the compiler used by browsers.
#![cfg_attr(test, allow(clippy::string_slice))]

pub mod builtins;
mod channels;
mod check_shader;
#[expect(missing_docs, reason = "named after what it is, for `explain`")]
mod checker;
mod constant;
mod corrections;
mod dialect;
mod fold;
mod host;
mod infer_channels;
pub mod lists;
#[expect(missing_docs, reason = "named after what it is, for `explain`")]
pub mod parsed;
#[expect(missing_docs, reason = "named after what it is, for `explain`")]
pub mod problem;
mod program;
#[expect(missing_docs, reason = "named after what it is, for `explain`")]
pub mod scope;
pub mod snippet;
pub mod tunable;
mod tunable_mark;
mod types;
#[expect(missing_docs, reason = "named after what it is, for `explain`")]
pub mod typing;
mod undefined;
mod unit;

pub use builtins::{BuiltinId, Stage};
pub use channels::needed_channels;
pub use check_shader::{CheckedShader, check_fragment, check_row, check_shader, with_prelude};
pub use constant::{Constant, Pool, Value};
pub use dialect::first_of_300;
pub use dialect::{
    CHUNK_OUTPUT, Channels, Dialect, Guess, GuessedKind, Pass, chunk_declarations, guess, needs_300,
};
pub use host::{EntryPoint, EntryResult, Host, channel, starts_a_shader};
pub use program::calls::CallGraph;
pub use program::interface;
pub use program::late_values::{globals, late_values};
pub use program::mentions::Mentions;
pub use program::reach::Reachability;
pub use program::std140::{BlockLayout, BlockMember};
pub use program::structure::{Structure, each_expr, each_inner, each_operand, is_dropped};
pub use program::target::{root, swizzled};
pub use program::{
    Call, Direction, ExprInfo, Function, FunctionRef, Parameter, Program, Resolution, Storage,
    Variable, VariableId,
};
pub use types::{Base, Field, Inside, Sampler, Scalar, Struct, Type, type_name};
pub use undefined::{ComparedWith, Comparing, OperandTest, Undefined};
pub use unit::{Completeness, Unit};
