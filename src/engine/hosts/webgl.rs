//! The context that compiles a shader, and its extensions: from the configuration, the host and the scripts
//! around the shader.

use super::host::Hosts;
use crate::options::{DialectChoice, Options};
use crate::shader::reading::Readings;
use shaderlint_host::Preset;
use shaderlint_syntax::{EXTENSIONS, Extensions, GlContext, GlExtension, WebGl};
use shaderlint_text::{Role, Sources};

/// What is known about a context apart from the shader.
#[derive(Clone, Copy, Default)]
struct KnownContext {
    webgl: Option<WebGl>,
    /// Whether the version is certain.
    is_sure: bool,
    /// The extensions that are enabled.
    enabled: Extensions,
    /// Whether no others are.
    is_all: bool,
}

/// The context of a shader that these hosts complete.
pub fn context(
    sources: &Sources,
    readings: &Readings,
    hosts: &Hosts,
    options: &Options,
    presets: &[&Preset],
) -> GlContext {
    if readings.is_shadertoy() {
        return GlContext::WEBGL2;
    }
    let files = readings.all.first().map_or(&[][..], |r| &r.files);
    let codes = files.iter().filter_map(|id| sources.code(*id));
    let own: Vec<&str> = codes
        .filter(|code| code.role == Role::User)
        .map(|code| code.text)
        .collect();
    let has = |name: &&str| own.iter().any(|text| text.contains(*name));
    let named = EXTENSIONS
        .iter()
        .filter(|facts| facts.directives.iter().any(has));
    let asked: Extensions = named.clone().map(|facts| facts.extension).collect();
    let is_concerned = || {
        let mut names = EXTENSIONS.iter().flat_map(|facts| facts.adds);
        asked != Extensions::NONE || names.any(has)
    };
    let mut known = of_options(options).or(of_presets(presets));
    if known.webgl.is_none() || !known.is_all {
        known = known.or(of_scripts(hosts, is_concerned));
    }
    let is_for_webgl1 = named.clone().any(|facts| !facts.exists_in(WebGl::Two));
    let presumed = match is_for_webgl1 && !readings.needs_300() {
        true => WebGl::One,
        false => WebGl::Two,
    };
    let unsure = match known.is_all {
        true => Extensions::NONE,
        false => asked.without(known.enabled),
    };
    GlContext {
        webgl: known.webgl.unwrap_or(presumed),
        is_known: known.is_sure,
        enabled: known.enabled.and(unsure),
        presumed: unsure,
    }
}

impl KnownContext {
    /// What this does not know is taken from another source.
    fn or(self, other: KnownContext) -> KnownContext {
        let (enabled, is_all) = match self.is_all {
            true => (self.enabled, true),
            false => (self.enabled.and(other.enabled), other.is_all),
        };
        KnownContext {
            webgl: self.webgl.or(other.webgl),
            is_sure: match self.webgl {
                Some(_) => self.is_sure,
                None => other.is_sure,
            },
            enabled,
            is_all,
        }
    }
}

fn of_options(options: &Options) -> KnownContext {
    let of_dialect = (options.dialect == DialectChoice::Webgl1).then_some(WebGl::One);
    let webgl = options.webgl.or(of_dialect);
    KnownContext {
        webgl,
        is_sure: webgl.is_some(),
        enabled: options.extensions.unwrap_or_default(),
        is_all: options.extensions.is_some(),
    }
}

/// What the hosts say, if they agree.
fn of_presets(presets: &[&Preset]) -> KnownContext {
    let first = presets.first().map_or(&[][..], |first| &first.context);
    let is_one = presets.iter().all(|preset| preset.context == first);
    let [webgl, enabled @ ..] = first else {
        return KnownContext::default();
    };
    if !is_one {
        return KnownContext::default();
    }
    KnownContext {
        webgl: Some(match webgl.as_str() {
            "webgl1" => WebGl::One,
            _ => WebGl::Two,
        }),
        is_sure: true,
        enabled: enabled
            .iter()
            .filter_map(|name| GlExtension::named(name))
            .collect(),
        is_all: !enabled.is_empty(),
    }
}

/// What the scripts around the shader ask for. Those that import it are read only for shaders that an
/// extension concerns.
fn of_scripts(hosts: &Hosts, is_concerned: impl Fn() -> bool) -> KnownContext {
    let Some(asked) = hosts.asked_webgl(is_concerned) else {
        return KnownContext::default();
    };
    let named = asked
        .words
        .iter()
        .filter_map(|word| GlExtension::named(word));
    KnownContext {
        webgl: match (asked.one, asked.two) {
            (true, false) => Some(WebGl::One),
            (false, true) => Some(WebGl::Two),
            _ => None,
        },
        is_sure: asked.compiles,
        enabled: named.collect(),
        is_all: asked.is_all,
    }
}
