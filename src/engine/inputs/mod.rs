//! What a shader is given at a moment: uniforms, varyings and the uniforms of ShaderToy's player.

mod moment;
mod player;
mod scene;
mod supply;
mod varyings;

pub use moment::{Button, Moment, Mouse};
pub use player::{player_draw, player_gives};
pub use scene::{GivenUniforms, Scene, Unfit};
pub(crate) use supply::Supply;
