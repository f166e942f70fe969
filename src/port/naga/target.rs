//! What is asked of a lowering, and how it says no.

use serde::Serialize;
use shaderlint_semantic::Program;
use shaderlint_text::Span;

/// Why a pass cannot be written in another language.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refused {
    /// Where the reason stands; empty where it is the whole pass.
    pub span: Span,
    /// The reason.
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

/// What is made, or why it is not.
pub(super) type Res<T> = Result<T, Refused>;

/// A value of the function that is being made.
pub(super) type Value = ::naga::Handle<::naga::Expression>;

/// Where the first row of the picture lies.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum FirstRow {
    /// On top, as graphics interfaces other than OpenGL show pictures: rows are turned
    #[default]
    Top,
    /// Below, as in OpenGL: what is drawn is read by the number of the row, or turned when it is shown
    Bottom,
}

/// How a shader is lowered.
#[derive(Clone, Copy)]
pub struct LowerOptions<'a> {
    /// The language that it goes into.
    pub language: TargetLanguage,
    /// Where the first row of the picture lies.
    pub first_row: FirstRow,
    /// The vertex shader of a fragment shader, where it is known: it numbers the varyings.
    pub vertex: Option<&'a Program>,
}

/// The languages that naga writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TargetLanguage {
    /// WebGPU's language.
    Wgsl,
    /// Vulkan's binary form.
    Spirv,
    /// Direct3D's language, shader model 5.1.
    Hlsl,
    /// Metal's language, version 2.1.
    Msl,
}

impl TargetLanguage {
    /// All of them.
    pub const ALL: [TargetLanguage; 4] = [
        TargetLanguage::Wgsl,
        TargetLanguage::Spirv,
        TargetLanguage::Hlsl,
        TargetLanguage::Msl,
    ];

    /// How the names of its files end.
    pub const fn ending(self) -> &'static str {
        match self {
            TargetLanguage::Wgsl => "wgsl",
            TargetLanguage::Spirv => "spv",
            TargetLanguage::Hlsl => "hlsl",
            TargetLanguage::Msl => "metal",
        }
    }

    /// As it is called.
    pub const fn name(self) -> &'static str {
        match self {
            TargetLanguage::Wgsl => "WGSL",
            TargetLanguage::Spirv => "SPIR-V",
            TargetLanguage::Hlsl => "HLSL",
            TargetLanguage::Msl => "MSL",
        }
    }
}

/// What a file holds.
pub type Output = Vec<u8>;
