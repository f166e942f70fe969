//! What the commands answer, without files: the command line and WebAssembly print the same bytes.
#![cfg_attr(test, allow(clippy::string_slice))]

mod check;
mod explain;
mod format;
#[cfg(feature = "cli")]
mod port;
mod reading;
mod reflect;
pub mod run;
mod scope;

pub use check::{CheckRequest, CheckedText, FindingKey, check, print};
pub use explain::{explain, rule_list, rule_page, rule_table};
pub use format::FormatRequest;
#[cfg(feature = "cli")]
pub use port::PortRequest;
pub use reading::{Recognition, reading};
pub use reflect::{FileReflection, ReflectedShader, ReflectionList, reflect, type_style};
pub use shaderlint_reflect::{TypeStyle, UniformTypes, declaration, helpers, module};
