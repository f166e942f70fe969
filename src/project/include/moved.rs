//! The include paths that change when files are moved.

use super::find::EXTENSIONS;
use crate::access::FileAccess;
use crate::files::FileType;
use crate::files::scan::scan;
use shaderlint_detect::embed::{DocumentLanguage, extract_named, strings};
use shaderlint_detect::kind::file_extension;
use shaderlint_text::path::{plain, relative, slashed, tidy};
use shaderlint_text::{Edit, Span};
use std::path::{Path, PathBuf};

/// Files and folders that are moved.
pub struct FileMoves(Vec<(PathBuf, PathBuf)>);

impl FileMoves {
    /// Pairs of an absolute path and the one that replaces it.
    pub fn new(all: Vec<(PathBuf, PathBuf)>) -> FileMoves {
        FileMoves(all)
    }

    /// The path of a file after the moves.
    fn after(&self, path: &Path) -> PathBuf {
        let moved = self.0.iter().find_map(|(old, new)| {
            let rest = path.strip_prefix(old).ok()?;
            Some(match rest.as_os_str().is_empty() {
                true => new.clone(),
                false => new.join(rest),
            })
        });
        moved.unwrap_or_else(|| path.to_path_buf())
    }
}

/// The edits after which a file includes the same files as before the moves. `name` is its absolute
/// path before.
pub fn moved_includes(name: &str, text: &str, context: FileAccess, moves: &FileMoves) -> Vec<Edit> {
    let file = MovedFile {
        name,
        context,
        moves,
    };
    let Some(language) = DocumentLanguage::of_extension(&file_extension(name)) else {
        return file.directives(text, 0);
    };
    let mut edits = Vec::new();
    for shader in extract_named(name, language, text) {
        edits.extend(file.directives(&shader.code, shader.start));
    }
    for range in strings(language, text) {
        let written = text.get(range.clone()).unwrap_or("");
        if let Some(path) = file.imported(written) {
            let span = Span::new(range.start as u32, range.end as u32);
            edits.push(Edit::replace(span, path));
        }
    }
    edits
}

struct MovedFile<'a> {
    name: &'a str,
    context: FileAccess<'a>,
    moves: &'a FileMoves,
}

impl MovedFile<'_> {
    /// The edits of the include directives in some code.
    fn directives(&self, code: &str, base: usize) -> Vec<Edit> {
        let directives = scan(code).directives.into_iter();
        let edits = directives.filter_map(|directive| {
            let written = &directive.requested.path;
            let found = self.context.find(self.name, &directive.requested).ok()?;
            let here = self.context.files.here();
            let (folder, target) = (here.join(&found.folder), here.join(&found.name));
            let path = self.path(written, &plain(&folder), &plain(&target))?;
            let line = code.get(directive.start..directive.end)?;
            let start = base + directive.start + line.rfind(written.as_str())?;
            let span = Span::new(start as u32, (start + written.len()) as u32);
            Some(Edit::replace(span, path))
        });
        edits.collect()
    }

    /// The new path of a shader that a script imports or loads by a relative path.
    fn imported(&self, written: &str) -> Option<String> {
        let named = written.split('?').next()?;
        let is_shader = EXTENSIONS.contains(&file_extension(named).as_str());
        if !named.starts_with('.') || !is_shader {
            return None;
        }
        let folder = Path::new(self.name).parent()?;
        let target = plain(&folder.join(named));
        if self.context.files.entry(&target) != Some(FileType::File) {
            return None;
        }
        self.path(written, folder, &target)
    }

    /// The path after the moves, if it differs: `written` is relative to `folder` and leads to
    /// `target`.
    fn path(&self, written: &str, folder: &Path, target: &Path) -> Option<String> {
        let (named, query) = match written.find('?') {
            Some(at) => written.split_at(at),
            None => (written, ""),
        };
        let file = Path::new(self.name);
        let is_relative = file.parent() == Some(folder);
        let own = self.moves.after(file);
        let is_elsewhere = is_relative && own.parent() != file.parent();
        if self.moves.after(target) == target && !is_elsewhere {
            return None;
        }
        let rest = named.trim_start_matches(['/', '~']);
        let shown = self.shown(&plain(&folder.join(rest)), target);
        let beside = || relative(own.parent()?, &shown);
        let new = match shown.strip_prefix(folder) {
            Ok(inside) if !is_relative => {
                let lead = named.get(..named.len() - rest.len()).unwrap_or("");
                format!("{lead}{}", slashed(inside))
            }
            _ => match named.starts_with('.') || !is_relative {
                true => dotted(beside()?),
                false => beside()?,
            },
        };
        (tidy(Path::new(&new)) != tidy(Path::new(named))).then(|| format!("{new}{query}"))
    }

    /// What the path leads to after the moves. `asked` is the target, without its extension or its
    /// name if the path leaves them out.
    fn shown(&self, asked: &Path, target: &Path) -> PathBuf {
        let after = self.moves.after(target);
        if asked == target {
            return after;
        }
        if target.starts_with(asked) {
            let folder = self.moves.after(asked);
            return if after.starts_with(&folder) {
                folder
            } else {
                after
            };
        }
        match after.extension() == target.extension() {
            true => after.with_extension(""),
            false => after,
        }
    }
}

/// A path that starts with `./` or `../`.
fn dotted(path: String) -> String {
    match path.starts_with('.') {
        true => path,
        false => format!("./{path}"),
    }
}
