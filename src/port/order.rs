//! Build orders: a target and a destination.

use super::Poster;
#[cfg(feature = "naga")]
use super::naga::{FirstRow, TargetLanguage};
use shaderlint_host::{Preset, presets};
use std::fmt;
use std::path::Path;

/// An output format.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Target {
    /// HTML page that contains everything
    Html,
    /// Fragment shader of each pass, and the vertex shader
    Glsl,
    /// JavaScript module without dependencies that exports `mount(canvas, options)`
    Module,
    /// Module for three.js: a RawShaderMaterial and its update function
    Three,
    /// Module for three.js' WebGPURenderer: a MeshBasicNodeMaterial in WGSL and its update function
    #[cfg(feature = "naga")]
    ThreeWebgpu,
    /// React component, and the module that it imports
    React,
    /// ShaderToy export of the project
    Json,
    /// WGSL shader of each pass, for WebGPU
    #[cfg(feature = "naga")]
    Wgsl,
    /// SPIR-V module of each pass, for Vulkan
    #[cfg(feature = "naga")]
    Spirv,
    /// HLSL shader of each pass, for Direct3D
    #[cfg(feature = "naga")]
    Hlsl,
    /// MSL shader of each pass, for Metal
    #[cfg(feature = "naga")]
    Msl,
    /// Shader for a host that has a template
    #[cfg_attr(feature = "cli", value(skip))]
    Host(&'static Preset),
}

impl Target {
    /// The hosts that shaders can be written for.
    pub fn hosts() -> impl Iterator<Item = &'static Preset> {
        presets().filter(|host| host.template.is_some())
    }

    /// The target for the extension of a path.
    ///
    /// # Errors
    /// If the extension does not correspond to a target.
    pub fn of_path(path: &Path) -> Result<Target, BadExtension> {
        Ok(
            match path.extension().and_then(|e| e.to_str()).unwrap_or("") {
                "html" | "htm" => Target::Html,
                "js" | "mjs" => Target::Module,
                "json" => Target::Json,
                #[cfg(feature = "naga")]
                "wgsl" => Target::Wgsl,
                #[cfg(feature = "naga")]
                "spv" => Target::Spirv,
                #[cfg(feature = "naga")]
                "hlsl" => Target::Hlsl,
                #[cfg(feature = "naga")]
                "metal" | "msl" => Target::Msl,
                #[cfg(not(feature = "naga"))]
                extension @ ("wgsl" | "spv" | "hlsl" | "metal" | "msl") => {
                    return Err(BadExtension::NotBuilt(extension.to_string()));
                }
                "" | "frag" | "glsl" | "fs" | "fsh" => Target::Glsl,
                other => return Err(BadExtension::Unknown(other.to_string())),
            },
        )
    }

    /// The file extension.
    pub fn extension(self) -> &'static str {
        match self {
            Target::Html => "html",
            Target::Json => "json",
            Target::Module | Target::Three | Target::React => "js",
            #[cfg(feature = "naga")]
            Target::ThreeWebgpu => "js",
            Target::Glsl => "frag",
            Target::Host(_) => "glsl",
            #[cfg(feature = "naga")]
            Target::Wgsl => "wgsl",
            #[cfg(feature = "naga")]
            Target::Spirv => "spv",
            #[cfg(feature = "naga")]
            Target::Hlsl => "hlsl",
            #[cfg(feature = "naga")]
            Target::Msl => "metal",
        }
    }

    /// The language that naga writes for it.
    #[cfg(feature = "naga")]
    pub fn language(self) -> Option<TargetLanguage> {
        match self {
            Target::Wgsl => Some(TargetLanguage::Wgsl),
            Target::Spirv => Some(TargetLanguage::Spirv),
            Target::Hlsl => Some(TargetLanguage::Hlsl),
            Target::Msl => Some(TargetLanguage::Msl),
            _ => None,
        }
    }

    /// Whether the output has sliders for values in the code.
    pub fn has_sliders(self) -> bool {
        matches!(self, Target::Html | Target::Module | Target::React)
    }

    /// Whether the output consists of shaders only, without their inputs.
    pub fn is_shaders(self) -> bool {
        #[cfg(feature = "naga")]
        if self == Target::ThreeWebgpu {
            return false;
        }
        !matches!(
            self,
            Target::Html | Target::Module | Target::Three | Target::React | Target::Json
        )
    }
}

/// An extension without a target.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BadExtension {
    /// The extension of a language that this build does not include.
    NotBuilt(String),
    /// Any other extension.
    Unknown(String),
}

impl fmt::Display for BadExtension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BadExtension::NotBuilt(extension) => write!(
                f,
                "this build does not support `.{extension}` files; rebuild with \
                 `cargo install --path . --features naga`"
            ),
            BadExtension::Unknown(extension) => {
                write!(f, "unknown output extension `.{extension}`; ")?;
                f.write_str(match extension.as_str() {
                    "vert" => "use `-o NAME.frag`, which writes NAME.vert as well",
                    "jsx" | "tsx" => "use `--target react`",
                    "ts" => "use `--target module`, which writes its types as well",
                    _ => "use `.html`, `.js`, `.json` or `.frag`, or set `--target`",
                })
            }
        }
    }
}

/// How plain shaders get their `main`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[cfg_attr(
    feature = "cli",
    derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema)
)]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"), schemars(inline))]
pub enum MainChoice {
    /// Prepend the player's header and keep the code unchanged
    #[default]
    Wrap,
    /// Rewrite `mainImage` as `main` where the image provably stays the same
    Rewrite,
}

/// A build order.
#[derive(Clone, Copy, Debug)]
pub struct Order<'a> {
    /// The output format.
    pub target: Target,
    /// How plain shaders get their `main`.
    pub main: MainChoice,
    /// Where the output goes.
    pub output: Destination<'a>,
    /// Whether to write the resource interface of a shader in another language as JSON.
    #[cfg(feature = "naga")]
    pub interface: bool,
    /// Which row of the image a shader in another language draws first.
    #[cfg(feature = "naga")]
    pub first_row: FirstRow,
    /// The version of a served page, which reloads itself when the server announces another.
    pub version: Option<&'a str>,
    /// What a page for frames of other pages shows until its shader plays.
    pub poster: Option<&'a Poster>,
    /// Whether the script and the style of a page are files beside it.
    pub split: bool,
    /// The address of the playground whose debugger a page offers.
    pub playground: Option<&'a str>,
}

/// The destination of a build.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Destination<'a> {
    /// Standard output: one file without a name.
    Standard,
    /// A file; further files get its name with another extension.
    File(&'a Path),
    /// A folder, for shaders with generated names.
    Folder(&'a Path),
}

impl<'a> Destination<'a> {
    pub(super) fn path(self) -> &'a Path {
        match self {
            Destination::Standard => Path::new(""),
            Destination::File(path) | Destination::Folder(path) => path,
        }
    }
}
