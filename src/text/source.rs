//! Files and their common address space.

use super::{LineIndex, Position, Span};
use std::sync::{Arc, OnceLock};

/// Index of a file in its [`Sources`], or of an embedded piece.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FileId(pub u32);

impl FileId {
    /// Whether it is a file, and not an embedded piece.
    pub fn is_file(self) -> bool {
        self.0 & PIECE == 0
    }
}

/// The origin of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Written by the user; diagnostics point to it.
    User,
    /// Added by a host, such as the header of ShaderToy's player; diagnostics never point to it.
    Prelude,
}

/// Lines of a text that are from one file, up to the next piece.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TextPiece {
    /// Its first line in the text, from 1.
    pub start: u32,
    /// Path of the file as in messages; empty for the text's own file.
    pub file: String,
    /// Its first line in the file, from 1.
    pub line: u32,
}

/// One file, or one pass of a ShaderToy export.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Path as given by the user, with forward slashes.
    pub path: String,
    /// Name of the pass, if the file is an export with several passes.
    pub part: Option<String>,
    /// Origin of the text.
    pub role: Role,
    /// Contents of the file.
    pub text: Arc<str>,
    /// Address of the first byte.
    pub base: u32,
    /// The files that the text was put together from, if several.
    pub pieces: Vec<TextPiece>,
    lines: OnceLock<LineIndex>,
}

impl SourceFile {
    /// The address range of the file.
    pub fn span(&self) -> Span {
        Span::new(self.base, self.base + self.text.len() as u32)
    }

    /// The line offsets, computed on first use.
    pub fn lines(&self) -> &LineIndex {
        self.lines.get_or_init(|| LineIndex::new(&self.text))
    }

    /// The file that a line is from, and its line there.
    pub fn origin(&self, line: u32) -> (&str, u32) {
        let after = self.pieces.partition_point(|piece| piece.start <= line);
        let piece = after.checked_sub(1).and_then(|at| self.pieces.get(at));
        let Some(piece) = piece else {
            return (&self.path, line);
        };
        let path = match piece.file.as_str() {
            "" => &self.path,
            file => file,
        };
        (path, piece.line + line - piece.start)
    }

    /// The position of an address in the file that it is from, as messages show it.
    pub fn shown_position(&self, address: u32) -> Position {
        let position = self.position(address);
        let (_, line) = self.origin(position.line);
        Position { line, ..position }
    }

    /// The path of the file that an address is from.
    pub fn shown_path(&self, address: u32) -> &str {
        self.origin(self.position(address).line).0
    }

    /// Line and columns of an address in this file; addresses outside are clamped.
    pub fn position(&self, address: u32) -> Position {
        let offset = address
            .saturating_sub(self.base)
            .min(self.text.len() as u32);
        self.lines().position(&self.text, offset)
    }
}

/// Set in the index of an embedded piece.
const PIECE: u32 = 1 << 31;

/// An embedded piece of a file: a shader in a page, script or document.
#[derive(Clone, Debug)]
struct SourcePiece {
    file: FileId,
    /// Address of its first byte.
    base: u32,
    /// Code to compile, with the same length as in the file.
    code: Arc<str>,
    /// The highest address in this and all previous pieces.
    reach: u32,
}

/// The code to compile of a file or of an embedded piece.
#[derive(Clone, Copy, Debug)]
pub struct CompiledText<'a> {
    /// Code of the file or piece.
    pub text: &'a str,
    /// Address of its first byte.
    pub base: u32,
    /// Origin of the text.
    pub role: Role,
}

/// The files of a shader in one address space.
///
/// Consecutive files are separated by one address, so that the end of a file differs from the start
/// of the next.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<SourceFile>,
    pieces: Vec<SourcePiece>,
    /// Whether the pieces are not sorted by address.
    is_shuffled: bool,
}

impl Sources {
    /// Creates an empty set of files.
    pub fn new() -> Sources {
        Sources::default()
    }

    /// Adds a file.
    ///
    /// Returns `None`, and adds nothing, if the address space of 4 GiB is exhausted.
    pub fn add(
        &mut self,
        path: impl Into<String>,
        part: Option<String>,
        role: Role,
        text: impl Into<Arc<str>>,
    ) -> Option<FileId> {
        let text = text.into();
        let base = self.files.last().map_or(0, |f| f.span().end + 1);
        let end = base as u64 + text.len() as u64 + 1;
        if end > u32::MAX as u64 {
            return None;
        }
        let id = FileId(self.files.len() as u32);
        self.files.push(SourceFile {
            path: path.into(),
            part,
            role,
            text,
            base,
            pieces: Vec::new(),
            lines: OnceLock::new(),
        });
        Some(id)
    }

