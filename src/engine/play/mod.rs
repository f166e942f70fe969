//! Shaders are run: what one is given at a moment, and what its picture shows.

mod moment;
mod picture;
mod scene;
mod varyings;

pub use moment::{Button, Moment, Mouse};
pub use picture::{Picture, PictureFacts};
pub use scene::{Scene, Unfit};
