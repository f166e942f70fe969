//! `shaderlint.toml`: which one holds for a file, and what it says of it.

mod project;

use crate::engine::config::{Config, Layer, parse};
use crate::engine::path::absolute;
use crate::engine::{
    Desktop, DialectChoice, Files, HostNames, Includes, NOBODY, Options, Packages,
};
use crate::host::{Preset, read as read_host};
use crate::lint::{Rule, Settings, UnknownRule};
use crate::text::kind::Claim;
use project::Project;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Name of the file.
pub const FILE: &str = "shaderlint.toml";

/// How a file is judged.
#[derive(Debug)]
pub struct Judge {
    /// Which rules run.
    pub settings: Settings,
    dialect: DialectChoice,
    host: HostNames,
    includes: Includes,
    packages: Packages,
    desktop: Desktop,
}

impl Judge {
    /// As the document wants it.
    pub fn options(&self) -> Options<'_> {
        Options {
            dialect: self.dialect,
            settings: &self.settings,
            host: &self.host,
            includes: &self.includes,
            partners: &NOBODY,
            packages: &self.packages,
            desktop: self.desktop,
            claim: Claim::None,
        }
    }
}

/// What the command line says, which goes before every configuration.
#[derive(Clone, Debug)]
pub struct Given {
    /// `--dialect`, where it is not `auto`.
    pub dialect: DialectChoice,
    /// `--select`
    pub select: Vec<String>,
    /// `--ignore`
    pub ignore: Vec<String>,
    /// `--only`
    pub only: Vec<String>,
    /// `--config` and `--no-config`
    pub source: Source,
    /// `--force-exclude`
    pub exclusion: Exclusion,
    /// The paths that are named.
    pub paths: Vec<PathBuf>,
}

/// What `exclude` holds for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Exclusion {
    /// Files found in folders.
    Found,
    /// Files that are named too, as a hook names them.
    Named,
}

/// Where the configuration comes from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Source {
    /// The nearest above each file.
    Nearest,
    /// This one, for all files.
    File(PathBuf),
    /// There is none.
    Nowhere,
}

/// Finds out how files are judged; each configuration is read once.
pub struct Configs {
    given: Given,
    rules: &'static [&'static Rule],
    cache: Mutex<Cache>,
    /// What `#include` has read.
    files: Arc<Files>,
}

type Found = Result<Option<Arc<Config>>, Arc<str>>;

#[derive(Default)]
struct Cache {
    /// By folder.
    configs: HashMap<PathBuf, Found>,
    /// By folder of files.
    projects: HashMap<PathBuf, Project>,
    judges: HashMap<Key, Arc<Judge>>,
}

/// What makes files be judged alike: the folder of the configuration, the project and the overrides.
type Key = (Option<PathBuf>, Project, Vec<usize>);

