//! Code actions for findings.

use super::document::Document;
use shaderlint_diagnostic::{Applicability, Diagnostic, Origin};
use shaderlint_engine::fix_text;
use shaderlint_lint::Allow;
use shaderlint_project::Files;
use shaderlint_text::{Edit, LineIndex, Span};

/// A code action.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Action {
    /// Title as an imperative sentence.
    pub title: String,
    /// Kind of action.
    pub kind: ActionKind,
    /// Index of the finding in the document.
    pub finding: usize,
    /// Edits of the document.
    pub edits: Vec<Edit>,
}

/// Kinds of code actions.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ActionKind {
    /// Applies a safe fix.
    Fix,
    /// Applies an unsafe fix, which may change the image.
    UnsafeFix,
    /// Inserts a suppression comment.
    Suppress,
    /// Shows the documentation of the rule.
    Explain,
}

/// The actions for findings that touch a span.
pub fn actions(document: &Document, files: &dyn Files, within: Span) -> Vec<Action> {
    let report = &document.report;
    let touches = |d: &Diagnostic| report.in_input(d.span).is_some_and(|s| s.touches(within));
    let input = (document.path.as_str(), &*document.text);
    let failing = report.failing_fixes(input, &document.options, files, touches);
    let mut found = Vec::new();
    for (number, diagnostic) in report.diagnostics.iter().enumerate() {
        if !touches(diagnostic) {
            continue;
        }
        if !failing.contains(&number) {
            found.extend(of_fix(document, number, diagnostic));
        }
        found.extend(suppress(document, number, diagnostic));
        found.push(Action {
            title: format!("Explain `{}`", diagnostic.rule),
            kind: ActionKind::Explain,
            finding: number,
            edits: Vec::new(),
        });
    }
    // Fixes come before suppressions.
    found.sort_by_key(|action| action.kind as u8);
    found
}

fn of_fix(document: &Document, finding: usize, diagnostic: &Diagnostic) -> Option<Action> {
    let fix = diagnostic.fix.as_ref()?;
    let edits = fix.edits.iter().map(|e| document.report.edit_of_input(e));
    let mut title = fix.title.chars();
    let first = title.next()?.to_uppercase();
    Some(Action {
        title: format!("{first}{}", title.as_str()),
        kind: match fix.applicability {
            Applicability::Safe => ActionKind::Fix,
            Applicability::Unsafe => ActionKind::UnsafeFix,
        },
        finding,
        edits: edits.collect::<Option<Vec<_>>>()?,
    })
}

/// Inserts a suppression comment above the line of a finding.
fn suppress(document: &Document, finding: usize, diagnostic: &Diagnostic) -> Option<Action> {
    if diagnostic.origin != Origin::Rule {
        return None;
    }
    // In the code of the shader: the strings of an export escape line breaks.
    let sources = &document.report.sources;
    let code = sources.code_at(diagnostic.span.start)?;
    let lines = LineIndex::new(code.text);
    let (start, end) = lines.bounds(diagnostic.span.start - code.base, code.text.len() as u32);
    let line = code.text.get(start as usize..end as usize)?;
    let indent = line.get(..line.len() - line.trim_start().len())?;
    let indent = indent.trim_end_matches(['\n', '\r']);
    // A comment cannot follow a line that ends with a backslash.
    let before = code.text.get(..start as usize)?;
    if before.trim_end_matches(['\n', '\r']).ends_with('\\') {
        return None;
    }
    let comment = format!("{indent}// shaderlint: allow({})\n", diagnostic.rule);
    let edit = Edit::insert(code.base + start, comment);
    Some(Action {
        title: format!("Allow `{}` on this line", diagnostic.rule),
        kind: ActionKind::Suppress,
        finding,
        edits: vec![document.report.edit_of_input(&edit)?],
    })
}

/// The text with all safe fixes applied, if there are any.
pub fn fix_all(document: &Document, files: &dyn Files) -> Option<String> {
    let fixed = fix_text(
        &document.path,
        &document.text,
        &document.options,
        files,
        Allow::Safe,
    );
    (*fixed.text != *document.text).then(|| fixed.text.to_string())
}
