//! Answers that edit text: fixes, renaming, formatting.

use super::navigation::declared;
use super::refactor::refactorings;
use super::workspace::{Related, project_files};
use crate::buffers::{TextBuffer, full_range};
use crate::capabilities::{EXPLAIN, FIX_ALL_KIND};
use crate::diagnostics::one;
use crate::position::text_edits;
use crate::snapshot::{Answer, Failure, Snapshot};
use crate::uri::path_of;
use crate::workspace::SampleRuns;
use gen_lsp_types::*;
use shaderlint_engine as engine;
use shaderlint_ide::{self as ide, ActionKind, Document};
use shaderlint_project::{FileMoves, Files, moved_includes};
use shaderlint_text::path::slashed;
use shaderlint_text::{Edit, Span};
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A workspace edit of one document, for its current version.
fn workspace_edit(buffer: &TextBuffer, edits: Vec<TextEdit>) -> WorkspaceEdit {
    WorkspaceEdit {
        changes: Some(HashMap::from([(buffer.uri.clone(), edits)])),
        ..WorkspaceEdit::default()
    }
}

/// The code actions for the findings in a range, and the refactorings of its code.
pub fn actions(
    snapshot: &Snapshot,
    params: CodeActionParams,
) -> Answer<Option<Vec<CodeActionResponse>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let document = snapshot.best(buffer);
    let only = params.context.only.as_deref();
    let is_requested = |kind: &CodeActionKind| {
        let of = |asked: &CodeActionKind| {
            let (asked, kind) = (asked.to_string(), kind.to_string());
            asked.is_empty() || kind == asked || kind.starts_with(&format!("{asked}."))
        };
        only.is_none_or(|only| only.iter().any(of))
    };
    let mut found = Vec::new();
    let span = snapshot.span(buffer, params.range);
    if is_requested(&CodeActionKind::QuickFix) {
        let actions = ide::actions(&document, &snapshot.files, span);
        let items = actions
            .iter()
            .filter_map(|action| of_finding(snapshot, buffer, &document, action));
        found.extend(items.map(CodeActionResponse::CodeAction));
    }
    // A cursor that moves asks for what an editor shows without being asked: no refactorings.
    let is_automatic = params.context.trigger_kind == Some(CodeActionTriggerKind::Automatic);
    if !(span.is_empty() && is_automatic) {
        let actions = refactorings(snapshot, buffer, span, is_requested);
        found.extend(actions.into_iter().map(CodeActionResponse::CodeAction));
    }
    // All safe fixes together, only on request: verifying them draws the shader.
    let asks = only.is_some_and(|only| only.iter().any(|k| k.to_string().starts_with("source")));
    if asks && is_requested(&FIX_ALL_KIND) {
        found.extend(fix_all(snapshot, buffer).map(CodeActionResponse::CodeAction));
    }
    Ok(Some(found))
}

fn of_finding(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    document: &Document,
    action: &ide::Action,
) -> Option<CodeAction> {
    let diagnostic = document.report.diagnostics.get(action.finding)?;
    let rule = diagnostic.rule.to_string();
    let explain = (action.kind == ActionKind::Explain).then(|| Command {
        title: action.title.clone(),
        command: EXPLAIN.to_string(),
        arguments: Some(vec![rule.into()]),
        tooltip: None,
    });
    let edits = text_edits(buffer.lines(snapshot.columns()), &action.edits);
    Some(CodeAction {
        title: match action.kind {
            ActionKind::UnsafeFix => format!("{} (may change the image)", action.title),
            _ => action.title.clone(),
        },
        kind: Some(CodeActionKind::QuickFix),
        diagnostics: one(snapshot, document, Some(buffer), diagnostic).map(|items| vec![items]),
        is_preferred: (action.kind == ActionKind::Fix).then_some(true),
        edit: (!edits.is_empty()).then(|| workspace_edit(buffer, edits)),
        command: explain,
        ..CodeAction::default()
    })
}

