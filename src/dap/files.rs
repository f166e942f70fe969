//! The files of a program, and the lines of its texts that come from them.

use super::debuggee::{Debuggee, ProgramSource};
use shaderlint_text::{FileId, Role, SourceFile, TextPiece};

/// The texts of a program, and where they are on disk.
pub struct ProgramFiles {
    texts: Vec<ProgramText>,
}

/// A text of a program.
struct ProgramText {
    id: FileId,
    /// The files that it was put together from, by path.
    pieces: Vec<TextPiece>,
    /// Whether it differs from its file, or has none.
    is_virtual: bool,
}

/// A line, as a client names it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum FileLine {
    /// A line of a file on disk.
    Disk(String, u32),
    /// A line of a text that has no file.
    Virtual(FileId, u32),
}

impl ProgramFiles {
    pub fn of(debuggee: &Debuggee, programs: &dyn ProgramSource) -> ProgramFiles {
        let program = debuggee.program();
        let files = program.map_or(&[][..], |p| p.sources.files());
        let own = (0..)
            .map(FileId)
            .zip(files)
            .filter(|(_, file)| file.role == Role::User);
        let texts = own.map(|(id, file)| {
            let starts = file.pieces.iter().map(|piece| piece.start);
            let starts = starts.chain(file.pieces.is_empty().then_some(1));
            let pieces = starts.map(|start| {
                let (file, line) = file.origin(start);
                TextPiece {
                    start,
                    file: file.to_string(),
                    line,
                }
            });
            let is_same = || {
                programs
                    .text(&file.path)
                    .is_none_or(|text| text == *file.text)
            };
            ProgramText {
                id,
                is_virtual: file.part.is_some() || file.pieces.is_empty() && !is_same(),
                pieces: pieces.collect(),
            }
        });
        ProgramFiles {
            texts: texts.collect(),
        }
    }

    /// The line of a file for a line of a text.
    pub fn line(&self, id: FileId, line: u32) -> Option<FileLine> {
        let text = self.texts.iter().find(|text| text.id == id)?;
        if text.is_virtual {
            return Some(FileLine::Virtual(id, line));
        }
        let after = text.pieces.partition_point(|piece| piece.start <= line);
        let piece = after.checked_sub(1).and_then(|at| text.pieces.get(at))?;
        let line = piece.line + line - piece.start;
        Some(FileLine::Disk(piece.file.clone(), line))
    }

    /// The texts that have a line of a file, with the line there and the last one of the same piece.
    pub fn texts_with<'f>(
        &'f self,
        programs: &'f dyn ProgramSource,
        (path, line): (&'f str, u32),
    ) -> impl Iterator<Item = (FileId, u32, u32)> + 'f {
        let path = programs.path(path);
        let is_it = move |known: &str| programs.path(known) == path;
        let texts = self.texts.iter().filter(|text| !text.is_virtual);
        texts.flat_map(move |text| {
            let ends = text.pieces.iter().skip(1).map(|next| next.start - 1);
            let ends = ends.chain([u32::MAX]);
            let pieces = text.pieces.iter().zip(ends);
            pieces
                .filter(|(piece, _)| is_it(&piece.file) && piece.line <= line)
                .map(|(piece, end)| (text.id, piece.start + line - piece.line, end))
                .filter(|(_, at, end)| at <= end)
                .collect::<Vec<_>>()
        })
    }

    /// The texts, as a client names them.
    pub fn all(&self) -> Vec<FileLine> {
        let mut all: Vec<FileLine> = Vec::new();
        for text in &self.texts {
            for piece in &text.pieces {
                let found = match self.line(text.id, piece.start) {
                    Some(FileLine::Disk(path, _)) => FileLine::Disk(path, 0),
                    Some(FileLine::Virtual(id, _)) => FileLine::Virtual(id, 0),
                    None => continue,
                };
                if !all.contains(&found) {
                    all.push(found);
                }
            }
        }
        all
    }
}

/// The name of a text: of its pass, or of its file.
pub fn title(file: &SourceFile) -> String {
    let name = file.path.rsplit('/').next().unwrap_or(&file.path);
    match &file.part {
        Some(part) => format!("{part} ({name})"),
        None => name.to_string(),
    }
}
