//! Ports ShaderToy projects to WebGL2.
//!
//! A [`Project`] contains what ShaderToy stores of a shader: passes and the inputs of their
//! channels. [`compose`] assembles each pass as the player compiles it; [`html`] and [`glsl`] write
//! the result. The user's text is never reformatted: it is copied unchanged after the player's
//! header. Only the languages of the feature `naga` are generated from the checked program.

mod build;
mod credits;
mod glsl;
mod host_output;
mod html;
mod json;
mod limits;
#[cfg(feature = "naga")]
pub mod naga;
mod order;
mod output;
mod payload;
mod rewrite;
mod script;
#[cfg(feature = "naga")]
mod translated;
#[cfg(feature = "naga")]
mod webgpu;

use shaderlint_project::{
    Bindings, Composed, ControlKind, Generator, Info, Input, InputKind, OutputId, PassUnit,
    Project, ProjectPass, SizeTerm, UniformControl, UniformData, Wrapper,
};

pub use build::{build, still_file};
pub use credits::license_words;
pub use glsl::{GlslPass, VERTEX, glsl};
pub use host_output::HostedShader;
pub use html::embed::{PageAddress, Poster, Still, embed};
pub use html::gallery::{Gallery, GalleryEntry, gallery};
pub use html::{PlayerPage, html, player_data, receiving_page, waiting_page};
pub use json::json;
pub use limits::{BeyondLimit, limits};
pub use order::{BadExtension, Destination, MainChoice, Order, Target};
pub use output::{Build, BuildError, File, Remark};
pub use payload::tuned::slider_notes;
pub use rewrite::{NotSafe, rewrite};
pub use script::{ScriptModule, module, react, three};
#[cfg(feature = "naga")]
pub use translated::{CompleteShader, CompleteShaders, complete_shaders, translate_shaders};
#[cfg(feature = "naga")]
pub use webgpu::channels_to_set;
