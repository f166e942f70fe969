//! `shaderlint.toml` as data: what it says of files, and how it is read.

mod layer;
#[cfg(feature = "cli")]
mod read;

pub use layer::{Adjustment, Config, Layer};
#[cfg(feature = "cli")]
pub use read::{ConfigError, parse, schema};

use super::options::{DialectChoice, Options};
use super::path::plain;
use shaderlint_format::StyleChoice;
use shaderlint_host::Preset;
use shaderlint_lint::trial::TrialLimit;
use shaderlint_lint::{Settings, UnknownRule};
use shaderlint_rules::RULES;
use std::sync::Arc;

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
