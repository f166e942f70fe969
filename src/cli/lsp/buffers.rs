//! The texts that are open in the editor, and the files around them.

use super::super::disk::Disk;
use super::position::{Columns, TextLines};
use super::uri::path_of;
use crate::engine::{FileType, Files, LoadError, Options};
use crate::ide::{Document, RunSeen};
use crate::text::LineIndex;
use gen_lsp_types::{Position, Range, TextDocumentContentChangeEvent, Uri};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// A text of an editor at a moment. A change makes another of it.
pub struct TextBuffer {
    /// Its address.
    pub uri: Uri,
    /// Its path; one that does not exist for a text that was never saved.
    pub path: String,
    /// The number that the client gives this state of it.
    pub version: i32,
    /// The text.
    pub text: Arc<str>,
    /// Its lines.
    pub lines: LineIndex,
    /// The number of this state among all states of all texts.
    pub state: u64,
    /// What the client takes it for.
    pub language: String,
    /// What is known of it without running it.
    document: OnceLock<Arc<Document>>,
    /// What came of running it, once that is done.
    pub ran: Arc<OnceLock<Ran>>,
    /// What running an earlier state has found.
    pub earlier: Option<(Arc<str>, Arc<OnceLock<Ran>>)>,
}

/// What came of running a text.
pub struct Ran {
    /// What is known of it, the findings of runs included.
    pub document: Arc<Document>,
    /// By shader: what was seen.
    pub seen: Vec<Option<RunSeen>>,
}

impl TextBuffer {
    /// A text that was just opened.
    pub fn new(uri: Uri, language: String, version: i32, text: String, state: u64) -> TextBuffer {
        let path = path_of(&uri).map(|path| path.to_string_lossy().replace('\\', "/"));
        // A text without a file stands alone, under a name that tells what it is.
        let path = path.unwrap_or_else(|| {
            let name: String = uri
                .0
                .chars()
                .map(|c| if c == ':' { '/' } else { c })
                .collect();
            let name = name.trim_start_matches('/');
            let has_ending = name.rsplit('/').next().is_some_and(|n| n.contains('.'));
            format!("/{name}{}", if has_ending { "" } else { ".glsl" })
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

    /// The same place with another text, or with other files around it.
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

    /// The text with its lines.
    pub fn lines(&self, columns: Columns) -> TextLines<'_> {
        TextLines {
            text: &self.text,
            index: &self.lines,
            columns,
        }
    }

    /// What is known of it.
    pub fn document(&self, options: &Arc<Options>, files: &dyn Files) -> &Arc<Document> {
        self.document.get_or_init(|| {
            let text = self.text.clone();
            Arc::new(Document::new(&self.path, text, options.clone(), files))
        })
    }

    /// What is known of it already.
    pub fn known(&self) -> Option<&Arc<Document>> {
        self.document.get()
    }
}

/// A text after changes.
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
            TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(whole) => {
                (None, whole.text)
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

/// The range of a whole text.
pub fn whole(lines: TextLines) -> Range {
    Range {
        start: Position::default(),
        end: lines.position(lines.text.len() as u32),
    }
}

/// The files of the disk, with the texts that are open in the place of theirs.
#[derive(Clone)]
pub struct OpenFiles {
    /// The disk.
    pub disk: Arc<Disk>,
    /// By path.
    pub open: Arc<BTreeMap<PathBuf, Arc<TextBuffer>>>,
}

impl Files for OpenFiles {
    fn load(&self, path: &Path) -> Result<Arc<str>, LoadError> {
        match self.open.get(path) {
            Some(buffer) => Ok(buffer.text.clone()),
            None => self.disk.load(path),
        }
    }

    fn entry(&self, path: &Path) -> Option<FileType> {
        match self.open.contains_key(path) {
            true => Some(FileType::File),
            false => self.disk.entry(path),
        }
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        self.disk.names(folder)
    }

    fn here(&self) -> &Path {
        self.disk.here()
    }

    fn real(&self, path: &Path) -> Option<PathBuf> {
        match self.open.contains_key(path) {
            true => Some(path.to_path_buf()),
            false => self.disk.real(path),
        }
    }

    fn version(&self, path: &Path) -> Option<u64> {
        match self.open.get(path) {
            // Apart from all that the disk gives.
            Some(buffer) => Some(buffer.state.wrapping_mul(0x9e37_79b9_7f4a_7c15)),
            None => self.disk.version(path),
        }
    }
}
