//! From the arguments to what is drawn: the text, its errors, and what its uniforms are set to.

use super::args::RunArgs;
use super::{show, uniforms};
use crate::cli::disk::Disk;
use crate::cli::port;
use crate::diagnostic::Severity;
use crate::engine::play::{Scene, Unfit};
use crate::engine::{Options, check};
use crate::exec::{CompileOptions, Refusal};
use crate::ir::{Module, Provenance, lower};
use crate::port::{Composed, PassUnit, Project, Wrapper};
use crate::report::{Format, Reporter};
use crate::semantic::{Pass, Program, Stage};
use crate::text::{Sources, Span};
use std::io;
use std::path::{Path, PathBuf};

/// Why there is nothing to draw.
#[derive(Debug)]
pub enum Trouble {
    /// The shader has errors, which were told.
    Errors,
    /// Something else, in words.
    Words(String),
}

impl From<String> for Trouble {
    fn from(words: String) -> Trouble {
        Trouble::Words(words)
    }
}

impl From<io::Error> for Trouble {
    fn from(error: io::Error) -> Trouble {
        Trouble::Words(error.to_string())
    }
}

/// A shader that was read and has no errors.
pub struct Loaded {
    /// How it is called.
    pub name: String,
    /// Its passes.
    pub project: Project,
    /// They, put together.
    pub composed: Composed,
    /// The files that it is made of, which nothing is written over.
    pub read: Vec<PathBuf>,
}

/// A pass that is ready to be drawn.
pub struct Shot {
    /// It, with what it is given.
    pub scene: Scene,
    /// Its middle form.
    pub module: Module,
    /// The index of its unit.
    unit: usize,
}

impl Loaded {
    /// What the pass of a shot means.
    pub fn program(&self, shot: &Shot) -> Option<&Program> {
        let unit = self.composed.units.get(shot.unit)?;
        Some(&self.composed.analysis(unit).program)
    }
}

/// Reads a shader. Its errors are told as the linter tells them.
pub fn load(path: &Path, args: &RunArgs, format: Format) -> Result<Loaded, Trouble> {
    let name = port::shown(path);
    let drafted = port::draft(path, args.from.as_deref());
    let resolved = drafted.and_then(|(mut project, read)| {
        let composed = project.resolve(&name);
        let composed = composed.map_err(|e| format!("{name}: {e}"))?;
        Ok((project, read, composed))
    });
    match resolved {
        Ok((project, read, composed)) if !composed.has_errors() => Ok(Loaded {
            name,
            project,
            composed,
            read,
        }),
        Ok((_, _, composed)) => {
            if !tell_errors(path, &name, args, format)? {
                tell_composed(&composed, args, format)?;
            }
            Err(Trouble::Errors)
        }
        Err(words) => match path.is_file() && tell_errors(path, &name, args, format)? {
            true => Err(Trouble::Errors),
            false => Err(Trouble::Words(words)),
        },
    }
}

/// Prints what the linter calls errors; says whether there are any.
fn tell_errors(path: &Path, name: &str, args: &RunArgs, format: Format) -> Result<bool, Trouble> {
    if path.as_os_str() == "-" {
        return Ok(false);
    }
    let text = port::read_text(path)?;
    let mut report = check(name, &text, &Options::default(), &Disk::new());
    report.diagnostics.retain(|d| d.severity == Severity::Error);
    if !report.diagnostics.is_empty() {
        let mut reporter = Reporter::new(format, io::stdout().lock(), args.color.is_on());
        reporter.file(name, &report.sources, &report.diagnostics)?;
        reporter.finish()?;
    }
    Ok(!report.diagnostics.is_empty())
}

/// Prints the errors of what goes around a shader and of itself together.
fn tell_composed(composed: &Composed, args: &RunArgs, format: Format) -> Result<(), Trouble> {
    let all = composed.units.iter().map(|unit| composed.analysis(unit));
    let found = all.flat_map(|checked| &checked.diagnostics);
    let mut errors: Vec<_> = found
        .filter(|d| d.severity == Severity::Error)
        .cloned()
        .collect();
    errors.dedup();
    let mut reporter = Reporter::new(format, io::stdout().lock(), args.color.is_on());
    reporter.file("", &composed.sources, &errors)?;
    reporter.finish()?;
    Ok(())
}

