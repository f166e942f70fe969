//! A shader file as a project of one pass.

use super::whole::{Unsupported, inputs};
use super::{Composed, Info, Input, InputKind, Project, ProjectPass, Wrapper, compose};
use crate::semantic::{
    GuessedKind, Pass, Program, Sampler, Stage, VariableId, guess, needed_channels,
};
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
    /// are of the types that their lookups need, and empty.
    ///
    /// # Errors
    /// Where no page of ours can show it.
    pub fn from_shader(title: &str, code: &str) -> Result<Project, ShaderError> {
        let mut project = Project::draft(title, code)?;
        project.resolve("")?;
        Ok(project)
    }

    /// A project of one pass, of whose channels nothing is known yet.
    ///
    /// # Errors
    /// Where its text shows that no page of ours can show it.
    pub fn draft(title: &str, code: &str) -> Result<Project, ShaderError> {
        let told = guess(code);
        let pass = match told.kind {
            Some(GuessedKind::ShaderToy(kind)) => ProjectPass::new(kind, code),
            Some(GuessedKind::Versioned) if told.stage == Some(Stage::Vertex) => {
                let message = "this is a vertex shader; give the fragment shader".to_string();
                return Err(ShaderError::Unsupported(Unsupported { line: 0, message }));
            }
            Some(GuessedKind::Versioned) => own(code),
            Some(GuessedKind::WebGl1) => return Err(ShaderError::WebGl1),
            _ => return Err(ShaderError::NoEntry),
        };
        Ok(Project::of_pass(title, pass))
    }

    /// A WebGL1 fragment shader as a project that is to be repaired, under the version of the language
    /// that it will have. Nothing is asked of it yet: [`Project::draft`] takes what comes of it.
    pub fn from_webgl1(title: &str, code: &str) -> Project {
        Project::of_pass(title, own(format!("{VERSION}{code}")))
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

    /// Puts the passes together, and gives the channels of shader files the types that their lookups
    /// need. Those of an export are what it says. `path` is the file that the user gave.
    ///
    /// # Errors
    /// Where no page of ours can show what comes of it.
    pub fn resolve(&mut self, path: &str) -> Result<Composed, ShaderError> {
        let composed = compose(self, path).ok_or(ShaderError::TooLarge)?;
        if self.is_export {
            return Ok(composed);
        }
        for unit in &composed.units {
            let program = &composed.analysis(unit).program;
            let inputs = match unit.wrapper {
                Wrapper::Player => channels_used(program, unit.kind),
                Wrapper::Own => inputs(program).map_err(ShaderError::Unsupported)?,
            };
            if let Some(pass) = self.passes.get_mut(unit.pass) {
                pass.inputs = inputs;
            }
        }
        self.renew(composed, path)
    }

    /// The passes put together, anew where something has changed that decides what is compiled.
    ///
    /// # Errors
    /// Where they are too large to be addressed.
    pub fn renew(&self, composed: Composed, path: &str) -> Result<Composed, ShaderError> {
        match composed.is_of(self) {
            true => Ok(composed),
            false => compose(self, path).ok_or(ShaderError::TooLarge),
        }
    }
}

/// What a WebGL2 shader starts with.
const VERSION: &str = "#version 300 es\n";

/// A pass that is a whole shader.
fn own(code: impl Into<Arc<str>>) -> ProjectPass {
    ProjectPass {
        wrapper: Wrapper::Own,
        ..ProjectPass::new(Pass::Image, code)
    }
}

/// The channels that code reads, as inputs of the types that its lookups need.
fn channels_used(program: &Program, kind: Pass) -> Vec<Input> {
    if kind == Pass::Common {
        return Vec::new();
    }
    let needed = needed_channels(program);
    let used = (0..4_u8).zip(needed).filter_map(|(channel, needed)| {
        let kind = match needed.or(channel_type(program, channel))? {
            Sampler::SamplerCube => InputKind::Cubemap,
            Sampler::Sampler3D => InputKind::Volume,
            _ => InputKind::Texture,
        };
        channel_type(program, channel).map(|_| Input::empty(channel, kind))
    });
    used.collect()
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
