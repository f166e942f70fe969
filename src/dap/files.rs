//! The files of a program, and the lines of its texts that come from them.

use super::debuggee::{Debuggee, ProgramSource};
use shaderlint_port::TextPiece;
use shaderlint_text::{FileId, Role, SourceFile};

/// The texts of a program, and where they are on disk.
pub struct ProgramFiles {
    texts: Vec<ProgramText>,
    /// The folder of the program.
    folder: String,
}

/// A text of a program.
struct ProgramText {
    id: FileId,
    /// Its path.
    path: String,
    /// The files that it was put together from.
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
        let first = own.clone().next().map_or("", |(_, file)| &file.path);
        let folder = first.rsplit_once('/').map_or("", |(folder, _)| folder);
        let texts = own.map(|(id, file)| {
            let pieces = debuggee.pieces(id);
            let is_same = || {
                programs
                    .text(&file.path)
                    .is_none_or(|text| text == *file.text)
            };
            ProgramText {
                id,
                path: file.path.clone(),
                is_virtual: file.part.is_some() || pieces.is_empty() && !is_same(),
                pieces: pieces.to_vec(),
            }
        });
        ProgramFiles {
            texts: texts.collect(),
            folder: folder.to_string(),
        }
    }

    /// The line of a file for a line of a text.
    pub fn line(&self, id: FileId, line: u32) -> Option<FileLine> {
        let text = self.texts.iter().find(|text| text.id == id)?;
        if text.is_virtual {
            return Some(FileLine::Virtual(id, line));
        }
        let after = text.pieces.partition_point(|piece| piece.start <= line);
        let piece = after.checked_sub(1).and_then(|at| text.pieces.get(at));
        Some(match piece {
            Some(piece) => FileLine::Disk(self.path(text, piece), piece.line + line - piece.start),
            None => FileLine::Disk(text.path.clone(), line),
        })
    }

    fn path(&self, text: &ProgramText, piece: &TextPiece) -> String {
        match (piece.file.as_str(), self.folder.as_str()) {
            ("", _) => text.path.clone(),
            (file, "") => file.to_string(),
            (file, folder) => format!("{folder}/{file}"),
        }
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
            let mut found: Vec<(FileId, u32, u32)> = text
                .pieces
                .iter()
                .zip(ends)
                .filter(|(piece, _)| is_it(&self.path(text, piece)) && piece.line <= line)
                .map(|(piece, end)| (text.id, piece.start + line - piece.line, end))
                .filter(|(_, at, end)| at <= end)
                .collect();
            if text.pieces.is_empty() && is_it(&text.path) {
                found.push((text.id, line, u32::MAX));
            }
            found
        })
    }

    /// The texts, as a client names them.
    pub fn all(&self) -> Vec<FileLine> {
        let mut all: Vec<FileLine> = Vec::new();
        for text in &self.texts {
            let starts = text.pieces.iter().map(|piece| piece.start);
            for start in starts.chain(text.pieces.is_empty().then_some(1)) {
                let found = match self.line(text.id, start) {
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
