//! Companion files that a shader refers to: includes, buffers and its vertex shader.

use super::read::read_text;
use crate::cli::config::project_root;
use crate::project::{Project, SiblingTexts};
use crate::text::path::slashed;
use std::path::{Path, PathBuf};

/// The largest number of companion files.
const MAX_TEXTS: usize = 256;

/// Drafts a project again until all companion files that it asks for have been read. The texts are
/// kept in `siblings`.
pub(super) fn draft_with_siblings(
    path: &Path,
    siblings: &mut SiblingTexts,
    draft: impl Fn(&SiblingTexts) -> Result<Project, String>,
) -> Result<Project, String> {
    loop {
        let project = draft(siblings)?;
        if project
            .requested
            .iter()
            .all(|path| siblings.contains_key(path))
        {
            return Ok(project);
        }
        read_requested(path, &project.requested, siblings)
            .map_err(|e| format!("{}: {e}", slashed(path)))?;
    }
}

/// Reads companion files. Files outside of the shader's project are rejected, as in checks.
fn read_requested(
    path: &Path,
    requested: &[String],
    texts: &mut SiblingTexts,
) -> Result<(), String> {
    let folder = folder_of(path);
    let here = folder.canonicalize();
    let root = project_root(path).unwrap_or_else(|| folder.to_path_buf());
    let root = root.canonicalize();
    let is_stdin = path.as_os_str() == "-";
    for asked in requested {
        if texts.contains_key(asked) {
            continue;
        }
        if texts.len() >= MAX_TEXTS {
            return Err(format!("the shader includes more than {MAX_TEXTS} files"));
        }
        let found = match &here {
            Ok(here) if !is_stdin => here.join(asked).canonicalize().ok(),
            _ => None,
        };
        let is_inside = |file: &PathBuf| root.as_ref().is_ok_and(|root| file.starts_with(root));
        let text = match found {
            Some(file) if !is_inside(&file) => {
                return Err(format!("`{asked}` is outside of the project"));
            }
            Some(file) if file.is_file() => Some(read_text(&folder.join(asked))?.into()),
            _ => None,
        };
        texts.insert(asked.clone(), text);
    }
    Ok(())
}

/// The folder of a file.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    /// Drafts a shader that includes a file. Returns the notes or the error.
    fn draft(folder: &Path, include: &str) -> Result<Vec<String>, String> {
        let code = format!(
            "#include \"{include}\"\nvoid mainImage(out vec4 c, in vec2 p) {{ c = vec4(1.0); }}\n"
        );
        let path = folder.join("in/x.glsl");
        fs::write(&path, &code).unwrap();
        let draft = |siblings: &SiblingTexts| {
            Project::draft_with_siblings("x", &code, None, siblings).map_err(|e| e.to_string())
        };
        draft_with_siblings(&path, &mut SiblingTexts::new(), draft).map(|project| project.notes)
    }

    #[test]
    fn files_outside_of_the_folder_are_not_read() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir_all(folder.path().join("in/deep")).unwrap();
        fs::write(
            folder.path().join("in/deep/a.glsl"),
            "#include \"b.glsl\"\n",
        )
        .unwrap();
        fs::write(
            folder.path().join("in/deep/b.glsl"),
            "const float B = 1.0;\n",
        )
        .unwrap();
        fs::write(folder.path().join("secret.glsl"), "no").unwrap();
        let missing = draft(folder.path(), "deep/a.glsl").unwrap();
        assert_eq!(missing.len(), 1, "{missing:?}");
        let missing = draft(folder.path(), "gone.glsl").unwrap();
        assert!(
            missing.contains(&"`gone.glsl` was not found".to_string()),
            "{missing:?}"
        );
        let out = draft(folder.path(), "deep/../../secret.glsl").unwrap_err();
        assert!(
            out.contains("`../secret.glsl` is outside of the project"),
            "{out}"
        );
        fs::write(folder.path().join("package.json"), "{}").unwrap();
        let inside = draft(folder.path(), "deep/../../secret.glsl").unwrap();
        assert_eq!(inside.len(), 1, "{inside:?}");
    }
}
