//! The handlers of requests.

mod appearance;
mod costs;
mod edits;
mod language;
mod navigation;
mod refactor;
mod workspace;

use super::snapshot::{Answer, Failure, Snapshot};
use gen_lsp_types::*;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::HashMap;

pub use edits::fix_all;
pub use navigation::name_uses;
pub use workspace::diagnostics_of;

/// Where a request is handled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lane {
    /// On the main loop.
    Quick,
    /// On a thread, because it may read many files or run a shader.
    Slow,
}

/// A handler of requests.
pub type Job = fn(&Snapshot, Value) -> Answer<Value>;

/// The handlers by method.
pub struct Jobs {
    all: HashMap<String, (Lane, Job)>,
}

/// Registers a handler for a request type.
macro_rules! jobs {
    ($($lane:ident $request:ident $answer:path,)*) => {{
        let mut all: HashMap<String, (Lane, Job)> = HashMap::new();
        $(
            let job: Job = |snapshot, params| {
                let params = read::<<$request as Request>::Params>(params)?;
                let answer: <$request as Request>::Result = $answer(snapshot, params)?;
                write(&answer)
            };
            all.insert($request::METHOD.to_string(), (Lane::$lane, job));
        )*
        all
    }};
}

fn read<T: for<'de> Deserialize<'de>>(params: Value) -> Answer<T> {
    serde_json::from_value(params).map_err(|error| Failure::invalid(error.to_string()))
}

fn write<T: Serialize>(answer: &T) -> Answer<Value> {
    serde_json::to_value(answer).map_err(|error| Failure::refused(error.to_string()))
}

/// Answers the request for costs by line.
fn show_costs(snapshot: &Snapshot, params: Value) -> Answer<Value> {
    write(&costs::costs(snapshot, &read(params)?)?)
}

/// The parameters of the preview request.
#[cfg(feature = "preview")]
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct PageParams {
    text_document: TextDocumentIdentifier,
    #[serde(flatten)]
    shown: super::preview::ShownShader,
}

/// Answers the preview request.
#[cfg(feature = "preview")]
fn show_page(snapshot: &Snapshot, params: Value) -> Answer<Value> {
    let params = read::<PageParams>(params)?;
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    write(&super::preview::page(snapshot, buffer, params.shown)?)
}

impl Jobs {
    /// All handlers of the server.
    pub fn new() -> Jobs {
        let mut all = jobs! {
            Slow HoverRequest language::hover,
            Quick CompletionRequest language::completion,
            Quick SignatureHelpRequest language::signature_help,
            Quick DefinitionRequest navigation::definition,
            Quick DeclarationRequest navigation::declaration,
            Quick TypeDefinitionRequest navigation::type_definition,
            Slow ReferencesRequest navigation::references,
            Quick DocumentHighlightRequest navigation::highlights,
            Quick DocumentSymbolRequest navigation::outline,
            Quick CallHierarchyPrepareRequest navigation::prepare_calls,
            Slow CallHierarchyIncomingCallsRequest navigation::incoming,
            Slow CallHierarchyOutgoingCallsRequest navigation::outgoing,
            Slow WorkspaceSymbolRequest workspace::symbols,
            Quick DocumentDiagnosticRequest workspace::document_diagnostics,
            Slow WorkspaceDiagnosticRequest workspace::workspace_diagnostics,
            Quick CodeActionRequest edits::actions,
            Quick PrepareRenameRequest edits::prepare_rename,
            Slow RenameRequest edits::rename,
            Slow WillRenameFilesRequest edits::move_files,
            Quick DocumentFormattingRequest edits::format,
            Quick DocumentRangeFormattingRequest edits::format_range,
            Quick DocumentOnTypeFormattingRequest edits::format_typed,
            Quick SemanticTokensRequest appearance::tokens,
            Quick SemanticTokensDeltaRequest appearance::tokens_delta,
            Quick SemanticTokensRangeRequest appearance::tokens_range,
            Quick InlayHintRequest appearance::hints,
            Quick FoldingRangeRequest appearance::folds,
            Quick SelectionRangeRequest appearance::selections,
            Quick DocumentColorRequest appearance::colors,
            Quick ColorPresentationRequest appearance::presentations,
            Quick CodeLensRequest appearance::lenses,
        };
        all.insert("shaderlint/costs".to_string(), (Lane::Slow, show_costs));
        #[cfg(feature = "preview")]
        all.insert("shaderlint/page".to_string(), (Lane::Slow, show_page));
        Jobs { all }
    }

    /// The handler of a method.
    pub fn get(&self, method: &str) -> Option<(Lane, Job)> {
        self.all.get(method).copied()
    }
}
