//! The arguments of `shaderlint`.

use super::super::color::ColorChoice;
use super::super::config::{ConfigArgs, Exclusion, Source};
use crate::cli::config::host_of;
use crate::engine::DialectChoice;
use crate::engine::config::Selection;
use crate::host::Preset;
use crate::report::Format;
use clap::{ArgAction, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
#[cfg(feature = "mcp")]
use std::ffi::OsString;
use std::path::PathBuf;

/// Checks GLSL for WebGL2 and ShaderToy. An error means that the browser's compiler refuses the
/// shader; everything else is a warning or an info.
#[derive(Parser, Debug)]
#[command(name = "shaderlint", version, about, max_term_width = 100)]
#[command(args_conflicts_with_subcommands = true, disable_help_subcommand = true)]
#[command(subcommand_help_heading = "Instead of PATH")]
#[command(override_usage = "shaderlint [OPTIONS] [PATH]...\n       shaderlint <COMMAND>")]
#[command(after_help = EXIT_CODES)]
pub struct LintArgs {
    /// Something else than checking
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Files and folders to check; `-` is standard input, no path the current folder
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,

    /// Run these rules or groups too; `all` is every rule
    #[arg(
        long,
        value_name = "RULE",
        value_delimiter = ',',
        help_heading = "Rules"
    )]
    pub select: Vec<String>,
    /// Do not run these; of --select and --ignore the more specific holds
    #[arg(
        long,
        value_name = "RULE",
        value_delimiter = ',',
        help_heading = "Rules"
    )]
    pub ignore: Vec<String>,
    /// Report nothing but these rules, groups or compile errors
    #[arg(
        long,
        value_name = "RULE",
        value_delimiter = ',',
        help_heading = "Rules"
    )]
    #[arg(conflicts_with_all = ["select", "ignore"])]
    pub only: Vec<String>,
    /// Who runs or completes the shaders, like `three` or `bonzomatic`, or a file that describes one; an
    /// unknown name shows all
    #[arg(long, value_name = "NAME", value_parser = host_of, help_heading = "Rules")]
    #[arg(conflicts_with = "dialect")]
    pub host: Option<&'static Preset>,
    /// What the shaders are written for: auto, shadertoy, webgl2, webgl1
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "DIALECT",
        help_heading = "Rules"
    )]
    #[arg(hide_possible_values = true)]
    pub dialect: DialectChoice,
    /// Run no shader: find what the text tells alone
    #[arg(long, help_heading = "Rules")]
    pub no_run: bool,
    /// Run N pixels of each shader, whatever that takes, in place of up to 9216
    #[arg(
        long,
        value_name = "N",
        conflicts_with = "no_run",
        help_heading = "Rules"
    )]
    pub run_samples: Option<u32>,
    /// The configuration, in place of the nearest shaderlint.toml above each file
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with = "no_config",
        help_heading = "Rules"
    )]
    pub config: Option<PathBuf>,
    /// Take no configuration
    #[arg(long, help_heading = "Rules")]
    pub no_config: bool,
    /// Leave out what the configuration excludes even where it is named, as hooks name files
    #[arg(long, help_heading = "Rules")]
    pub force_exclude: bool,
    /// Name of standard input in messages; its ending tells what it is
    #[arg(long, value_name = "NAME", help_heading = "Rules")]
    pub stdin_filename: Option<String>,

    /// Write the fixes that keep the picture into the files
    #[arg(long, help_heading = "Fixes")]
    pub fix: bool,
    /// Write the other fixes too
    #[arg(long, help_heading = "Fixes")]
    pub unsafe_fixes: bool,
    /// Print what the fixes would change, and write nothing
    #[arg(long, help_heading = "Fixes")]
    pub diff: bool,

    /// human, short, agent, json, jsonl, sarif, github, gitlab, junit, checkstyle
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "FORMAT",
        help_heading = "Output"
    )]
    #[arg(hide_possible_values = true)]
    pub format: FormatChoice,
    /// Say of each file what it was read as, and what was skipped
    #[arg(short, long, conflicts_with = "quiet", help_heading = "Output")]
    pub verbose: bool,
    /// Print findings only, no summary; twice: print nothing
    #[arg(short, long, action = ArgAction::Count, help_heading = "Output")]
    pub quiet: u8,
    /// Print how often each rule finds something, not the findings
    #[arg(long, conflicts_with = "diff", help_heading = "Output")]
    pub statistics: bool,
    /// Check again whenever a file changes
    #[arg(long, help_heading = "Output")]
    pub watch: bool,
    /// When to print in colour: auto, always, never
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "WHEN",
        help_heading = "Output"
    )]
    #[arg(hide_possible_values = true)]
    pub color: ColorChoice,

    /// Exit with 1 on warnings too
    #[arg(long, conflicts_with = "max_warnings", help_heading = "Exit code")]
    pub deny_warnings: bool,
    /// Exit with 1 on more than N warnings
    #[arg(long, value_name = "N", help_heading = "Exit code")]
    pub max_warnings: Option<usize>,
    /// Exit with 0 whatever is found
    #[arg(long, help_heading = "Exit code")]
    pub exit_zero: bool,
    /// Leave out the findings that this file names, and say which of them are gone
    #[arg(long, value_name = "FILE", help_heading = "Exit code")]
    pub baseline: Option<PathBuf>,
    /// Write the findings into this file, for --baseline
    #[arg(long, value_name = "FILE", help_heading = "Exit code")]
    #[arg(conflicts_with_all = ["baseline", "fix", "unsafe_fixes", "diff", "watch"])]
    pub write_baseline: Option<PathBuf>,

    /// Print the page of a rule or a compile error
    #[arg(long, value_name = "NAME", conflicts_with = "paths", hide = true)]
    pub explain: Option<String>,
}