/// Applies all safe fixes of a document.
pub fn fix_all(snapshot: &Snapshot, buffer: &TextBuffer) -> Option<CodeAction> {
    let text = ide::fix_all(&snapshot.document(buffer), &snapshot.files)?;
    let lines = buffer.lines(snapshot.columns());
    let edit = TextEdit {
        range: full_range(lines),
        new_text: text,
    };
    Some(CodeAction {
        title: "Apply all safe fixes".to_string(),
        kind: Some(FIX_ALL_KIND),
        edit: Some(workspace_edit(buffer, vec![edit])),
        ..CodeAction::default()
    })
}

/// Checks whether the name at a position can be renamed.
pub fn prepare_rename(
    snapshot: &Snapshot,
    params: PrepareRenameParams,
) -> Answer<Option<PrepareRenameResult>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let document = snapshot.document(buffer);
    let (named, at) = declared(snapshot, document.clone(), offset);
    let found = ide::may_rename(&named, at, &snapshot.files);
    let (span, placeholder) = found.map_err(|refusal| Failure::refused(refusal.0))?;
    let span = match document.spot(offset) {
        Some(_) => span,
        None => ide::bound_at(&document, offset, &snapshot.files).span,
    };
    let range = buffer.lines(snapshot.columns()).range(span);
    Ok(Some(PrepareRenameResult::PrepareRenamePlaceholder(
        PrepareRenamePlaceholder { range, placeholder },
    )))
}

/// Renames the name at a position in all files of the workspace.
pub fn rename(snapshot: &Snapshot, params: RenameParams) -> Answer<Option<WorkspaceEdit>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let (document, offset) = declared(snapshot, snapshot.document(buffer), offset);
    let related = Related::of(snapshot, &document, offset);
    if related.is_cut {
        return Err(Failure::refused(
            "the project has too many files to find all names",
        ));
    }
    let renaming = ide::rename(
        &related.all(),
        &document,
        offset,
        &params.new_name,
        &snapshot.files,
    );
    let renaming = renaming.map_err(|refusal| Failure::refused(refusal.0))?;
    let mut changes = HashMap::new();
    for (path, edits) in &renaming.edits {
        let edits = snapshot.with_lines(path, |lines| text_edits(lines, edits));
        let edits = edits.ok_or_else(|| Failure::refused(format!("cannot read {path}")))?;
        changes.insert(snapshot.uri(path), edits);
    }
    Ok(Some(WorkspaceEdit {
        changes: Some(changes),
        ..WorkspaceEdit::default()
    }))
}

/// The edits that format a document, or a range of it.
fn formatted(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    options: &FormattingOptions,
    within: Option<Span>,
) -> Answer<Option<Vec<TextEdit>>> {
    let style = snapshot.style(buffer, options)?;
    let claim = snapshot.options(SampleRuns::Off, buffer).claim;
    let Ok(formatting) = engine::format(&buffer.path, &buffer.text, claim, style) else {
        return Ok(None);
    };
    let mut edits: Vec<Edit> = formatting.edits;
    if let Some(within) = within {
        let clipped = edits
            .iter()
            .filter_map(|edit| clip(&buffer.text, edit, within));
        edits = clipped.collect();
    } else if let ([], [left, ..]) = (&edits[..], &formatting.left[..]) {
        let line = buffer.lines.line(left.span.start);
        return Err(Failure::refused(format!("line {line}: {}", left.message)));
    }
    let lines = buffer.lines(snapshot.columns());
    Ok(Some(text_edits(lines, &edits)))
}

/// The part of a white-space edit that belongs to complete lines: the indentation of the first, and
/// the end of the last.
fn clip(text: &str, edit: &Edit, within: Span) -> Option<Edit> {
    let mut edit = edit.clone();
    if edit.span.end < within.start || edit.span.start > within.end {
        return None;
    }
    if edit.span.start < within.start {
        edit.text = edit.text.rsplit(['\n', '\r']).next()?.to_string();
        edit.span.start = within.start;
    }
    if edit.span.end > within.end {
        // Up to the line break, which belongs to the text outside.
        let end = text
            .get(..within.end as usize)?
            .trim_end_matches(['\n', '\r'])
            .len() as u32;
        edit.text = edit.text.split(['\n', '\r']).next()?.to_string();
        edit.span.end = end.max(edit.span.start);
    }
    let old = text.get(edit.span.start as usize..edit.span.end as usize)?;
    (old != edit.text).then_some(edit)
}

