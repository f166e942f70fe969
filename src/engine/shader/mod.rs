//! The shaders of a file: their text in each possible reading, and what is known of them.

pub mod analysis;
pub mod assumption;
mod chunks;
pub mod export;
pub mod input;
mod prelude;
pub mod reading;
pub mod shader_input;
