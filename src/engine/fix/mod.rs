//! Changes of texts: fixes of findings, conversions, the format; and whether they keep the picture.

pub mod fix_text;
pub mod format;
mod look;
pub mod modernize;
pub mod offer;
pub mod verify;
