//! The code of an embedded shader, put together as its script does.

use shaderlint_detect::embed::{Embedded, InsertedPart, ModuleFile};
use shaderlint_text::{FileId, Role, Sources};
use std::collections::HashMap;
use std::sync::Arc;

/// The files to compile for a shader in a file, in order. `modules` are the files that were added for
/// the shaders before it. `None` if they are too large.
pub fn pieces(
    sources: &mut Sources,
    file: FileId,
    shader: &Embedded,
    modules: &mut HashMap<Arc<str>, FileId>,
) -> Option<Vec<FileId>> {
    let mut pieces = Pieces {
        sources,
        file,
        modules,
        found: Vec::new(),
    };
    pieces.add(Some(file), shader.start, &shader.code, &shader.inserted)?;
    if pieces.found.is_empty() {
        pieces.piece(Some(file), shader.start, "")?;
    }
    Some(pieces.found)
}

struct Pieces<'s> {
    sources: &'s mut Sources,
    file: FileId,
    modules: &'s mut HashMap<Arc<str>, FileId>,
    found: Vec<FileId>,
}

impl Pieces<'_> {
    /// Adds code that starts at an offset in a file, with what is inserted into it.
    fn add(
        &mut self,
        file: Option<FileId>,
        start: usize,
        code: &str,
        inserted: &[InsertedPart],
    ) -> Option<()> {
        let mut from = 0;
        for part in inserted {
            self.before(file, start + from, code.get(from..part.at.start)?)?;
            let inner = match (&part.module, part.start) {
                (_, None) => None,
                (None, Some(_)) => Some(self.file),
                (Some(module), Some(_)) => Some(self.module(module)?),
            };
            self.add(inner, part.start.unwrap_or(0), &part.code, &part.inserted)?;
            from = part.at.end;
        }
        self.before(file, start + from, code.get(from..)?)
    }

    fn before(&mut self, file: Option<FileId>, at: usize, code: &str) -> Option<()> {
        match code.is_empty() {
            true => Some(()),
            false => self.piece(file, at, code),
        }
    }

    fn piece(&mut self, file: Option<FileId>, at: usize, code: &str) -> Option<()> {
        self.found.push(match file {
            Some(file) => self.sources.embed(file, at, code)?,
            None => self.sources.add("", None, Role::Prelude, code)?,
        });
        Some(())
    }

    fn module(&mut self, module: &ModuleFile) -> Option<FileId> {
        if let Some(known) = self.modules.get(&module.path) {
            return Some(*known);
        }
        let path = module.path.to_string();
        let id = self
            .sources
            .add(path, None, Role::User, module.text.clone())?;
        self.modules.insert(module.path.clone(), id);
        Some(id)
    }
}
