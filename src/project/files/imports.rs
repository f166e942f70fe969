//! What scripts import.

use super::Files;
use super::repository::visit;
use super::words::is_glsl;
use rustc_hash::FxHashMap;
use shaderlint_detect::embed::DocumentLanguage;
use shaderlint_detect::kind::file_extension;
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
    vec![tidy(&top.join(rest)), tidy(&top.join("src").join(rest))]
}

/// The shader files that a script may import.
pub fn imported_shaders(text: &str, script: &Path, top: &Path) -> Vec<PathBuf> {
    let is_shader = |path: &&str| is_glsl(&file_extension(path.split('?').next().unwrap_or("")));
    let all = imports(text).into_iter().filter(is_shader);
    all.flat_map(|path| meant(path, script, top)).collect()
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
                Some(DocumentLanguage::Script | DocumentLanguage::Component)
            )
        };
        visit(root, files, is_script, &mut |path| {
            let Ok(text) = files.load(&path) else {
                return 0;
            };
            if names_shader(&text) {
                for shader in imported_shaders(&text, &path, root) {
                    found.0.entry(shader).or_default().push(path.clone());
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

/// Whether a text contains a dot and the extension of a shader file.
fn names_shader(text: &str) -> bool {
    text.split('.').skip(1).any(|after| {
        let end = after.find(|c: char| !c.is_ascii_alphanumeric());
        after.get(..end.unwrap_or(after.len())).is_some_and(is_glsl)
    })
}
