//! The languages that a text may be written in.

use std::fmt;

/// A language that a text is written in.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ShaderLanguage {
    /// GLSL ES as in WebGL and ShaderToy, with features that no other GLSL has.
    Web,
    /// GLSL of any kind.
    Glsl,
    /// GLSL for OpenGL or Vulkan, with stages, qualifiers and functions that WebGL does not have.
    Desktop,
    /// HLSL and Cg.
    Hlsl,
    /// Metal Shading Language.
    Metal,
    /// WGSL.
    Wgsl,
    /// Skia's shading language, SkSL.
    Sksl,
    /// Unity's ShaderLab.
    ShaderLab,
    /// Godot's shading language.
    Godot,
    /// ReShade FX, a relative of HLSL.
    ReShade,
    /// RetroArch's shaders, which contain both stages.
    RetroArch,
    /// Effects of OBS, relatives of HLSL.
    Obs,
    /// User shaders of mpv and libplacebo, which hook into the steps of a video's rendering.
    Mpv,
    /// The GLSL of TouchDesigner, which has inputs and functions of its own.
    TouchDesigner,
    /// Presets of MilkDrop, with shaders in HLSL.
    MilkDrop,
    /// C, C++ and similar languages.
    C,
    /// Rust.
    Rust,
    /// F#.
    FSharp,
    /// Python.
    Python,
    /// JavaScript and TypeScript.
    Script,
    /// HTML and XML.
    Markup,
    /// JSON.
    Json,
    /// The output of a program that compares files.
    Diff,
    /// A script with an interpreter line.
    Shell,
    /// Natural language.
    Prose,
}

impl ShaderLanguage {
    /// A text in this language, with an article.
    pub const fn shader(self) -> &'static str {
        match self {
            ShaderLanguage::Desktop => "a shader for OpenGL or Vulkan",
            ShaderLanguage::Hlsl => "an HLSL shader",
            ShaderLanguage::Metal => "a Metal shader",
            ShaderLanguage::Wgsl => "a WGSL shader",
            ShaderLanguage::Sksl => "an SkSL shader",
            ShaderLanguage::ShaderLab => "a Unity shader",
            ShaderLanguage::Godot => "a Godot shader",
            ShaderLanguage::ReShade => "a ReShade effect",
            ShaderLanguage::RetroArch => "a RetroArch shader",
            ShaderLanguage::Obs => "an OBS effect",
            ShaderLanguage::Mpv => "a user shader of mpv",
            ShaderLanguage::TouchDesigner => "a TouchDesigner shader",
            ShaderLanguage::MilkDrop => "a MilkDrop preset",
            _ => "not a shader for WebGL",
        }
    }
}

impl fmt::Display for ShaderLanguage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ShaderLanguage::Web => "GLSL ES",
            ShaderLanguage::Glsl => "GLSL",
            ShaderLanguage::Desktop => "GLSL for OpenGL or Vulkan",
            ShaderLanguage::Hlsl => "HLSL",
            ShaderLanguage::Metal => "Metal",
            ShaderLanguage::Sksl => "SkSL",
            ShaderLanguage::Wgsl => "WGSL",
            ShaderLanguage::ShaderLab => "Unity's ShaderLab",
            ShaderLanguage::Godot => "Godot's shading language",
            ShaderLanguage::ReShade => "ReShade FX",
            ShaderLanguage::RetroArch => "RetroArch's shader format",
            ShaderLanguage::Obs => "effects of OBS",
            ShaderLanguage::Mpv => "user shaders of mpv",
            ShaderLanguage::TouchDesigner => "TouchDesigner's GLSL",
            ShaderLanguage::MilkDrop => "presets of MilkDrop",
            ShaderLanguage::C => "C or a similar language",
            ShaderLanguage::Rust => "Rust",
            ShaderLanguage::FSharp => "F#",
            ShaderLanguage::Python => "Python",
            ShaderLanguage::Script => "JavaScript",
            ShaderLanguage::Markup => "markup",
            ShaderLanguage::Json => "JSON",
            ShaderLanguage::Diff => "a diff",
            ShaderLanguage::Shell => "a script",
            ShaderLanguage::Prose => "text",
        })
    }
}
