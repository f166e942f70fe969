//! Runs shaders and projects: draws frames as the player does, summarises images, and runs tests
//! in GLSL.
#![cfg_attr(test, allow(clippy::string_slice))]

mod image;
mod png;
mod project;
mod steepest;
mod test;

pub use image::{ImageFacts, RenderedImage};
pub use png::png;
pub use project::{Decode, Decoded, PlaybackOptions, PlaybackProblem, Played, Player, SOUND_RATE};
pub use steepest::{Steepest, Unsampled, steepest};
pub use test::{
    Coverage, CoveredFunction, FileCoverage, FoundValues, RunCounts, SeenCondition, SeenValue,
    Test, TestCase, TestFailure, TestProblem, TestResult, TestSettings, TestSuite, TestVerdict,
    TextureMark, run_test, unusable_tests,
};
