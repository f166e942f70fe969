//! Finds the `shaderlint.toml` that applies to a file, for every front.

use super::layer::Config;
use super::load::{FILE, LastGood, load};
use super::project::{ProjectFinder, ProjectFolders, ProjectLimit};
use super::selection::{Selection, options, style};
use crate::options::{ContractCache, Options};
use shaderlint_format::StyleChoice;
use shaderlint_lint::{Settings, UnknownRule};
use shaderlint_project::FileCache;
use shaderlint_project::{FileType, Files};
use shaderlint_rules::RULES;
use shaderlint_text::path::plain;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// The options of a run that concern configuration files.
#[derive(Clone, Default, Debug)]
pub struct ConfigArgs {
    /// Overrides every configuration.
    pub given: Selection,
    /// `--config` and `--no-config`
    pub source: ConfigSource,
    /// `--force-exclude`
    pub exclusion: Exclusion,
    /// The paths on the command line, or the folders of a workspace.
    pub paths: Vec<PathBuf>,
}

/// Which files `exclude` applies to.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Exclusion {
    /// Files found in folders only.
    #[default]
    Found,
    /// Files named on the command line too, which is how hooks pass them.
    Named,
}

/// Which configuration file is used.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub enum ConfigSource {
    /// The nearest one above each file.
    #[default]
    Nearest,
    /// This one for all files.
    File(PathBuf),
    /// None.
    Nowhere,
}

/// Resolves the options of files; each configuration is read once.
pub struct Configs {
    files: Arc<dyn Files + Send>,
    asked: ConfigArgs,
    /// Takes the place of configurations that are invalid, if set.
    last_good: Option<Arc<LastGood>>,
    finder: ProjectFinder,
    cache: Mutex<Cache>,
    /// Files that were read for other files, such as includes.
    file_cache: Arc<FileCache>,
    /// What scripts set.
    contracts: Arc<ContractCache>,
}

type FoundConfig = Result<Option<Arc<Config>>, Arc<str>>;

#[derive(Default)]
struct Cache {
    /// The nearest configuration of each folder.
    configs: HashMap<PathBuf, FoundConfig>,
    /// The project of each folder.
    projects: HashMap<PathBuf, ProjectFolders>,
    options: HashMap<ConfigKey, Arc<Options>>,
}

/// Files with the same key have the same options: folder of the configuration, project, overrides.
type ConfigKey = (Option<PathBuf>, ProjectFolders, Vec<usize>);

impl Configs {
    /// Whether `--host` names the host of all files.
    pub fn names_host(&self) -> bool {
        self.asked.given.host.is_some()
    }

    /// Reads no file yet.
    pub fn new(files: Arc<dyn Files + Send>, limit: ProjectLimit, asked: ConfigArgs) -> Configs {
        let named = asked.paths.iter().map(|p| plain(&files.here().join(p)));
        Configs {
            finder: ProjectFinder::new(named.collect(), limit),
            files,
            asked,
            last_good: None,
            cache: Mutex::default(),
            file_cache: Arc::default(),
            contracts: Arc::default(),
        }
    }

    /// The same, with the last valid content of configurations that are invalid.
    pub fn with_last_good(self, last_good: Arc<LastGood>) -> Configs {
        Configs {
            last_good: Some(last_good),
            ..self
        }
    }

    fn load(&self, file: &Path) -> FoundConfig {
        let loaded = match &self.last_good {
            Some(kept) => kept.load(&*self.files, file),
            None => load(&*self.files, file),
        };
        let found = loaded.map(Some);
        found.map_err(|problem| problem.shown(self.files.here()).into())
    }

    /// The configuration that applies to a file.
    ///
    /// # Errors
    /// A message if it is invalid, and never was valid.
    pub fn config(&self, path: &Path) -> FoundConfig {
        match &self.asked.source {
            ConfigSource::Nowhere => Ok(None),
            ConfigSource::File(file) => self.cached(file, || self.load(file)),
            ConfigSource::Nearest => {
                let path = self.absolute(path);
                self.nearest(path.parent().unwrap_or(Path::new("/")))
            }
        }
    }

