//! The texts of the program: files, and passes of exports, which have no file of their own.

use super::session::Session;
use super::{Answer, Client, Reply};
use crate::arguments::{Asked, SourceArgument};
use crate::debuggee::Programs;
use serde_json::{Value, json};
use shaderlint_text::{FileId, Role, Span};

impl Session {
    /// The file that a client names.
    pub(super) fn file_of(
        &self,
        programs: &dyn Programs,
        source: &SourceArgument,
    ) -> Option<FileId> {
        let program = self.debuggee.program()?;
        if let Some(number) = source.source_reference.and_then(|n| n.checked_sub(1)) {
            return Some(FileId(number));
        }
        let path = programs.path(source.path.as_deref()?);
        let mut files = (0..).map(FileId).zip(program.sources.files());
        let is_it = |path: &str, known: &str| programs.path(known) == path;
        let found = files.find(|(_, file)| file.role == Role::User && is_it(&path, &file.path));
        found.map(|(id, _)| id)
    }

    /// A text as the client names it.
    fn source_of(&self, id: FileId) -> Value {
        let program = self.debuggee.program();
        let Some(file) = program.and_then(|p| p.sources.file(id)) else {
            return Value::Null;
        };
        let name = file.path.rsplit('/').next().unwrap_or(&file.path);
        match (&file.part, file.role) {
            (None, Role::User) => json!({ "name": name, "path": file.path }),
            (part, _) => {
                let name = part
                    .as_ref()
                    .map_or(name.to_string(), |part| format!("{part} ({name})"));
                json!({ "name": name, "sourceReference": id.0 + 1 })
            }
        }
    }

    /// A range of the source, with its source.
    pub(super) fn range(&self, client: &Client, span: Span) -> Value {
        let program = self.debuggee.program();
        let Some((program, id)) =
            program.and_then(|p| Some((p, p.sources.file_id_at(span.start)?)))
        else {
            return json!({ "line": 0, "column": 0 });
        };
        let Some(file) = program.sources.file(id) else {
            return json!({ "line": 0, "column": 0 });
        };
        let place = |address: u32| {
            let at = file.position(address);
            let before = file
                .text
                .get(..(address - file.base) as usize)
                .unwrap_or("");
            let line = before.rsplit('\n').next().unwrap_or("");
            let column = line.encode_utf16().count() as u32;
            (
                at.line + client.first_line - 1,
                column + client.first_column,
            )
        };
        let ((line, column), (end_line, end_column)) = (place(span.start), place(span.end));
        json!({
            "source": self.source_of(id),
            "line": line,
            "column": column,
            "endLine": end_line,
            "endColumn": end_column,
        })
    }

    pub(super) fn source(&self, asked: &Asked) -> Answer {
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
        let program = self.debuggee.program();
        let files = program.map_or(&[][..], |p| p.sources.files());
        let own = (0..)
            .map(FileId)
            .zip(files)
            .filter(|(_, file)| file.role == Role::User);
        let sources: Vec<Value> = own.map(|(id, _)| self.source_of(id)).collect();
        Reply::with(json!({ "sources": sources }))
    }
}
