//! Messages about declarations: variables, functions, structs, blocks, and their qualifiers.

mod array;
mod block;
mod declare;
mod entry;
mod function;
mod interface;
mod layout;
mod legacy_output;
mod output;
mod qualifier;
mod record;
