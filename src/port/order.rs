//! What is asked for: a target, and where it goes.

#[cfg(feature = "naga")]
use super::naga::{FirstRow, TargetLanguage};
use std::fmt;
use std::path::Path;

/// What is made of a project.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Target {
    /// One page with everything in it
    Html,
    /// A fragment shader for each pass, and the vertex shader
    Glsl,
    /// An ES module without dependencies, which exports `mount(canvas, options)`
    Module,
    /// A module for three.js: a RawShaderMaterial and its update function
    Three,
    /// A React component, over a module beside it
    React,
    /// The project itself, as an export
    Json,
    /// A WGSL shader for each pass, for WebGPU
    #[cfg(feature = "naga")]
    Wgsl,
    /// A SPIR-V module for each pass, for Vulkan
    #[cfg(feature = "naga")]
    Spirv,
    /// An HLSL shader for each pass, for Direct3D
    #[cfg(feature = "naga")]
    Hlsl,
    /// An MSL shader for each pass, for Metal
    #[cfg(feature = "naga")]
    Msl,
}

impl Target {
    /// What the ending of a file's name asks for.
    ///
    /// # Errors
    /// Where it asks for nothing that can be made.
    pub fn of_path(path: &Path) -> Result<Target, BadEnding> {
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
                ending @ ("wgsl" | "spv" | "hlsl" | "metal" | "msl") => {
                    return Err(BadEnding::NotBuilt(ending.to_string()));
                }
                "" | "frag" | "glsl" | "fs" | "fsh" => Target::Glsl,
                other => return Err(BadEnding::Unknown(other.to_string())),
            },
        )
    }

    /// How the names of its files end.
    pub fn ending(self) -> &'static str {
        match self {
            Target::Html => "html",
            Target::Json => "json",
            Target::Module | Target::Three | Target::React => "js",
            Target::Glsl => "frag",
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

    /// Whether it is shaders alone, which read nothing themselves.
    pub fn is_shaders(self) -> bool {
        !matches!(
            self,
            Target::Html | Target::Module | Target::Three | Target::React | Target::Json
        )
    }
}

/// The ending of a file's name that tells no target.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BadEnding {
    /// This program was built without its language.
    NotBuilt(String),
    /// It is that of something else.
    Unknown(String),
}

impl fmt::Display for BadEnding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BadEnding::NotBuilt(ending) => write!(
                f,
                "this program was built without the language of `.{ending}` files; build it with \
                 `cargo install --path . --features naga`"
            ),
            BadEnding::Unknown(ending) => {
                write!(f, "nothing is made for the ending `.{ending}`; ")?;
                f.write_str(match ending.as_str() {
                    "vert" => "write `-o NAME.frag`, and the vertex shader lies beside it",
                    "jsx" | "tsx" => "say `--target react`",
                    "ts" => "say `--target module`; its types lie beside it",
                    _ => "`.html`, `.js`, `.json` and `.frag` tell the target, or say `--target`",
                })
            }
        }
    }
}

/// How plain shaders get their `main`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum MainChoice {
    /// The player's header, then the code as it is
    #[default]
    Wrap,
    /// `mainImage` becomes `main`, where the picture stays the same
    Rewrite,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Order<'a> {
    /// What is to be made.
    pub target: Target,
    /// How plain shaders get their `main`.
    pub main: MainChoice,
    /// Where it goes.
    pub output: Destination<'a>,
    /// Whether what a host must know of a shader in another language is written beside it.
    #[cfg(feature = "naga")]
    pub interface: bool,
    /// Which row of a picture lies first, drawn by a shader in another language.
    #[cfg(feature = "naga")]
    pub first_row: FirstRow,
    /// The version of a page that a server shows; it loads itself anew when it hears of another.
    pub version: Option<&'a str>,
}

/// Where what is made goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Destination<'a> {
    /// Nowhere yet: one file without a name.
    Standard,
    /// To this file; files beside it get its name.
    File(&'a Path),
    /// Into this folder, under names of their own, where it is shaders.
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
