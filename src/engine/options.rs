//! How a text is judged: what it is written for, what completes it, where its files are found.

use super::memo::Memo;
use shaderlint_host::{Preset, kept};
use shaderlint_lint::Settings;
use shaderlint_rules::RULES;
use shaderlint_text::kind::Claim;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

/// How a text is judged.
#[derive(Clone, Debug)]
pub struct Options {
    /// What its shaders are written for.
    pub dialect: DialectChoice,
    /// Which rules run.
    pub settings: Arc<Settings>,
    /// What the host declares.
    pub host: HostNames,
    /// Where `#include` finds its files.
    pub includes: Includes,
    /// The files that are checked in the same run: what is wrong between two of them is told once.
    pub checked: Arc<BTreeSet<String>>,
    /// What is said of shaders for OpenGL, Vulkan and others.
    pub desktop: Desktop,
    /// What the user says of the file.
    pub claim: Claim,
    /// What earlier checks have read of other files.
    pub memo: Arc<Memo>,
}

impl Default for Options {
    /// The rules that run by default, on what the text itself tells.
    fn default() -> Options {
        Options::new(DialectChoice::default(), Settings::of_rules(RULES))
    }
}

impl Options {
    /// A text that stands alone.
    pub fn new(dialect: DialectChoice, settings: Settings) -> Options {
        Options {
            dialect,
            settings: Arc::new(settings),
            host: HostNames::default(),
            includes: Includes::default(),
            checked: Arc::default(),
            desktop: Desktop::default(),
            claim: Claim::default(),
            memo: Arc::default(),
        }
    }
}

/// Where `#include` finds its files.
#[derive(Clone, Default, Debug)]
pub struct Includes {
    /// The folder that no include may leave, from the root and without links; empty where any file
    /// may be included.
    pub root: PathBuf,
    /// What a leading `/` may stand for, the nearest first.
    pub tops: Vec<PathBuf>,
    /// The folders that are searched behind that of the file: `include_roots` of the configuration.
    pub roots: Vec<PathBuf>,
}

/// What the user says a shader is written for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum DialectChoice {
    /// What the text tells.
    #[default]
    Auto,
    /// A pass of ShaderToy.
    Shadertoy,
    /// A shader of WebGL2, GLSL ES 3.00.
    Webgl2,
    /// A shader of WebGL1, GLSL ES 1.00.
    Webgl1,
}

/// What declares names for a shader, besides the shader itself.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct HostNames {
    /// The host that completes the shaders.
    pub preset: Option<&'static Preset>,
    /// The file in which the user describes a host, as the configuration names it.
    pub prelude: Option<String>,
    /// Further uniforms.
    pub uniforms: Vec<HostUniform>,
}

impl HostNames {
    /// Puts what the user says of a host behind the preset.
    pub fn describe(&mut self, own: Preset) {
        let described = match self.preset {
            Some(preset) => own.over(preset),
            None => own,
        };
        self.preset = Some(kept(described));
    }
}

/// A uniform that the host declares, unless the shader does it itself.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HostUniform {
    /// Its name.
    pub name: String,
    /// Its type without an array's size, `vec4`.
    pub ty: String,
    /// How many there are, where it is an array.
    pub size: Option<u32>,
}

/// What is said of shaders that WebGL does not compile.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum Desktop {
    /// That WebGL does not compile them.
    #[default]
    Report,
    /// Nothing.
    Skip,
    /// Those in GLSL are checked as what they are to become, GLSL ES 3.00.
    Port,
}