    /// Sets the files that a text was put together from.
    pub fn set_pieces(&mut self, id: FileId, pieces: &[TextPiece]) {
        if let Some(file) = self.files.get_mut(id.0 as usize) {
            file.pieces = pieces.to_vec();
        }
    }

    /// Adds an embedded piece of a file that starts at this offset, with code of the same length.
    /// Addresses in it are addresses in the file.
    ///
    /// Returns `None` if the file has no such piece.
    pub fn embed(
        &mut self,
        file: FileId,
        offset: usize,
        code: impl Into<Arc<str>>,
    ) -> Option<FileId> {
        let code = code.into();
        let parent = self.file(file)?;
        parent.text.get(offset..offset.checked_add(code.len())?)?;
        let base = parent.base + offset as u32;
        let id = FileId(PIECE | self.pieces.len() as u32);
        let last = self.pieces.last();
        self.is_shuffled |= last.is_some_and(|p| p.base > base);
        let reach = last.map_or(0, |p| p.reach);
        let reach = reach.max(base + code.len() as u32);
        self.pieces.push(SourcePiece {
            file,
            base,
            code,
            reach,
        });
        Some(id)
    }

    /// The code to compile of a file or a piece.
    pub fn code(&self, id: FileId) -> Option<CompiledText<'_>> {
        if id.is_file() {
            let file = self.file(id)?;
            return Some(CompiledText {
                text: &file.text,
                base: file.base,
                role: file.role,
            });
        }
        let piece = self.pieces.get((id.0 & !PIECE) as usize)?;
        Some(CompiledText {
            text: &piece.code,
            base: piece.base,
            role: self.file(piece.file)?.role,
        })
    }

    /// The code of the piece that contains an address, or of its file.
    pub fn code_at(&self, address: u32) -> Option<CompiledText<'_>> {
        // Pieces usually are sorted, so a binary search skips the later ones, and `reach` ends the
        // search early.
        let from = match self.is_shuffled {
            false => self.pieces.partition_point(|p| p.base <= address),
            true => self.pieces.len(),
        };
        let before = self.pieces.get(..from).unwrap_or(&[]);
        let near = before.iter().enumerate().rev();
        let holds = |p: &SourcePiece| (p.base..=p.base + p.code.len() as u32).contains(&address);
        let piece = near
            .take_while(|(_, p)| p.reach >= address)
            .find(|(_, p)| holds(p));
        match piece.map(|(index, _)| index) {
            Some(index) => self.code(FileId(PIECE | index as u32)),
            None => self.code(self.file_id_at(address)?),
        }
    }

    /// All files in order of addresses.
    pub fn files(&self) -> &[SourceFile] {
        &self.files
    }

    /// The file with this index.
    pub fn file(&self, id: FileId) -> Option<&SourceFile> {
        self.files.get(id.0 as usize)
    }

    /// Index of the file that contains an address.
    pub fn file_id_at(&self, address: u32) -> Option<FileId> {
        let after = self.files.partition_point(|f| f.base <= address);
        after.checked_sub(1).map(|i| FileId(i as u32))
    }

    /// The file that contains an address.
    pub fn file_at(&self, address: u32) -> Option<&SourceFile> {
        self.file_id_at(address).and_then(|id| self.file(id))
    }

    /// Whether the text at an address was written by the user.
    pub fn is_user(&self, address: u32) -> bool {
        self.file_at(address).is_some_and(|f| f.role == Role::User)
    }

    /// The code before an address in its text, and from there on; empty if there is none.
    pub fn around(&self, address: u32) -> (&str, &str) {
        let code = self.code_at(address);
        let parts = code.and_then(|code| {
            let at = (address - code.base) as usize;
            code.text.split_at_checked(at)
        });
        parts.unwrap_or_default()
    }

    /// The text of a span; empty if the span leaves its file or splits a character.
    pub fn text(&self, span: Span) -> &str {
        self.file_at(span.start)
            .and_then(|f| {
                f.text
                    .get((span.start - f.base) as usize..(span.end.checked_sub(f.base)?) as usize)
            })
            .unwrap_or("")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_identify_their_file() {
        let mut sources = Sources::new();
        let a = sources.add("a", None, Role::User, "one").unwrap();
        let b = sources.add("b", None, Role::User, "two").unwrap();
        assert_eq!(sources.file_id_at(0), Some(a));
        assert_eq!(
            sources.file_id_at(3),
            Some(a),
            "the place behind the last character"
        );
        assert_eq!(sources.file_id_at(4), Some(b));
        assert_eq!(sources.text(Span::new(5, 7)), "wo");
        let piece = sources.embed(b, 1, "W").unwrap();
        let code = sources.code(piece).unwrap();
        assert_eq!((code.text, code.base), ("W", 5));
        assert!(sources.embed(b, 2, "XY").is_none());
        assert_eq!(
            sources.text(Span::new(1, 6)),
            "",
            "a span over two files has no text"
        );
    }
}
