//! What scripts import.

use super::words::is_glsl;
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
