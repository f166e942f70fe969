//! The arguments of `shaderlint`.

use super::super::config::{Exclusion, Given, Source};
use super::super::document::DialectChoice;
use crate::report::Format;
use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::io::{self, IsTerminal};
use std::path::PathBuf;

/// Checks GLSL for WebGL2 and ShaderToy. An error means that the browser's compiler refuses the
/// shader; everything else is a warning or an info.
#[derive(Parser, Debug)]
#[command(name = "shaderlint", version, about, max_term_width = 100)]
#[command(subcommand_negates_reqs = true, args_conflicts_with_subcommands = true)]
#[command(
    disable_help_subcommand = true,
    subcommand_help_heading = "Instead of PATH"
)]
#[command(override_usage = "shaderlint [OPTIONS] <PATH>...\n       shaderlint <COMMAND>")]
pub struct Args {
    /// Something else than checking
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Files and folders to check; `-` is standard input
    #[arg(value_name = "PATH", required_unless_present = "explain")]
    pub paths: Vec<PathBuf>,
    /// How to print the findings
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "FORMAT",
        hide_possible_values = true
    )]
    #[arg(
        help = "How to print the findings: human, short, json, jsonl, sarif, github, gitlab, junit, checkstyle"
    )]
    pub format: FormatChoice,
    /// What the shaders are written for
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "DIALECT",
        hide_possible_values = true
    )]
    #[arg(help = "What the shaders are written for: auto, shadertoy, webgl2, webgl1")]
    pub dialect: DialectChoice,
    /// Name that stands for standard input in messages, and tells by its ending what it is
    #[arg(long, value_name = "NAME")]
    pub stdin_filename: Option<String>,
    /// Run these rules or groups too; `all` is every rule
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub select: Vec<String>,
    /// Do not run these rules or groups
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    pub ignore: Vec<String>,
    /// Write the fixes that keep the picture into the files
    #[arg(long)]
    pub fix: bool,
    /// Write the other fixes too
    #[arg(long)]
    pub unsafe_fixes: bool,
    /// Print what the fixes would change, and write nothing
    #[arg(long)]
    pub diff: bool,
    /// Exit with 1 on warnings too
    #[arg(long)]
    pub deny_warnings: bool,
    /// Leave out the findings that this file names
    #[arg(long, value_name = "FILE")]
    pub baseline: Option<PathBuf>,
    /// Write the findings into this file, for --baseline
    #[arg(long, value_name = "FILE", conflicts_with_all = ["baseline", "fix", "unsafe_fixes", "diff", "watch"])]
    pub write_baseline: Option<PathBuf>,
    /// Print how often each rule finds something, not the findings
    #[arg(long, conflicts_with = "diff")]
    pub statistics: bool,
    /// Check again whenever a file changes
    #[arg(long)]
    pub watch: bool,
    /// The configuration, in place of the nearest shaderlint.toml above each file
    #[arg(long, value_name = "PATH", conflicts_with = "no_config")]
    pub config: Option<PathBuf>,
    /// Take no configuration
    #[arg(long)]
    pub no_config: bool,
    /// Leave out what the configuration excludes even where it is named, as hooks name files
    #[arg(long)]
    pub force_exclude: bool,
    /// Print the page of a rule or a compile error
    #[arg(long, value_name = "NAME", conflicts_with = "paths")]
    pub explain: Option<String>,
    /// When to print in colour: auto, always, never
    #[arg(
        long,
        value_enum,
        default_value_t,
        value_name = "WHEN",
        hide_possible_values = true
    )]
    pub color: ColorChoice,
}

/// What can be done besides checking.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Print the page of a rule or a compile error
    Explain {
        /// Its name
        name: String,
    },
    /// List all rules
    Rules,
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

/// The values of `--format`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, ValueEnum)]
pub enum FormatChoice {
    /// With excerpts of the source
    #[default]
    Human,
    /// One line a finding
    Short,
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

/// The values of `--color`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub enum ColorChoice {
    /// On a terminal, unless the environment says otherwise
    #[default]
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl ColorChoice {
    /// Whether to print in colour.
    pub fn is_on(self) -> bool {
        let is_set = |name: &str| std::env::var_os(name).is_some_and(|v| !v.is_empty());
        match self {
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto if is_set("NO_COLOR") => false,
            ColorChoice::Auto if is_set("FORCE_COLOR") || is_set("CLICOLOR_FORCE") => true,
            ColorChoice::Auto => {
                let dumb = std::env::var_os("TERM").is_some_and(|t| t == "dumb");
                !dumb && io::stdout().is_terminal()
            }
        }
    }
}

impl Args {
    /// The output format.
    pub fn format(&self) -> Format {
        match self.format {
            _ if self.statistics => Format::Statistics,
            FormatChoice::Human => Format::Human,
            FormatChoice::Short => Format::Short,
            FormatChoice::Json => Format::Json,
            FormatChoice::Jsonl => Format::Jsonl,
            FormatChoice::Sarif => Format::Sarif,
            FormatChoice::Github => Format::Github,
            FormatChoice::Gitlab => Format::Gitlab,
            FormatChoice::Junit => Format::Junit,
            FormatChoice::Checkstyle => Format::Checkstyle,
        }
    }

    /// What goes before every configuration.
    pub fn given(&self) -> Given {
        Given {
            dialect: self.dialect,
            select: self.select.clone(),
            ignore: self.ignore.clone(),
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
        }
    }
}
