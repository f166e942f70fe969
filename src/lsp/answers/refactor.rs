//! Refactorings as code actions.

use crate::buffers::TextBuffer;
use crate::capabilities::action_kind;
use crate::position::{TextLines, text_edits};
use crate::snapshot::Snapshot;
use gen_lsp_types::*;
use shaderlint_ide::{self as ide, RefactorKind, Refactoring};
use shaderlint_text::{LineIndex, Span, apply_edits};

/// The refactorings of the code in a range, of the requested kinds.
pub fn refactorings(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    span: Span,
    is_requested: impl Fn(&CodeActionKind) -> bool,
) -> Vec<CodeAction> {
    let document = snapshot.document(buffer);
    let is_requested = |kind| {
        let is_possible = kind != RefactorKind::Move || snapshot.client.creates_files;
        is_possible && is_requested(&action_kind(kind))
    };
    let found = ide::refactorings(&document, &snapshot.files, span, is_requested);
    let actions = found.into_iter().map(|r| action(snapshot, buffer, r));
    actions.collect()
}

fn action(snapshot: &Snapshot, buffer: &TextBuffer, refactoring: Refactoring) -> CodeAction {
    let lines = buffer.lines(snapshot.columns());
    let edits = text_edits(lines, &refactoring.edits);
    let identifier = |uri: &Uri, version| OptionalVersionedTextDocumentIdentifier {
        version,
        text_document_identifier: TextDocumentIdentifier { uri: uri.clone() },
    };
    let mut edit = WorkspaceEdit::default();
    match &refactoring.creates {
        None => edit.changes = Some([(buffer.uri.clone(), edits)].into()),
        Some(file) => {
            let uri = snapshot.uri(&file.path);
            let content = TextEdit {
                range: Range::default(),
                new_text: file.text.clone(),
            };
            let change = |identifier, edits: Vec<TextEdit>| {
                let edits = edits.into_iter().map(Edit::TextEdit).collect();
                DocumentChange::TextDocumentEdit(TextDocumentEdit::new(identifier, edits))
            };
            edit.document_changes = Some(vec![
                DocumentChange::CreateFile(CreateFile {
                    uri: uri.clone(),
                    options: None,
                    annotation_id: None,
                }),
                change(identifier(&uri, None), vec![content]),
                change(identifier(&buffer.uri, Some(buffer.version)), edits),
            ]);
        }
    }
    CodeAction {
        kind: Some(action_kind(refactoring.kind)),
        command: rename(snapshot, buffer, &refactoring),
        title: refactoring.title,
        edit: Some(edit),
        ..CodeAction::default()
    }
}

/// The command of the client that renames the new name.
fn rename(snapshot: &Snapshot, buffer: &TextBuffer, refactoring: &Refactoring) -> Option<Command> {
    let command = snapshot.settings.rename_command.as_ref()?;
    let text = apply_edits(&buffer.text, 0, &refactoring.edits).ok()?;
    let lines = TextLines {
        text: &text,
        index: &LineIndex::new(&text),
        columns: snapshot.columns(),
    };
    let position = lines.range(Span::at(refactoring.name?)).start;
    Some(Command {
        title: "Rename".to_string(),
        command: command.clone(),
        arguments: Some(vec![
            buffer.uri.0.clone().into(),
            serde_json::to_value(position).ok()?,
        ]),
        tooltip: None,
    })
}
