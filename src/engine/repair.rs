//! Repairs the errors of a project that have only one possible fix, in all passes.

use shaderlint_diagnostic::{Diagnostic, Fix, Severity};
use shaderlint_lint::{Allow, Fixed, Look, fix, without_images};
use shaderlint_project::{Composed, Project, add_repairs, compose};
use shaderlint_text::{Role, SourceFile, Sources, Span};
use std::sync::Arc;

/// Separates the texts of a project that are joined to one. Sources leave one address between two
/// files, so offsets in the joined text differ from addresses only by the start of the first file.
const BETWEEN: char = '\0';

/// The repairs of a project.
#[derive(Default)]
pub struct Repairs {
    /// The original texts, which the spans of `done` refer to.
    pub before: Sources,
    /// The repairs as findings.
    pub done: Vec<Diagnostic>,
    /// The repaired texts, in the order of `before`.
    after: Vec<String>,
    /// Why the text was left as it is, although something could be repaired.
    pub left: Option<String>,
}

impl Repairs {
    /// Whether nothing was repaired.
    pub fn is_empty(&self) -> bool {
        self.done.is_empty()
    }

    /// The original texts that were changed, each with the repaired one.
    pub fn changed(&self) -> impl Iterator<Item = (&SourceFile, &str)> {
        let pairs = self.before.files().iter().zip(&self.after);
        let pairs = pairs.map(|(before, after)| (before, after.as_str()));
        pairs.filter(|(before, after)| *before.text != **after)
    }

    /// The repaired text of a project of one text.
    pub fn text(&self) -> Option<&str> {
        self.after.first().map(String::as_str)
    }

    pub(super) fn set_text(&mut self, text: String) {
        self.after = vec![text];
    }
}

/// Repairs the passes of a project. `path` is the input file. Nothing is repaired if that would leave more
/// errors than there were.
pub fn repair(project: &mut Project, composed: &Composed, path: &str) -> Option<Repairs> {
    Some(fixed(project, composed, path)?.0)
}

/// Repairs a project. Also returns how offsets in the joined text moved.
pub(super) fn fixed(
    project: &mut Project,
    composed: &Composed,
    path: &str,
) -> Option<(Repairs, Fixed)> {
    let files: Vec<&SourceFile> = users(composed).collect();
    let owners = owners(composed);
    let texts: Vec<&str> = files.iter().map(|f| &*f.text).collect();
    let joined = texts.join(&BETWEEN.to_string());
    let look = |text: &str| match text == joined {
        true => look(composed, text),
        false => look(&renewed(project, &owners, path, text)?, text),
    };
    // Code that does not compile has no image to compare.
    let fixed = fix(&joined, Allow::Safe, look, without_images);
    let mut repairs = Repairs::default();
    for file in &files {
        let (path, part) = (file.path.clone(), file.part.clone());
        repairs
            .before
            .add(path, part, Role::User, file.text.clone())?;
    }
    if !fixed.applied.is_empty() {
        let after = renewed(project, &owners, path, &fixed.text)?;
        let (old, new) = (error_count(composed), error_count(&after));
        if new > old {
            repairs.left = Some(format!(
                "not repaired: the result would have {new} errors instead of {old}"
            ));
            repairs.after = texts.into_iter().map(str::to_string).collect();
            return Some((repairs, fixed));
        }
    }
    // The first text starts at address 0: offsets in the joined text are addresses.
    repairs.done = fixed.applied.iter().cloned().map(as_note).collect();
    repairs.done.sort_by_key(|d| d.span);
    repairs.after = fixed.text.split(BETWEEN).map(str::to_string).collect();
    put(project, &owners, &fixed.text)?;
    Some((repairs, fixed))
}

/// The number of errors of all passes.
pub(super) fn error_count(composed: &Composed) -> usize {
    errors(composed).0.len()
}

/// By how many the errors decrease if the project is repaired. It is repaired for this, because the
/// fix of one error may cause another.
pub fn repairable(project: &Project, composed: &Composed, path: &str) -> usize {
    let mut candidate = project.clone();
    let done = repair(&mut candidate, composed, path).filter(|repairs| !repairs.is_empty());
    let after = done.and_then(|_| compose(&candidate, path));
    after.map_or(0, |after| {
        error_count(composed).saturating_sub(error_count(&after))
    })
}

fn users(composed: &Composed) -> impl Iterator<Item = &SourceFile> {
    composed
        .sources
        .files()
        .iter()
        .filter(|f| f.role == Role::User)
}

/// The pass of each text.
fn owners(composed: &Composed) -> Vec<usize> {
    let files = users(composed);
    files
        .filter_map(|f| composed.owner(composed.sources.file_id_at(f.base)?))
        .collect()
}

/// Splits a joined text and stores the parts in the passes.
fn put(project: &mut Project, owners: &[usize], joined: &str) -> Option<()> {
    let parts: Vec<&str> = joined.split(BETWEEN).collect();
    if parts.len() != owners.len() {
        return None;
    }
    for (part, owner) in parts.into_iter().zip(owners) {
        let pass = project.passes.get_mut(*owner)?;
        if *pass.code != *part {
            pass.code = Arc::from(part);
        }
    }
    Some(())
}

/// A copy of the project with other texts, composed again.
fn renewed(project: &Project, owners: &[usize], path: &str, joined: &str) -> Option<Composed> {
    let mut project = project.clone();
    put(&mut project, owners, joined)?;
    compose(&project, path)
}

/// The errors of a project, with positions in the joined text.
fn look(composed: &Composed, joined: &str) -> Option<Look> {
    let first = users(composed).next()?.base;
    let span = Span::new(first, first + joined.len() as u32);
    let (diagnostics, size) = errors(composed);
    Some(Look {
        diagnostics,
        span,
        checked_spans: None,
        size,
        shaders: Vec::new(),
    })
}

/// The errors of all passes with their repairs, and the number of tokens and macro calls.
fn errors(composed: &Composed) -> (Vec<Diagnostic>, usize) {
    let mut found: Vec<Diagnostic> = Vec::new();
    let mut size = 0;
    for unit in &composed.units {
        let analysis = composed.analysis(unit);
        size += analysis.program.size();
        let errors = analysis.diagnostics.iter();
        let errors = errors.filter(|d| d.severity == Severity::Error);
        let mut diagnostics: Vec<Diagnostic> = errors.cloned().collect();
        add_repairs(&analysis.program, &mut diagnostics);
        for error in diagnostics {
            let mut known = found.iter_mut();
            match known.find(|k| (k.rule, k.span) == (error.rule, error.span)) {
                Some(known) => join(known, error),
                None => found.push(error),
            }
        }
    }
    (found, size)
}

/// Merges an error that two passes report in common code: both share one repair.
fn join(known: &mut Diagnostic, other: Diagnostic) {
    let (Some(fix), Some(other)) = (&mut known.fix, other.fix) else {
        return;
    };
    let written = |fix: &Fix| fix.edits.first().map(|edit| edit.text.clone());
    if written(fix) != written(&other) {
        return;
    }
    for edit in other.edits {
        if !fix.edits.contains(&edit) {
            fix.edits.push(edit);
        }
    }
}

/// The info about an error that was repaired.
fn as_note(error: Diagnostic) -> Diagnostic {
    let how = error.fix.map_or(String::new(), |f| f.title);
    let message = format!("repaired: {how}");
    Diagnostic::new(
        error.rule,
        error.origin,
        Severity::Info,
        error.span,
        message,
    )
    .note(error.message)
}