/// The edits after which all files include the same files as before some are moved.
pub fn move_files(snapshot: &Snapshot, params: RenameFilesParams) -> Answer<Option<WorkspaceEdit>> {
    let pairs = params.files.iter();
    let pairs = pairs.filter_map(|f| Some((path_of(&f.old_uri)?, path_of(&f.new_uri)?)));
    let pairs: Vec<(PathBuf, PathBuf)> = pairs.collect();
    let mut files = BTreeSet::new();
    for (old, _) in &pairs {
        files.append(&mut project_files(snapshot, old).0);
    }
    let stems = pairs
        .iter()
        .filter_map(|(old, _)| old.file_stem()?.to_str());
    let stems: Vec<String> = stems.map(str::to_string).collect();
    let is_moved = |file: &Path| pairs.iter().any(|(old, _)| file.starts_with(old));
    let may_change =
        |file: &Path, text: &str| is_moved(file) || stems.iter().any(|stem| text.contains(stem));
    let files: Vec<(PathBuf, Arc<str>)> = files
        .into_iter()
        .filter_map(|file| {
            let text = snapshot.files.load(&file).ok()?;
            may_change(&file, &text).then_some((file, text))
        })
        .collect();
    let moves = FileMoves::new(pairs);
    let mut changes = HashMap::new();
    for (file, text) in files {
        let name = slashed(&file);
        let Some(options) = snapshot.workspace().options(&file, SampleRuns::Off) else {
            continue;
        };
        let edits = moved_includes(&name, &text, options.file_access(&snapshot.files), &moves);
        if !edits.is_empty() {
            let edits = snapshot.with_lines(&name, |lines| text_edits(lines, &edits));
            changes.insert(snapshot.uri(&name), edits.unwrap_or_default());
        }
    }
    Ok((!changes.is_empty()).then(|| WorkspaceEdit {
        changes: Some(changes),
        ..WorkspaceEdit::default()
    }))
}

/// Formats a document.
pub fn format(
    snapshot: &Snapshot,
    params: DocumentFormattingParams,
) -> Answer<Option<Vec<TextEdit>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    formatted(snapshot, buffer, &params.options, None)
}

/// Formats the lines of a range.
pub fn format_range(
    snapshot: &Snapshot,
    params: DocumentRangeFormattingParams,
) -> Answer<Option<Vec<TextEdit>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let span = snapshot.span(buffer, params.range);
    formatted(
        snapshot,
        buffer,
        &params.options,
        Some(full_lines(buffer, span)),
    )
}

/// Formats after typing: the block that a `}` closes, or the line that a `;` ends.
pub fn format_typed(
    snapshot: &Snapshot,
    params: DocumentOnTypeFormattingParams,
) -> Answer<Option<Vec<TextEdit>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let offset = snapshot.offset(buffer, params.position);
    let span = match params.ch.as_str() {
        "}" => {
            let around = ide::selection(&snapshot.document(buffer), offset.saturating_sub(1));
            let ends_here = |span: &&Span| span.end == offset;
            let closed = around.iter().rev().find(ends_here).copied();
            closed.unwrap_or(Span::at(offset))
        }
        _ => Span::at(offset),
    };
    formatted(
        snapshot,
        buffer,
        &params.options,
        Some(full_lines(buffer, span)),
    )
}

/// Extends a span to complete lines, without the last line break.
fn full_lines(buffer: &TextBuffer, span: Span) -> Span {
    let length = buffer.text.len() as u32;
    let (start, _) = buffer.lines.bounds(span.start, length);
    // A range that ends at the start of a line does not include that line.
    let last = if span.end > span.start {
        span.end - 1
    } else {
        span.end
    };
    let (_, end) = buffer.lines.bounds(last, length);
    Span::new(start, end)
}
