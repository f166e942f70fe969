//! The configurations of files on disk.

mod editor;

use super::disk::Disk;
use super::global::given;
use crate::engine::config::{ConfigArgs, Configs, ProjectLimit};
use crate::format::StyleChoice;
use crate::host::{Preset, host_named, kept, read as read_host};
use crate::text::path::plain;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The configurations of files on disk, or the one that the user names. Reads none yet.
pub fn configs(asked: ConfigArgs) -> Configs {
    let source = given().source();
    let asked = ConfigArgs { source, ..asked };
    Configs::new(Arc::new(Disk::new()), project_limit(), asked)
}

/// What limits the files of a project on disk.
pub fn project_limit() -> ProjectLimit {
    ProjectLimit::Folder {
        home: std::env::var_os("HOME").map(PathBuf::from),
    }
}

/// The formatting style of a file: from its configuration, otherwise from `.editorconfig`, and
/// otherwise `last`.
pub fn style(configs: &Configs, path: &Path, last: StyleChoice) -> Result<StyleChoice, Arc<str>> {
    configs.style(path, editor::choice(&absolute(path)).or(last))
}

/// The host that a user names: a built-in one, or a GLSL file that describes one.
///
/// # Errors
/// A message if the host is unknown or the file is invalid.
pub fn host_of(name: &str) -> Result<&'static Preset, String> {
    if !name.ends_with(".glsl") {
        return host_named(name);
    }
    let text = fs::read_to_string(name).map_err(|e| format!("{name}: {e}"))?;
    let own = read_host(&text).map_err(|e| format!("{name}:{}: {}", e.line, e.message))?;
    Ok(kept(own))
}

/// An absolute path without `..`, resolved lexically.
pub fn absolute(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    plain(&path)
}
