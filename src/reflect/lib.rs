//! What shaders declare for the program around them, as data and as types of TypeScript.
#![cfg_attr(test, allow(clippy::string_slice))]

mod block;
mod declared_type;
mod defines;
mod inactive;
mod reflection;
mod typescript;
mod variable;

pub use block::{PlacedMember, ReflectedBlock};
pub use declared_type::{DeclaredMember, ReflectedType};
pub use defines::SettableMacro;
pub use reflection::Reflection;
pub use typescript::{TypeStyle, UniformTypes, declaration, helpers, module};
pub use variable::ReflectedVariable;
