//! The IR of a checked [`Program`](shaderlint_semantic::Program): typed operations with structured
//! control flow, the input of all analyses, back ends and the bytecode compiler.
#![cfg_attr(test, allow(clippy::string_slice, clippy::unreachable))]

mod cost;
pub mod expand;
mod form;
mod layout;
mod lower;
mod print;
#[cfg(test)]
mod tests;
mod verify;
mod walk;

pub use form::{
    Access, Binary, Case, CaseLabel, Function, Lanes, Loop, LoopId, Module, Op, OpId, OpKind,
    Place, PlaceId, Precision, Provenance, Region, Root, Run, Step, Switch, SwitchId, Unary,
    Variable,
};
pub use layout::{Layout, PartLayout, column_lanes, length_lane};
pub use lower::lower;
pub use print::print;
pub use verify::{Violation, verify};
pub use walk::{Visit, Visited};
