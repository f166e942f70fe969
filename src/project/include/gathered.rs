//! A shader and what it includes as one text, for whoever compiles or writes it.

use super::{MissingInclude, Spreader};
use crate::access::FileAccess;
use shaderlint_text::{FileId, Role, Sources, TextPiece};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A shader and what it includes, as one text.
#[derive(Clone, Default, Debug)]
pub struct GatheredText {
    /// The text.
    pub text: Arc<str>,
    /// The files that its lines are from; empty if it is one file.
    pub pieces: Vec<TextPiece>,
    /// The files that were included.
    pub read: Vec<PathBuf>,
    /// The includes that were not found.
    pub missing: Vec<MissingInclude>,
}

impl GatheredText {
    /// The same, if its own first line is this one of its file.
    pub fn from_line(mut self, line: u32) -> GatheredText {
        if self.pieces.is_empty() {
            self.pieces.push(TextPiece {
                start: 1,
                file: String::new(),
                line: 1,
            });
        }
        for piece in self.pieces.iter_mut().filter(|piece| piece.file.is_empty()) {
            piece.line += line - 1;
        }
        self
    }

    /// A text that includes nothing.
    pub fn of(text: impl Into<Arc<str>>) -> GatheredText {
        GatheredText {
            text: text.into(),
            ..GatheredText::default()
        }
    }
}

/// The shader `text` with the files that its directives name, except for `common` and what that
/// includes: it is put before the shader. `None` if it is too large.
pub fn gather(
    name: &str,
    text: &str,
    common: Option<&Path>,
    access: FileAccess,
) -> Option<GatheredText> {
    let mut sources = Arc::new(Sources::new());
    let own = Arc::make_mut(&mut sources).add(name, None, Role::User, text)?;
    let mut spreader = Spreader::new(&mut sources, name, access);
    spreader.keeps_chunks = true;
    if let Some(common) = common.and_then(|path| access.load(path).ok()) {
        spreader.put_beside(common, false)?;
        spreader.found.files.clear();
        spreader.found.missing.clear();
    }
    spreader.shader(name, own, text)?;
    let found = spreader.found;
    let mut gathered = GatheredText {
        missing: found.missing,
        ..GatheredText::of(text)
    };
    if found.files != [own] {
        let files = sources.files().iter().skip(1);
        let files = files.filter(|file| file.role == Role::User);
        gathered.read = files.map(|file| PathBuf::from(&file.path)).collect();
        (gathered.text, gathered.pieces) = joined(&sources, &found.files, own)?;
    }
    Some(gathered)
}

/// Joins the pieces of files. A line belongs to the file that its first character is from.
fn joined(sources: &Sources, files: &[FileId], own: FileId) -> Option<(Arc<str>, Vec<TextPiece>)> {
    let mut text = String::new();
    let mut lines = 0;
    let mut pieces: Vec<TextPiece> = Vec::new();
    for id in files {
        let code = sources.code(*id)?;
        let file = sources
            .file_id_at(code.base)
            .filter(|_| code.role == Role::User);
        let mut code_line = 1;
        let mut rest = code.text;
        if let Some(file) = file.and_then(|id| sources.file(id)) {
            code_line = file.position(code.base).line;
        }
        if !text.is_empty() && !text.ends_with('\n') {
            // The rest of a line after an include continues the last line of the included file.
            let end = rest.find('\n').map_or(rest.len(), |at| at + 1);
            let (first, after) = rest.split_at_checked(end)?;
            text.push_str(first);
            lines += u32::from(first.ends_with('\n'));
            (rest, code_line) = (after, code_line + 1);
        }
        if rest.is_empty() {
            continue;
        }
        if let Some(file) = file {
            pieces.push(TextPiece {
                start: lines + 1,
                file: match file == own {
                    true => String::new(),
                    false => sources.file(file)?.path.clone(),
                },
                line: code_line,
            });
        }
        text.push_str(rest);
        lines += rest.matches('\n').count() as u32;
    }
    Some((text.into(), pieces))
}
