//! Which shaders are in the text of a file.

pub mod embedded;
pub mod foreign;
mod leading_blanks;
mod pieces;
pub mod shader_file;
pub mod split;
pub mod stage_name;
