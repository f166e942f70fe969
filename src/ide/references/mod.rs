//! Where else a name is used: definitions, references, renaming, the call hierarchy; also in the
//! scripts that use a shader.

pub(super) mod calls;
mod family;
pub(super) mod navigate;
pub(super) mod rename;
mod scripts;
