//! What is found in the text of a file.

mod assumption;
mod check;
pub mod document;
mod group;
mod inactive;
pub mod partner;
mod place;
mod required;
mod typo;
mod unknown;
pub mod upgrade;
mod version;
