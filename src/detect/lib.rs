//! Finds GLSL in other files, and decides which language a text is.
#![cfg_attr(test, allow(clippy::string_slice))]

mod document_language;
pub mod embed;
pub mod kind;
mod script;
