//! The configurations that were valid last, for programs that must go on while one is being edited.

use super::load::{ConfigProblem, load};
use crate::engine::config::Config;
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

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
    pub fn load(&self, file: &Path) -> Result<Arc<Config>, ConfigProblem> {
        let loaded = load(file);
        let mut kept = self.lock();
        match loaded {
            Ok(config) => {
                kept.good.insert(file.to_path_buf(), config.clone());
                Ok(config)
            }
            Err(problem) => {
                kept.problems.insert(file.to_path_buf(), problem.clone());
                kept.good.get(file).cloned().ok_or(problem)
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
