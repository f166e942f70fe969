//! What the fix engine sees of a checked text: the findings with positions in the input, and its shaders.

use crate::check::check_text;
use crate::check_context::CheckContext;
use crate::findings::report::Report;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_lint::{CheckedSpans, Look, Shown};
use shaderlint_semantic::Completeness;
use shaderlint_text::{Encoding, Span};
use std::sync::Arc;

/// Checks a text for the fix engine; `None` if it is not read.
pub(super) fn look(name: &str, text: &str, context: CheckContext) -> Option<Look> {
    let mut report = check_text(name, text, Encoding::Utf8, context);
    if report.unread.is_some() {
        return None;
    }
    // Rules that are not selected are checked, but not fixed.
    let others = report.diagnostics.iter_mut();
    others
        .filter(|d| !context.options.settings.reports(d.rule))
        .for_each(|d| d.fix = None);
    report.look(text)
}

impl Report {
    /// The findings with positions in the input text, for the fix engine.
    pub(super) fn look(&self, text: &str) -> Option<Look> {
        let shaders = self.analyses.iter().map(|analysis| Shown {
            program: Arc::clone(&analysis.program),
            is_drawn: analysis.completeness == Completeness::Complete && !analysis.has_errors,
        });
        let shaders = shaders.collect();
        if let Some(export) = &self.export {
            let place = |d: &Diagnostic| export.finding(&self.sources, d.clone());
            return Some(Look {
                shaders,
                span: Span::new(0, text.len() as u32),
                diagnostics: self.diagnostics.iter().map(place).collect(),
                checked_spans: self.checked_spans.as_ref().map(|j| CheckedSpans {
                    done: export.spans(&self.sources, &j.done),
                    left: export.spans(&self.sources, &j.left),
                }),
                size: self.size(),
            });
        }
        Some(Look {
            shaders,
            span: self.sources.file(self.file?)?.span(),
            diagnostics: self.diagnostics.clone(),
            checked_spans: self.checked_spans.clone(),
            size: self.size(),
        })
    }

    /// The offset of each finding in the input text.
    pub(super) fn offsets(&self) -> Vec<u32> {
        let base = self.file.and_then(|id| self.sources.file(id));
        let base = base.map_or(0, |file| file.base);
        let offset = |found: &Diagnostic| {
            let start = match &self.export {
                Some(export) => export.finding(&self.sources, found.clone()).span.start,
                None => found.span.start,
            };
            start.saturating_sub(base)
        };
        self.diagnostics.iter().map(offset).collect()
    }

    /// Number of tokens and macro calls.
    fn size(&self) -> usize {
        self.shaders.iter().map(|s| s.size).sum()
    }
}
