//! What most rules use: a rule starts with `use shaderlint_lint::prelude::*`.

pub use crate::sample::{Round, SampleFrame, SampleRun, SampledPixel, share};
pub use crate::{
    BinaryExpr, Builtin, Context, DeclaredName, DeclaredVariable, Setting, Shape, remove_statement,
    same_code, without_statement,
};
pub use shaderlint_diagnostic::Fix;
pub use shaderlint_exec::{FaultKind, Watch};
pub use shaderlint_flow::ranges::{Interval, Side};
pub use shaderlint_flow::{LoopFacts, Start, Varying};
pub use shaderlint_ir::{Binary, Module, OpId, OpKind, Provenance, Unary};
pub use shaderlint_semantic::{
    BuiltinId, Dialect, Direction, FunctionRef, Pass, Program, Resolution, Scalar, Stage, Storage,
    Type, Value, VariableId, each_inner, each_operand,
};
pub use shaderlint_syntax::ast::*;
pub use shaderlint_syntax::{Macro, TokenKind, Version};
pub use shaderlint_text::number::{decimals, grouped, rounded_percent};
pub use shaderlint_text::{Edit, Span};
