//! Maps positions and fixes in passes of an export to its JSON text.

use shaderlint_diagnostic::{Diagnostic, Fix};
use shaderlint_project::{Composed, Project};
use shaderlint_text::json::{JsonString, strings_in};
use shaderlint_text::{Edit, FileId, Sources, Span};

/// The positions of the code of passes in the JSON text.
#[derive(Default)]
pub struct ExportText {
    /// By text of a pass: the JSON string that contains it.
    codes: Vec<(FileId, JsonString)>,
}

impl ExportText {
    /// Finds the code of the passes in the JSON text. Code that is not found exactly as parsed
    /// cannot be edited.
    pub fn of(text: &str, project: &Project, composed: &Composed) -> ExportText {
        let found = strings_in(text, "renderpass", "code").unwrap_or_default();
        let ids = (0..composed.sources.files().len()).map(|i| FileId(i as u32));
        let code = |id: FileId| {
            let pass = composed.owner(id)?;
            let mut own = found.iter().filter(|(index, _)| *index == pass);
            let (_, string) = own.next().filter(|_| own.next().is_none())?;
            let is_same = *string.value == *project.passes.get(pass)?.code;
            is_same.then(|| (id, string.clone()))
        };
        ExportText {
            codes: ids.filter_map(code).collect(),
        }
    }

    fn span(&self, sources: &Sources, span: Span) -> Option<(&JsonString, Span)> {
        let id = sources.file_id_at(span.start)?;
        let file = sources.file(id).filter(|f| f.span().contains(span))?;
        let (_, string) = self.codes.iter().find(|(own, _)| *own == id)?;
        let from = (span.start - file.base) as usize;
        let place = string.place(from, from + span.len() as usize)?;
        Some((string, Span::new(place.start, place.end)))
    }

    /// A span in a pass as a span in the JSON text.
    pub fn in_json(&self, sources: &Sources, span: Span) -> Option<Span> {
        Some(self.span(sources, span)?.1)
    }

    /// The address of an offset in the JSON text.
    pub fn address(&self, sources: &Sources, offset: u32) -> Option<u32> {
        let mut codes = self.codes.iter();
        let (id, code) = codes.find(|(_, code)| {
            let place = code.place(0, code.value.len());
            place.is_some_and(|place| place.start <= offset && offset <= place.end)
        })?;
        Some(sources.file(*id)?.base + code.value_at(offset)?)
    }

    /// A finding with its span and fix in the JSON text.
    pub fn finding(&self, sources: &Sources, diagnostic: Diagnostic) -> Diagnostic {
        let place = self.span(sources, diagnostic.span);
        let span = place.map_or(Span::at(0), |(_, span)| span);
        let fix = diagnostic.fix.as_ref().and_then(|fix| {
            let edits = fix.edits.iter().map(|e| self.edit(sources, e));
            Some(Fix {
                edits: edits.collect::<Option<Vec<_>>>()?,
                ..fix.clone()
            })
        });
        Diagnostic {
            span,
            fix,
            ..diagnostic
        }
    }

    /// Spans in passes as spans in the JSON text.
    pub fn spans(&self, sources: &Sources, spans: &[Span]) -> Vec<Span> {
        let place = |span: &Span| self.in_json(sources, *span);
        spans.iter().filter_map(place).collect()
    }

    /// An edit of a pass as an edit of the JSON text.
    pub fn edit(&self, sources: &Sources, edit: &Edit) -> Option<Edit> {
        let (string, span) = self.span(sources, edit.span)?;
        let first = string
            .value
            .find('\n')
            .and_then(|at| string.value.get(..at));
        let text = if first.is_some_and(|line| line.ends_with('\r')) {
            edit.text.replace("\r\n", "\n").replace('\n', "\r\n")
        } else {
            edit.text.clone()
        };
        Some(Edit::replace(span, string.escape(&text)))
    }
}
