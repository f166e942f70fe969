//! A shader file as a project: a pass of ShaderToy, or a whole shader of any dialect.

use super::dialect::{self, Clues, Plan, PlannedPass, Recognised, TextsBeside, bind, recognise};
use super::{
    Bindings, Composed, Info, Input, InputKind, Project, ProjectPass, UniformControl, Wrapper,
    compose,
};
use shaderlint_host::{Preset, page};
use shaderlint_semantic::{
    GuessedKind, Pass, Program, Sampler, Stage, VariableId, guess, needed_channels,
};

/// Why a shader file cannot be ported.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ShaderError {
    /// It is a vertex shader.
    Vertex,
    /// It has none of ShaderToy's entry functions, and no `main`.
    NoEntry,
    /// It is too large to be addressed.
    TooLarge,
}

impl std::fmt::Display for ShaderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ShaderError::Vertex => "this is a vertex shader; give the fragment shader",
            ShaderError::NoEntry => {
                "this has neither `mainImage`, which every ShaderToy shader has, nor `main`"
            }
            ShaderError::TooLarge => "this is too large",
        })
    }
}

impl Project {
    /// A project of a shader file. Its channels are of the types that their lookups need, and empty.
    ///
    /// # Errors
    /// Where no page of ours can show it.
    pub fn from_shader(title: &str, code: &str) -> Result<Project, ShaderError> {
        let mut project = Project::draft(title, code, None)?;
        project.resolve("")?;
        Ok(project)
    }

    /// A project of a shader file, of whose channels nothing is known yet. `host` is who
    /// runs it, as the user says.
    ///
    /// # Errors
    /// Where its text shows that no page of ours can show it.
    pub fn draft(
        title: &str,
        code: &str,
        host: Option<&'static Preset>,
    ) -> Result<Project, ShaderError> {
        Project::draft_beside(title, code, host, &TextsBeside::new())
    }

    /// The same of a text that others stand beside: those that it still asks for are in
    /// [`Project::wanted`].
    ///
    /// # Errors
    /// Where its text shows that no page of ours can show it.
    pub fn draft_beside(
        title: &str,
        code: &str,
        host: Option<&'static Preset>,
        beside: &TextsBeside,
    ) -> Result<Project, ShaderError> {
        let told = guess(code);
        let pass = match told.kind {
            Some(GuessedKind::ShaderToy(kind)) => Some(kind),
            _ => None,
        };
        let clues = Clues::beside(code, title, beside);
        let recognised = host.map(Recognised::given).or_else(|| recognise(&clues));
        let recognised = recognised.ok_or(ShaderError::NoEntry)?;
        let Some(plan) = dialect::plan(recognised.host, &clues) else {
            let kind = pass.ok_or(ShaderError::NoEntry)?;
            return Ok(Project::of_pass(title, ProjectPass::new(kind, code)));
        };
        if !clues.is_shader() && !plan.is_description {
            return Err(ShaderError::NoEntry);
        }
        let draws_vertices = plan.draws.iter().any(|d| d.has_vertices);
        if told.stage == Some(Stage::Vertex) && !draws_vertices {
            return Err(ShaderError::Vertex);
        }
        let mut project = Project::of_plan(title, recognised.host, plan)?;
        if host.is_none() && !recognised.signs.is_empty() {
            project.notes.insert(0, recognised.told());
        }
        Ok(project)
    }

    /// A WebGL1 fragment shader as a project that is to be made WebGL2, under the version of the
    /// language that it will have; `None` where the text is none, or where its host completes it.
    /// Nothing is asked of it yet: [`Project::draft`] takes what comes of it.
    pub fn modernized(&self, text: &str) -> Option<Project> {
        let is_whole = self.host.is_some_and(|h| !h.declares()) && self.passes.len() == 1;
        let is_old = is_whole && guess(text).kind == Some(GuessedKind::WebGl1);
        is_old.then(|| {
            let pass = ProjectPass {
                wrapper: Wrapper::Own,
                ..ProjectPass::new(Pass::Image, format!("{VERSION}{text}"))
            };
            Project::of_pass(&self.info.name, pass)
        })
    }

