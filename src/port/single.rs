//! A shader file as a project of one pass.

use super::whole::{Unsupported, whole};
use super::{Info, Input, InputKind, Project, ProjectPass};
use crate::semantic::{
    Dialect, Kind, Pass, Program, Sampler, Stage, Unit, VariableId, analyze, guess,
    shadertoy_header,
};
use crate::text::{Role, Sources};

/// Why a shader file cannot be ported.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ShaderError {
    /// It is a whole shader, and needs what no page of ours gives.
    Unsupported(Unsupported),
    /// It is WebGL1 code.
    WebGl1,
    /// It has none of ShaderToy's entry functions.
    NoEntry,
    /// It is too large to be addressed.
    TooLarge,
}

impl std::fmt::Display for ShaderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ShaderError::Unsupported(what) => what.fmt(f),
            ShaderError::WebGl1 => f.write_str(
                "this is WebGL1 code; write it for ShaderToy, with a `mainImage`, or for WebGL2, \
                 with `#version 300 es`",
            ),
            ShaderError::NoEntry => {
                f.write_str("this has no `mainImage`, which every ShaderToy shader has")
            }
            ShaderError::TooLarge => f.write_str("this is too large"),
        }
    }
}

impl Project {
    /// A project of one pass: one of ShaderToy's, or a whole WebGL2 fragment shader. Its channels
    /// are of the types that their uses need, and empty.
    pub fn from_shader(title: &str, code: &str) -> Result<Project, ShaderError> {
        let pass = match guess(code).kind {
            Some(Kind::ShaderToy(kind)) => {
                let inputs = channels_used(None, code, kind).ok_or(ShaderError::TooLarge)?;
                ProjectPass {
                    inputs,
                    ..ProjectPass::new(kind, code)
                }
            }
            Some(Kind::Versioned) => whole(code).map_err(ShaderError::Unsupported)?,
            Some(Kind::WebGl1) => return Err(ShaderError::WebGl1),
            _ => return Err(ShaderError::NoEntry),
        };
        let info = Info {
            name: title.to_string(),
            ..Info::default()
        };
        Ok(Project {
            info,
            passes: vec![pass],
            is_export: false,
        })
    }
}

/// The channels that code reads, as inputs of the types that it needs. `common` is put before it.
pub(super) fn channels_used(common: Option<&str>, code: &str, kind: Pass) -> Option<Vec<Input>> {
    if kind == Pass::Common {
        return Some(Vec::new());
    }
    let mut sources = Sources::new();
    let header = shadertoy_header(kind, [None; 4]);
    let mut files = vec![sources.add("", None, Role::Prelude, header)?];
    for text in common.into_iter().chain([code]) {
        files.push(sources.add("", None, Role::User, text)?);
    }
    let analysis = analyze(&Unit {
        sources: &sources,
        files: &files,
        stage: Stage::Fragment,
        dialect: Dialect::ShaderToy(kind),
        infer_channels: true,
    });
    let program = &analysis.program;
    let used = (0..4_u8).filter_map(|channel| {
        let kind = match channel_type(program, channel)? {
            Sampler::SamplerCube => InputKind::Cubemap,
            Sampler::Sampler3D => InputKind::Volume,
            _ => InputKind::Texture,
        };
        Some(Input::empty(channel, kind))
    });
    Some(used.collect())
}

/// The type of a channel that the code reads.
fn channel_type(program: &Program, channel: u8) -> Option<Sampler> {
    let name = program.names.get(&format!("iChannel{channel}"))?;
    let is_it = |id: &VariableId| program.variable(*id).is_some_and(|v| v.name == name);
    let id = (0..program.variables.len() as u32)
        .map(VariableId)
        .find(is_it)?;
    let variable = program.variable(id).filter(|v| v.read)?;
    variable.ty.as_sampler()
}
