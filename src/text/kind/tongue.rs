//! The languages that a text may be written in.

use std::fmt;

/// What a text is written in.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Tongue {
    /// GLSL ES as WebGL has it, or what ShaderToy makes of it; what no other GLSL has.
    Web,
    /// GLSL of any kind.
    Glsl,
    /// GLSL of OpenGL or Vulkan: stages, qualifiers and functions that WebGL does not have.
    Desktop,
    /// HLSL, and Cg.
    Hlsl,
    /// The Metal shading language.
    Metal,
    /// WGSL.
    Wgsl,
    /// The shading language of Skia.
    Sksl,
    /// Unity's ShaderLab.
    ShaderLab,
    /// Godot's shading language.
    Godot,
    /// C, C++ and those that look like them.
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
    /// What a program that compares files prints.
    Diff,
    /// A script that names its interpreter.
    Shell,
    /// Sentences.
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
            Tongue::C => "C or a language like it",
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
