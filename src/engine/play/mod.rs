//! Shaders are run: what one is given at a moment, and what its picture shows.

mod moment;
mod picture;
mod project;
mod scene;
mod varyings;

pub use moment::{Button, Moment, Mouse};
pub use picture::{Picture, PictureFacts};
pub use project::{PlayOptions, PlayProblem, Played, Player, SOUND_RATE};
pub use scene::{Scene, Unfit};
