//! Checks of declarations: variables, functions, structs, blocks, and their qualifiers.

pub(super) mod array;
pub(super) mod declare;
pub(super) mod entry;
pub(super) mod function;
pub(super) mod interface;
pub(super) mod layout;
pub(super) mod output;
pub(super) mod qualifier;
pub(super) mod record;