/// Makes the pass ready that is to be shown.
pub fn shot(loaded: &Loaded, args: &RunArgs, options: &CompileOptions) -> Result<Shot, Trouble> {
    let Loaded { name, composed, .. } = loaded;
    let (at, unit) = chosen(loaded, args.pass.as_deref())?;
    let program = &composed.analysis(unit).program;
    let pass = loaded.project.passes.get(unit.pass);
    if unit.stage != Stage::Fragment || pass.is_some_and(|p| p.draw.has_vertices) {
        let words = format!("{name}: it draws with a vertex shader; only fragment shaders are run");
        return Err(Trouble::Words(words));
    }
    let module = lower(program);
    let probe = match &args.show {
        Some(show) => Some(show::probe(show, composed, unit, program, &module)?),
        None => None,
    };
    let options = &CompileOptions { probe, ..*options };
    let scene = match (unit.wrapper, pass) {
        (Wrapper::Own, Some(pass)) => Scene::bound(program, &module, pass.bound.clone(), options),
        _ => Scene::of(program, &module, options),
    };
    let mut scene = scene.map_err(|refusal| refused(&composed.sources, program, name, &refusal))?;
    let project = &loaded.project;
    let described = project.controls.iter().take(project.described);
    scene.set_controls(described.cloned().collect::<Vec<_>>().as_slice());
    if let Some(path) = &args.uniforms {
        set_uniforms(&mut scene, path)?;
    }
    Ok(Shot {
        scene,
        module,
        unit: at,
    })
}

/// The pass that is to be shown: the one asked for, else the picture.
fn chosen<'a>(loaded: &'a Loaded, asked: Option<&str>) -> Result<(usize, &'a PassUnit), Trouble> {
    let passes = &loaded.project.passes;
    let slug = |unit: &PassUnit| passes.get(unit.pass).map_or("", |p| p.slug());
    let mut units = loaded.composed.units.iter().enumerate();
    let found = match asked {
        Some(asked) => units.find(|(_, unit)| slug(unit) == asked),
        None => units.find(|(_, unit)| unit.kind == Pass::Image),
    };
    found.ok_or_else(|| {
        let all: Vec<&str> = loaded.composed.units.iter().map(slug).collect();
        let wanted = asked.unwrap_or("image");
        let name = &loaded.name;
        let words = format!(
            "{name}: there is no pass `{wanted}`; there is {}",
            all.join(", ")
        );
        Trouble::Words(words)
    })
}

/// Sets what the user's JSON says.
fn set_uniforms(scene: &mut Scene, path: &Path) -> Result<(), Trouble> {
    let text = port::read_text(path)?;
    let shown = port::shown(path);
    let wrong = |(line, column): (usize, usize), message: String| {
        Trouble::Words(format!("{shown}:{line}:{column}: {message}"))
    };
    let assigned = uniforms::read(&text).map_err(|bad| wrong(bad.at, bad.message))?;
    for given in assigned {
        let unfit = match scene.set(&given.name, &given.scalars) {
            Ok(()) => continue,
            Err(unfit) => unfit,
        };
        let name = &given.name;
        let said = match unfit {
            Unfit::Unknown => {
                let near = crate::cli::run::near(name, scene.declared());
                format!("the shader has no uniform `{name}`{near}")
            }
            Unfit::Sampler => format!("`{name}` is a sampler, which a number is not put onto"),
            Unfit::Count { takes, .. } => {
                let (count, noun) = (
                    given.scalars.len(),
                    if takes == 1 { "number" } else { "numbers" },
                );
                format!("`{name}` takes {takes} {noun}, and this is {count}")
            }
        };
        return Err(wrong(given.at, said));
    }
    Ok(())
}

/// What is said of a shader that cannot be run.
fn refused(sources: &Sources, program: &Program, name: &str, refusal: &Refusal) -> Trouble {
    let at = span(program, refusal.at).and_then(|span| position(sources, span));
    let at = at.unwrap_or_else(|| name.to_string());
    Trouble::Words(format!("{at}: {} cannot be run", refusal.what))
}

/// Where something comes from.
pub fn span(program: &Program, from: Provenance) -> Option<Span> {
    match from {
        Provenance::Expr(id) => Some(program.expr_span(id)),
        Provenance::Declaration(token) => program.token(token).map(|t| t.span),
        Provenance::Stmt(id) => Some(program.span(program.tree.stmt(id).extent)),
        Provenance::Language => None,
    }
}

/// A place as `file:line:column`.
pub fn position(sources: &Sources, span: Span) -> Option<String> {
    let file = sources.file_at(span.start)?;
    let at = file.position(span.start);
    Some(format!("{}:{}:{}", file.path, at.line, at.column))
}
