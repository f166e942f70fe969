//! A snapshot of all documents, by which a request is answered.

use super::buffers::{OpenFiles, TextBuffer};
use super::client::{Client, UserSettings};
use super::position::{Columns, TextLines};
use super::uri::{path_of, uri_of};
use super::workspace::{SampleRuns, Workspace};
use gen_lsp_types::{FormattingOptions, Location, Position, TextDocumentPositionParams, Uri};
use lsp_server::ErrorCode;
use shaderlint_detect::kind::Claim;
use shaderlint_engine::Options;
use shaderlint_format::{Indentation, StyleChoice};
use shaderlint_ide::{Document, FileSpan, RunObservations};
use shaderlint_project::Files;
use shaderlint_text::{LineIndex, Span};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};

/// Why a request failed.
#[derive(Debug)]
pub struct Failure {
    /// Error code of the protocol.
    pub code: ErrorCode,
    /// Message for the user.
    pub message: String,
}

impl Failure {
    /// A valid request that cannot be fulfilled.
    pub fn refused(message: impl Into<String>) -> Failure {
        Failure {
            code: ErrorCode::RequestFailed,
            message: message.into(),
        }
    }

    /// A request with invalid parameters.
    pub fn invalid(message: impl Into<String>) -> Failure {
        Failure {
            code: ErrorCode::InvalidParams,
            message: message.into(),
        }
    }
}

/// The result of a request.
pub type Answer<T> = Result<T, Failure>;

/// By path: the semantic tokens that were sent last, with their result id.
pub type SentTokens = Mutex<HashMap<String, (String, Vec<u32>)>>;

/// The state of all documents at one time.
#[derive(Clone)]
pub struct Snapshot {
    /// Capabilities of the client.
    pub client: Arc<Client>,
    /// Settings of the user.
    pub settings: Arc<UserSettings>,
    /// The open documents and the other files.
    pub files: OpenFiles,
    /// Workspace folders.
    pub folders: Arc<Vec<PathBuf>>,
    /// Semantic tokens that were sent.
    pub tokens: Arc<SentTokens>,
    /// Number of this state.
    pub state: u64,
    /// Number of the newest state.
    pub newest: Arc<AtomicU64>,
}

impl Snapshot {
    /// The files that are not open, and the options of all.
    pub fn workspace(&self) -> &dyn Workspace {
        &*self.files.others
    }

    /// Whether documents have changed since.
    pub fn is_stale(&self) -> bool {
        self.newest.load(Ordering::Relaxed) != self.state
    }

    /// The unit of columns.
    pub fn columns(&self) -> Columns {
        self.client.columns
    }

    /// The open document with a URI.
    pub fn buffer(&self, uri: &Uri) -> Answer<&Arc<TextBuffer>> {
        let by_path = path_of(uri).and_then(|path| self.files.open.get(&path));
        let mut all = self.files.open.values();
        let found = by_path.or_else(|| all.find(|b| b.uri == *uri));
        found.ok_or_else(|| Failure::invalid(format!("{} is not open", uri.0)))
    }

    /// The options for a document; the defaults if its configuration is invalid.
    pub fn options(&self, runs: SampleRuns, buffer: &TextBuffer) -> Arc<Options> {
        let options = self.workspace().options(Path::new(&buffer.path), runs);
        let options = options.unwrap_or_default();
        let is_glsl = buffer.language == "glsl";
        match is_glsl && options.claim == Claim::None {
            true => Arc::new(Options {
                claim: Claim::Shader,
                ..Options::clone(&options)
            }),
            false => options,
        }
    }

    /// The analysis of a document without sample runs.
    pub fn document(&self, buffer: &TextBuffer) -> Arc<Document> {
        let options = self.options(SampleRuns::Off, buffer);
        buffer.document(&options, &self.files).clone()
    }

    /// The best analysis of a document that exists.
    pub fn best(&self, buffer: &TextBuffer) -> Arc<Document> {
        match buffer.ran.get() {
            Some(ran) => ran.document.clone(),
            None => self.document(buffer),
        }
    }

    /// The values that sample runs recorded, by shader.
    pub fn seen(&self, buffer: &TextBuffer) -> Vec<Option<RunObservations>> {
        buffer.ran.get().map_or(Vec::new(), |ran| ran.seen.clone())
    }

    /// A document and the offset of a position in it.
    pub fn place(&self, at: &TextDocumentPositionParams) -> Answer<(&Arc<TextBuffer>, u32)> {
        let buffer = self.buffer(&at.text_document.uri)?;
        Ok((buffer, self.offset(buffer, at.position)))
    }

    /// Converts a position to an offset.
    pub fn offset(&self, buffer: &TextBuffer, position: Position) -> u32 {
        buffer.lines(self.columns()).offset(position)
    }

    /// The URI of a file, as the client knows it.
    pub fn uri(&self, path: &str) -> Uri {
        let open = self.files.open.get(Path::new(path));
        open.map_or_else(|| uri_of(path), |buffer| buffer.uri.clone())
    }

    /// Converts a span in any file to a location.
    pub fn location(&self, place: &FileSpan) -> Option<Location> {
        let range = self.with_lines(&place.path, |lines| lines.range(place.span))?;
        Some(Location {
            uri: self.uri(&place.path),
            range,
        })
    }

    /// Calls a function with the lines of a file, open or not.
    pub fn with_lines<T>(&self, path: &str, ask: impl FnOnce(TextLines) -> T) -> Option<T> {
        if let Some(buffer) = self.files.open.get(Path::new(path)) {
            return Some(ask(buffer.lines(self.columns())));
        }
        let text = self.files.load(Path::new(path)).ok()?;
        Some(ask(TextLines {
            text: &text,
            index: &LineIndex::new(&text),
            columns: self.columns(),
        }))
    }

    /// The formatting style of a document: from its configuration, and otherwise from the client.
    pub fn style(&self, buffer: &TextBuffer, options: &FormattingOptions) -> Answer<StyleChoice> {
        let width = options.tab_size.clamp(1, 16);
        let client = StyleChoice {
            indent: Some(match options.insert_spaces {
                true => Indentation::Spaces(width),
                false => Indentation::Tab(width),
            }),
            ..StyleChoice::default()
        };
        let style = self.workspace().style(Path::new(&buffer.path), client);
        style.map_err(|message| Failure::refused(&*message))
    }

    /// Whether the configuration excludes a document.
    pub fn leaves_out(&self, buffer: &TextBuffer) -> bool {
        self.workspace().leaves_out(Path::new(&buffer.path))
    }

    /// The semantic tokens that were sent.
    pub fn sent_tokens(&self) -> MutexGuard<'_, HashMap<String, (String, Vec<u32>)>> {
        self.tokens
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// Converts a range to a span.
    pub fn span(&self, buffer: &TextBuffer, range: gen_lsp_types::Range) -> Span {
        buffer.lines(self.columns()).span(range)
    }
}
