//! Options and errors of the translation.

use serde::Serialize;
use shaderlint_semantic::Program;
use shaderlint_text::Span;

/// Why a shader cannot be translated.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refused {
    /// The span of the cause; empty for the whole pass.
    pub span: Span,
    /// The error message.
    pub message: String,
}

impl Refused {
    pub(super) fn new(span: Span, message: impl Into<String>) -> Refused {
        Refused {
            span,
            message: message.into(),
        }
    }
}

pub(super) type Res<T> = Result<T, Refused>;

/// A value in the current function.
pub(super) type Value = ::naga::Handle<::naga::Expression>;

/// The first row of an image in memory.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(
    feature = "cli",
    derive(clap::ValueEnum, serde::Deserialize, schemars::JsonSchema)
)]
#[cfg_attr(feature = "cli", schemars(inline))]
pub enum FirstRow {
    /// The top row, as in WebGPU, Vulkan, Direct3D and Metal: the image is flipped
    #[default]
    Top,
    /// The bottom row, as in OpenGL: the host flips the image when it shows it
    Bottom,
}

/// Options of lowering.
#[derive(Clone, Copy)]
pub struct LowerOptions<'a> {
    /// The target language.
    pub language: TargetLanguage,
    /// The first row of the image.
    pub first_row: FirstRow,
    /// The vertex shader for a fragment shader, if known: it determines the locations of varyings.
    pub vertex: Option<&'a Program>,
}

/// The target languages of naga.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TargetLanguage {
    /// For WebGPU.
    Wgsl,
    /// For Vulkan.
    Spirv,
    /// For Direct3D, shader model 5.1.
    Hlsl,
    /// For Metal, version 2.1.
    Msl,
}

impl TargetLanguage {
    /// All target languages.
    pub const ALL: [TargetLanguage; 4] = [
        TargetLanguage::Wgsl,
        TargetLanguage::Spirv,
        TargetLanguage::Hlsl,
        TargetLanguage::Msl,
    ];

    /// The file extension.
    pub const fn extension(self) -> &'static str {
        match self {
            TargetLanguage::Wgsl => "wgsl",
            TargetLanguage::Spirv => "spv",
            TargetLanguage::Hlsl => "hlsl",
            TargetLanguage::Msl => "metal",
        }
    }

    /// The name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            TargetLanguage::Wgsl => "WGSL",
            TargetLanguage::Spirv => "SPIR-V",
            TargetLanguage::Hlsl => "HLSL",
            TargetLanguage::Msl => "MSL",
        }
    }
}

/// The content of an output file.
pub type Output = Vec<u8>;
