//! Replaces `#include <name>` by what the host inserts there.

use shaderlint_host::Preset;
use shaderlint_project::{IncludedChunk, chunks_in};
use shaderlint_text::{FileId, Role, Sources};

/// Maximum number of chunks in a shader.
const MAX_CHUNKS: usize = 256;

/// A text with the chunks of its host.
pub struct ExpandedText {
    /// The files to compile, in order.
    pub files: Vec<FileId>,
    /// Whether chunks were inserted.
    pub has_chunks: bool,
    /// Whether a chunk is not known.
    pub is_open: bool,
    /// Names that chunks declare in other releases of the host.
    pub once: Vec<String>,
}

impl ExpandedText {
    /// A text without chunks.
    pub fn of(files: &[FileId]) -> ExpandedText {
        ExpandedText {
            files: files.to_vec(),
            has_chunks: false,
            is_open: false,
            once: Vec::new(),
        }
    }
}

/// Inserts the chunks of a host into a text. `None` if the address space is full.
pub fn with_chunks(sources: &mut Sources, files: &[FileId], host: &Preset) -> Option<ExpandedText> {
    let mut expansion = ChunkExpansion {
        sources,
        host,
        left: MAX_CHUNKS,
        found: ExpandedText::of(&[]),
    };
    files.iter().try_for_each(|file| expansion.file(*file))?;
    Some(expansion.found)
}

struct ChunkExpansion<'s> {
    sources: &'s mut Sources,
    host: &'s Preset,
    left: usize,
    found: ExpandedText,
}

impl ChunkExpansion<'_> {
    fn file(&mut self, id: FileId) -> Option<()> {
        let code = self.sources.code(id)?;
        let all = match code.role {
            Role::User => chunks_in(code.text),
            Role::Prelude => Vec::new(),
        };
        if all.is_empty() {
            self.found.files.push(id);
            return Some(());
        }
        let (text, base) = (code.text.to_string(), code.base);
        let file = self.sources.file_id_at(base)?;
        let offset = (base - self.sources.file(file)?.base) as usize;
        let mut done = 0;
        for IncludedChunk { range, name } in all {
            let Some(inserted) = self.chunk(&name) else {
                self.found.is_open = true;
                continue;
            };
            let before = text.get(done..range.start)?;
            self.found
                .files
                .push(self.sources.embed(file, offset + done, before)?);
            let path = format!("<{name}>");
            let id = self.sources.add(path, None, Role::Prelude, inserted)?;
            self.found.files.push(id);
            self.found.has_chunks = true;
            done = range.end;
        }
        let rest = self.sources.embed(file, offset + done, text.get(done..)?)?;
        self.found.files.push(rest);
        Some(())
    }

    /// The code of a chunk with the chunks in it.
    fn chunk(&mut self, name: &str) -> Option<String> {
        let chunk = self.host.chunk(name)?;
        self.left = self.left.checked_sub(1)?;
        self.found
            .once
            .extend(chunk.once.iter().map(ToString::to_string));
        let mut code = String::new();
        let mut done = 0;
        for IncludedChunk { range, name } in chunks_in(&chunk.code) {
            code.push_str(chunk.code.get(done..range.start)?);
            code.push_str(&self.chunk(&name).unwrap_or_default());
            done = range.end;
        }
        code.push_str(chunk.code.get(done..)?);
        Some(code)
    }
}
