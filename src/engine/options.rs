//! How a text is judged: what it is written for, what completes it, where its files are found.

use super::host::Packages;
use super::include::Includes;
use super::partner::Partners;
use crate::host::Preset;
use crate::lint::Settings;
use crate::text::kind::Claim;
use std::sync::Arc;

/// What the user says a shader is written for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, clap::ValueEnum)]
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
    pub preset: Option<Arc<Preset>>,
    /// The file in which the user describes a host, as the configuration names it.
    pub prelude: Option<String>,
    /// Further uniforms.
    pub uniforms: Vec<HostUniform>,
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

/// How an input is judged.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// What its shaders are written for.
    pub dialect: DialectChoice,
    /// Which rules run.
    pub settings: &'a Settings,
    /// What the host declares.
    pub host: &'a HostNames,
    /// Where `#include` finds its files.
    pub includes: &'a Includes,
    /// Where the other stage is found.
    pub partners: &'a Partners,
    /// Where the packages of the project are found.
    pub packages: &'a Packages,
    /// What is said of shaders for OpenGL, Vulkan and others.
    pub desktop: Desktop,
    /// What the user says of the file.
    pub claim: Claim,
}

/// What is said of shaders that WebGL does not compile.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Desktop {
    /// That WebGL does not compile them.
    #[default]
    Report,
    /// Nothing.
    Skip,
    /// Those in GLSL are checked as what they are to become, GLSL ES 3.00.
    Port,
}
