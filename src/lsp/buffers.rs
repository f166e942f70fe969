//! The documents that are open in the editor, and the files around them.

use super::position::{Columns, TextLines};
use super::uri::path_of;
use super::workspace::Workspace;
use gen_lsp_types::{Position, Range, TextDocumentContentChangeEvent, Uri};
use shaderlint_engine::Options;
use shaderlint_ide::{Document, RunObservations};
use shaderlint_project::{FileType, Files, LoadError};
use shaderlint_text::LineIndex;
use shaderlint_text::path::slashed;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Bound;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// One version of an open document. Changes create a new one.
pub struct TextBuffer {
    /// URI of the document.
    pub uri: Uri,
    /// Path of the document; an invented one for a document that was never saved.
    pub path: String,
    /// Version that the client assigned.
    pub version: i32,
    /// Contents of the document.
    pub text: Arc<str>,
    /// Offsets of its lines.
    pub lines: LineIndex,
    /// Number of this state, unique among all states of all documents.
    pub state: u64,
    /// Language id that the client assigned.
    pub language: String,
    /// The analysis without sample runs.
    document: OnceLock<Arc<Document>>,
    /// The analysis with sample runs, once they have finished.
    pub ran: Arc<OnceLock<Ran>>,
    /// Text and analysis of an earlier state.
    pub earlier: Option<(Arc<str>, Arc<OnceLock<Ran>>)>,
}

/// The result of sample runs.
pub struct Ran {
    /// The analysis, including the findings of sample runs.
    pub document: Arc<Document>,
    /// By shader: the recorded values.
    pub seen: Vec<Option<RunObservations>>,
}

impl TextBuffer {
    /// A document that was just opened.
    pub fn new(uri: Uri, language: String, version: i32, text: String, state: u64) -> TextBuffer {
        let path = path_of(&uri).map(slashed);
        // A document without a file gets a name with an extension that selects its language.
        let path = path.unwrap_or_else(|| {
            let name: String = uri
                .0
                .chars()
                .map(|c| if c == ':' { '/' } else { c })
                .collect();
            let name = name.trim_start_matches('/');
            let has_extension = name.rsplit('/').next().is_some_and(|n| n.contains('.'));
            format!("/{name}{}", if has_extension { "" } else { ".glsl" })
        });
        let lines = LineIndex::new(&text);
        TextBuffer {
            uri,
            path,
            version,
            text: text.into(),
            lines,
            state,
            language,
            document: OnceLock::new(),
            ran: Arc::default(),
            earlier: None,
        }
    }

    /// The next state of the document, with a new text or after changes to other files.
    pub fn next(&self, version: i32, text: Arc<str>, state: u64) -> TextBuffer {
        let earlier = match self.ran.get() {
            Some(_) => Some((self.text.clone(), self.ran.clone())),
            None => self.earlier.clone(),
        };
        TextBuffer {
            uri: self.uri.clone(),
            path: self.path.clone(),
            version,
            lines: LineIndex::new(&text),
            text,
            state,
            language: self.language.clone(),
            document: OnceLock::new(),
            ran: Arc::default(),
            earlier,
        }
    }

    /// The text with its line offsets, for conversions of positions.
    pub fn lines(&self, columns: Columns) -> TextLines<'_> {
        TextLines {
            text: &self.text,
            index: &self.lines,
            columns,
        }
    }

    /// The analysis without sample runs, computed on demand.
    pub fn document(&self, options: &Arc<Options>, files: &dyn Files) -> &Arc<Document> {
        self.document.get_or_init(|| {
            let text = self.text.clone();
            Arc::new(Document::new(&self.path, text, options.clone(), files))
        })
    }

    /// The analysis without sample runs, if it was computed already.
    pub fn known(&self) -> Option<&Arc<Document>> {
        self.document.get()
    }
}

/// Applies changes to a text.
pub fn changed(
    text: &str,
    changes: Vec<TextDocumentContentChangeEvent>,
    columns: Columns,
) -> String {
    let mut text = text.to_string();
    for change in changes {
        let (range, new) = match change {
            TextDocumentContentChangeEvent::TextDocumentContentChangePartial(part) => {
                (Some(part.range), part.text)
            }
            TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(change) => {
                (None, change.text)
            }
        };
        match range {
            Some(range) => {
                let index = LineIndex::new(&text);
                let lines = TextLines {
                    text: &text,
                    index: &index,
                    columns,
                };
                let span = lines.span(range);
                text.replace_range(span.start as usize..span.end as usize, &new);
            }
            None => text = new,
        }
    }
    text
}

/// The range of a complete text.
pub fn full_range(lines: TextLines) -> Range {
    Range {
        start: Position::default(),
        end: lines.position(lines.text.len() as u32),
    }
}

/// The files of the workspace, overlaid with the open documents.
#[derive(Clone)]
pub struct OpenFiles {
    /// The files that are not open.
    pub others: Arc<dyn Workspace>,
    /// The open documents by path.
    pub open: Arc<BTreeMap<PathBuf, Arc<TextBuffer>>>,
}

impl OpenFiles {
    /// The names in a folder that only the editor knows: those of unsaved documents, and of folders with some.
    fn unsaved(&self, folder: &Path) -> BTreeSet<&str> {
        let inside = self
            .open
            .range::<Path, _>((Bound::Included(folder), Bound::Unbounded));
        let inside = inside.map(|(path, _)| path);
        let inside = inside.take_while(|path| path.starts_with(folder));
        let names = inside.filter_map(|path| {
            let name = path.strip_prefix(folder).ok()?.components().next()?;
            name.as_os_str().to_str()
        });
        let is_saved = |name: &str| self.others.saved().entry(&folder.join(name)).is_some();
        names.filter(|name| !is_saved(name)).collect()
    }
}

impl Files for OpenFiles {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        match self.open.get(path) {
            Some(buffer) => Ok(buffer.text.clone()),
            None => self.others.saved().load(path),
        }
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        match self.open.contains_key(path) {
            true => Some(FileType::File),
            false => self.others.saved().entry(path).or_else(|| {
                let is_folder = !self.unsaved(path).is_empty();
                is_folder.then_some(FileType::Folder)
            }),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let mut names = self.others.saved().names(folder);
        names.extend(self.unsaved(folder).into_iter().map(str::to_string));
        names
    }

    fn here(&self) -> &Path {
        self.others.saved().here()
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        match self.open.contains_key(path) {
            true => Some(path.to_path_buf()),
            false => self.others.saved().real(path),
        }
    }

    fn version(&self, path: &Path) -> Option<u64> {
        match self.open.get(path) {
            // Never equal to a version of a file on disk.
            Some(buffer) => Some(buffer.state.wrapping_mul(0x9e37_79b9_7f4a_7c15)),
            None => {
                let version = self.others.saved().version(path)?;
                let names = self.unsaved(path);
                if names.is_empty() {
                    return Some(version);
                }
                let mut hasher = DefaultHasher::new();
                (version, names).hash(&mut hasher);
                Some(hasher.finish())
            }
        }
    }
}
