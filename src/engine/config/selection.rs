//! The options and the style of a file: what its configuration says, and what a run overrides.

use super::layer::Config;
use crate::options::{DialectChoice, Options};
use shaderlint_format::StyleChoice;
use shaderlint_host::Preset;
use shaderlint_lint::sample::SampleLimit;
use shaderlint_lint::{Infos, Settings, UnknownRule};
use shaderlint_rules::RULES;
use shaderlint_text::path::plain;
use std::sync::Arc;

/// The formatting style for a configuration and some of its overrides, given by index, with
/// `others` for what they do not set.
pub fn style(config: &Config, layers: &[usize], others: StyleChoice) -> StyleChoice {
    let matching = layers.iter().rev().filter_map(|i| config.overrides.get(*i));
    let layers = matching.map(|(_, layer)| layer).chain([&config.base]);
    let chosen = layers.fold(StyleChoice::default(), |chosen, layer| {
        chosen.or(layer.format)
    });
    chosen.or(others)
}

/// Options of one run, which override every configuration.
#[derive(Clone, Default, Debug)]
pub struct Selection {
    /// Dialect of the shaders, unless `auto`.
    pub dialect: DialectChoice,
    /// Host that runs or completes the shaders.
    pub host: Option<&'static Preset>,
    /// Rules and groups to enable.
    pub select: Vec<String>,
    /// Rules and groups to disable.
    pub ignore: Vec<String>,
    /// The only rules, groups and compile errors to report, if there are any.
    pub only: Vec<String>,
    /// Number of pixels to sample per shader, if set.
    pub run_samples: Option<u32>,
    /// Whether infos are reported that neither the configuration nor the user asks for.
    pub infos: Infos,
}

impl Selection {
    /// Applies the selection of rules.
    ///
    /// # Errors
    /// If a name is not a rule or group.
    pub fn adjust(&self, settings: &mut Settings) -> Result<(), UnknownRule> {
        settings.adjust(RULES, &self.select, &self.ignore)?;
        if self.only.is_empty() {
            return Ok(());
        }
        settings.choose(RULES, &self.only)
    }
}

/// The options for a configuration and some of its overrides, given by index.
///
/// # Errors
/// If a name in `given` is not a rule or group.
pub fn options(
    config: Option<&Config>,
    layers: &[usize],
    given: &Selection,
) -> Result<Options, UnknownRule> {
    let mut options = Options::default();
    let mut settings = Settings::of_rules(RULES);
    settings.set_infos(given.infos);
    let overrides = config.map_or(&[][..], |c| &c.overrides);
    let matching = layers.iter().filter_map(|i| overrides.get(*i));
    let base = config.map(|c| &c.base).into_iter();
    for layer in base.chain(matching.map(|(_, layer)| layer)) {
        layer.apply(&mut settings);
        options.dialect = layer.dialect.unwrap_or(options.dialect);
        options.webgl = layer.webgl.or(options.webgl);
        options.extensions = layer.extensions.or(options.extensions);
        options.desktop = layer.desktop.unwrap_or(options.desktop);
        options.host = layer.host.clone().unwrap_or(options.host);
        if let (Some(roots), Some(config)) = (&layer.include_roots, config) {
            let roots = roots.iter().map(|r| plain(&config.root.join(r)));
            options.includes.roots = roots.collect();
        }
    }
    given.adjust(&mut settings)?;
    if let Some(pixels) = given.run_samples {
        settings.set_sample_limit(SampleLimit::of(pixels));
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
