//! What scripts import.

use super::Files;
use super::repository::visit;
use super::words::is_glsl;
use rustc_hash::FxHashMap;
use shaderlint_detect::embed::DocumentLanguage;
use shaderlint_text::path::tidy;
use std::path::{Path, PathBuf};

/// Maximum length of an import path in bytes.
const MAX_PATH: usize = 300;

/// The paths that a script imports or requires.
pub fn imports(script: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for word in ["from", "import", "require"] {
        for (at, _) in script.match_indices(word) {
            let after = script.get(at + word.len()..).unwrap_or("");
            let after = after.trim_start_matches([' ', '(', '\t']);
            let Some(quote) = after.chars().next().filter(|c| matches!(c, '"' | '\'')) else {
                continue;
            };
            let path = after.get(1..).unwrap_or("");
            let mut near = path.bytes().take(MAX_PATH);
            let end = near.position(|b| b == quote as u8 || b == b'\n');
            found.extend(end.and_then(|end| path.get(..end)));
        }
    }
    found
}

/// The files that the path in an import of a script may mean. A path that starts with a name is relative
/// to the root of the repository or to its folder `src`, as bundlers are usually configured.
pub fn meant(path: &str, script: &Path, top: &Path) -> Vec<PathBuf> {
    let path = path.split('?').next().unwrap_or("");
    let folder = script.parent().unwrap_or(Path::new(""));
    if path.starts_with('.') {
        return vec![tidy(&folder.join(path))];
    }
    let rest = path.trim_start_matches(['@', '~']).trim_start_matches('/');
    let mut all = vec![tidy(&top.join(rest)), tidy(&top.join("src").join(rest))];
    // What a page loads is relative to the page.
    let beside = tidy(&folder.join(path));
    if !all.contains(&beside) {
        all.push(beside);
    }
    all
}

/// The shader files that a script or page may import or load.
pub fn imported_shaders(text: &str, script: &Path, top: &Path) -> Vec<PathBuf> {
    let all = shader_paths(text).into_iter();
    all.flat_map(|path| meant(path, script, top)).collect()
}

/// The strings of a script that are paths of shader files, without a query.
fn shader_paths(text: &str) -> Vec<&str> {
    let ends = text.match_indices('.').filter_map(|(dot, _)| {
        let after = text.get(dot + 1..)?;
        let length = after.find(|c: char| !c.is_ascii_alphanumeric());
        let (extension, rest) = after.split_at_checked(length.unwrap_or(after.len()))?;
        let is_end = rest.starts_with(['"', '\'', '`', '?']);
        (is_end && is_glsl(extension)).then_some(dot + 1 + extension.len())
    });
    let path = |end: usize| {
        let from = text.floor_char_boundary(end.saturating_sub(MAX_PATH));
        let before = text.get(from..end)?;
        let start = before.rfind(['"', '\'', '`', '\n', ' ', '\\'])? + 1;
        let is_quoted = before.get(..start)?.ends_with(['"', '\'', '`']);
        before.get(start..).filter(|_| is_quoted)
    };
    ends.filter_map(path).collect()
}

/// By shader file: the scripts of a repository that import it.
#[derive(Default, Debug)]
pub struct ShaderImports(FxHashMap<PathBuf, Vec<PathBuf>>);

impl ShaderImports {
    /// Reads the scripts under a folder.
    pub fn under(root: &Path, files: &dyn Files) -> ShaderImports {
        let mut found = ShaderImports::default();
        let is_script = |extension: &str| {
            let language = DocumentLanguage::of_extension(extension);
            matches!(
                language,
                Some(
                    DocumentLanguage::Script | DocumentLanguage::Component | DocumentLanguage::Html
                )
            )
        };
        visit(root, files, is_script, &mut |path| {
            let Ok(text) = files.load(&path) else {
                return 0;
            };
            for shader in imported_shaders(&text, &path, root) {
                let all = found.0.entry(shader).or_default();
                if all.last() != Some(&path) {
                    all.push(path.clone());
                }
            }
            text.len()
        });
        found
    }

    /// The scripts that import a shader file.
    pub fn of(&self, file: &Path) -> &[PathBuf] {
        self.0.get(file).map_or(&[], Vec::as_slice)
    }
}
