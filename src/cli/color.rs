//! Whether to use colours.

use clap::ValueEnum;
use std::io::{self, IsTerminal};

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
    /// Whether to use colours, given the terminal and the environment variables.
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
