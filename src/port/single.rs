//! A shader file as a project of one pass.

use super::{Info, Input, InputKind, Project, ProjectPass, SamplerSettings};
use crate::semantic::{
    Dialect, Kind, Pass, Program, Sampler, Stage, Unit, VariableId, analyze, guess,
    shadertoy_header,
};
use crate::text::{Role, Sources};

/// Why a shader file cannot be ported.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ShaderError {
    /// It has a `#version`: it is WebGL code already.
    Versioned,
    /// It has none of ShaderToy's entry functions.
    NoEntry,
    /// It is too large to be addressed.
    TooLarge,
}

impl std::fmt::Display for ShaderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ShaderError::Versioned => "this has a `#version`, so it is WebGL code already",
            ShaderError::NoEntry => "this has no `mainImage`, which every ShaderToy shader has",
            ShaderError::TooLarge => "this is too large",
        })
    }
}

impl Project {
    /// A project of one pass. Its channels are of the types that their uses need, and empty.
    pub fn from_shader(title: &str, code: &str) -> Result<Project, ShaderError> {
        let kind = match guess(code).kind {
            Some(Kind::ShaderToy(kind)) => kind,
            Some(Kind::Versioned) => return Err(ShaderError::Versioned),
            _ => return Err(ShaderError::NoEntry),
        };
        let inputs = channels_used(code, kind).ok_or(ShaderError::TooLarge)?;
        let pass = ProjectPass {
            kind,
            name: String::new(),
            code: code.into(),
            inputs,
            output: None,
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

/// The channels that code reads, as inputs of the types that it needs.
fn channels_used(code: &str, kind: Pass) -> Option<Vec<Input>> {
    let mut sources = Sources::new();
    let header = sources.add("", None, Role::Prelude, shadertoy_header(kind, [None; 4]))?;
    let file = sources.add("", None, Role::User, code)?;
    let files = [header, file];
    let analysis = analyze(&Unit {
        sources: &sources,
        files: &files,
        stage: Stage::Fragment,
        dialect: Dialect::ShaderToy(kind),
        infer_channels: true,
    });
    let program = &analysis.program;
    let used = (0..4_u8).filter_map(|channel| {
        let sampler = channel_type(program, channel)?;
        Some(Input {
            channel,
            kind: match sampler {
                Sampler::SamplerCube => InputKind::Cubemap,
                Sampler::Sampler3D => InputKind::Volume,
                _ => InputKind::Texture,
            },
            id: String::new(),
            src: String::new(),
            // What most channels of the site are set to.
            sampler: SamplerSettings {
                filter: "mipmap".to_string(),
                wrap: "repeat".to_string(),
                vflip: sampler == Sampler::Sampler2D,
            },
            name: String::new(),
            urls: Vec::new(),
        })
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
