//! The state of all texts at a moment, by which a request is answered.

use super::super::config::{Configs, absolute};
use super::buffers::{OpenFiles, TextBuffer};
use super::client::{Client, UserSettings};
use super::pages::PageFiles;
use super::position::{Columns, TextLines};
use super::uri::{path_of, uri_of};
use crate::engine::{Files, Options};
use crate::format::{Indentation, Style, StyleChoice};
use crate::ide::{Document, FileSpan, RunSeen};
use crate::text::kind::Claim;
use crate::text::{LineIndex, Span};
use gen_lsp_types::{FormattingOptions, Location, Position, TextDocumentPositionParams, Uri};
use lsp_server::ErrorCode;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};

/// Why a request has no answer.
#[derive(Debug)]
pub struct Failure {
    /// The number of the protocol.
    pub code: ErrorCode,
    /// In words.
    pub message: String,
}

impl Failure {
    /// A request that cannot be done, for this reason.
    pub fn refused(message: impl Into<String>) -> Failure {
        Failure {
            code: ErrorCode::RequestFailed,
            message: message.into(),
        }
    }

    /// A request whose parameters mean nothing.
    pub fn invalid(message: impl Into<String>) -> Failure {
        Failure {
            code: ErrorCode::InvalidParams,
            message: message.into(),
        }
    }
}

/// What answers a request.
pub type Answer<T> = Result<T, Failure>;

/// By path: what was sent last of the colours of a text.
pub type SentTokens = Mutex<HashMap<String, (String, Vec<u32>)>>;

/// The state of all texts at a moment.
#[derive(Clone)]
pub struct Snapshot {
    /// What the client can do.
    pub client: Arc<Client>,
    /// What its user has set.
    pub settings: Arc<UserSettings>,
    /// The texts.
    pub files: OpenFiles,
    /// How they are judged without being run.
    pub quick: Arc<Configs>,
    /// How they are judged.
    pub full: Arc<Configs>,
    /// The folders that the user works on.
    pub folders: Arc<Vec<PathBuf>>,
    /// The pages of the rules, as files.
    pub pages: Arc<PageFiles>,
    /// What was sent of colours.
    pub tokens: Arc<SentTokens>,
    /// The number of this state, and of the newest one.
    pub state: u64,
    /// See `state`.
    pub newest: Arc<AtomicU64>,
}

impl Snapshot {
    /// Whether texts have changed since.
    pub fn is_stale(&self) -> bool {
        self.newest.load(Ordering::Relaxed) != self.state
    }

    /// What columns count.
    pub fn columns(&self) -> Columns {
        self.client.columns
    }

    /// The text that is open under an address.
    pub fn buffer(&self, uri: &Uri) -> Answer<&Arc<TextBuffer>> {
        let by_path = path_of(uri).and_then(|path| self.files.open.get(&path));
        let mut all = self.files.open.values();
        let found = by_path.or_else(|| all.find(|b| b.uri == *uri));
        found.ok_or_else(|| Failure::invalid(format!("{} is not open", uri.0)))
    }

    /// How a text is judged. Where the configuration is wrong, as if there was none.
    pub fn options(&self, configs: &Configs, buffer: &TextBuffer) -> Arc<Options> {
        let options = configs.options(Path::new(&buffer.path)).unwrap_or_default();
        let is_glsl = buffer.language == "glsl";
        match is_glsl && options.claim == Claim::None {
            true => Arc::new(Options {
                claim: Claim::Shader,
                ..Options::clone(&options)
            }),
            false => options,
        }
    }

    /// What is known of a text without running it.
    pub fn document(&self, buffer: &TextBuffer) -> Arc<Document> {
        let options = self.options(&self.quick, buffer);
        buffer.document(&options, &self.files).clone()
    }

    /// The best that is known of a text.
    pub fn best(&self, buffer: &TextBuffer) -> Arc<Document> {
        match buffer.ran.get() {
            Some(ran) => ran.document.clone(),
            None => self.document(buffer),
        }
    }

    /// What runs of the shaders of a text have shown.
    pub fn seen(&self, buffer: &TextBuffer) -> Vec<Option<RunSeen>> {
        buffer.ran.get().map_or(Vec::new(), |ran| ran.seen.clone())
    }

    /// A text and an offset in it.
    pub fn place(&self, at: &TextDocumentPositionParams) -> Answer<(&Arc<TextBuffer>, u32)> {
        let buffer = self.buffer(&at.text_document.uri)?;
        Ok((buffer, self.offset(buffer, at.position)))
    }

    /// The offset of a position.
    pub fn offset(&self, buffer: &TextBuffer, position: Position) -> u32 {
        buffer.lines(self.columns()).offset(position)
    }

    /// The address of a file as the client knows it.
    pub fn uri(&self, path: &str) -> Uri {
        let open = self.files.open.get(Path::new(path));
        open.map_or_else(|| uri_of(path), |buffer| buffer.uri.clone())
    }

    /// A stretch of whatever file as the protocol has it.
    pub fn location(&self, place: &FileSpan) -> Option<Location> {
        let range = self.with_lines(&place.path, |lines| lines.range(place.span))?;
        Some(Location {
            uri: self.uri(&place.path),
            range,
        })
    }

    /// Asks the lines of a file, open or not.
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

    /// How a text is set: as its configuration says, and of the rest as the client says.
    pub fn style(&self, buffer: &TextBuffer, options: &FormattingOptions) -> Answer<Style> {
        let width = options.tab_size.clamp(1, 16);
        let client = StyleChoice {
            indent: Some(match options.insert_spaces {
                true => Indentation::Spaces(width),
                false => Indentation::Tab(width),
            }),
            ..StyleChoice::default()
        };
        let style = self.quick.style_or(Path::new(&buffer.path), client);
        style.map_err(|message| Failure::refused(&*message))
    }

    /// Whether the configuration leaves a text out.
    pub fn leaves_out(&self, buffer: &TextBuffer) -> bool {
        self.quick.leaves_out(&absolute(Path::new(&buffer.path)))
    }

    /// What was sent of colours.
    pub fn sent_tokens(&self) -> MutexGuard<'_, HashMap<String, (String, Vec<u32>)>> {
        self.tokens
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// The stretch of a range.
    pub fn span(&self, buffer: &TextBuffer, range: gen_lsp_types::Range) -> Span {
        buffer.lines(self.columns()).span(range)
    }
}
