//! Ports ShaderToy projects to WebGL2.
//!
//! A [`Project`] contains what ShaderToy stores of a shader: passes and the inputs of their
//! channels. [`compose`] assembles each pass as the player compiles it; [`html`] and [`glsl`] write
//! the result. The user's text is never reformatted: it is copied unchanged after the player's
//! header. Only the languages of the feature `naga` are generated from the checked program.

mod build;
mod compose;
mod control;
mod credits;
mod dialect;
mod draw;
mod glsl;
mod host_output;
mod html;
mod input;
mod json;
mod limits;
mod media;
#[cfg(feature = "naga")]
pub mod naga;
mod order;
mod output;
mod payload;
mod project;
mod repair;
mod rewrite;
mod script;
mod signature;
mod sliders;
#[cfg(feature = "naga")]
mod translated;
#[cfg(feature = "naga")]
mod webgpu;

pub use build::{build, still_file};
pub use compose::{Composed, PassUnit, compose};
pub use control::{ControlChoice, ControlKind, UniformControl};
pub use credits::license_words;
pub use dialect::{
    Bindings, Clues, Completion, Hosted, MAX_CHANNELS, Recognised, SiblingTexts, TextChange,
    UniformData, VaryingValue, bindings, calls_entry, declared_control, hosted, may_be_composed,
    recognise,
};
pub use draw::{PassDraw, SizeTerm};
pub use glsl::{GlslPass, VERTEX, glsl};
pub use host_output::HostedShader;
pub use html::embed::{PageAddress, Poster, Still, embed};
pub use html::gallery::{Gallery, GalleryEntry, gallery};
pub use html::{PlayerPage, html, player_data, receiving_page, waiting_page};
pub use input::assumed::AssumedInput;
pub use input::channel::{ChannelName, ChannelOrder, ChannelSource, Media, unknown_source};
pub use input::export::{MAX_EXPORT, ProjectError, exports_in};
pub use input::parts::{PartsError, PassFile, PassRole, saver_roles, unknown_pass};
pub use input::single::ShaderError;
pub use input::supply::{Missing, missing};
pub use json::json;
pub use limits::{BeyondLimit, limits};
pub use media::{Generator, StandIn, add_stand_ins, is_gray};
pub use order::{BadExtension, Destination, MainChoice, Order, Target};
pub use output::{Build, BuildError, File, Remark};
pub use payload::tuned::slider_notes;
pub use project::{
    Info, Input, InputKind, OutputId, Project, ProjectPass, SamplerSettings, SignalForm, Wrapper,
};
pub use repair::add_repairs;
pub use rewrite::{NotSafe, rewrite};
pub use script::{ScriptModule, module, react, three};
pub use signature::{VolumeHead, kind_of_bytes, kind_of_name, why_not};
pub use sliders::SliderChoice;
#[cfg(feature = "naga")]
pub use translated::{CompleteShader, CompleteShaders, complete_shaders, translate_shaders};
#[cfg(feature = "naga")]
pub use webgpu::channels_to_set;
