//! The hosts of shaders: which may complete a text, and what they make of it.

pub mod host;
pub mod hosted;
pub mod joined;
pub mod webgl;
