//! `shaderlint.toml` as data: what it says of files, and how it is read.

#[cfg(feature = "cli")]
mod read;

#[cfg(feature = "cli")]
pub use read::{ConfigError, parse, schema};

use super::options::{Desktop, DialectChoice, HostNames, Options};
use super::path::plain;
use globset::GlobSet;
use shaderlint_diagnostic::Severity;
use shaderlint_format::StyleChoice;
use shaderlint_host::Preset;
use shaderlint_lint::trial::TrialLimit;
use shaderlint_lint::{Failing, OptionValue, Renderer, Rule, Settings, UnknownRule};
use shaderlint_rules::RULES;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a configuration says of all files, or of those under some patterns.
#[derive(Default)]
pub struct Layer {
    /// What draws the shaders.
    pub target: Option<Renderer>,
    /// How many pixels of each shader are run.
    pub run_samples: Option<u32>,
    /// What the shaders are written for.
    pub dialect: Option<DialectChoice>,
    /// What the host declares.
    pub host: Option<HostNames>,
    /// What is said of shaders that WebGL does not compile.
    pub desktop: Option<Desktop>,
    /// Folders that `#include` searches behind that of the file, from the configuration's own.
    pub include_roots: Option<Vec<String>>,
    /// How code is set.
    pub format: StyleChoice,
    /// What it says of rules; the later holds.
    pub rules: Vec<(&'static Rule, Adjustment)>,
}

/// What is said of a rule.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Adjustment {
    /// How bad its findings are; `None` is off.
    Level(Option<Severity>),
    /// Whether its findings fail the run.
    Failing(Failing),
    /// What it goes by.
    Option(&'static str, OptionValue),
}

impl Layer {
    /// Does what it says of rules.
    fn apply(&self, settings: &mut Settings) {
        if let Some(target) = self.target {
            settings.set_target(RULES, target);
        }
        if let Some(pixels) = self.run_samples {
            settings.set_trial_limit(TrialLimit::of(pixels));
        }
        for (rule, adjustment) in &self.rules {
            match *adjustment {
                Adjustment::Level(level) => settings.set_level(rule, level),
                Adjustment::Failing(failing) => settings.set_failing(rule, failing),
                Adjustment::Option(name, value) => settings.set_option(rule, name, value),
            }
        }
    }
}

/// A configuration. The paths that it is asked about start at the root of the file system.
#[derive(Default)]
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
    fn inside<'p>(&self, path: &'p Path) -> &'p Path {
        path.strip_prefix(&self.root).unwrap_or(path)
    }

    /// Whether a file found in a folder is to be checked; `is_known` tells whether its ending is
    /// one of a shader.
    pub fn takes(&self, path: &Path, is_known: bool) -> bool {
        let path = self.inside(path);
        let included = self.include.as_ref();
        included.map_or(is_known, |i| i.is_match(path)) && !self.is_excluded(path)
    }

    /// Whether a pattern of `include` fits a file.
    pub fn names(&self, path: &Path) -> bool {
        let included = self.include.as_ref();
        included.is_some_and(|i| i.is_match(self.inside(path)))
    }

    /// Whether a file is left out even where it is named itself.
    pub fn leaves_out(&self, path: &Path) -> bool {
        self.is_excluded(self.inside(path))
    }

    fn is_excluded(&self, path: &Path) -> bool {
        self.exclude.as_ref().is_some_and(|e| e.is_match(path))
    }

    /// Numbers of the overrides that hold for a file.
    pub fn layers(&self, path: &Path) -> Vec<usize> {
        let path = self.inside(path);
        let overrides = self.overrides.iter().enumerate();
        let matching = overrides.filter(|(_, (globs, _))| globs.is_match(path));
        matching.map(|(i, _)| i).collect()
    }
}

/// How the code of files is set for which a configuration and some of its overrides, by their
/// numbers, hold; of what they do not say `others` holds.
pub fn style(config: &Config, layers: &[usize], others: StyleChoice) -> StyleChoice {
    let matching = layers.iter().rev().filter_map(|i| config.overrides.get(*i));
    let layers = matching.map(|(_, layer)| layer).chain([&config.base]);
    let said = layers.fold(StyleChoice::default(), |said, layer| said.or(layer.format));
    said.or(others)
}

/// What a user says for one run, which goes before every configuration.
#[derive(Clone, Default, Debug)]
pub struct Selection {
    /// What the shaders are written for, where it is not `auto`.
    pub dialect: DialectChoice,
    /// Who runs or completes them.
    pub host: Option<&'static Preset>,
    /// Rules and groups that run too.
    pub select: Vec<String>,
    /// Rules and groups that do not run.
    pub ignore: Vec<String>,
    /// The only rules and groups that run, and compile errors that are reported, where there are any.
    pub only: Vec<String>,
    /// How many pixels of each shader are run, where that is said.
    pub run_samples: Option<u32>,
}

impl Selection {
    /// Does what its words say of rules.
    ///
    /// # Errors
    /// Where a word names no rule and no group.
    pub fn adjust(&self, settings: &mut Settings) -> Result<(), UnknownRule> {
        settings.adjust(RULES, &self.select, &self.ignore)?;
        if self.only.is_empty() {
            return Ok(());
        }
        settings.choose(RULES, &self.only)
    }
}

/// How files are judged for which a configuration and some of its overrides, by their numbers, hold.
///
/// # Errors
/// Where a word of `given` names no rule and no group.
pub fn options(
    config: Option<&Config>,
    layers: &[usize],
    given: &Selection,
) -> Result<Options, UnknownRule> {
    let mut options = Options::default();
    let mut settings = Settings::of_rules(RULES);
    let overrides = config.map_or(&[][..], |c| &c.overrides);
    let matching = layers.iter().filter_map(|i| overrides.get(*i));
    let base = config.map(|c| &c.base).into_iter();
    for layer in base.chain(matching.map(|(_, layer)| layer)) {
        layer.apply(&mut settings);
        options.dialect = layer.dialect.unwrap_or(options.dialect);
        options.desktop = layer.desktop.unwrap_or(options.desktop);
        options.host = layer.host.clone().unwrap_or(options.host);
        if let (Some(roots), Some(config)) = (&layer.include_roots, config) {
            let roots = roots.iter().map(|r| plain(&config.root.join(r)));
            options.includes.roots = roots.collect();
        }
    }
    given.adjust(&mut settings)?;
    if let Some(pixels) = given.run_samples {
        settings.set_trial_limit(TrialLimit::of(pixels));
    }
    if given.dialect != DialectChoice::Auto {
        options.dialect = given.dialect;
    }
    if let Some(host) = given.host {
        options.host.preset = Some(host);
    }
    options.settings = Arc::new(settings);
    Ok(options)
}