    /// Whether a file on the command line is excluded.
    pub fn leaves_out(&self, path: &Path) -> bool {
        let config = match self.asked.exclusion {
            Exclusion::Found => None,
            Exclusion::Named => self.config(path).ok().flatten(),
        };
        config.is_some_and(|c| c.leaves_out(&self.absolute(path)))
    }

    /// The configuration file that applies to a file.
    pub fn file_of(&self, path: &Path) -> Option<PathBuf> {
        match &self.asked.source {
            ConfigSource::File(file) => Some(file.clone()),
            _ => Some(self.config(path).ok()??.root.join(FILE)),
        }
    }

    fn cached(&self, key: &Path, find: impl FnOnce() -> FoundConfig) -> FoundConfig {
        let known = self.lock().configs.get(key).cloned();
        known.unwrap_or_else(|| {
            let found = find();
            self.lock().configs.insert(key.to_path_buf(), found.clone());
            found
        })
    }

    fn nearest(&self, folder: &Path) -> FoundConfig {
        self.cached(folder, || {
            let file = folder.join(FILE);
            if self.files.entry(&file) == Some(FileType::File) {
                return self.load(&file);
            }
            folder
                .parent()
                .map_or(Ok(None), |above| self.nearest(above))
        })
    }

    /// A path as in the keys of the caches.
    fn absolute(&self, path: &Path) -> PathBuf {
        plain(&self.files.here().join(path))
    }

    fn lock(&self) -> MutexGuard<'_, Cache> {
        self.cache
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// An error in the command-line options or in the file that `--config` names.
    pub fn problem(&self) -> Option<Arc<str>> {
        let words = self.asked.given.adjust(&mut Settings::of_rules(RULES));
        let named = match &self.asked.source {
            ConfigSource::File(_) => self.config(Path::new("")).err(),
            ConfigSource::Nearest | ConfigSource::Nowhere => None,
        };
        words.map_err(unknown).err().or(named)
    }

    /// The options for checking a file. Standard input counts as the file that `--stdin-filename`
    /// names.
    ///
    /// # Errors
    /// A message if the configuration is invalid, or names an unknown rule.
    pub fn options(&self, path: &Path) -> Result<Arc<Options>, Arc<str>> {
        let config = self.config(path)?;
        let layers = config.as_ref().map(|c| c.layers(&self.absolute(path)));
        let layers = layers.unwrap_or_default();
        let root = config.as_ref().map(|c| c.root.clone());
        let key = (root, self.project(path), layers);
        if let Some(options) = self.lock().options.get(&key) {
            return Ok(options.clone());
        }
        let (_, project, layers) = &key;
        let mut options = options(config.as_deref(), layers, &self.asked.given).map_err(unknown)?;
        options.includes.tops.clone_from(&project.tops);
        options.includes.root.clone_from(&project.root);
        options.file_cache = self.file_cache.clone();
        options.contracts = self.contracts.clone();
        let options = Arc::new(options);
        self.lock().options.insert(key, options.clone());
        Ok(options)
    }

    /// The formatting style of a file: from its configuration, and otherwise `others`.
    ///
    /// # Errors
    /// A message if the configuration is invalid.
    pub fn style(&self, path: &Path, others: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        let config = self.config(path)?;
        let layers = |c: &Config| c.layers(&self.absolute(path));
        let chosen = config.map(|c| style(&c, &layers(&c), others));
        Ok(chosen.unwrap_or(others))
    }

    /// The outermost folder of the project that contains a file; `None` if nothing marks one.
    pub fn project_root(&self, path: &Path) -> Option<PathBuf> {
        let path = self.absolute(path);
        self.finder.found(&*self.files, path.parent()?).pop()
    }

    /// The project that contains a file.
    fn project(&self, path: &Path) -> ProjectFolders {
        let path = self.absolute(path);
        let folder = path.parent().unwrap_or(Path::new("/"));
        if let Some(known) = self.lock().projects.get(folder) {
            return known.clone();
        }
        let project = self.finder.around(&*self.files, folder);
        let mut cache = self.lock();
        cache.projects.insert(folder.to_path_buf(), project.clone());
        project
    }
}

fn unknown(unknown: UnknownRule) -> Arc<str> {
    let near = unknown
        .near
        .map_or(String::new(), |n| format!("; did you mean `{n}`?"));
    format!("unknown rule or group `{}`{near}", unknown.name).into()
}
