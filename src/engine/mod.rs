//! The one way in: from the text of a file to what is to be said of it.
//!
//! A text is *whole* or a *part* by evidence; a host completes a part. What a shader includes, what
//! holds it (a page, a script, an export) and how it is configured is dealt with here, so that every
//! front only reads files and prints.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::string_slice
    )
)]

pub mod config;
mod document;
mod embedded;
mod export;
mod foreign;
mod host;
mod include;
mod mend;
mod options;
mod part;
mod partner;
pub mod path;
mod reading;

pub use crate::semantic::Extent;
pub use document::{DocumentError, Findings, check, check_with};
pub use host::Packages;
pub use include::{Absence, Files, Includes, Missing};
pub use mend::{Offer, fix_text, fix_with, offer};
pub use options::{Desktop, DialectChoice, HostNames, HostUniform, Options};
pub use part::Shader;
pub use partner::{NOBODY, Partners};
