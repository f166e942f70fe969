//! The settings of a configuration, for all files or for some.

use crate::options::{Desktop, DialectChoice, HostNames};
use globset::GlobSet;
use shaderlint_diagnostic::Severity;
use shaderlint_format::StyleChoice;
use shaderlint_lint::sample::SampleLimit;
use shaderlint_lint::{Failing, Infos, OptionValue, Renderer, Rule, RulePreset, Settings};
use shaderlint_rules::RULES;
use shaderlint_syntax::{Extensions, Version, WebGl};
use std::path::{Path, PathBuf};

/// Settings for all files, or for files that match patterns.
#[derive(Default)]
pub struct Layer {
    /// The rules that run, before adjustments.
    pub preset: Option<RulePreset>,
    /// Whether all infos are reported.
    pub info: Option<bool>,
    /// Renderer that the shaders run on in production.
    pub target: Option<Renderer>,
    /// Version that shaders are converted to; the inner `None` turns it off.
    pub target_version: Option<Option<Version>>,
    /// Number of pixels to sample per shader.
    pub run_samples: Option<u32>,
    /// Dialect of the shaders.
    pub dialect: Option<DialectChoice>,
    /// The version of WebGL that compiles the shaders.
    pub webgl: Option<WebGl>,
    /// The extensions that are enabled.
    pub extensions: Option<Extensions>,
    /// Host that completes the shaders.
    pub host: Option<HostNames>,
    /// How desktop GLSL and other languages are treated.
    pub desktop: Option<Desktop>,
    /// Folders that `#include` searches after the folder of the file, relative to the
    /// configuration.
    pub include_roots: Option<Vec<String>>,
    /// Formatting style.
    pub format: StyleChoice,
    /// Adjustments of rules; later ones take precedence.
    pub rules: Vec<(&'static Rule, Adjustment)>,
}

/// An adjustment of a rule.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Adjustment {
    /// Severity of its findings; `None` is off.
    Level(Option<Severity>),
    /// Whether its findings fail the run.
    Failing(Failing),
    /// Value of an option.
    Option(&'static str, OptionValue),
}

impl Layer {
    /// Applies the adjustments of rules.
    pub(super) fn apply(&self, settings: &mut Settings) {
        if let Some(preset) = self.preset {
            settings.set_preset(RULES, preset);
        }
        match self.info {
            Some(true) => settings.set_infos(Infos::Shown),
            Some(false) => settings.set_infos(Infos::Counted),
            None => {}
        }
        if let Some(target) = self.target {
            settings.set_target(RULES, target);
        }
        if let Some(version) = self.target_version {
            settings.set_target_version(version);
        }
        if let Some(pixels) = self.run_samples {
            settings.set_sample_limit(SampleLimit::of(pixels));
        }
        for (rule, adjustment) in &self.rules {
            match *adjustment {
                Adjustment::Level(level) => {
                    settings.ask_for(rule);
                    settings.set_level(rule, level);
                }
                Adjustment::Failing(failing) => settings.set_failing(rule, failing),
                Adjustment::Option(name, value) => {
                    settings.ask_for(rule);
                    settings.set_option(rule, name, value);
                }
            }
        }
    }
}

/// A configuration. Paths in its methods are absolute.
#[derive(Default)]
pub struct Config {
    /// Folder of the configuration file, which patterns are relative to.
    pub root: PathBuf,
    /// Settings for all files.
    pub base: Layer,
    /// Settings for some files; later ones take precedence.
    pub overrides: Vec<(GlobSet, Layer)>,
    /// Files to check when folders are searched, if set.
    pub include: Option<GlobSet>,
    /// Files to skip when folders are searched.
    pub exclude: Option<GlobSet>,
}

impl Config {
    /// A path relative to the configuration.
    fn inside<'p>(&self, path: &'p Path) -> &'p Path {
        path.strip_prefix(&self.root).unwrap_or(path)
    }

    /// Whether a file found in a folder is checked; `is_known` says whether its extension is one of
    /// a shader.
    pub fn takes(&self, path: &Path, is_known: bool) -> bool {
        let path = self.inside(path);
        let included = self.include.as_ref();
        included.map_or(is_known, |i| i.is_match(path)) && !self.is_excluded(path)
    }

    /// Whether a file matches a pattern of `include`.
    pub fn names(&self, path: &Path) -> bool {
        let included = self.include.as_ref();
        included.is_some_and(|i| i.is_match(self.inside(path)))
    }

    /// Whether a file is excluded even if it is named on the command line.
    pub fn leaves_out(&self, path: &Path) -> bool {
        self.is_excluded(self.inside(path))
    }

    fn is_excluded(&self, path: &Path) -> bool {
        self.exclude.as_ref().is_some_and(|e| e.is_match(path))
    }

    /// Indices of the overrides that match a file.
    pub fn layers(&self, path: &Path) -> Vec<usize> {
        let path = self.inside(path);
        let overrides = self.overrides.iter().enumerate();
        let matching = overrides.filter(|(_, (globs, _))| globs.is_match(path));
        matching.map(|(i, _)| i).collect()
    }
}
