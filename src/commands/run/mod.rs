//! `shaderlint run`: draws a shader without a GPU, and summarises what happened.

mod answer;
mod bitmap;
mod columns;
mod compare;
mod facts;
mod fields;
pub mod font;
mod frame;
mod functions;
pub mod heat;
mod loops;
mod numbers;
mod place;
mod rays;
mod request;
mod scalars;
mod setting;
mod sheet;
mod shot;
mod show;
mod trace;
mod uniforms;
mod variant;

pub use answer::{AnswerFacts, RunAnswer, answer};
pub use bitmap::Bitmap;
pub use frame::{Frame, frame};
pub use place::position;
pub use request::{InputRequest, MAX_PIXELS, MouseRequest, RunFront, RunRequest, size_of, time_of};
pub use setting::{FrameView, HeatMap, ObservedRays, RunProgress, ShotSetting, Show, UniformText};
pub use shot::{Loaded, Shot, shot};
pub use show::value_image;
pub use variant::{FrameDraw, Unmade, Variant};
