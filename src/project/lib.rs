//! The program around a shader: the files that belong to it, its passes, the inputs of their
//! channels, and the host that completes it.
//!
//! A [`Project`] contains what ShaderToy stores of a shader, or a complete shader of another host;
//! [`compose`] assembles each pass as the player compiles it. Everything outside of the text itself
//! is asked of [`Files`], so that each front sees the same project.
#![cfg_attr(test, allow(clippy::string_slice))]

mod access;
mod compose;
mod control;
mod dialect;
mod draw;
mod files;
mod include;
mod input;
mod media;
mod open;
mod project;
mod repair;
mod signature;
mod sliders;

pub use access::{FileAccess, Includes};
pub use compose::{Composed, PassUnit, compose};
pub use control::{ControlChoice, ControlKind, UniformControl};
pub use dialect::{
    Bindings, Clues, Completion, Hosted, MAX_CHANNELS, Recognised, SiblingTexts, TextChange,
    UniformData, VaryingValue, asks_for_desktop, best, bind, bindings, calls_entry,
    declared_control, hosted, imported_hosts, installed_hosts, installed_release, may_be_composed,
    plan, recognise, uses_installed,
};
pub use draw::{PassDraw, SizeTerm};
pub use files::family::{Family, common_of, family, is_common};
pub use files::file_cache::FileCache;
pub use files::for_others::{NamesForOthers, macros};
pub use files::imports::{imports, meant};
pub use files::scan::{IncludedChunk, chunks_in, required_names};
pub use files::words::{counts, hash};
pub use files::{Dependency, FileType, Files, LoadError, MAX_LOADED, NoFiles};
pub use include::gathered::{GatheredText, gather};
pub use include::script::{ModuleCache, ScriptModules, module_files};
pub use include::{
    Absence, FileMoves, Hushed, JoinedFiles, MissingInclude, Spread, moved_includes, spread,
    spread_chunks,
};
pub use input::assumed::AssumedInput;
pub use input::channel::{ChannelName, ChannelOrder, ChannelSource, Media, unknown_source};
pub use input::export::{MAX_EXPORT, ProjectError, exports_in};
pub use input::parts::{PartsError, PassFile, PassRole, saver_roles, unknown_pass};
pub use input::single::ShaderError;
pub use input::supply::{Missing, missing};
pub use media::{Generator, StandIn, add_stand_ins, is_gray};
pub use open::{
    GivenOrder, MediaFiles, NoMedia, OpenedProject, SingleShader, channel_file, folder_passes,
    open_file, open_passes, read_siblings,
};
pub use project::{
    Info, Input, InputKind, OutputId, Project, ProjectPass, SamplerSettings, SignalForm, Wrapper,
};
pub use repair::add_repairs;
pub use signature::{VolumeHead, kind_of_bytes, kind_of_name, why_not};
pub use sliders::{Slider, SliderChoice, Sliders};
