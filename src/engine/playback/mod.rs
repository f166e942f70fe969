//! Runs shaders: sets their inputs for a frame, and summarises the image.

mod image;
mod moment;
mod player;
mod png;
mod project;
mod scene;
mod steepest;
mod supply;
mod test;
mod varyings;

pub use image::{ImageFacts, RenderedImage};
pub use moment::{Button, Moment, Mouse};
pub use player::{player_draw, player_gives};
pub use png::png;
pub use project::{Decode, Decoded, PlaybackOptions, PlaybackProblem, Played, Player, SOUND_RATE};
pub use scene::{GivenUniforms, Scene, Unfit};
pub use steepest::{Steepest, Unsampled, steepest};
pub(crate) use supply::Supply;
pub use test::{
    Coverage, CoveredFunction, FileCoverage, FoundValues, RunCounts, SeenCondition, SeenValue,
    Test, TestCase, TestFailure, TestProblem, TestResult, TestSettings, TestSuite, TestVerdict,
    TextureMark, run_test, unusable_tests,
};
