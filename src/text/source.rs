//! Files and the address space they share.

use super::{LineIndex, Position, Span};
use std::sync::{Arc, OnceLock};

/// Index of a file in its [`Sources`], or of a piece of one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FileId(pub u32);

impl FileId {
    /// Whether it is a file, and not a piece of one.
    pub fn is_whole(self) -> bool {
        self.0 & PIECE == 0
    }
}

/// Whose text a file holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// Written by the user: diagnostics point here.
    User,
    /// Put before the user's text by a host (the ShaderToy player's header): never pointed at.
    Prelude,
}

/// One file, or one pass of a ShaderToy export.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Path as the user gave it, with forward slashes.
    pub path: String,
    /// Name of the pass, if the file is an export that holds several.
    pub part: Option<String>,
    /// Whose text it is.
    pub role: Role,
    /// The text itself.
    pub text: Arc<str>,
    /// Address of the first byte.
    pub base: u32,
    lines: OnceLock<LineIndex>,
}

impl SourceFile {
    /// All of the file's addresses.
    pub fn span(&self) -> Span {
        Span::new(self.base, self.base + self.text.len() as u32)
    }

    /// Its line starts, found at the first call.
    pub fn lines(&self) -> &LineIndex {
        self.lines.get_or_init(|| LineIndex::new(&self.text))
    }

    /// Line and columns of an address in this file; addresses outside are moved to its nearer end.
    pub fn position(&self, address: u32) -> Position {
        let offset = address
            .saturating_sub(self.base)
            .min(self.text.len() as u32);
        self.lines().position(&self.text, offset)
    }
}

/// Set in the index of a piece.
const PIECE: u32 = 1 << 31;

/// A stretch of a file as the compiler reads it: a shader inside a page, a script or a text.
#[derive(Clone, Debug)]
struct SourcePiece {
    /// The file.
    file: FileId,
    /// Address of its first byte.
    base: u32,
    /// What the compiler reads, byte for byte in the place of the file's own text.
    code: Arc<str>,
    /// The highest address in this piece and all pieces before it.
    reach: u32,
}

/// What the compiler reads of a file or a piece of one.
#[derive(Clone, Copy, Debug)]
pub struct CompiledText<'a> {
    /// The text.
    pub text: &'a str,
    /// Address of its first byte.
    pub base: u32,
    /// Whose text it is.
    pub role: Role,
}

/// The files of one shader in one address space.
///
/// Each file starts one past the end of the one before, so that the place behind a file's last
/// character differs from the place before the next file's first.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<SourceFile>,
    pieces: Vec<SourcePiece>,
    /// Whether the pieces are not in the order of the text.
    is_shuffled: bool,
}

impl Sources {
    /// No file yet.
    pub fn new() -> Sources {
        Sources::default()
    }

    /// Adds a file behind those that are there.
    ///
    /// Returns `None`, and adds nothing, when the address space of 4 GiB is full.
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
            lines: OnceLock::new(),
        });
        Some(id)
    }

    /// Names the piece of a file that starts at this offset and that the compiler reads as `code`,
    /// which is as long as the piece. Places in it are places in the file.
    ///
    /// Returns `None` where the file has no such piece.
    pub fn embed(
        &mut self,
        file: FileId,
        offset: usize,
        code: impl Into<Arc<str>>,
    ) -> Option<FileId> {
        let code = code.into();
        let whole = self.file(file)?;
        whole.text.get(offset..offset.checked_add(code.len())?)?;
        let base = whole.base + offset as u32;
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

    /// What the compiler reads of a file, or of a piece of one.
    pub fn code(&self, id: FileId) -> Option<CompiledText<'_>> {
        if id.is_whole() {
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

    /// The piece that holds an address, or else its file.
    pub fn code_at(&self, address: u32) -> Option<CompiledText<'_>> {
        // Pieces are mostly named in the order of the text: those behind are left out at once, and
        // nothing is looked for where no piece before reaches.
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

    /// Every file, in the order of addresses.
    pub fn files(&self) -> &[SourceFile] {
        &self.files
    }

    /// The file with this index, if there is one.
    pub fn file(&self, id: FileId) -> Option<&SourceFile> {
        self.files.get(id.0 as usize)
    }

    /// Index of the file that holds an address.
    pub fn file_id_at(&self, address: u32) -> Option<FileId> {
        let after = self.files.partition_point(|f| f.base <= address);
        after.checked_sub(1).map(|i| FileId(i as u32))
    }

    /// The file that holds an address.
    pub fn file_at(&self, address: u32) -> Option<&SourceFile> {
        self.file_id_at(address).and_then(|id| self.file(id))
    }

    /// Whether the user wrote what stands at an address, and no host put it there.
    pub fn is_user(&self, address: u32) -> bool {
        self.file_at(address).is_some_and(|f| f.role == Role::User)
    }

    /// The text under a span; empty where the span leaves its file or splits a character.
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
    fn an_address_names_its_file() {
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
