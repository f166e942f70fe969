//! ShaderToy in, WebGL2 out.
//!
//! A [`Project`] is what ShaderToy knows of a shader: passes, and what their channels read.
//! [`compose`] puts each pass together as the player compiles it; [`html`] and [`glsl`] write what
//! comes of it. The user's text is never reprinted: it travels as it is, behind the player's own
//! header.

mod compose;
mod credits;
mod glsl;
mod html;
mod payload;
mod project;
mod single;

pub use compose::{Composed, PassUnit, compose};
pub use credits::license_words;
pub use glsl::{GlslPass, VERTEX, glsl};
pub use html::html;
pub use project::{
    Info, Input, InputKind, OutputId, Project, ProjectError, ProjectPass, SamplerSettings,
};
pub use single::ShaderError;
