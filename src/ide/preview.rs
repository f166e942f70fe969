//! One shader of a document as a project that can be played.

use super::document::Document;
use shaderlint_detect::kind::file_extension;
use shaderlint_engine::Analysis;
use shaderlint_project::{GatheredText, Project, ShaderError, SiblingTexts, imported_hosts};
use shaderlint_semantic::Stage;
use shaderlint_text::Role;

/// The shader that a preview of a document shows: the one at an offset, or the first that can be
/// played.
pub fn previewed(document: &Document, offset: Option<u32>) -> Option<usize> {
    let here = offset.and_then(|offset| document.spot(offset));
    let can = |shader: &usize| preview_project(document, *shader).is_ok();
    let here = here.map(|spot| spot.shader).filter(can);
    here.or_else(|| (0..document.report.analyses.len()).find(can))
}

/// The project of a shader of a document, with what it includes.
///
/// # Errors
/// If it cannot be played.
pub fn preview_project(document: &Document, shader: usize) -> Result<Project, ShaderError> {
    let analysis = document.report.analyses.get(shader);
    let analysis = analysis.ok_or(ShaderError::NoEntry)?;
    if analysis.program.stage == Stage::Vertex {
        return Err(ShaderError::Vertex);
    }
    let name = document.path.rsplit('/').next().unwrap_or("shader");
    let title = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let host = document.options.host.preset;
    let own = GatheredText::of(&*text(document, analysis));
    let is_part = document.report.holds_shaders();
    let own = match first_line(analysis).filter(|_| is_part) {
        Some(line) => own.from_line(line),
        None => own,
    };
    let around = || match is_part {
        true => imported_hosts(&document.text),
        false => Vec::new(),
    };
    Project::draft_with_siblings(title, &own, (host, &around), &SiblingTexts::new())
}

/// The line of a document in which the code of its shader starts.
fn first_line(analysis: &Analysis) -> Option<u32> {
    let sources = analysis.sources();
    let codes = analysis.files().iter().filter_map(|id| sources.code(*id));
    let base = codes.into_iter().find(|code| code.role == Role::User)?.base;
    Some(sources.file_at(base)?.position(base).line)
}

/// The text of a shader: the document's own, if it is all of it.
fn text(document: &Document, analysis: &Analysis) -> String {
    let is_own = |path: &str| path == document.path;
    let files = document.report.sources.files().iter();
    let mut user = files.filter(|file| document.report.sources.is_user(file.base));
    let is_whole = user.all(|file| is_own(&file.path) && file.part.is_none());
    let is_alone = document.report.analyses.len() == 1 && !document.report.holds_shaders();
    match is_whole && is_alone && file_extension(&document.path) != "json" {
        true => document.text.to_string(),
        false => analysis.user_code(),
    }
}
