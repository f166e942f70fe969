//! Reads a configuration file.

use crate::engine::HostNames;
use crate::engine::config::{Config, parse};
use crate::host::read as read_host;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::project::absolute;

/// Why a configuration cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigProblem {
    /// The configuration file.
    pub file: PathBuf,
    /// Line and column in characters, from 1, if a place is wrong.
    pub at: Option<(u32, u32)>,
    /// Message without the place.
    pub message: String,
}

impl fmt::Display for ConfigProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let here = std::env::current_dir().unwrap_or_default();
        let shown = self.file.strip_prefix(here).unwrap_or(&self.file).display();
        match self.at {
            Some((line, column)) => write!(f, "{shown}:{line}:{column}: {}", self.message),
            None => write!(f, "{shown}: {}", self.message),
        }
    }
}

/// Reads and parses a configuration.
///
/// # Errors
/// If it cannot be read or is invalid, or if a file that it names is.
pub fn load(file: &Path) -> Result<Arc<Config>, ConfigProblem> {
    let problem = |at, message| ConfigProblem {
        file: file.to_path_buf(),
        at,
        message,
    };
    let text = fs::read_to_string(file).map_err(|e| problem(None, e.to_string()))?;
    let parsed = parse(&text);
    let mut config = parsed.map_err(|e| problem(Some((e.line, e.column)), e.message))?;
    let folder = absolute(file);
    config.root = folder.parent().unwrap_or(Path::new("/")).to_path_buf();
    let overrides = config.overrides.iter_mut().map(|(_, layer)| layer);
    for layer in std::iter::once(&mut config.base).chain(overrides) {
        if let Some(host) = &mut layer.host {
            describe(host, &config.root).map_err(|message| problem(None, message))?;
        }
    }
    Ok(Arc::new(config))
}

/// Reads the file that describes a host, in addition to its preset.
fn describe(host: &mut HostNames, root: &Path) -> Result<(), String> {
    let Some(path) = &host.prelude else {
        return Ok(());
    };
    let text = fs::read_to_string(root.join(path)).map_err(|e| format!("{path}: {e}"))?;
    let own = read_host(&text).map_err(|e| format!("{path}:{}: {}", e.line, e.message))?;
    host.describe(own);
    Ok(())
}
