//! Conversion of a WebGL1 shader for a page that uses WebGL2.

use crate::findings::upgrade::reason;
use crate::repair::{Repairs, error_count, fixed};
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_explain::{Upgrade, UpgradeObstacle, upgrade};
use shaderlint_project::{Composed, Project, compose};
use shaderlint_semantic::Program;
use shaderlint_text::{Edit, Role, Sources, Span, apply_edits};

/// Longest text that is quoted in the title of a repair.
const MAX_QUOTED: usize = 60;

/// A result of repairs, with its errors.
struct RepairOutcome {
    repairs: Repairs,
    errors: usize,
}

/// Repairs a WebGL1 shader and converts it to GLSL ES 3.00. A shader that compiles is never replaced by one
/// that does not: it stays in GLSL ES 1.00, with a note, if it cannot be converted. `draft` makes a project
/// of a text.
pub fn modernize(
    project: &Project,
    path: &str,
    text: &str,
    mut draft: impl FnMut(&str) -> Option<Project>,
) -> Option<Repairs> {
    let mut old = project.clone();
    let composed = old.resolve(path).ok()?;
    let (mut repairs, moves) = fixed(&mut old, &composed, path)?;
    let composed = old.resolve(path).ok()?;
    let kept = RepairOutcome {
        errors: error_count(&composed),
        repairs: Repairs::default(),
    };
    let converted = (kept.errors == 0).then(|| convert(&composed));
    if let Some(Ok((done, notes))) = converted {
        let is_same = repairs.is_empty();
        let origin = |address: u32| match is_same {
            true => address,
            false => moves.origin(address),
        };
        let notes = notes.into_iter().map(|note| Diagnostic {
            span: Span::new(origin(note.span.start), origin(note.span.end)),
            ..note
        });
        repairs.done.extend(notes);
        repairs.set_text(done);
        return Some(repairs);
    }
    let mut errors_of = |code: &str| {
        let mut project = draft(code)?;
        Some(error_count(&project.resolve(path).ok()?))
    };
    let modern = project.modernized(text).and_then(|mut modern| {
        let repairs = by_errors(&mut modern, path, text)?;
        let errors = errors_of(repairs.text()?)?;
        Some(RepairOutcome { repairs, errors })
    });
    // Where both have errors, the newer text is the one that the page needs.
    if let Some(modern) = modern.filter(|modern| modern.errors <= kept.errors) {
        return Some(modern.repairs);
    }
    repairs.left = Some(match converted {
        Some(Err(obstacle)) => {
            let why = reason(&obstacle.kind).why;
            format!("not converted to GLSL ES 3.00 because {why}")
        }
        _ => "not converted to GLSL ES 3.00, which has more errors".to_string(),
    });
    Some(repairs)
}

/// The text in GLSL ES 3.00, and what was changed.
fn convert(composed: &Composed) -> Result<(String, Vec<Diagnostic>), Box<UpgradeObstacle>> {
    let [unit] = &composed.units[..] else {
        return Err(Box::new(UpgradeObstacle::included(Span::default())));
    };
    let program = &composed.analysis(unit).program;
    let done = upgrade(program).map_err(Box::new)?;
    let first = program.tokens.tokens.first().map(|t| t.span.start);
    let code = first.and_then(|at| program.sources.code_at(at));
    let text = code.and_then(|code| {
        let text = apply_edits(code.text, code.base, &done.edits).ok()?;
        Some((text, code.base))
    });
    let Some((text, base)) = text else {
        return Err(Box::new(UpgradeObstacle::included(Span::default())));
    };
    Ok((text, notes(program, &done, base)))
}

/// An info for each different change, at the first place.
fn notes(program: &Program, done: &Upgrade, base: u32) -> Vec<Diagnostic> {
    let mut seen: Vec<(&str, &str)> = Vec::new();
    let mut notes = Vec::new();
    for edit in &done.edits {
        let old = program.sources.text(edit.span);
        if seen.contains(&(old, &edit.text)) {
            continue;
        }
        seen.push((old, &edit.text));
        let span = Span::new(edit.span.start - base, edit.span.end - base);
        let message = format!("repaired: {}", title(old, edit));
        let note = Diagnostic::of(error::LEGACY_GLSL, Severity::Info, span, message);
        let is_renamed = done.renamed.iter().any(|(name, _)| name == old);
        notes.push(match is_renamed {
            true => note.note("the code that sets it must use the new name"),
            false => note.note("this is a WebGL1 shader"),
        });
    }
    notes
}

fn title(old: &str, edit: &Edit) -> String {
    let quoted = |text: &str| {
        let mut lines = text.trim().lines();
        let line = lines.next().unwrap_or("");
        let short: String = line.chars().take(MAX_QUOTED).collect();
        match lines.next().is_some() || short.len() < line.len() {
            true => format!("`{short} ...`"),
            false => format!("`{short}`"),
        }
    };
    match (old.trim().is_empty(), edit.text.trim().is_empty()) {
        (true, _) => format!("add {}", quoted(&edit.text)),
        (false, true) => format!("remove {}", quoted(old)),
        (false, false) => format!("replace {} with {}", quoted(old), quoted(&edit.text)),
    }
}

/// Repairs a WebGL1 shader to which `#version 300 es` was added by the errors that it then has; `text` is the
/// original.
fn by_errors(draft: &mut Project, path: &str, text: &str) -> Option<Repairs> {
    let composed = compose(draft, path)?;
    let (mut repairs, _) = fixed(draft, &composed, path)?;
    let added = draft.passes.first()?.code.find('\n')? as u32 + 1;
    repairs.before = Sources::new();
    repairs.before.add(path, None, Role::User, text)?;
    for done in &mut repairs.done {
        let place = |address: u32| address.saturating_sub(added);
        done.span = Span::new(place(done.span.start), place(done.span.end));
    }
    let version = Diagnostic::of(
        error::LEGACY_GLSL,
        Severity::Info,
        Span::at(0),
        "repaired: add `#version 300 es`",
    );
    repairs
        .done
        .insert(0, version.note("this is a WebGL1 shader"));
    Some(repairs)
}
