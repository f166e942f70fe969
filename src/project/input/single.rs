//! A shader file as a project: a ShaderToy pass, or a complete shader of any host.

use crate::dialect::{
    self, Clues, HostsAround, Plan, PlannedPass, Recognised, SiblingTexts, bind, recognise,
};
use crate::{
    Bindings, Composed, GatheredText, Info, Input, InputKind, Project, ProjectPass, UniformControl,
    Wrapper, compose,
};
use shaderlint_host::{Feed, Preset, page};
use shaderlint_semantic::{
    GuessedKind, Pass, Program, Sampler, Stage, VariableId, guess, needed_channels,
};
use shaderlint_text::TextPiece;

/// Why a shader file cannot be ported.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ShaderError {
    /// It is a vertex shader.
    Vertex,
    /// It has no entry function of ShaderToy and no `main`.
    NoEntry,
    /// It is too large to be addressed.
    TooLarge,
}

impl std::fmt::Display for ShaderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ShaderError::Vertex => "this is a vertex shader; pass the fragment shader instead",
            ShaderError::NoEntry => "no entry point: expected `mainImage` (ShaderToy) or `main`",
            ShaderError::TooLarge => "the shader is too large",
        })
    }
}

impl Project {
    /// A project of a shader file. Its channels have the types that their lookups require, and no
    /// content.
    ///
    /// # Errors
    /// If the page cannot show it.
    pub fn from_shader(title: &str, code: &str) -> Result<Project, ShaderError> {
        let mut project = Project::draft(title, code, None)?;
        project.resolve("")?;
        Ok(project)
    }

    /// A project of a shader file, with unknown channels. `host` is the host given by the user.
    ///
    /// # Errors
    /// If its text shows that the page cannot show it.
    pub fn draft(
        title: &str,
        code: &str,
        host: Option<&'static Preset>,
    ) -> Result<Project, ShaderError> {
        let nothing = SiblingTexts::new();
        Project::draft_with_siblings(title, &GatheredText::of(code), (host, &Vec::new), &nothing)
    }

