//! shaderlint checks GLSL for WebGL2 and ShaderToy; shaderport turns ShaderToy code into WebGL2.
//!
//! `src/README.md` draws the house.
#![forbid(unsafe_code)]
#![deny(clippy::disallowed_methods)]
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::todo,
        clippy::unimplemented,
        clippy::indexing_slicing,
        clippy::string_slice
    )
)]

#[cfg(feature = "cli")]
pub mod cli;
pub mod diagnostic;
pub mod engine;
pub mod exec;
pub mod flow;
pub mod format;
pub mod host;
pub mod ide;
pub mod ir;
pub mod lint;
mod math;
pub mod port;
pub mod report;
#[path = "../rules/mod.rs"]
pub mod rules;
pub mod semantic;
pub mod syntax;
pub mod text;
