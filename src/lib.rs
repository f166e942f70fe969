//! shaderlint checks GLSL for WebGL2 and ShaderToy; shaderport turns ShaderToy code into WebGL2.
//!
//! `src/README.md` draws the house. Each layer is a crate; this one holds the programs.
#![forbid(unsafe_code)]
#![deny(clippy::disallowed_methods)]
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::todo,
        clippy::unimplemented,
        clippy::indexing_slicing,
        clippy::string_slice
    )
)]

#[cfg(feature = "cli")]
pub mod cli;

pub use shaderlint_commands as commands;
#[cfg(feature = "dap")]
pub use shaderlint_dap as dap;
pub use shaderlint_detect as detect;
pub use shaderlint_diagnostic as diagnostic;
pub use shaderlint_engine as engine;
pub use shaderlint_exec as exec;
pub use shaderlint_explain as explain;
pub use shaderlint_flow as flow;
pub use shaderlint_format as format;
pub use shaderlint_host as host;
pub use shaderlint_ide as ide;
pub use shaderlint_ir as ir;
pub use shaderlint_lint as lint;
#[cfg(feature = "lsp")]
pub use shaderlint_lsp as lsp;
pub use shaderlint_play as play;
pub use shaderlint_port as port;
pub use shaderlint_project as project;
pub use shaderlint_report as report;
pub use shaderlint_rules as rules;
pub use shaderlint_script as script;
pub use shaderlint_semantic as semantic;
pub use shaderlint_syntax as syntax;
pub use shaderlint_text as text;