    /// Like [`Project::draft`], for a text with companion files, in a program with hosts `around`.
    /// Files that have not been read yet are in [`Project::requested`].
    ///
    /// # Errors
    /// If its text shows that the page cannot show it.
    pub fn draft_with_siblings(
        title: &str,
        own: &GatheredText,
        (host, around): (Option<&'static Preset>, HostsAround),
        siblings: &SiblingTexts,
    ) -> Result<Project, ShaderError> {
        let code = &*own.text;
        let first_guess = guess(code);
        let pass = match first_guess.kind {
            Some(GuessedKind::ShaderToy(kind)) => Some(kind),
            _ => None,
        };
        let clues = Clues::with_siblings(code, title, siblings).among(around);
        let recognised = host.map(Recognised::given).or_else(|| recognise(&clues));
        let recognised = recognised.ok_or(ShaderError::NoEntry)?;
        let framed = || Some(Plan::image(vec![dialect::framed(code, "")?]));
        let Some(plan) = dialect::plan(recognised.host, &clues).or_else(framed) else {
            let kind = pass.ok_or(ShaderError::NoEntry)?;
            let pass = ProjectPass {
                pieces: own.pieces.clone(),
                ..ProjectPass::new(kind, code)
            };
            return Ok(Project::of_pass(title, pass));
        };
        let is_known = host.is_some() || !recognised.signs.is_empty();
        let mut entries = recognised.host.entries.iter();
        let is_called = clues.is_body || entries.any(|entry| clues.declares(entry));
        let is_body = is_called && is_known;
        if !clues.is_shader() && !is_body && !plan.is_description {
            return Err(ShaderError::NoEntry);
        }
        let draws_vertices = plan.draws.iter().any(|d| d.has_vertices);
        let is_vertex = first_guess.stage == Some(Stage::Vertex) && !plan.is_description;
        if is_vertex && !draws_vertices {
            return Err(ShaderError::Vertex);
        }
        let mut project = Project::of_plan(title, recognised.host, plan, &own.pieces)?;
        if host.is_none() && !recognised.signs.is_empty() {
            project.notes.insert(0, recognised.summary());
            project.recognised = Some(recognised);
        }
        Ok(project)
    }

    /// A WebGL1 fragment shader as a project to be converted to WebGL2, with the new `#version`;
    /// `None` for other shaders, or if the host completes them. The result is the input of
    /// [`Project::draft`].
    pub fn modernized(&self, text: &str) -> Option<Project> {
        let is_complete = self.host.is_some_and(|h| !h.declares()) && self.passes.len() == 1;
        let is_old = is_complete && guess(text).kind == Some(GuessedKind::WebGl1);
        is_old.then(|| {
            let pieces = self
                .passes
                .iter()
                .flat_map(|pass| pass.pieces.iter().cloned());
            let pass = ProjectPass {
                wrapper: Wrapper::Own,
                pieces: pieces
                    .map(|piece| TextPiece {
                        start: piece.start + 1,
                        ..piece
                    })
                    .collect(),
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

    fn of_plan(
        title: &str,
        host: &'static Preset,
        plan: Plan,
        own_pieces: &[TextPiece],
    ) -> Result<Project, ShaderError> {
        let mut notes = plan.notes;
        let mut passes = Vec::new();
        let mut draws = plan.draws.into_iter();
        for mut planned in plan.passes {
            if planned.is_of_text {
                planned.pieces = own_pieces.to_vec();
            }
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
            requested: plan.requested,
            ..Project::default()
        })
    }

    /// Composes the passes and gives the channels of shader files the types that their lookups
    /// require. Channels of an export keep their types. `path` is the input file given by the user.
    ///
    /// # Errors
    /// If the page cannot show the result.
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
                Wrapper::Player => {
                    let used = channels_used(program, unit.kind);
                    pass.inputs = used.into_iter().map(|i| given(&pass.inputs, i)).collect();
                }
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

    /// Returns the composed passes, composed again if the project has changed.
    ///
    /// # Errors
    /// If they are too large to be addressed.
    pub fn renew(&self, composed: Composed, path: &str) -> Result<Composed, ShaderError> {
        match composed.is_of(self) {
            true => Ok(composed),
            false => compose(self, path).ok_or(ShaderError::TooLarge),
        }
    }

    /// Notes about how a shader file was interpreted and which values are assumed.
    pub fn remarks(&self) -> Vec<String> {
        let mut notes = self.notes.clone();
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
        let all = self.passes.iter().flat_map(|p| &p.bound.uniforms);
        let mut heard: Vec<&str> = all
            .filter(|u| matches!(u.source, Feed::Volume | Feed::VolumeBytes | Feed::Spectrum))
            .map(|u| u.name.as_str())
            .collect();
        heard.sort_unstable();
        heard.dedup();
        for (names, what) in [
            (
                heard,
                "loudness of sound that the page does not have, set by a made-up beat",
            ),
            (set, "unknown uniforms, set by controls on the page"),
            (
                guessed,
                "unknown varyings, set to the position in the image",
            ),
            (zeros, "unknown uniforms, set to zero"),
        ] {
            if !names.is_empty() && self.host.is_some() {
                notes.push(format!("{what}: {}", quoted(names)));
            }
        }
        notes
    }
}

/// The first line of a WebGL2 shader.
const VERSION: &str = "#version 300 es\n";

/// A pass that is a complete shader.
fn own(planned: PlannedPass, notes: &mut Vec<String>) -> Result<ProjectPass, ShaderError> {
    let best = dialect::best(planned.candidates).ok_or(ShaderError::TooLarge)?;
    notes.extend(best.note.clone().filter(|n| !notes.contains(n)));
    let given = planned.inputs.into_iter().map(|input| Input {
        is_given: true,
        ..input
    });
    Ok(ProjectPass {
        name: planned.name,
        inputs: given.collect(),
        output: Some(planned.output),
        pieces: planned.pieces,
        ..ProjectPass::completed(planned.kind, best)
    })
}

/// Adds controls with new names. A control found before a repair is kept.
fn add_controls(all: &mut Vec<UniformControl>, more: &[UniformControl]) {
    for control in more {
        if !all.iter().any(|c| c.name == control.name) {
            all.push(control.clone());
        }
    }
}
/// The channels that the code reads, as inputs of the types that its lookups require.
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

/// The buffer that was connected to the channel of an input, or else the input.
fn given(inputs: &[Input], input: Input) -> Input {
    let is_given = |i: &&Input| i.channel == input.channel && i.kind == InputKind::Buffer;
    inputs.iter().find(is_given).cloned().unwrap_or(input)
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
