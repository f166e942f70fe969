//! The shader of a pass, with inputs that do not depend on its channels.

use super::PlaybackProblem;
use shaderlint_engine::inputs::{Moment, Scene, Unfit, player_draw};
use shaderlint_exec::{Bytecode, CompileOptions, Draw, compile};
use shaderlint_host::Feed;
use shaderlint_ir::lower;
use shaderlint_project::{Bindings, Composed, PassUnit, Project, ProjectPass, SizeTerm, Wrapper};
use shaderlint_semantic::Stage;

/// The shader of a pass.
pub(super) enum PassShader {
    /// The player declares its uniforms.
    Player(Box<Bytecode>),
    /// The shader declares its uniforms.
    Own(Box<Scene>),
}

impl PassShader {
    /// Compiles a pass.
    pub fn of(
        project: &Project,
        composed: &Composed,
        unit: &PassUnit,
        options: &CompileOptions,
    ) -> Result<PassShader, PlaybackProblem> {
        let found = project.passes.get(unit.pass);
        let title = || found.map_or(String::new(), |pass| pass.title(unit.pass));
        if unit.stage == Stage::Vertex {
            return Err(PlaybackProblem::Vertices { pass: title() });
        }
        let checked = composed.analysis(unit);
        if checked.has_errors() {
            return Err(PlaybackProblem::Errors { pass: title() });
        }
        let program = &checked.program;
        let module = lower(program);
        let shader = match unit.wrapper {
            Wrapper::Player => {
                compile(program, &module, options).map(|code| PassShader::Player(Box::new(code)))
            }
            Wrapper::Own => {
                let bound = found.map_or(Bindings::default(), |pass| pass.bound.clone());
                Scene::bound(program, &module, bound, options).map(|mut scene| {
                    scene.set_controls(&project.controls);
                    PassShader::Own(Box::new(scene))
                })
            }
        };
        shader.map_err(|refusal| PlaybackProblem::Refused {
            pass: title(),
            refusal,
        })
    }

    pub fn code(&self) -> &Bytecode {
        match self {
            PassShader::Player(code) => code,
            PassShader::Own(scene) => &scene.code,
        }
    }

    /// Sets a uniform that the shader declares.
    pub fn set(&mut self, name: &str, scalars: &[f64]) -> Result<(), Unfit> {
        match self {
            PassShader::Own(scene) => scene.set(name, scalars),
            PassShader::Player(_) => Err(Unfit::Unknown),
        }
    }

    /// A draw of a frame, with everything set except the channels.
    pub fn draw(&self, size: [u32; 2], moment: &Moment) -> Draw<'_> {
        match self {
            PassShader::Own(scene) => scene.draw(size, moment),
            PassShader::Player(code) => player_draw(code, size, moment),
        }
    }

    /// The uniforms that contain the texture size of a sampler.
    pub fn sizes_of<'s>(&'s self, sampler: &'s str) -> impl Iterator<Item = &'s str> {
        let uniforms = match self {
            PassShader::Player(_) => &[][..],
            PassShader::Own(scene) => &scene.given.bound.uniforms,
        };
        let names = uniforms
            .iter()
            .filter(move |u| u.source == Feed::TextureSize && u.of.as_deref() == Some(sampler));
        names.map(|u| u.name.as_str())
    }
}

/// Maximum side in pixels of a render target with its own size.
const MAX_SIDE: f64 = 8192.0;

/// The size of the render target of a pass.
pub(super) fn size_of(project: &Project, pass: &ProjectPass, canvas: [u32; 2]) -> [u32; 2] {
    let Some(terms) = &pass.draw.size else {
        return canvas;
    };
    let pixels = |term| {
        let size = value(term, project, canvas).floor();
        // NaN becomes 0, and then one pixel.
        (size.min(MAX_SIDE) as u32).max(1)
    };
    let [width, height] = terms;
    [pixels(width), pixels(height)]
}

fn value(term: &SizeTerm, project: &Project, canvas: [u32; 2]) -> f64 {
    match term {
        SizeTerm::Number(number) => *number,
        SizeTerm::Name(name) => match name.as_str() {
            "$WIDTH" => f64::from(canvas[0]),
            "$HEIGHT" => f64::from(canvas[1]),
            name => {
                let control = project.controls.iter().find(|c| c.name == name);
                let first = control.and_then(|c| c.value.first());
                first.copied().unwrap_or(0.0)
            }
        },
        SizeTerm::Call(name, terms) => {
            let terms = terms.iter().map(|term| value(term, project, canvas));
            call(name, &terms.collect::<Vec<_>>())
        }
    }
}

fn call(name: &str, terms: &[f64]) -> f64 {
    let first = terms.first().copied().unwrap_or(0.0);
    let second = terms.get(1).copied().unwrap_or(0.0);
    match name {
        "add" => first + second,
        "subtract" => first - second,
        "multiply" => first * second,
        "divide" => first / second,
        "modulo" => first % second,
        "floor" => first.floor(),
        "ceil" => first.ceil(),
        "round" => (first + 0.5).floor(),
        "trunc" => first.trunc(),
        "abs" => first.abs(),
        "sqrt" => first.sqrt(),
        "exp" => first.exp(),
        "log" => first.ln(),
        "log2" => first.log2(),
        "sin" => first.sin(),
        "cos" => first.cos(),
        "pow" => first.powf(second),
        "min" => terms.iter().copied().fold(f64::INFINITY, f64::min),
        _ => terms.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    }
}
