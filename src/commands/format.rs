//! What is asked of the formatter: the same for the command line, MCP and WebAssembly.

use serde::{Deserialize, Serialize};
use shaderlint_format::{Indentation, StyleChoice};

/// The style of formatted code; the configuration decides on what is not given.
#[derive(Clone, Copy, Default, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::Args, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", command(next_help_heading = "Style"))]
#[serde(default, rename_all = "camelCase")]
pub struct FormatRequest {
    /// Spaces per level, up to 16; 0 for tabs
    #[cfg_attr(feature = "cli", arg(long, value_name = "N"))]
    pub indent: Option<u32>,
    /// Maximum length of a line in characters
    #[cfg_attr(feature = "cli", arg(long, value_name = "N"))]
    pub line_length: Option<u32>,
}

impl FormatRequest {
    /// The options that are given.
    pub fn choice(self) -> StyleChoice {
        StyleChoice {
            indent: self.indent.map(|spaces| match spaces {
                0 => Indentation::Tab(4),
                spaces => Indentation::Spaces(spaces.min(16)),
            }),
            width: self.line_length,
            brace: None,
        }
    }
}
