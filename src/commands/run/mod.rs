//! `shaderlint run`: draws a shader without a GPU, and summarises what happened.

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
mod scalars;
mod setting;
mod shot;
mod show;
mod trace;
mod uniforms;
mod variant;

pub use bitmap::Bitmap;
pub use compare::{Compared, compare, compared_moments};
pub use facts::{RunFacts, SheetFacts};
pub use frame::{Frame, frame};
pub use place::position;
pub use rays::rays;
pub use setting::{FrameView, HeatMap, ObservedRays, ShotSetting, Show, UniformText};
pub use shot::{Loaded, Shot, shot};
pub use show::value_image;
pub use trace::{TraceFacts, trace};
pub use variant::{FrameDraw, Unmade, Variant};
