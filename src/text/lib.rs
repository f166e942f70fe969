//! Source text and places in it.
//!
//! A [`Sources`] holds every file that one shader is made of, laid end to end in one address space,
//! so that a [`Span`] of two offsets names both the file and the place in it. Nothing here knows
//! what the text means.
#![cfg_attr(test, allow(clippy::string_slice))]

mod content;
mod edit;
pub mod embed;
pub mod json;
pub mod kind;
mod line_index;
mod source;
mod span;
mod words;

pub use content::{Content, Encoding};
pub use edit::{Edit, EditError, apply_edits};
pub use line_index::{LineIndex, Position};
pub use source::{CompiledText, FileId, Role, SourceFile, Sources};
pub use span::Span;
pub use words::WordIndex;
