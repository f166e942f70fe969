//! Conversion of complete GLSL ES 1.00 shaders to GLSL ES 3.00.
//!
//! The conversion replaces words: a word means the same in active code, in code that `#if` excludes, and
//! in macros, so all of them are converted alike. The result is checked before it is offered.

mod edits;
mod obstacle;
mod output;
mod scan;
mod words;

use super::analyze::analyze;
use edits::original;
pub use obstacle::{ObstacleKind, UpgradeObstacle};
use scan::RawScan;
use shaderlint_diagnostic::Severity;
use shaderlint_semantic::{Program, Unit};
use shaderlint_text::{CompiledText, Edit, Role, Sources, Span, apply_edits};
use std::sync::Arc;
use words::WordMap;

/// The edits that convert a shader to GLSL ES 3.00.
#[derive(Clone, Debug)]
pub struct Upgrade {
    /// The edits, in the order of the text.
    pub edits: Vec<Edit>,
    /// The uniforms, attributes, varyings and members of uniforms that get other names, and these.
    pub renamed: Vec<(String, String)>,
}

/// Converts a complete shader in GLSL ES 1.00.
///
/// # Errors
/// If some of it cannot be converted, or the result has an error.
pub fn upgrade(program: &Program) -> Result<Upgrade, UpgradeObstacle> {
    let code = own_code(program)?;
    let scan = RawScan::of(&code);
    let mut edits = Vec::new();
    edits::directives(program, &scan, &mut edits)?;
    let mut map = WordMap::of(program, &scan)?;
    edits.extend(output::declare(program, &scan, &mut map)?);
    edits::initial_values(program, &mut edits)?;
    edits::invariant_inputs(program, &scan, &mut edits);
    edits::words(&scan, &map, &mut edits);
    edits::version(program, &code, &mut edits);
    edits.sort_by_key(|e| e.span);
    check(program, &code, &edits)?;
    let renamed = map.renamed_interface();
    Ok(Upgrade { edits, renamed })
}

/// The text of the shader, if all of it is in one place.
fn own_code(program: &Program) -> Result<CompiledText<'_>, UpgradeObstacle> {
    let tokens = &program.tokens.tokens;
    let first = tokens.first().map_or(Span::default(), |t| t.span);
    let included = |span| UpgradeObstacle::at(span, ObstacleKind::Included);
    let code = program.sources.code_at(first.start);
    let code = code.filter(|c| c.role == Role::User);
    let code = code.ok_or(included(first))?;
    let extent = code.base..=code.base + code.text.len() as u32;
    let outside = tokens.iter().find(|t| !extent.contains(&t.span.start));
    match outside {
        Some(token) => Err(included(token.span)),
        None => Ok(code),
    }
}

/// Checks the converted shader.
fn check(program: &Program, code: &CompiledText, edits: &[Edit]) -> Result<(), UpgradeObstacle> {
    let first = Span::at(code.base);
    let included = || UpgradeObstacle::at(first, ObstacleKind::Included);
    let text = apply_edits(code.text, code.base, edits).map_err(|_| included())?;
    let mut sources = Sources::new();
    let file = sources.add("", None, Role::User, text).ok_or(included())?;
    let start = sources.file(file).map_or(0, |f| f.base);
    let sources = Arc::new(sources);
    let checked = analyze(&Unit::complete(&sources, &[file], program.stage));
    let mut found = checked.diagnostics.into_iter();
    let Some(error) = found.find(|d| d.severity == Severity::Error) else {
        return Ok(());
    };
    let place = |at: u32| code.base + original(edits, code.base, at.saturating_sub(start));
    let span = Span::new(place(error.span.start), place(error.span.end));
    Err(UpgradeObstacle::at(
        span,
        ObstacleKind::Error(Box::new(error)),
    ))
}

#[cfg(test)]
mod tests;