    fn of_pass(title: &str, pass: ProjectPass) -> Project {
        let info = Info {
            name: title.to_string(),
            ..Info::default()
        };
        Project {
            info,
            passes: vec![pass],
            ..Project::default()
        }
    }

    fn of_plan(title: &str, host: &'static Preset, plan: Plan) -> Result<Project, ShaderError> {
        let mut notes = plan.notes;
        let mut passes = Vec::new();
        let mut draws = plan.draws.into_iter();
        for planned in plan.passes {
            let pass = own(planned, &mut notes)?;
            passes.push(ProjectPass {
                draw: draws.next().unwrap_or_default(),
                ..pass
            });
        }
        let credit = plan.credit.unwrap_or_default();
        Ok(Project {
            info: Info {
                name: title.to_string(),
                author: credit.author,
                description: credit.description,
                ..Info::default()
            },
            passes,
            host: Some(host),
            described: plan.controls.len(),
            controls: plan.controls,
            notes,
            wanted: plan.wanted,
            ..Project::default()
        })
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
        let mut controls = std::mem::take(&mut self.controls);
        for unit in &composed.units {
            let program = &composed.analysis(unit).program;
            let Some(pass) = self.passes.get_mut(unit.pass) else {
                continue;
            };
            match unit.wrapper {
                Wrapper::Player => pass.inputs = channels_used(program, unit.kind),
                Wrapper::Own => {
                    let Some(host) = self.host.or_else(page) else {
                        continue;
                    };
                    let own = (&pass.inputs[..], &controls[..]);
                    let partner = pass.draw.partner.as_deref();
                    pass.bound = bind(program, host, own, pass.output.as_ref(), partner);
                    pass.inputs = pass.bound.inputs.clone();
                    add_controls(&mut controls, &pass.bound.controls);
                }
            }
        }
        self.controls = controls;
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

    /// What is to be told of how a shader file was read, and what was made up for it.
    pub fn remarks(&self) -> Vec<String> {
        let mut told = self.notes.clone();
        let quoted = |names: Vec<&str>| format!("`{}`", names.join("`, `"));
        let names = |of: fn(&Bindings) -> &[String]| {
            let all = self.passes.iter().flat_map(|p| of(&p.bound));
            let mut names: Vec<&str> = Vec::new();
            for name in all {
                if !names.contains(&name.as_str()) {
                    names.push(name);
                }
            }
            names
        };
        let set = self
            .controls
            .iter()
            .skip(self.described)
            .map(|c| c.name.as_str())
            .collect::<Vec<_>>();
        let guessed = names(|b| &b.guessed);
        let zeros = names(|b| &b.zeros);
        for (names, what) in [
            (
                set,
                "nothing sets these uniforms, so the page has controls for them",
            ),
            (
                guessed,
                "nothing gives these varyings, so they hold the place in the picture",
            ),
            (zeros, "nothing sets these uniforms, so they are zeros"),
        ] {
            if !names.is_empty() && self.host.is_some() {
                told.push(format!("{what}: {}", quoted(names)));
            }
        }
        told
    }
}

/// What a WebGL2 shader starts with.
const VERSION: &str = "#version 300 es\n";

/// A pass that is a whole shader.
fn own(planned: PlannedPass, notes: &mut Vec<String>) -> Result<ProjectPass, ShaderError> {
    let best = dialect::best(planned.candidates).ok_or(ShaderError::TooLarge)?;
    if let Some(note) = best.note.filter(|n| !notes.contains(n)) {
        notes.push(note);
    }
    Ok(ProjectPass {
        name: planned.name,
        wrapper: Wrapper::Own,
        before: best.before,
        behind: best.behind,
        stage: best.stage,
        inputs: planned.inputs,
        output: Some(planned.output),
        ..ProjectPass::new(planned.kind, best.code)
    })
}

/// Adds the controls that are new. What a text said of one before it was repaired stays.
fn add_controls(all: &mut Vec<UniformControl>, more: &[UniformControl]) {
    for control in more {
        if !all.iter().any(|c| c.name == control.name) {
            all.push(control.clone());
        }
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
