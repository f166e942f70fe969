//! The arguments of `shaderlint`.

use super::super::command::TextOrJson;
use super::super::global::GlobalArgs;
use crate::cli::config::host_of;
use crate::cli::input::requests;
use crate::commands::CheckRequest;
use crate::engine::config::{ConfigArgs, Exclusion};
use crate::host::Preset;
use crate::report::Format;
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use serde::de::IgnoredAny;
#[cfg(feature = "mcp")]
use std::ffi::OsString;
use std::path::PathBuf;

/// A linter for GLSL shaders in WebGL2 and ShaderToy.
#[derive(Parser, Debug)]
#[command(name = "shaderlint", version, max_term_width = 100)]
#[command(override_usage = "shaderlint [OPTIONS] [PATH]...\n       shaderlint <COMMAND>")]
#[command(after_help = EXIT_CODES)]
pub struct LintArgs {
    /// Without a command, shaderlint checks files
    #[command(subcommand)]
    pub command: Option<Command>,
    /// What to check if there is no command
    #[command(flatten)]
    pub check: CheckArgs,
    /// The options of all commands
    #[command(flatten)]
    pub global: GlobalArgs,

    /// Print the documentation of a rule or a compile error
    #[arg(long, value_name = "NAME", conflicts_with = "paths", hide = true)]
    pub explain: Option<String>,
}

/// The arguments of a check.
#[derive(Args, Clone, Debug)]
pub struct CheckArgs {
    /// Files or folders to check, or `-` for standard input [default: the current folder]
    #[arg(value_name = "PATH", default_value = ".", hide_default_value = true)]
    pub paths: Vec<PathBuf>,

    /// How they are checked
    #[command(flatten)]
    pub request: CheckRequest,
    /// JSON file with the same, as the MCP server writes it
    #[arg(long, value_name = "FILE", hide = true)]
    pub asked: Option<PathBuf>,
    /// The host that is named
    #[arg(skip)]
    pub host: Option<&'static Preset>,

    /// Treat named files like files in folders: `exclude` applies, and they may have no shader
    #[arg(long, help_heading = "Files")]
    pub force_exclude: bool,
    /// File name to use for standard input; its extension selects the kind of file
    #[arg(long, value_name = "NAME", help_heading = "Files")]
    pub stdin_filename: Option<String>,

    /// Apply safe fixes, which do not change the image
    #[arg(long, help_heading = "Fixes")]
    pub fix: bool,
    /// Apply safe and unsafe fixes; unsafe fixes may change the image
    #[arg(long, help_heading = "Fixes")]
    pub unsafe_fixes: bool,
    /// Show the fixes as a diff without writing files
    #[arg(long, help_heading = "Fixes")]
    pub diff: bool,

    /// Output format: human, short, agent, json, jsonl, sarif, github, gitlab, junit, checkstyle
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    #[arg(help_heading = "Output", hide_possible_values = true)]
    pub format: Format,
    /// Print the number of findings of each rule instead of the findings
    #[arg(long, conflicts_with = "diff", help_heading = "Output")]
    pub statistics: bool,
    /// Check unchanged files again, and leave `.shaderlint_cache` alone
    #[arg(long, help_heading = "Files")]
    pub no_cache: bool,
    /// Check again whenever a file changes
    #[arg(long, help_heading = "Output")]
    pub watch: bool,

    /// Hide the findings listed in this baseline, and list its obsolete entries
    #[arg(long, value_name = "FILE", help_heading = "Baseline")]
    pub baseline: Option<PathBuf>,
    /// Write the current findings to a baseline
    #[arg(long, value_name = "FILE", help_heading = "Baseline")]
    #[arg(conflicts_with_all = ["baseline", "fix", "unsafe_fixes", "diff", "watch"])]
    pub write_baseline: Option<PathBuf>,

    /// Exit with code 1 if there are warnings
    #[arg(long, conflicts_with = "max_warnings", help_heading = "Exit code")]
    pub deny_warnings: bool,
    /// Exit with code 1 if there are more than N warnings
    #[arg(long, value_name = "N", help_heading = "Exit code")]
    pub max_warnings: Option<usize>,
    /// Exit with code 0 even if there are findings
    #[arg(long, help_heading = "Exit code")]
    pub exit_zero: bool,
}

