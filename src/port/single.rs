//! A shader file as a project of one pass.

use super::whole::{Unsupported, whole};
use super::{Info, Input, InputKind, Project, ProjectPass, Wrapper};
use crate::semantic::{
    Dialect, Extent, Kind, Pass, Program, Sampler, Stage, Unit, VariableId, analyze, guess,
};
use crate::text::{Role, Sources};
use std::sync::Arc;

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
            ShaderError::WebGl1 => {
                f.write_str("this is WebGL1 code; `--repair` makes WebGL2 of it")
            }
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
        Ok(Project::of_pass(title, pass))
    }

    /// A WebGL1 fragment shader as a project that is to be repaired, under the version of the language
    /// that it will have. Nothing is asked of it yet: [`Project::from_shader`] takes what comes of it.
    pub fn from_webgl1(title: &str, code: &str) -> Project {
        let pass = ProjectPass {
            wrapper: Wrapper::Own,
            ..ProjectPass::new(Pass::Image, format!("{VERSION}{code}"))
        };
        Project::of_pass(title, pass)
    }

    fn of_pass(title: &str, pass: ProjectPass) -> Project {
        let info = Info {
            name: title.to_string(),
            ..Info::default()
        };
        Project {
            info,
            passes: vec![pass],
            is_export: false,
        }
    }

    /// Gives the channels of shader files the types that their uses need. Those of an export are what
    /// it says.
    pub fn infer_channels(&mut self) -> Option<()> {
        if self.is_export {
            return Some(());
        }
        let mut commons = self.passes.iter().filter(|p| p.kind == Pass::Common);
        let common = commons.next().map(|p| p.code.clone());
        for pass in &mut self.passes {
            if pass.wrapper == Wrapper::Player {
                pass.inputs = channels_used(common.as_deref(), &pass.code, pass.kind)?;
            }
        }
        Some(())
    }
}

/// What a WebGL2 shader starts with.
const VERSION: &str = "#version 300 es\n";

/// The channels that code reads, as inputs of the types that it needs. `common` is put before it.
pub(super) fn channels_used(common: Option<&str>, code: &str, kind: Pass) -> Option<Vec<Input>> {
    if kind == Pass::Common {
        return Some(Vec::new());
    }
    let mut sources = Sources::new();
    let header = kind.host().prelude([None; 4]);
    let mut files = vec![sources.add("", None, Role::Prelude, header)?];
    for text in common.into_iter().chain([code]) {
        files.push(sources.add("", None, Role::User, text)?);
    }
    let analysis = analyze(&Unit {
        sources: &Arc::new(sources),
        files: &files,
        stage: Stage::Fragment,
        dialect: Dialect::ShaderToy(kind),
        infer_channels: true,
        extent: Extent::Whole,
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
