//! The configurations among the files that the host sent.

use super::files::MemoryFiles;
use shaderlint_engine::config::{Config, Selection, options, style};
use shaderlint_engine::{Files, Options};
use shaderlint_format::StyleChoice;
use shaderlint_lsp::{ConfigFinding, SampleRuns};
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// Name of the configuration file.
const FILE: &str = "shaderlint.toml";
/// What marks a folder as a project.
const MARKS: [&str; 2] = [FILE, "package.json"];

/// Files with the same key have the same options: folder of the configuration, folders that a leading `/`
/// may refer to, overrides, and whether shaders are run.
type OptionsKey = (Option<PathBuf>, Vec<PathBuf>, Vec<usize>, bool);

/// The configuration that applies, if any; an error if it never was valid.
type NearestConfig = Result<Option<Arc<Config>>, Arc<str>>;

/// Resolves the options of files; each configuration is read once.
pub struct SentConfigs {
    files: Arc<MemoryFiles>,
    cache: Mutex<ConfigCache>,
}

#[derive(Default)]
struct ConfigCache {
    /// By file: its content, or the last valid one.
    read: BTreeMap<PathBuf, NearestConfig>,
    /// By file: the last valid content.
    good: BTreeMap<PathBuf, Arc<Config>>,
    problems: BTreeMap<PathBuf, ConfigFinding>,
    options: HashMap<OptionsKey, Arc<Options>>,
}

impl SentConfigs {
    /// Reads no file yet.
    pub fn new(files: Arc<MemoryFiles>) -> SentConfigs {
        SentConfigs {
            files,
            cache: Mutex::default(),
        }
    }

    /// The same valid configurations, to read all files again.
    pub fn renewed(&self) -> SentConfigs {
        SentConfigs {
            files: self.files.clone(),
            cache: Mutex::new(ConfigCache {
                good: self.lock().good.clone(),
                ..ConfigCache::default()
            }),
        }
    }

    /// The options of a file in some workspace folders.
    pub fn options(
        &self,
        path: &Path,
        folders: Vec<PathBuf>,
        runs: SampleRuns,
    ) -> Option<Arc<Options>> {
        let config = self.nearest(path).ok()?;
        let layers = config.as_ref().map(|config| config.layers(path));
        let is_quick = runs == SampleRuns::Off;
        let key = (
            config.as_ref().map(|config| config.root.clone()),
            self.tops(path, folders),
            layers.unwrap_or_default(),
            is_quick,
        );
        if let Some(known) = self.lock().options.get(&key) {
            return Some(known.clone());
        }
        let selection = Selection {
            run_samples: is_quick.then_some(0),
            ..Selection::default()
        };
        let mut options = options(config.as_deref(), &key.2, &selection).ok()?;
        options.includes.tops.clone_from(&key.1);
        let options = Arc::new(options);
        self.lock().options.insert(key, options.clone());
        Some(options)
    }

    /// The folders that a leading `/` in an include may refer to, nearest first.
    fn tops(&self, path: &Path, folders: Vec<PathBuf>) -> Vec<PathBuf> {
        let above = path.ancestors().skip(1);
        let marked = MARKS.iter().filter_map(|mark| {
            let mut above = above.clone();
            above.find(|folder| self.files.entry(&folder.join(mark)).is_some())
        });
        let mut tops: Vec<PathBuf> = marked.map(Path::to_path_buf).chain(folders).collect();
        tops.sort_by_key(|folder| std::cmp::Reverse(folder.components().count()));
        tops.dedup();
        tops
    }

    /// The formatting style of a file: as configured, and otherwise `others`.
    pub fn style(&self, path: &Path, others: StyleChoice) -> Result<StyleChoice, Arc<str>> {
        let config = self.nearest(path)?;
        let chosen = config.map(|config| style(&config, &config.layers(path), others));
        Ok(chosen.unwrap_or(others))
    }

    /// The configurations above some files that are invalid.
    pub fn problems(&self, paths: &[PathBuf]) -> Vec<ConfigFinding> {
        for path in paths {
            // An invalid one is kept as a problem.
            let _ = self.nearest(path);
        }
        self.lock().problems.values().cloned().collect()
    }

    /// The configuration that applies to a file.
    pub fn nearest(&self, path: &Path) -> NearestConfig {
        let mut above = path.ancestors().skip(1).map(|folder| folder.join(FILE));
        let Some((file, text)) = above.find_map(|file| {
            let text = self.files.load(&file).ok()?;
            Some((file, text))
        }) else {
            return Ok(None);
        };
        let mut cache = self.lock();
        if let Some(known) = cache.read.get(&file) {
            return known.clone();
        }
        let found = match self.read(&file, &text) {
            Ok(config) => {
                let config = Arc::new(config);
                cache.good.insert(file.clone(), config.clone());
                Ok(Some(config))
            }
            Err(problem) => {
                let message = problem.message.clone();
                cache.problems.insert(file.clone(), problem);
                let good = cache.good.get(&file).cloned();
                good.map(Some).ok_or_else(|| message.into())
            }
        };
        cache.read.insert(file, found.clone());
        found
    }

    #[cfg(feature = "port")]
    fn read(&self, file: &Path, text: &str) -> Result<Config, ConfigFinding> {
        let problem = |at, message| ConfigFinding {
            path: file.to_path_buf(),
            at,
            message,
        };
        let parsed = shaderlint_engine::config::parse(text);
        let mut config = parsed.map_err(|e| problem(Some((e.line, e.column)), e.message))?;
        config.root = file.parent().unwrap_or(Path::new("/")).to_path_buf();
        let Config {
            root,
            base,
            overrides,
            ..
        } = &mut config;
        let overrides = overrides.iter_mut().map(|(_, layer)| layer);
        for host in std::iter::once(base)
            .chain(overrides)
            .filter_map(|layer| layer.host.as_mut())
        {
            let Some(path) = &host.prelude else {
                continue;
            };
            let text = self.files.load(&root.join(path));
            let text = text.map_err(|e| problem(None, format!("{path}: {e}")))?;
            let own = shaderlint_host::read(&text);
            let own = own.map_err(|e| {
                let message = format!("{path}:{}: {}", e.line, e.message);
                problem(None, message)
            })?;
            host.describe(own);
        }
        Ok(config)
    }

    /// The module for pages has no reader of configurations, which would be a tenth of it.
    #[cfg(not(feature = "port"))]
    #[expect(
        clippy::unnecessary_wraps,
        clippy::unused_self,
        reason = "as with the reader"
    )]
    fn read(&self, _: &Path, _: &str) -> Result<Config, ConfigFinding> {
        Ok(Config::default())
    }

    fn lock(&self) -> MutexGuard<'_, ConfigCache> {
        let cache = self.cache.lock();
        cache.unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}
