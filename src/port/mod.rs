//! ShaderToy in, WebGL2 out.

mod project;

pub use project::{
    Info, Input, InputKind, OutputId, Project, ProjectError, ProjectPass, SamplerSettings,
};