impl Configs {
    /// Nothing is read yet.
    pub fn new(given: Given, rules: &'static [&'static Rule]) -> Configs {
        Configs {
            given,
            rules,
            cache: Mutex::default(),
            files: Arc::default(),
        }
    }

    /// The configuration that holds for a file.
    pub fn config(&self, path: &Path) -> Found {
        match &self.given.source {
            Source::Nowhere => Ok(None),
            Source::File(file) => self.cached(file, || load(file, self.rules).map(Some)),
            Source::Nearest => {
                let path = absolute(path);
                let folder = path.parent().unwrap_or(Path::new("/"));
                self.nearest(folder)
            }
        }
    }

    /// Whether a file is left out although it is named.
    pub fn leaves_out(&self, path: &Path) -> bool {
        let config = match self.given.exclusion {
            Exclusion::Found => None,
            Exclusion::Named => self.config(path).ok().flatten(),
        };
        config.is_some_and(|c| c.leaves_out(path))
    }

    /// The file that holds a file's configuration.
    pub fn file_of(&self, path: &Path) -> Option<PathBuf> {
        match &self.given.source {
            Source::File(file) => Some(file.clone()),
            _ => Some(self.config(path).ok()??.root.join(FILE)),
        }
    }

    fn cached(&self, key: &Path, find: impl FnOnce() -> Found) -> Found {
        let known = self.lock().configs.get(key).cloned();
        known.unwrap_or_else(|| {
            let found = find();
            self.lock().configs.insert(key.to_path_buf(), found.clone());
            found
        })
    }

    fn nearest(&self, folder: &Path) -> Found {
        self.cached(folder, || {
            let file = folder.join(FILE);
            if file.is_file() {
                return load(&file, self.rules).map(Some);
            }
            folder
                .parent()
                .map_or(Ok(None), |above| self.nearest(above))
        })
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Cache> {
        self.cache
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// What is wrong with the words of the command line, or with the configuration that it names.
    pub fn problem(&self) -> Option<Arc<str>> {
        let words = Settings::new(self.rules, &[], &[]).and_then(|mut s| self.adjust(&mut s));
        let named = match &self.given.source {
            Source::File(_) => self.config(Path::new("")).err(),
            Source::Nearest | Source::Nowhere => None,
        };
        words.map_err(unknown).err().or(named)
    }

    /// How a file is judged. Standard input counts as a file of its name.
    pub fn judge(&self, path: &Path) -> Result<Arc<Judge>, Arc<str>> {
        let config = self.config(path)?;
        let layers = config.as_ref().map_or(Vec::new(), |c| c.layers(path));
        let root = config.as_ref().map(|c| c.root.clone());
        let key = (root, self.project(path), layers);
        if let Some(judge) = self.lock().judges.get(&key) {
            return Ok(judge.clone());
        }
        let judge = Arc::new(self.make(config.as_deref(), &key.1, &key.2)?);
        self.lock().judges.insert(key, judge.clone());
        Ok(judge)
    }

    /// The project that a file belongs to.
    fn project(&self, path: &Path) -> Project {
        let path = absolute(path);
        let folder = path.parent().unwrap_or(Path::new("/"));
        if let Some(known) = self.lock().projects.get(folder) {
            return known.clone();
        }
        let project = Project::around(folder, &self.given.paths);
        let mut cache = self.lock();
        cache.projects.insert(folder.to_path_buf(), project.clone());
        project
    }

    fn make(
        &self,
        config: Option<&Config>,
        project: &Project,
        layers: &[usize],
    ) -> Result<Judge, Arc<str>> {
        let mut settings = Settings::new(self.rules, &[], &[]).map_err(unknown)?;
        let mut judge = Judge {
            settings: settings.clone(),
            dialect: DialectChoice::Auto,
            host: HostNames::default(),
            includes: Includes::inside(&project.root)
                .with_tops(project.tops.clone())
                .sharing(self.files.clone()),
            packages: Packages::of_projects(),
            desktop: Desktop::default(),
        };
        let overrides = config.map_or(&[][..], |c| &c.overrides);
        let matching = layers.iter().filter_map(|i| overrides.get(*i));
        let base = config.map(|c| &c.base).into_iter();
        for layer in base.chain(matching.map(|(_, layer)| layer)) {
            self.apply(layer, &mut settings);
            judge.dialect = layer.dialect.unwrap_or(judge.dialect);
            judge.desktop = layer.desktop.unwrap_or(judge.desktop);
            judge.host = layer.host.clone().unwrap_or(judge.host);
            if let (Some(roots), Some(config)) = (&layer.include_roots, config) {
                let roots = roots.iter().map(|r| absolute(&config.root.join(r)));
                judge.includes = judge.includes.with_roots(roots.collect());
            }
        }
        self.adjust(&mut settings).map_err(unknown)?;
        if self.given.dialect != DialectChoice::Auto {
            judge.dialect = self.given.dialect;
        }
        judge.settings = settings;
        Ok(judge)
    }

    /// Does what the words of the command line say.
    fn adjust(&self, settings: &mut Settings) -> Result<(), UnknownRule> {
        let given = &self.given;
        settings.adjust(self.rules, &given.select, &given.ignore)?;
        if given.only.is_empty() {
            return Ok(());
        }
        settings.choose(self.rules, &given.only)
    }

    fn apply(&self, layer: &Layer, settings: &mut Settings) {
        let rule = |name: &str| self.rules.iter().find(|r| r.name == name);
        settings.target = layer.target.unwrap_or(settings.target);
        for (name, level) in &layer.levels {
            if let Some(rule) = rule(name) {
                settings.set_level(rule, *level);
            }
        }
        for (name, failing) in &layer.failing {
            if let Some(rule) = rule(name) {
                settings.set_failing(rule, *failing);
            }
        }
        for (name, option, value) in &layer.options {
            if let Some(rule) = rule(name) {
                settings.set_option(rule, option, *value);
            }
        }
    }
}

fn unknown(unknown: UnknownRule) -> Arc<str> {
    let near = unknown
        .near
        .map_or(String::new(), |n| format!("; did you mean `{n}`?"));
    format!("there is no rule or group `{}`{near}", unknown.name).into()
}

fn load(file: &Path, rules: &'static [&'static Rule]) -> Result<Arc<Config>, Arc<str>> {
    let here = std::env::current_dir().unwrap_or_default();
    let shown = file.strip_prefix(here).unwrap_or(file).display();
    let text = fs::read_to_string(file).map_err(|e| format!("{shown}: {e}"))?;
    let mut config = parse(&text, rules)
        .map_err(|e| format!("{shown}:{}:{}: {}", e.line, e.column, e.message))?;
    let folder = absolute(file);
    config.root = folder.parent().unwrap_or(Path::new("/")).to_path_buf();
    let overrides = config.overrides.iter_mut().map(|(_, layer)| layer);
    for layer in std::iter::once(&mut config.base).chain(overrides) {
        if let Some(host) = &mut layer.host {
            describe(host, &config.root).map_err(|e| format!("{shown}: {e}"))?;
        }
    }
    Ok(Arc::new(config))
}

/// Reads the file in which the user describes a host; a preset comes before it.
fn describe(host: &mut HostNames, root: &Path) -> Result<(), String> {
    let Some(path) = &host.prelude else {
        return Ok(());
    };
    let text = fs::read_to_string(root.join(path)).map_err(|e| format!("{path}: {e}"))?;
    let mut own = read_host(&text).map_err(|e| format!("{path}:{}: {}", e.line, e.message))?;
    if let Some(preset) = &host.preset {
        own = Preset {
            prelude: format!("{}\n{}", preset.prelude, own.prelude),
            is_complete: own.is_complete && preset.is_complete,
            version: preset.version,
            ..own
        };
    }
    host.preset = Some(Arc::new(own));
    Ok(())
}
