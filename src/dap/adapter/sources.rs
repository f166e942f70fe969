//! The texts of the program: files, and passes of exports, which have no file of their own.

use super::reply::{ClientState, DebugAnswer, Reply};
use super::session::DebugSession;
use crate::arguments::{DebugArguments, SourceArgument};
use crate::debuggee::ProgramSource;
use crate::files::{FileLine, title};
use serde_json::{Value, json};
use shaderlint_text::{FileId, Span};

impl DebugSession {
    /// The places in texts that a client names by a source and a line: the text, the line there, and the
    /// last line that belongs to the source.
    pub(super) fn lines_of(
        &self,
        programs: &dyn ProgramSource,
        (source, line): (&SourceArgument, u32),
    ) -> Vec<(FileId, u32, u32)> {
        match (source.source_reference, &source.path) {
            (Some(number), _) if number > 0 => vec![(FileId(number - 1), line, u32::MAX)],
            (_, Some(path)) => self.files.texts_with(programs, (path, line)).collect(),
            _ => Vec::new(),
        }
    }

    /// A text as the client names it.
    fn source_of(&self, file: &FileLine) -> Value {
        match file {
            FileLine::Disk(path, _) => {
                let name = path.rsplit('/').next().unwrap_or(path);
                json!({ "name": name, "path": path })
            }
            FileLine::Virtual(id, _) => {
                let file = self.debuggee.program().and_then(|p| p.sources.file(*id));
                json!({ "name": file.map_or(String::new(), title), "sourceReference": id.0 + 1 })
            }
        }
    }

    /// A range of the source, with its source.
    pub(super) fn range(&self, client: &ClientState, span: Span) -> Value {
        self.known_range(client, span)
            .unwrap_or_else(|| json!({ "line": 0, "column": 0 }))
    }

    fn known_range(&self, client: &ClientState, span: Span) -> Option<Value> {
        let program = self.debuggee.program()?;
        let id = program.sources.file_id_at(span.start)?;
        let file = program.sources.file(id)?;
        let place = |address: u32| {
            let at = file.position(address);
            let before = file
                .text
                .get(..(address - file.base) as usize)
                .unwrap_or("");
            let line = before.rsplit('\n').next().unwrap_or("");
            (
                at.line,
                line.encode_utf16().count() as u32 + client.first_column,
            )
        };
        let ((first, column), (last, end_column)) = (place(span.start), place(span.end));
        let at = self.files.line(id, first)?;
        let (FileLine::Disk(_, line) | FileLine::Virtual(_, line)) = at;
        let line = line + client.first_line - 1;
        Some(json!({
            "source": self.source_of(&at),
            "line": line,
            "column": column,
            "endLine": line + last - first,
            "endColumn": end_column,
        }))
    }

    pub(super) fn source(&self, asked: &DebugArguments) -> DebugAnswer {
        let number = asked
            .source
            .source_reference
            .unwrap_or(asked.source_reference);
        let program = self.debuggee.program().ok_or("the program is gone")?;
        let id = number.checked_sub(1).map(FileId);
        let file = id
            .and_then(|id| program.sources.file(id))
            .ok_or("there is no such source")?;
        Ok(Reply::with(
            json!({ "content": &*file.text, "mimeType": "text/x-glsl" }),
        ))
    }

    pub(super) fn loaded_sources(&self) -> Reply {
        let sources: Vec<Value> = self
            .files
            .all()
            .iter()
            .map(|file| self.source_of(file))
            .collect();
        Reply::with(json!({ "sources": sources }))
    }
}
