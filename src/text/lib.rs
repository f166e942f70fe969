//! Source text and positions.
//!
//! A [`Sources`] contains all files of a shader in one address space, so that a [`Span`] of two
//! offsets determines both file and position. This crate does not parse GLSL.
#![cfg_attr(test, allow(clippy::string_slice))]

mod cases;
mod content;
mod edit;
pub mod json;
mod line_index;
pub mod markup;
pub mod number;
pub mod path;
mod removal;
mod slots;
mod source;
mod span;
mod spelling;
mod words;

pub use cases::each_case;
pub use content::{Content, Encoding};
pub use edit::{Edit, EditError, apply_edits};
pub use line_index::{LineIndex, Position};
pub use removal::remove_lines;
pub use slots::SetAt;
pub use source::{CompiledText, FileId, Role, SourceFile, Sources, TextPiece};
pub use span::Span;
pub use spelling::is_respelled;
pub use words::WordIndex;
