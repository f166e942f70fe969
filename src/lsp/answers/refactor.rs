//! Refactorings as code actions.

use crate::buffers::TextBuffer;
#[cfg(feature = "preview")]
use crate::capabilities::PREVIEW;
use crate::capabilities::action_kind;
use crate::new_file::new_file;
use crate::position::{TextLines, text_edits};
use crate::snapshot::Snapshot;
use gen_lsp_types::*;
use shaderlint_ide::{self as ide, Document, RefactorKind, Refactoring};
use shaderlint_text::{LineIndex, Span, apply_edits};

/// The refactorings of the code in a range, of the requested kinds.
pub fn refactorings(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    span: Span,
    is_requested: impl Fn(&CodeActionKind) -> bool,
) -> Vec<CodeAction> {
    let document = snapshot.document(buffer);
    let is_possible = |kind| kind != RefactorKind::Move || snapshot.client.creates_files;
    let is_offered = |kind| is_possible(kind) && is_requested(&action_kind(kind));
    let found = ide::refactorings(&document, &snapshot.files, span, is_offered);
    let actions = found.into_iter().map(|r| action(snapshot, buffer, r));
    let shows = is_requested(&CodeActionKind::Refactor);
    let shown = shows.then(|| show_value(snapshot, buffer, &document, span));
    actions.chain(shown.flatten()).collect()
}

/// The action that shows the value of the code in a range over the frame.
fn show_value(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    document: &Document,
    span: Span,
) -> Option<CodeAction> {
    let own_view = snapshot.settings.preview_command.clone();
    #[cfg(feature = "preview")]
    let command = own_view.unwrap_or_else(|| PREVIEW.to_string());
    #[cfg(not(feature = "preview"))]
    let command = own_view?;
    let value = ide::shown_value(document, &snapshot.files, span, ide::WITHIN)?;
    let range = buffer.lines(snapshot.columns()).range(value.span);
    let title = "Preview this value".to_string();
    let arguments = vec![
        buffer.uri.0.clone().into(),
        serde_json::to_value(range).ok()?,
    ];
    Some(CodeAction {
        title: title.clone(),
        kind: Some(CodeActionKind::Refactor),
        command: Some(Command {
            title,
            command,
            arguments: Some(arguments),
            tooltip: None,
        }),
        ..CodeAction::default()
    })
}

fn action(snapshot: &Snapshot, buffer: &TextBuffer, refactoring: Refactoring) -> CodeAction {
    let lines = buffer.lines(snapshot.columns());
    let edits = text_edits(lines, &refactoring.edits);
    let mut edit = WorkspaceEdit::default();
    match &refactoring.creates {
        None => edit.changes = Some([(buffer.uri.clone(), edits)].into()),
        Some(file) => {
            let mut changes = new_file(snapshot.uri(&file.path), file.text.clone());
            let identifier = OptionalVersionedTextDocumentIdentifier {
                version: Some(buffer.version),
                text_document_identifier: TextDocumentIdentifier {
                    uri: buffer.uri.clone(),
                },
            };
            let edits = edits.into_iter().map(Edit::TextEdit).collect();
            changes.push(DocumentChange::TextDocumentEdit(TextDocumentEdit::new(
                identifier, edits,
            )));
            edit.document_changes = Some(changes);
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
