//! The languages that a text may be written in.

use std::fmt;

/// A language that a text is written in.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Tongue {
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

impl fmt::Display for Tongue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Tongue::Web => "GLSL ES",
            Tongue::Glsl => "GLSL",
            Tongue::Desktop => "GLSL for OpenGL or Vulkan",
            Tongue::Hlsl => "HLSL",
            Tongue::Metal => "Metal",
            Tongue::Sksl => "SkSL",
            Tongue::Wgsl => "WGSL",
            Tongue::ShaderLab => "Unity's ShaderLab",
            Tongue::Godot => "Godot's shading language",
            Tongue::C => "C or a similar language",
            Tongue::Rust => "Rust",
            Tongue::FSharp => "F#",
            Tongue::Python => "Python",
            Tongue::Script => "JavaScript",
            Tongue::Markup => "markup",
            Tongue::Json => "JSON",
            Tongue::Diff => "a diff",
            Tongue::Shell => "a script",
            Tongue::Prose => "text",
        })
    }
}