/// Printed after the options.
const EXIT_CODES: &str = "\
Exit codes:
  0  No errors, and no findings of rules with `fail = true`
  1  Errors, findings of rules with `fail = true`, or too many warnings
  2  Wrong usage, a file cannot be read or written, or a named file has no GLSL";

/// The commands besides checking.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Check files; the same as no command
    #[command(after_help = EXIT_CODES)]
    Check(Box<CheckArgs>),
    /// Write a shaderlint.toml with the defaults to the current folder
    Init,
    /// Show the documentation of a rule, a compile error or a host
    Explain {
        /// Name of the rule, compile error or host, a part of it, or words to search for
        #[arg(value_name = "NAME")]
        words: Vec<String>,
    },
    /// List all rules; the JSON output also lists compile errors and options
    Rules {
        /// Output format: human, json
        #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
        #[arg(hide_possible_values = true)]
        format: TextOrJson,
    },
    /// Format shaders; only white space changes
    Fmt(super::super::fmt::FormatArgs),
    /// Run a shader on the CPU and show its image and statistics
    Run(Box<super::super::run::RunArgs>),
    /// Run tests written in GLSL and compare shaders with their golden images
    Test(Box<super::super::test::TestArgs>),
    /// Minimise a shader while keeping a diagnostic
    Reduce(super::reduce::ReduceArgs),
    /// Write TypeScript declarations of what shaders declare
    Types(super::super::types::TypesArgs),
    /// Print what shaders declare as JSON
    Reflect(super::super::types::ReflectArgs),
    /// List where the project of a file uses a name, with one group per symbol of this name
    #[cfg(feature = "lsp")]
    References(super::super::lsp::ReferencesArgs),
    /// Print the IR of a shader
    #[command(hide = true)]
    Ir {
        /// Shader to lower
        #[arg(value_name = "FILE")]
        file: PathBuf,
    },
    /// Run the language server over standard input and output
    #[cfg(feature = "lsp")]
    Lsp {
        /// Accepted because editors pass it; stdio is the only transport
        #[arg(long, hide = true)]
        stdio: bool,
    },
    /// Run the debugger over standard input and output, for editors: the Debug Adapter Protocol
    #[cfg(feature = "dap")]
    Dap,
    /// Run the Model Context Protocol (MCP) server over standard input and output
    #[cfg(feature = "mcp")]
    Mcp,
    /// Run `shaderport`, which converts shaders: the MCP server only knows the path of this program
    #[cfg(feature = "mcp")]
    #[command(hide = true, disable_help_flag = true)]
    Port {
        /// Arguments of `shaderport`, parsed when the command runs
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<OsString>,
    },
    /// Generate shell completions
    Completions {
        /// Shell to generate completions for
        shell: Shell,
        /// Program to complete
        #[arg(value_enum, default_value_t)]
        program: ProgramName,
    },
    /// Print the man page
    Man {
        /// Program to describe
        #[arg(value_enum, default_value_t)]
        program: ProgramName,
    },
    /// Print the JSON schema of shaderlint.toml
    Schema,
}

/// The programs of the package.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum ProgramName {
    /// The linter
    #[default]
    Shaderlint,
    /// The porter
    Shaderport,
}

impl CheckArgs {
    /// The output format; `--statistics` overrides `--format`.
    pub fn format(&self) -> Format {
        match self.statistics {
            true => Format::Statistics,
            false => self.format,
        }
    }

    /// The arguments with the request of a file, if one is named, and with the host.
    pub fn completed(mut self) -> Result<CheckArgs, String> {
        if let Some(path) = &self.asked {
            (self.request, _) = requests::<_, IgnoredAny>(path)?;
        }
        let host = self.request.host.as_deref().map(host_of).transpose();
        self.host = host.map_err(|e| format!("--host: {e}"))?;
        Ok(self)
    }

    /// The options that concern configuration files.
    pub fn asked(&self) -> ConfigArgs {
        ConfigArgs {
            given: self.request.selection(self.host, self.format()),
            exclusion: if self.force_exclude {
                Exclusion::Named
            } else {
                Exclusion::Found
            },
            paths: self.paths.clone(),
            ..ConfigArgs::default()
        }
    }
}
