//! The options of a check: dialect, rules, host, includes.

use shaderlint_contract::Contract;
use shaderlint_detect::kind::Claim;
use shaderlint_host::{Preset, kept};
use shaderlint_lint::Settings;
use shaderlint_project::{FileAccess, FileCache, Files, Includes};
use shaderlint_rules::RULES;
#[cfg(feature = "cli")]
use shaderlint_syntax::Version;
use shaderlint_syntax::{Extensions, WebGl};
use std::collections::{BTreeSet, HashMap};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

/// By path of a script: what it sets. Cloned options share it.
pub type ContractCache = Mutex<HashMap<PathBuf, Arc<Contract>>>;

/// The options of a check.
#[derive(Clone, Debug)]
pub struct Options {
    /// Dialect of the shaders.
    pub dialect: DialectChoice,
    /// The version of WebGL that compiles them, if it is given.
    pub webgl: Option<WebGl>,
    /// The extensions that are enabled, if they are given.
    pub extensions: Option<Extensions>,
    /// Levels and options of the rules.
    pub settings: Arc<Settings>,
    /// Names that the host declares.
    pub host: HostNames,
    /// How includes are resolved.
    pub includes: Includes,
    /// The files of the same run: link errors between two of them are reported once.
    pub checked: Arc<BTreeSet<String>>,
    /// How desktop GLSL and other languages are treated.
    pub desktop: Desktop,
    /// Whether the configuration lists the file as a shader.
    pub claim: Claim,
    /// Cache of other files.
    pub file_cache: Arc<FileCache>,
    /// Cache of what scripts set.
    pub contracts: Arc<ContractCache>,
}

impl Default for Options {
    /// The default rules and an automatic dialect.
    fn default() -> Options {
        Options::new(DialectChoice::default(), Settings::of_rules(RULES))
    }
}

impl Options {
    /// Options for a text on its own, without host and includes.
    pub fn new(dialect: DialectChoice, settings: Settings) -> Options {
        Options {
            dialect,
            webgl: None,
            extensions: None,
            settings: Arc::new(settings),
            host: HostNames::default(),
            includes: Includes::default(),
            checked: Arc::default(),
            desktop: Desktop::default(),
            claim: Claim::default(),
            file_cache: Arc::default(),
            contracts: Arc::default(),
        }
    }

    /// All options that the result of a check depends on, as text; not the files of the run, which a check
    /// asks for by name.
    pub fn fingerprint(&self) -> String {
        let Options {
            dialect,
            webgl,
            extensions,
            settings,
            host,
            includes,
            checked: _,
            desktop,
            claim,
            file_cache: _,
            contracts: _,
        } = self;
        format!(
            "{dialect:?} {webgl:?} {extensions:?} {settings:?} {host:?} {includes:?} {desktop:?} {claim:?}"
        )
    }

    /// What the files around a shader are found with.
    pub fn file_access<'a>(&'a self, files: &'a dyn Files) -> FileAccess<'a> {
        FileAccess {
            files,
            includes: &self.includes,
            cache: &self.file_cache,
            host: self.host.preset,
            may_be_passes: matches!(self.dialect, DialectChoice::Auto | DialectChoice::Shadertoy),
            checked: &self.checked,
        }
    }

    /// What the user declares about the file.
    pub(super) fn claimed(&self) -> Claim {
        match self.claim {
            Claim::None if self.dialect != DialectChoice::Auto => Claim::Dialect,
            claim => claim,
        }
    }
}

/// The dialect of shaders.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum, schemars::JsonSchema))]
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DialectChoice {
    /// Detected from the code.
    #[default]
    Auto,
    /// ShaderToy passes.
    Shadertoy,
    /// WebGL2 shaders in GLSL ES 3.00.
    Webgl2,
    /// WebGL1 shaders in GLSL ES 1.00.
    Webgl1,
}

/// The context that compiles shaders.
#[cfg(feature = "cli")]
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ContextChoice {
    /// `getContext('webgl')`
    #[serde(alias = "webgl")]
    Webgl1,
    /// `getContext('webgl2')`
    Webgl2,
}

#[cfg(feature = "cli")]
impl ContextChoice {
    /// The version of WebGL.
    pub fn webgl(self) -> WebGl {
        match self {
            ContextChoice::Webgl1 => WebGl::One,
            ContextChoice::Webgl2 => WebGl::Two,
        }
    }
}

/// The version that shaders are converted to.
#[cfg(feature = "cli")]
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Deserialize, schemars::JsonSchema)]
pub enum TargetVersion {
    /// GLSL ES 3.00.
    #[serde(rename = "300 es")]
    Es300,
    /// Shaders are not converted.
    #[serde(rename = "any")]
    Any,
}

#[cfg(feature = "cli")]
impl TargetVersion {
    /// The version, if there is one.
    pub fn version(self) -> Option<Version> {
        match self {
            TargetVersion::Es300 => Some(Version::Es300),
            TargetVersion::Any => None,
        }
    }
}

/// Declarations that are added to a shader.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct HostNames {
    /// The host that completes the shaders.
    pub preset: Option<&'static Preset>,
    /// The file that describes a host, as written in the configuration.
    pub prelude: Option<String>,
    /// Whether nothing else is declared for the shaders.
    pub is_complete: bool,
    /// Additional uniforms.
    pub uniforms: Vec<HostUniform>,
}

impl HostNames {
    /// Adds a host that the user describes, if there is one, to the preset.
    pub fn describe(&mut self, own: Option<Preset>) {
        let mut described = match (self.preset, own) {
            (Some(preset), Some(own)) => own.over(preset),
            (preset, own) => own.or(preset.cloned()).unwrap_or_default(),
        };
        described.is_complete |= self.is_complete;
        self.preset = Some(kept(described));
    }
}

/// A uniform that the host declares, unless the shader does.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HostUniform {
    /// Identifier of the uniform.
    pub name: String,
    /// Type without array size, such as `vec4`.
    pub ty: String,
    /// Array size; `None` if it is not an array.
    pub size: Option<u32>,
}

/// How shaders in languages that WebGL cannot compile are treated.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum Desktop {
    /// Report one finding for each.
    #[default]
    Report,
    /// Skip them.
    Skip,
    /// Check desktop GLSL as GLSL ES 3.00, and report other languages.
    Port,
}
