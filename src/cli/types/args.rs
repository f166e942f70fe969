//! The arguments of `shaderlint types` and `shaderlint reflect`.

use crate::commands::UniformTypes;
use crate::engine::config::{ConfigArgs, Selection};
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Write TypeScript declarations of what shaders declare.
///
/// `glow.frag.d.ts` beside `glow.frag` gives the imported text a type: its uniforms with their values,
/// blocks, attributes, varyings, outputs and macros.
#[derive(Parser, Debug)]
#[command(after_help = "\
Exit codes:
  0  All declarations are written, or with --check: up to date
  1  A shader has errors, or with --check: a declaration is not up to date
  2  Wrong usage, or a file cannot be read or written")]
pub struct TypesArgs {
    /// Shader files or folders, or `-` for standard input [default: the current folder]
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    pub paths: Vec<PathBuf>,
    /// Write one module with the types of all shaders, `Program` and `setUniforms`, instead of a file per shader
    #[arg(long, value_name = "FILE.ts", help_heading = "Output")]
    pub module: Option<PathBuf>,
    /// Write `Program` and `setUniforms` to a module too
    #[arg(long, value_name = "FILE.ts", help_heading = "Output")]
    #[arg(conflicts_with = "module")]
    pub helpers: Option<PathBuf>,
    /// Print the declarations instead of writing files
    #[arg(long, help_heading = "Output")]
    #[arg(conflicts_with_all = ["helpers", "check", "watch"])]
    pub stdout: bool,
    /// Types of uniforms: tuples for WebGL, the classes of three.js, or both
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "TYPES",
        help_heading = "Output"
    )]
    pub uniforms: UniformChoice,
    /// List the files that are not up to date, without writing them
    #[arg(long, conflicts_with = "watch", help_heading = "Output")]
    pub check: bool,
    /// Write again whenever a shader changes
    #[arg(long, help_heading = "Output")]
    pub watch: bool,
    /// File name to use for standard input
    #[arg(long, value_name = "NAME", help_heading = "Files")]
    pub stdin_filename: Option<String>,
}

/// The values of `--uniforms`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum UniformChoice {
    /// `vec3` is `readonly [number, number, number]`
    #[default]
    Tuples,
    /// `vec3` is `{ value: Vector3 | Color }`
    Three,
    /// Both
    Both,
}

impl UniformChoice {
    /// What is written.
    pub fn types(self) -> UniformTypes {
        match self {
            UniformChoice::Tuples => UniformTypes::Tuples,
            UniformChoice::Three => UniformTypes::Three,
            UniformChoice::Both => UniformTypes::Both,
        }
    }
}

/// Print what shaders declare as JSON: uniforms, blocks with the places of their members, attributes,
/// varyings, outputs, macros.
#[derive(Parser, Debug)]
#[command(after_help = "\
Exit codes:
  0  All shaders are described
  1  A shader has errors
  2  Wrong usage, or a file cannot be read")]
pub struct ReflectArgs {
    /// Files or folders, or `-` for standard input [default: the current folder]
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    pub paths: Vec<PathBuf>,
    /// File name to use for standard input
    #[arg(long, value_name = "NAME", help_heading = "Files")]
    pub stdin_filename: Option<String>,
}

/// The options of both commands that concern configuration files: no shader is run.
pub fn asked(paths: &[PathBuf]) -> ConfigArgs {
    ConfigArgs {
        given: Selection {
            run_samples: Some(0),
            ..Selection::default()
        },
        paths: paths.to_vec(),
        ..ConfigArgs::default()
    }
}
