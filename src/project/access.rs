//! What the files around a shader are found with.

use crate::files::file_cache::FileCache;
use crate::files::{Dependency, Files};
use shaderlint_host::Preset;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// How includes are resolved.
#[derive(Clone, Default, Debug)]
pub struct Includes {
    /// The absolute folder that includes may not leave, without symbolic links; empty for no limit.
    pub root: PathBuf,
    /// Folders that a leading `/` may refer to, nearest first.
    pub tops: Vec<PathBuf>,
    /// Folders that are searched after the folder of the file: `include_roots` of the
    /// configuration.
    pub roots: Vec<PathBuf>,
}

/// What the files around a shader are found with.
#[derive(Clone, Copy)]
pub struct FileAccess<'a> {
    /// Access to other files.
    pub files: &'a dyn Files,
    /// How includes are resolved.
    pub includes: &'a Includes,
    /// What earlier readers of the same files kept.
    pub cache: &'a FileCache,
    /// The host given by the user or by the configuration.
    pub host: Option<&'static Preset>,
    /// Whether files may be passes of ShaderToy.
    pub may_be_passes: bool,
    /// The names of the files that are checked in the same run.
    pub checked: &'a BTreeSet<String>,
}

impl FileAccess<'_> {
    /// Whether the file of this name is checked in the same run.
    pub fn is_checked(&self, name: &str) -> bool {
        self.files.depends_on(Dependency::Checked(name));
        self.checked.contains(name)
    }
}
