//! `shaderlint.toml` as data: what it says of files, and how it is read.

mod read;
mod schema;

pub use read::{ConfigError, parse};
pub use schema::schema;

use super::options::{Desktop, DialectChoice, HostNames};
use super::path::absolute;
use crate::diagnostic::Severity;
use crate::lint::{Failing, Target};
use globset::GlobSet;
use std::path::{Path, PathBuf};

/// What a configuration says of all files, or of those under some patterns.
#[derive(Clone, Default, Debug)]
pub struct Layer {
    /// What draws the shaders.
    pub target: Option<Target>,
    /// What the shaders are written for.
    pub dialect: Option<DialectChoice>,
    /// What the host declares.
    pub host: Option<HostNames>,
    /// What is said of shaders that WebGL does not compile.
    pub desktop: Option<Desktop>,
    /// Levels of rules, groups before single rules; `None` is off.
    pub levels: Vec<(RuleName, Option<Severity>)>,
    /// Rules whose findings fail the run, or do not, groups before single rules.
    pub failing: Vec<(RuleName, Failing)>,
    /// Numbers that rules go by.
    pub options: Vec<(RuleName, String, f64)>,
    /// Folders that `#include` searches behind that of the file, from the configuration's own.
    pub include_roots: Option<Vec<String>>,
}

/// Name of a rule, whose table is not printed.
pub type RuleName = &'static str;

/// A configuration.
#[derive(Default, Debug)]
pub struct Config {
    /// The folder that it stands in, which patterns count from.
    pub root: PathBuf,
    /// What holds for all files.
    pub base: Layer,
    /// What holds for some, the later over the earlier.
    pub overrides: Vec<(GlobSet, Layer)>,
    /// The files that folders are searched for, where it says so.
    pub include: Option<GlobSet>,
    /// What folders are not searched for.
    pub exclude: Option<GlobSet>,
}

impl Config {
    /// A path as patterns see it.
    fn inside(&self, path: &Path) -> PathBuf {
        let path = absolute(path);
        let inside = path.strip_prefix(&self.root).map(Path::to_path_buf);
        inside.unwrap_or(path)
    }

    /// Whether a file found in a folder is to be checked; `is_known` tells whether its ending is
    /// one of a shader.
    pub fn takes(&self, path: &Path, is_known: bool) -> bool {
        let path = self.inside(path);
        let included = self.include.as_ref();
        included.map_or(is_known, |i| i.is_match(&path)) && !self.is_excluded(&path)
    }

    /// Whether a pattern of `include` fits a file.
    pub fn names(&self, path: &Path) -> bool {
        let included = self.include.as_ref();
        included.is_some_and(|i| i.is_match(self.inside(path)))
    }

    /// Whether a file is left out even where it is named itself.
    pub fn leaves_out(&self, path: &Path) -> bool {
        self.is_excluded(&self.inside(path))
    }

    fn is_excluded(&self, path: &Path) -> bool {
        self.exclude.as_ref().is_some_and(|e| e.is_match(path))
    }

    /// Numbers of the overrides that hold for a file.
    pub fn layers(&self, path: &Path) -> Vec<usize> {
        let path = self.inside(path);
        let overrides = self.overrides.iter().enumerate();
        let matching = overrides.filter(|(_, (globs, _))| globs.is_match(&path));
        matching.map(|(i, _)| i).collect()
    }
}
