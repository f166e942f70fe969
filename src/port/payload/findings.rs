//! Findings shown on the page for code that does not compile: they are more detailed than the
//! messages of the browser.

use crate::Composed;
use serde::Serialize;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::{Sources, Span};

/// Maximum number of findings; further errors are mostly consequential.
const MAX_FINDINGS: usize = 20;

/// An error with positions in UTF-16 units, as JavaScript counts them.
#[derive(Serialize, PartialEq, Eq)]
pub(super) struct FindingData {
    rule: &'static str,
    message: String,
    /// The primary label comes first.
    labels: Vec<LabelData>,
    notes: Vec<String>,
}

/// A labelled span.
#[derive(Serialize, PartialEq, Eq)]
struct LabelData {
    file: usize,
    start: usize,
    end: usize,
    text: String,
}

/// The errors of all passes, without duplicates.
pub(crate) fn findings(composed: &Composed) -> Vec<FindingData> {
    let mut found: Vec<FindingData> = Vec::new();
    for unit in &composed.units {
        let all = composed.analysis(unit).diagnostics.iter();
        for error in all.filter(|d| d.severity == Severity::Error) {
            let data = finding(&composed.sources, error);
            if let Some(data) = data.filter(|d| !found.contains(d)) {
                found.push(data);
            }
            if found.len() == MAX_FINDINGS {
                return found;
            }
        }
    }
    found
}

/// An error in the user's text; errors in the player's own text have no position to show.
fn finding(sources: &Sources, error: &Diagnostic) -> Option<FindingData> {
    let mut labels = vec![label(sources, error.span, &error.label)?];
    let others = error.labels.iter();
    labels.extend(others.filter_map(|l| label(sources, l.span, &l.message)));
    let mut notes = error.notes.clone();
    let fix = error.fix.iter().map(|fix| &fix.title);
    let unsaid = fix.filter(|title| !error.help.contains(title));
    notes.extend(
        error
            .help
            .iter()
            .chain(unsaid)
            .map(|h| format!("help: {h}")),
    );
    Some(FindingData {
        rule: error.rule,
        message: error.message.clone(),
        labels,
        notes,
    })
}

fn label(sources: &Sources, span: Span, text: &str) -> Option<LabelData> {
    let id = sources.file_id_at(span.start)?;
    let file = sources.file(id)?;
    let units = |address: u32| {
        let before = file.text.get(..(address - file.base) as usize)?;
        Some(before.encode_utf16().count())
    };
    Some(LabelData {
        file: id.0 as usize,
        start: units(span.start)?,
        end: units(span.end)?,
        text: text.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Project;
    use shaderlint_project::compose;

    #[test]
    fn errors_have_utf_16_positions() {
        let json = r#"{"renderpass":[{"type":"image",
            "code":"/* 😀 */ void mainImage(out vec4 c, in vec2 f) { c = broken; }"}]}"#;
        let project = Project::from_json(json).unwrap();
        let composed = compose(&project, "x.json").unwrap();
        let found = findings(&composed);
        assert_eq!(found.len(), 1);
        let place = &found[0].labels[0];
        assert_eq!((place.start, place.end), (53, 59));
    }

    #[test]
    fn valid_code_has_no_findings() {
        let json = r#"{"renderpass":[{"type":"image",
            "code":"void mainImage(out vec4 c, in vec2 f) { c = vec4(1.0); }"}]}"#;
        let project = Project::from_json(json).unwrap();
        let composed = compose(&project, "x.json").unwrap();
        assert!(findings(&composed).is_empty());
    }
}
