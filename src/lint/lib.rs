//! Definition of lint rules, and the engine that runs them. The rules themselves are in `rules/`.
#![cfg_attr(test, allow(clippy::string_slice))]

mod broken;
mod change;
mod context;
#[cfg(test)]
mod example_rules;
pub mod expansion;
mod facts;
mod fix;
pub mod formula;
pub mod given;
pub mod indent;
mod judged;
mod look;
pub mod march;
mod misspelt;
mod option;
mod page;
mod removal;
mod rule;
mod run;
mod same;
pub mod screen;
mod settings;
pub mod still;
mod suppress;
pub mod trial;
mod unseen;
mod words;

pub use broken::Broken;
pub use context::{Context, Finding};
pub use facts::{Around, Facts, Known};
pub use fix::{Allow, Fixed, Proof, fix, keep_comments, without_pictures};
pub use judged::Judged;
pub use look::{Look, Shown};
pub use option::{OptionType, OptionValue, RuleOption, Setting};
pub use page::{Fence, FenceKind, Page};
pub use removal::{remove_declaration, remove_lines, remove_statement};
pub use rule::{
    ALIASES, BinaryExpr, Builtin, Check, DeclaredName, DeclaredVariable, Group, Named, Rule, Shape,
    rule_name,
};
pub use run::{Unrun, lint, lint_within};
pub use same::{code_hash, same_code};
pub use settings::{Failing, Reach, Renderer, Settings, UnknownRule, nearest_name, nearest_rule};
pub use suppress::Allows;
pub use unseen::Unseen;
