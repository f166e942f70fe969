//! A shader as a page that plays it.

use super::buffers::TextBuffer;
use super::snapshot::{Answer, Failure, Snapshot};
use gen_lsp_types::Position;
use serde::{Deserialize, Serialize};
use shaderlint_diagnostic::Severity;
use shaderlint_engine::Files;
use shaderlint_host::shadertoy;
use shaderlint_ide as ide;
use shaderlint_port::{Composed, PassFile, PassRole, Project, add_stand_ins, html};
use shaderlint_semantic::Pass;
use std::path::Path;

/// Which shader of a document is shown.
#[derive(Clone, Copy, Default, Deserialize)]
pub struct ShownShader {
    /// A position in it.
    pub position: Option<Position>,
    /// Its number, which an earlier page had.
    pub shader: Option<usize>,
}

/// A page that plays a shader.
#[derive(Serialize)]
pub struct ShaderPage {
    /// The page.
    pub html: String,
    /// Number of the shader in its document.
    pub shader: usize,
}

/// The page of a shader of a document, with the passes in the same folder.
pub fn page(snapshot: &Snapshot, buffer: &TextBuffer, shown: ShownShader) -> Answer<ShaderPage> {
    let document = snapshot.document(buffer);
    let offset = shown.position.map(|at| snapshot.offset(buffer, at));
    let shader = shown.shader.or_else(|| ide::previewed(&document, offset));
    let shader = shader.unwrap_or(0);
    let mut project = project(snapshot, buffer, shader)?;
    let wrong = |error: shaderlint_port::ShaderError| Failure::refused(error.to_string());
    let composed = project.resolve(&buffer.path).map_err(wrong)?;
    let draws = |kind: Pass| matches!(kind, Pass::Image | Pass::Cubemap | Pass::Sound);
    if !project.passes.iter().any(|pass| draws(pass.kind)) {
        return Err(Failure::refused(
            "the document contains no shader that can be drawn",
        ));
    }
    // The view keeps the last valid image.
    if let Some(error) = first_error(&composed) {
        return Err(Failure::refused(error));
    }
    add_stand_ins(&mut project);
    let composed = project.renew(composed, &buffer.path).map_err(wrong)?;
    Ok(ShaderPage {
        html: html(&project, &composed, None).whole(),
        shader,
    })
}

/// The first error in the passes of a project, with its line.
fn first_error(composed: &Composed) -> Option<String> {
    let analyses = composed.units.iter().map(|unit| composed.analysis(unit));
    let mut all = analyses.flat_map(|analysis| &analysis.diagnostics);
    let error = all.find(|d| d.severity == Severity::Error)?;
    let file = composed.sources.file_at(error.span.start)?;
    let line = file.position(error.span.start).line;
    let part = file
        .part
        .as_ref()
        .map_or(String::new(), |part| format!("{part}, "));
    Some(format!("{part}line {line}: {}", error.message))
}

fn project(snapshot: &Snapshot, buffer: &TextBuffer, shader: usize) -> Answer<Project> {
    let name = buffer.path.rsplit('/').next().unwrap_or("shader");
    if name.ends_with(".json") {
        return Project::from_json(&buffer.text).map_err(|e| Failure::refused(e.to_string()));
    }
    let parts = parts(snapshot, buffer);
    let has_image = parts.iter().any(|part| part.role == PassRole::Image);
    if parts.len() > 1 && has_image {
        let title = Path::new(&buffer.path).parent().and_then(|p| p.file_name());
        let title = title.map_or("shader".into(), |t| t.to_string_lossy());
        return Project::from_parts(&title, parts).map_err(|e| Failure::refused(e.to_string()));
    }
    let project = ide::preview_project(&snapshot.document(buffer), shader);
    project.map_err(|e| Failure::refused(e.to_string()))
}

/// The passes in the folder of a document that is named like a pass.
fn parts(snapshot: &Snapshot, buffer: &TextBuffer) -> Vec<PassFile> {
    let own = Path::new(&buffer.path);
    let (Some(folder), Some(name)) = (own.parent(), own.file_name()) else {
        return Vec::new();
    };
    if role_of(&name.to_string_lossy()).is_none() {
        return Vec::new();
    }
    let mut names = snapshot.files.names(folder);
    names.sort_unstable();
    let part = names.into_iter().filter_map(|name| {
        let role = role_of(&name)?;
        let code = snapshot.files.load(&folder.join(&name)).ok()?;
        Some(PassFile {
            role,
            file: name,
            code,
        })
    });
    part.collect()
}

/// The role of a file according to its name.
fn role_of(name: &str) -> Option<PassRole> {
    let (stem, extension) = name.rsplit_once('.')?;
    let is_shader = shadertoy().is_some_and(|host| host.has_extension(extension));
    PassRole::of_name(stem).filter(|_| is_shader)
}
