//! What scripts set, kept for the next check.

use shaderlint_contract::Contract;
use shaderlint_project::Files;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// Maximum number of contracts that are kept.
const MAX_KEPT: usize = 64;

/// The contracts of scripts that earlier checks have evaluated, by path. Cloned options share them.
#[derive(Default, Debug)]
pub struct ContractCache(Mutex<HashMap<PathBuf, Arc<Contract>>>);

impl ContractCache {
    fn all(&self) -> MutexGuard<'_, HashMap<PathBuf, Arc<Contract>>> {
        self.0
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// The contract of a script with this text, if the modules are the same as well.
    pub fn get(&self, path: &Path, text: &str, files: &dyn Files) -> Option<Arc<Contract>> {
        let known = self.all().get(path).cloned()?;
        let (root, modules) = known.files.split_first()?;
        let is_same =
            |(path, text): &(PathBuf, Arc<str>)| files.load(path).is_ok_and(|now| now == *text);
        (*root.1 == *text && modules.iter().all(is_same)).then_some(known)
    }

    /// Keeps the contract of a script.
    pub fn keep(&self, path: &Path, contract: Arc<Contract>) {
        let mut all = self.all();
        if all.len() >= MAX_KEPT {
            all.clear();
        }
        all.insert(path.to_path_buf(), contract);
    }
}