/// What the help ends with.
const EXIT_CODES: &str = "\
Exit codes: 0 nothing at or above the threshold (errors, and rules with `fail = true`), 1 findings,
2 wrong use or unreadable input";

/// What can be done besides checking.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Print the page of a rule or a compile error
    Explain {
        /// Its name
        name: String,
    },
    /// List all rules; as JSON with compile errors and all that is known of each
    Rules {
        /// How to print them: human, json
        #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
        #[arg(hide_possible_values = true)]
        format: ListFormat,
    },
    /// Set the code of shaders in one style; only white space changes
    Fmt(super::super::fmt::FormatArgs),
    /// Draw a shader without a GPU, and say what was seen
    Run(Box<super::super::run::RunArgs>),
    /// Run the tests that are written in GLSL, and compare pictures with those that were blessed
    Test(Box<super::super::test::TestArgs>),
    /// Make a shader small while what is reported of it stays
    Reduce(super::reduce::ReduceArgs),
    /// Print what a shader becomes before it is looked at
    #[command(hide = true)]
    Ir {
        /// The shader
        #[arg(value_name = "FILE")]
        file: PathBuf,
    },
    /// Serve an editor: the language server, over standard input and output
    #[cfg(feature = "lsp")]
    Lsp {
        /// What editors pass on to name the way; there is no other
        #[arg(long, hide = true)]
        stdio: bool,
    },
    /// Serve a program that calls tools: the Model Context Protocol, over standard input and output
    #[cfg(feature = "mcp")]
    Mcp,
    /// What `shaderport` does, for tools that know where this program is alone
    #[cfg(feature = "mcp")]
    #[command(hide = true, disable_help_flag = true)]
    Port {
        /// They are parsed where the command is run: no other has to build that parser
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<OsString>,
    },
    /// Print the completions for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the man page
    Man,
    /// Print the JSON schema of shaderlint.toml
    Schema,
}

/// The values of `--format` for lists.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum ListFormat {
    /// A table
    #[default]
    Human,
    /// One JSON object
    Json,
}

/// The values of `--format`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum FormatChoice {
    /// With excerpts of the source
    #[default]
    Human,
    /// One line a finding
    Short,
    /// One line a finding, with all that belongs to it
    Agent,
    /// One JSON object
    Json,
    /// One JSON object a line
    Jsonl,
    /// SARIF 2.1.0
    Sarif,
    /// Annotations of GitHub Actions
    Github,
    /// GitLab's code quality report
    Gitlab,
    /// JUnit XML
    Junit,
    /// Checkstyle XML
    Checkstyle,
}

/// How much is said.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Talk {
    /// `-qq`: only the exit code.
    Nothing,
    /// `-q`: findings.
    Findings,
    /// Findings and a summary.
    Normal,
    /// `-v`: what was read, too.
    Verbose,
}

impl LintArgs {
    /// The output format.
    pub fn format(&self) -> Format {
        match self.format {
            _ if self.statistics => Format::Statistics,
            FormatChoice::Human => Format::Human,
            FormatChoice::Short => Format::Short,
            FormatChoice::Agent => Format::Agent,
            FormatChoice::Json => Format::Json,
            FormatChoice::Jsonl => Format::Jsonl,
            FormatChoice::Sarif => Format::Sarif,
            FormatChoice::Github => Format::Github,
            FormatChoice::Gitlab => Format::Gitlab,
            FormatChoice::Junit => Format::Junit,
            FormatChoice::Checkstyle => Format::Checkstyle,
        }
    }

    /// How much is said.
    pub fn talk(&self) -> Talk {
        match (self.verbose, self.quiet) {
            (true, _) => Talk::Verbose,
            (false, 0) => Talk::Normal,
            (false, 1) => Talk::Findings,
            (false, _) => Talk::Nothing,
        }
    }

    /// The paths to check.
    pub fn paths(&self) -> Vec<PathBuf> {
        match self.paths.as_slice() {
            [] => vec![PathBuf::from(".")],
            paths => paths.to_vec(),
        }
    }

    /// What is said of configurations.
    pub fn asked(&self) -> ConfigArgs {
        ConfigArgs {
            given: Selection {
                dialect: self.dialect,
                host: self.host,
                select: self.select.clone(),
                ignore: self.ignore.clone(),
                only: self.only.clone(),
                run_samples: self.run_samples.or(self.no_run.then_some(0)),
            },
            source: match &self.config {
                Some(file) => Source::File(file.clone()),
                None if self.no_config => Source::Nowhere,
                None => Source::Nearest,
            },
            exclusion: if self.force_exclude {
                Exclusion::Named
            } else {
                Exclusion::Found
            },
            paths: self.paths(),
        }
    }
}
