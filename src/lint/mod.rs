//! What a lint rule is, and how rules are run. No rule is in here; they are in `rules/`.

mod context;
mod rule;
mod run;

pub use context::{Context, Finding};
pub use rule::{Binary, Check, Group, Rule};
pub use run::{Selection, UnknownRule, lint};
