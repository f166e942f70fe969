//! Requests about all files of the workspace.

use crate::buffers::TextBuffer;
use crate::capabilities::symbol_kind;
use crate::diagnostics::{convert, diagnostics, result_id};
use crate::snapshot::{Answer, Snapshot};
use crate::workspace::SampleRuns;
use gen_lsp_types::*;
use shaderlint_ide::{self as ide, Document};
use shaderlint_project::Files;
use shaderlint_text::path::slashed;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Maximum number of files read for one request.
const MOST_FILES: usize = 5_000;
/// Maximum number of symbols in an answer.
const MOST_SYMBOLS: usize = 256;

/// The shader files of the workspace, and other files that may contain shaders.
fn files(snapshot: &Snapshot) -> Vec<PathBuf> {
    let found = snapshot.workspace().files(&snapshot.folders).into_iter();
    let open = snapshot.files.open.keys().cloned();
    let all: BTreeSet<PathBuf> = found.take(MOST_FILES).chain(open).collect();
    all.into_iter().collect()
}

/// The files of the project that contains a file, and whether there are more.
pub fn project_files(snapshot: &Snapshot, path: &Path) -> (BTreeSet<PathBuf>, bool) {
    let saved = snapshot.workspace().project_files(path, &snapshot.folders);
    let is_cut = saved.len() > MOST_FILES;
    let open = snapshot.files.open.keys().cloned();
    (
        saved.into_iter().take(MOST_FILES).chain(open).collect(),
        is_cut,
    )
}

/// The analysed document of a file, open or not.
pub fn document_at(snapshot: &Snapshot, path: &Path) -> Option<Arc<Document>> {
    if let Some(buffer) = snapshot.files.open.get(path) {
        return Some(snapshot.document(buffer));
    }
    let text = snapshot.files.load(path).ok()?;
    let options = snapshot.workspace().options(path, SampleRuns::Off)?;
    let name = slashed(path);
    Some(Arc::new(Document::new(
        &name,
        text,
        options,
        &snapshot.files,
    )))
}

/// The documents that may refer to the symbol at an offset.
pub struct Related {
    /// The documents; the one of the symbol is the first.
    pub documents: Vec<Arc<Document>>,
    /// Whether there may be more.
    pub is_cut: bool,
}

impl Related {
    /// The documents of the project that contain the name at an offset.
    pub fn of(snapshot: &Snapshot, document: &Arc<Document>, offset: u32) -> Related {
        let mut found = Related {
            documents: vec![document.clone()],
            is_cut: false,
        };
        let Some(name) = ide::shared_name(document, offset, &snapshot.files) else {
            return found;
        };
        let own = Path::new(&document.path);
        let (all, is_cut) = project_files(snapshot, own);
        found.is_cut = is_cut;
        for path in all.iter().filter(|path| *path != own) {
            let text = snapshot.files.load(path).ok();
            if text.is_some_and(|text| text.contains(&name)) {
                found.documents.extend(document_at(snapshot, path));
            }
        }
        found
    }

    /// The documents.
    pub fn all(&self) -> Vec<&Document> {
        self.documents.iter().map(Arc::as_ref).collect()
    }
}

/// The workspace symbols.
pub fn symbols(
    snapshot: &Snapshot,
    params: WorkspaceSymbolParams,
) -> Answer<Option<WorkspaceSymbolResponse>> {
    let query = params.query.to_lowercase();
    let mut found = Vec::new();
    for path in files(snapshot) {
        let Some(document) = document_at(snapshot, &path) else {
            continue;
        };
        for item in ide::outline(&document) {
            if !is_like(&item.name.to_lowercase(), &query) {
                continue;
            }
            let place = ide::FileSpan {
                path: document.path.clone(),
                span: item.name_span,
            };
            let Some(location) = snapshot.location(&place) else {
                continue;
            };
            found.push(WorkspaceSymbol {
                location: WorkspaceSymbolLocation::Location(location),
                data: None,
                base_symbol_information: BaseSymbolInformation {
                    name: item.name,
                    kind: symbol_kind(item.kind),
                    tags: None,
                    container_name: None,
                },
            });
            if found.len() >= MOST_SYMBOLS {
                return Ok(Some(WorkspaceSymbolResponse::WorkspaceSymbolList(found)));
            }
        }
    }
    Ok(Some(WorkspaceSymbolResponse::WorkspaceSymbolList(found)))
}

/// Whether a name contains the letters of a query in order.
fn is_like(name: &str, query: &str) -> bool {
    let mut letters = name.chars();
    query
        .chars()
        .all(|typed| letters.any(|letter| letter == typed))
}

/// The findings of an open document.
pub fn diagnostics_of(snapshot: &Snapshot, buffer: &TextBuffer) -> PublishDiagnosticsParams {
    PublishDiagnosticsParams {
        uri: buffer.uri.clone(),
        version: Some(buffer.version),
        diagnostics: diagnostics(snapshot, buffer),
    }
}

/// The findings of a document on request.
pub fn document_diagnostics(
    snapshot: &Snapshot,
    params: DocumentDiagnosticParams,
) -> Answer<DocumentDiagnosticReport> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let items = diagnostics(snapshot, buffer);
    let id = result_id(&items);
    if params.previous_result_id.as_ref() == Some(&id) {
        return Ok(RelatedUnchangedDocumentDiagnosticReport {
            related_documents: None,
            unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport {
                result_id: id,
            },
        }
        .into());
    }
    Ok(RelatedFullDocumentDiagnosticReport {
        related_documents: None,
        full_document_diagnostic_report: FullDocumentDiagnosticReport {
            result_id: Some(id),
            items,
        },
    }
    .into())
}

/// The findings of all files of the workspace. Shaders that are not open are not executed.
pub fn workspace_diagnostics(
    snapshot: &Snapshot,
    params: WorkspaceDiagnosticParams,
) -> Answer<WorkspaceDiagnosticReport> {
    let mut items = Vec::new();
    for path in files(snapshot) {
        let open = snapshot.files.open.get(&path);
        let findings = match open {
            Some(buffer) => diagnostics(snapshot, buffer),
            None => match document_at(snapshot, &path) {
                Some(document) => convert(snapshot, &document, None),
                None => continue,
            },
        };
        let uri = snapshot.uri(&path.to_string_lossy());
        let version = open.map(|buffer| buffer.version);
        let id = result_id(&findings);
        let mut previous = params.previous_result_ids.iter();
        let is_known = previous.any(|p| p.uri == uri && p.value == id);
        items.push(match is_known {
            true => WorkspaceUnchangedDocumentDiagnosticReport {
                uri,
                version,
                unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport {
                    result_id: id,
                },
            }
            .into(),
            false => WorkspaceFullDocumentDiagnosticReport {
                uri,
                version,
                full_document_diagnostic_report: FullDocumentDiagnosticReport {
                    result_id: Some(id),
                    items: findings,
                },
            }
            .into(),
        });
    }
    Ok(WorkspaceDiagnosticReport { items })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workspace_symbols_match_subsequences() {
        assert!(is_like("mapscene", "mpsc") && is_like("x", ""));
        assert!(!is_like("map", "pam"));
    }
}
