//! Ports ShaderToy projects to WebGL2.
//!
//! A [`Project`] contains what ShaderToy stores of a shader: passes and the inputs of their
//! channels. [`compose`] assembles each pass as the player compiles it; [`html`] and [`glsl`] write
//! the result. The user's text is never reformatted: it is copied unchanged after the player's
//! header. Only the languages of the feature `naga` are generated from the checked program.

mod assumed;
mod build;
mod channel;
mod choice;
mod compose;
mod control;
mod credits;
mod dialect;
mod draw;
mod embed;
mod export;
mod findings;
mod gallery;
mod glsl;
mod host_output;
mod html;
mod json;
mod keys;
mod limits;
mod media;
#[cfg(feature = "naga")]
pub mod naga;
mod order;
mod output;
mod parts;
mod payload;
mod pieces;
mod project;
mod repair;
mod rewrite;
mod script;
mod signature;
mod single;
mod sliders;
mod supply;
#[cfg(feature = "naga")]
mod translated;
mod tuned;
#[cfg(feature = "naga")]
mod webgpu;

pub use assumed::AssumedInput;
pub use build::{build, still_file};
pub use channel::{ChannelName, ChannelOrder, ChannelSource, Media, unknown_source};
pub use compose::{Composed, PassUnit, compose};
pub use control::{ControlChoice, ControlKind, UniformControl};
pub use credits::license_words;
pub use dialect::{
    Bindings, Clues, Completion, Hosted, MAX_CHANNELS, Recognised, SiblingTexts, TextChange,
    UniformData, VaryingValue, bindings, calls_entry, declared_control, hosted, may_be_composed,
    recognise,
};
pub use draw::{PassDraw, SizeTerm};
pub use embed::{PageAddress, Poster, Still, embed};
pub use export::{MAX_EXPORT, ProjectError, exports_in};
pub use gallery::{Gallery, GalleryEntry, gallery};
pub use glsl::{GlslPass, VERTEX, glsl};
pub use host_output::HostedShader;
pub use html::{PlayerPage, html, player_data, receiving_page, waiting_page};
pub use json::json;
pub use limits::{BeyondLimit, limits};
pub use media::{Generator, StandIn, add_stand_ins, is_gray};
pub use order::{BadExtension, Destination, MainChoice, Order, Target};
pub use output::{Build, BuildError, File, Remark};
pub use parts::{PartsError, PassFile, PassRole, saver_roles, unknown_pass};
pub use project::{
    Info, Input, InputKind, OutputId, Project, ProjectPass, SamplerSettings, SignalForm, Wrapper,
};
pub use repair::add_repairs;
pub use rewrite::{NotSafe, rewrite};
pub use script::{ScriptModule, module, react, three};
pub use signature::{VolumeHead, kind_of_bytes, kind_of_name, why_not};
pub use single::ShaderError;
pub use sliders::SliderChoice;
pub use supply::{Missing, missing};
#[cfg(feature = "naga")]
pub use translated::{CompleteShader, CompleteShaders, complete_shaders, translate_shaders};
pub use tuned::slider_notes;
#[cfg(feature = "naga")]
pub use webgpu::channels_to_set;
