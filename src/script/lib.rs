//! Evaluates scripts as far as their values are known without running them.
//!
//! A program is followed from its first statement through its functions, classes and modules. Known values stay
//! known; everything else has an identity, so that what is done with it can be followed. Of a condition that is
//! not known both branches are evaluated, and what they change differently is unknown after them. What a program
//! does with things outside of it (WebGL, libraries) is recorded in order as [`ScriptEvent`]s.
#![cfg_attr(test, allow(clippy::string_slice))]

mod assign;
mod branch;
mod builtin;
mod call;
mod class;
mod evaluator;
mod expression;
mod jsx;
mod module;
mod page;
mod statement;
mod value;
mod world;

pub use evaluator::{ExternalScript, Loader, evaluate};
pub use value::{KnownText, ObjectId, Primitive, ScriptPlace, ScriptValue};
pub use world::{
    Closure, EventCertainty, EventId, EventKind, ForeignCall, ObjectKind, Property, ScriptClass,
    ScriptEvent, ScriptObject, Source, World,
};
