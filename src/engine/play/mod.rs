//! Runs shaders: sets their inputs for a frame, and summarises the image.

mod moment;
mod picture;
mod player;
mod project;
mod scene;
mod supply;
mod test;
mod varyings;

pub use moment::{Button, Moment, Mouse};
pub use picture::{Picture, PictureFacts};
pub use player::{player_draw, player_gives};
pub use project::{Decode, Decoded, PlayOptions, PlayProblem, Played, Player, SOUND_RATE};
pub use scene::{Given, Scene, Unfit};
pub(crate) use supply::Supply;
pub use test::{SeenCondition, SeenValue, TestFailure, TestVerdict, run_test, tests};
