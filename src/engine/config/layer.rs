//! What a configuration says, of all files or of some.

use crate::options::{Desktop, DialectChoice, HostNames};
use globset::GlobSet;
use shaderlint_diagnostic::Severity;
use shaderlint_format::StyleChoice;
use shaderlint_lint::trial::TrialLimit;
use shaderlint_lint::{Failing, OptionValue, Renderer, Rule, Settings};
use shaderlint_rules::RULES;
use std::path::{Path, PathBuf};

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
    pub(super) fn apply(&self, settings: &mut Settings) {
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
