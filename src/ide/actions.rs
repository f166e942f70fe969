//! What can be done about findings.

use super::document::Document;
use shaderlint_diagnostic::{Applicability, Diagnostic, Origin};
use shaderlint_engine::{Files, mend};
use shaderlint_lint::Allow;
use shaderlint_text::{Edit, LineIndex, Span};

/// Something that can be done.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Action {
    /// What it does, as an order.
    pub title: String,
    /// What sort of thing it does.
    pub kind: ActionKind,
    /// The number of the finding that it is about, among those of the document.
    pub finding: usize,
    /// What it changes in the text of the document.
    pub edits: Vec<Edit>,
}

/// What sort of thing an action does.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ActionKind {
    /// It mends the finding, and keeps the picture or makes the shader compile.
    Fix,
    /// It mends the finding, perhaps with another picture.
    UnsafeFix,
    /// It keeps the finding from being told.
    Suppress,
    /// It shows the page of the rule.
    Explain,
}

/// What can be done about the findings that touch a stretch of the text.
pub fn actions(document: &Document, within: Span) -> Vec<Action> {
    let mut found = Vec::new();
    for (number, diagnostic) in document.report.diagnostics.iter().enumerate() {
        let span = document.report.in_input(diagnostic.span);
        if !span.is_some_and(|span| span.touches(within)) {
            continue;
        }
        found.extend(of_fix(document, number, diagnostic));
        found.extend(suppress(document, number, diagnostic));
        found.push(Action {
            title: format!("Explain `{}`", diagnostic.rule),
            kind: ActionKind::Explain,
            finding: number,
            edits: Vec::new(),
        });
    }
    // What mends comes before what hides.
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

/// A comment above the line of a finding that allows it.
fn suppress(document: &Document, finding: usize, diagnostic: &Diagnostic) -> Option<Action> {
    if diagnostic.origin != Origin::Rule {
        return None;
    }
    // In the words of the shader: a JSON string writes its line breaks in another way.
    let sources = &document.report.sources;
    let code = sources.code_at(diagnostic.span.start)?;
    let lines = LineIndex::new(code.text);
    let (start, end) = lines.bounds(diagnostic.span.start - code.base, code.text.len() as u32);
    let line = code.text.get(start as usize..end as usize)?;
    let indent = line.get(..line.len() - line.trim_start().len())?;
    let indent = indent.trim_end_matches(['\n', '\r']);
    // A line that goes on from the one before has no place for a comment above.
    let before = code.text.get(..start as usize)?;
    if before.trim_end_matches(['\n', '\r']).ends_with('\\') {
        return None;
    }
    let comment = format!("{indent}// shaderlint: allow({})\n", diagnostic.rule);
    let edit = Edit::insert(code.base + start, comment);
    Some(Action {
        title: format!("Allow `{}` here", diagnostic.rule),
        kind: ActionKind::Suppress,
        finding,
        edits: vec![document.report.edit_of_input(&edit)?],
    })
}

/// The text with all that can be mended safely, where that changes anything.
pub fn fix_all(document: &Document, files: &dyn Files) -> Option<String> {
    let fixed = mend(
        &document.path,
        &document.text,
        &document.options,
        files,
        Allow::Safe,
    );
    (*fixed.text != *document.text).then(|| fixed.text.to_string())
}
