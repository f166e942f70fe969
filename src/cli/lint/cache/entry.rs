//! What the cache keeps of a check: all that is printed, and the questions whose answers it depends on.

use super::recorder::Question;
use crate::diagnostic::{Diagnostic, ERRORS};
use crate::engine::{Offer, Report};
use crate::report::Scope;
use crate::rules::RULES;
use crate::text::{Role, Sources, Span};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The result of a check.
#[derive(Debug, Deserialize, Serialize)]
pub struct Entry {
    /// Questions, and the digests of their answers.
    pub depends_on: Vec<(Question, u128)>,
    /// What was checked.
    pub scope: Scope,
    files: Vec<StoredFile>,
    findings: Vec<StoredFinding>,
    safe_fixes: usize,
    other_fixes: usize,
}

/// A file of the sources.
#[derive(Debug, Deserialize, Serialize)]
struct StoredFile {
    path: String,
    part: Option<String>,
    is_user: bool,
    length: usize,
    /// The text, if findings refer to it and it is not the input.
    text: Option<String>,
    is_input: bool,
}

/// A finding, as far as it is printed, with what it refers to elsewhere.
#[derive(Debug, Deserialize, Serialize)]
struct StoredFinding {
    rule: String,
    part: Option<Vec<String>>,
    finding: Diagnostic,
}

impl Entry {
    /// The entry of a report on this input.
    pub fn of(
        (report, scope, offer): (&Report, &Scope, Offer),
        input: &str,
        depends_on: Vec<(Question, u128)>,
    ) -> Entry {
        let findings = || report.diagnostics.iter();
        let files = report.sources.files().iter().map(|file| {
            let is_input = *file.text == *input;
            let is_used = findings().any(|d| refers_to(d, file.span()));
            StoredFile {
                path: file.path.clone(),
                part: file.part.clone(),
                is_user: file.role == Role::User,
                length: file.text.len(),
                text: (is_used && !is_input).then(|| file.text.to_string()),
                is_input,
            }
        });
        Entry {
            depends_on,
            scope: scope.clone(),
            files: files.collect(),
            findings: findings().map(StoredFinding::of).collect(),
            safe_fixes: offer.safe,
            other_fixes: offer.others,
        }
    }

    /// Reads an entry; `None` if it is damaged, or of another key.
    pub fn read(bytes: &[u8], valid_for: u128) -> Option<Entry> {
        let (key, json) = bytes.split_first_chunk::<16>()?;
        if u128::from_le_bytes(*key) != valid_for {
            return None;
        }
        serde_json::from_slice(json).ok()
    }

    /// The bytes of its file.
    pub fn bytes(&self, valid_for: u128) -> Option<Vec<u8>> {
        let mut bytes = valid_for.to_le_bytes().to_vec();
        serde_json::to_writer(&mut bytes, self).ok()?;
        Some(bytes)
    }

    /// The report on this input, as far as it is printed; `None` if a rule no longer exists.
    pub fn report(self, input: &str) -> Option<(Report, Scope, Offer)> {
        let mut sources = Sources::new();
        for file in self.files {
            let text = match file.text {
                Some(text) => text,
                None if file.is_input => input.to_string(),
                None => " ".repeat(file.length),
            };
            let role = match file.is_user {
                true => Role::User,
                false => Role::Prelude,
            };
            sources.add(file.path, file.part, role, text)?;
        }
        let mut report = Report::default();
        report.sources = Arc::new(sources);
        report.left_out = self.scope.left_out;
        report.counted_infos = self.scope.counted_infos;
        let findings = self.findings.into_iter().map(StoredFinding::finding);
        report.diagnostics = findings.collect::<Option<_>>()?;
        let offer = Offer {
            safe: self.safe_fixes,
            others: self.other_fixes,
        };
        Some((report, self.scope, offer))
    }
}

/// Whether a finding refers to a place in a file.
fn refers_to(d: &Diagnostic, file: Span) -> bool {
    let labels = d.labels.iter().map(|l| l.span);
    let macros = d.macros.iter().flat_map(|m| [m.call, m.definition]);
    let edits = d.fix.iter().flat_map(|f| &f.edits).map(|e| e.span);
    let mut all = [d.span]
        .into_iter()
        .chain(labels)
        .chain(macros)
        .chain(edits);
    all.any(|span| file.start <= span.start && span.start <= file.end)
}

impl StoredFinding {
    fn of(d: &Diagnostic) -> StoredFinding {
        StoredFinding {
            rule: d.rule.to_string(),
            part: d.part.as_ref().map(|hosts| hosts.to_vec()),
            finding: d.clone(),
        }
    }

    fn finding(self) -> Option<Diagnostic> {
        let rules = RULES.iter().map(|rule| rule.name);
        let mut names = rules.chain(ERRORS.iter().copied());
        Some(Diagnostic {
            rule: names.find(|name| *name == self.rule)?,
            part: self.part.map(Arc::from),
            ..self.finding
        })
    }
}
