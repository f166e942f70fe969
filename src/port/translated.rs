//! Translation with naga: of the passes of a project, and of complete shaders of both stages,
//! whatever their uniforms mean.

use super::naga::{LowerOptions, Refused, TranslatedShader, lower, translate, write};
use super::order::Order;
use super::output::{Build, BuildError, File, NamedPass, Remark, file, named};
use super::{Composed, Project};
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_explain::{Checked, analyze};
use shaderlint_semantic::{GuessedKind, Stage, Unit, guess};
use shaderlint_text::{Role, Sources};
use std::path::Path;
use std::sync::Arc;

/// Translates each pass; passes that cannot be translated become remarks.
pub(super) fn translated(
    order: Order,
    project: &Project,
    composed: &Composed,
) -> Result<Build, BuildError> {
    let Some(language) = order.target.language() else {
        return Ok(Build::default());
    };
    let mut made = Vec::new();
    for unit in &composed.units {
        if let Some(pass) = project.passes.get(unit.pass) {
            made.push(ShaderOutcome {
                title: pass.title(unit.pass),
                slug: pass.slug().to_string(),
                outcome: translate(project, composed, unit, language, order.first_row),
            });
        }
    }
    files(order, made)
}

/// A complete shader, with its own uniforms and `main`.
pub struct CompleteShader {
    /// The path given by the user.
    pub path: String,
    /// The shader stage.
    pub stage: Stage,
    /// The result of the check.
    pub checked: Checked,
}

/// The complete shaders of one run.
pub struct CompleteShaders {
    /// Their texts.
    pub sources: Arc<Sources>,
    /// One for each input file.
    pub shaders: Vec<CompleteShader>,
}

/// Checks shaders, given with path and stage. Returns `None` unless all are complete: they have a
/// `#version`, or compile as WebGL1.
pub fn complete_shaders(files: Vec<(String, String, Option<Stage>)>) -> Option<CompleteShaders> {
    let mut sources = Sources::new();
    let mut added = Vec::new();
    for (path, code, stage) in files {
        let guessed = guess(&code);
        let kind = guessed.kind?;
        let stage = stage.or(guessed.stage).unwrap_or(Stage::Fragment);
        let file = sources.add(path.clone(), None, Role::User, code)?;
        added.push((path, kind, stage, file));
    }
    let sources = Arc::new(sources);
    let mut shaders = Vec::new();
    for (path, kind, stage, file) in added {
        let checked = analyze(&Unit::complete(&sources, &[file], stage));
        let is_complete = match kind {
            GuessedKind::Versioned => true,
            // A shader fragment for a host can look like this too.
            GuessedKind::WebGl1 => !is_wrong(&checked),
            _ => false,
        };
        if !is_complete {
            return None;
        }
        shaders.push(CompleteShader {
            path,
            stage,
            checked,
        });
    }
    Some(CompleteShaders { sources, shaders })
}

fn is_wrong(checked: &Checked) -> bool {
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    checked.diagnostics.iter().any(is_error)
}

/// Translates complete shaders. The varyings of a vertex and a fragment shader in the same run get
/// the same locations.
///
/// # Errors
/// If several shaders are to be written to one file.
pub fn translate_shaders(order: Order, all: &CompleteShaders) -> Result<Build, BuildError> {
    let Some(language) = order.target.language() else {
        return Ok(Build::default());
    };
    let mut vertices = all.shaders.iter().filter(|s| s.stage == Stage::Vertex);
    let vertex = match (vertices.next(), vertices.next()) {
        (Some(only), None) => Some(&only.checked.program),
        _ => None,
    };
    let mut made = Vec::new();
    for shader in &all.shaders {
        let options = LowerOptions {
            language,
            first_row: order.first_row,
            vertex,
        };
        let outcome = match is_wrong(&shader.checked) {
            true => Ok(None),
            false => lower(&shader.checked.program, options).and_then(|lowered| {
                let text = write(&lowered, &[])?;
                let interface = lowered.interface;
                Ok(Some(TranslatedShader { text, interface }))
            }),
        };
        let name = Path::new(&shader.path).file_name();
        made.push(ShaderOutcome {
            title: shader.path.clone(),
            slug: name.map_or(String::new(), |n| n.to_string_lossy().into_owned()),
            outcome,
        });
    }
    files(order, made)
}

/// The result for one shader.
struct ShaderOutcome {
    title: String,
    slug: String,
    outcome: Result<Option<TranslatedShader>, Refused>,
}

/// The files of all shaders; none if one cannot be translated.
fn files(order: Order, all: Vec<ShaderOutcome>) -> Result<Build, BuildError> {
    let extension = order.target.language().map_or("", |l| l.extension());
    let mut remarks = Vec::new();
    let mut passes = Vec::new();
    let mut interfaces = Vec::new();
    for made in all {
        match made.outcome {
            Ok(Some(done)) => {
                passes.push(NamedPass {
                    name: made.title,
                    slug: made.slug,
                    extension,
                    content: done.text,
                });
                interfaces.push(done.interface);
            }
            // Compile errors are reported separately.
            Ok(None) => {}
            Err(refused) => remarks.push(Remark::refused(made.title, &refused)),
        }
    }
    if !remarks.is_empty() {
        let files = Vec::new();
        return Ok(Build { files, remarks });
    }
    let mut files = named(order, passes)?;
    if order.interface {
        let guessed = files.iter().zip(&interfaces).map(|(shader, interface)| {
            let mut path = shader.path.clone().into_os_string();
            path.push(".json");
            let text = serde_json::to_string_pretty(interface).unwrap_or_default();
            file(Path::new(&path), text + "\n")
        });
        let guessed: Vec<File> = guessed.collect();
        files.extend(guessed);
    }
    Ok(Build { files, remarks })
}
