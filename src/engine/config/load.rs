//! Reads configurations, and keeps those that were valid last, for programs that must go on while one
//! is being edited.

use super::layer::Config;
#[cfg(feature = "cli")]
use super::read::parse;
use crate::options::HostNames;
use shaderlint_project::Files;
use shaderlint_text::path::plain;
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// Name of the configuration file.
pub const FILE: &str = "shaderlint.toml";

/// Why a configuration cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConfigProblem {
    /// Path of the configuration file.
    pub path: PathBuf,
    /// Line and column in characters, from 1, if a place is wrong.
    pub at: Option<(u32, u32)>,
    /// Message without the place.
    pub message: String,
}

impl ConfigProblem {
    /// The message with the place; the path is relative to a folder, if it is in it.
    pub fn shown(&self, here: &Path) -> String {
        let shown = self.path.strip_prefix(here).unwrap_or(&self.path).display();
        match self.at {
            Some((line, column)) => format!("{shown}:{line}:{column}: {}", self.message),
            None => format!("{shown}: {}", self.message),
        }
    }
}

/// Reads and parses a configuration.
///
/// # Errors
/// If it cannot be read or is invalid, or if a file that it names is.
pub fn load(files: &dyn Files, path: &Path) -> Result<Arc<Config>, ConfigProblem> {
    let problem = |at, message| ConfigProblem {
        path: path.to_path_buf(),
        at,
        message,
    };
    let text = files.load(path);
    let text = text.map_err(|e| problem(None, e.to_string()))?;
    let mut config = parsed(&text).map_err(|(at, message)| problem(Some(at), message))?;
    let file = plain(&files.here().join(path));
    config.root = file.parent().unwrap_or(Path::new("/")).to_path_buf();
    let overrides = config.overrides.iter_mut().map(|(_, layer)| layer);
    for layer in std::iter::once(&mut config.base).chain(overrides) {
        if let Some(host) = &mut layer.host {
            describe(files, host, &config.root).map_err(|message| problem(None, message))?;
        }
    }
    Ok(Arc::new(config))
}

#[cfg(feature = "cli")]
fn parsed(text: &str) -> Result<Config, ((u32, u32), String)> {
    parse(text).map_err(|e| ((e.line, e.column), e.message))
}

/// The module for pages has no reader of configurations, which would be a tenth of it.
#[cfg(not(feature = "cli"))]
#[expect(clippy::unnecessary_wraps, reason = "as with the reader")]
fn parsed(_: &str) -> Result<Config, ((u32, u32), String)> {
    Ok(Config::default())
}

/// Reads the file that describes a host, in addition to its preset.
fn describe(files: &dyn Files, host: &mut HostNames, root: &Path) -> Result<(), String> {
    let read = |path: &String| {
        let text = files.load(&root.join(path));
        let text = text.map_err(|e| format!("{path}: {e}"))?;
        let own = shaderlint_host::read(&text);
        own.map_err(|e| format!("{path}:{}: {}", e.line, e.message))
    };
    let own = host.prelude.as_ref().map(read).transpose()?;
    if own.is_some() || host.is_complete {
        host.describe(own);
    }
    Ok(())
}

/// The last valid content of each configuration, and what is wrong with the others.
#[derive(Default)]
pub struct LastGood(Mutex<KeptConfigs>);

#[derive(Clone, Default)]
struct KeptConfigs {
    good: HashMap<PathBuf, Arc<Config>>,
    problems: BTreeMap<PathBuf, ConfigProblem>,
}

impl LastGood {
    /// Reads a configuration; an invalid one is replaced by its last valid content, if there was
    /// one.
    ///
    /// # Errors
    /// If it never was valid.
    pub fn load(&self, files: &dyn Files, path: &Path) -> Result<Arc<Config>, ConfigProblem> {
        let loaded = load(files, path);
        let mut kept = self.lock();
        match loaded {
            Ok(config) => {
                kept.good.insert(path.to_path_buf(), config.clone());
                Ok(config)
            }
            Err(problem) => {
                kept.problems.insert(path.to_path_buf(), problem.clone());
                kept.good.get(path).cloned().ok_or(problem)
            }
        }
    }

    /// The problems of the configurations that were read.
    pub fn problems(&self) -> Vec<ConfigProblem> {
        self.lock().problems.values().cloned().collect()
    }

    /// The same valid configurations, to read all files again.
    pub fn renewed(&self) -> LastGood {
        LastGood(Mutex::new(KeptConfigs {
            problems: BTreeMap::new(),
            ..self.lock().clone()
        }))
    }

    fn lock(&self) -> MutexGuard<'_, KeptConfigs> {
        self.0
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}
