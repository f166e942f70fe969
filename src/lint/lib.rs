//! Definition of lint rules, and the engine that runs them. The rules themselves are in `rules/`.
#![cfg_attr(test, allow(clippy::string_slice))]

mod absorb;
mod broken;
mod checked_spans;
mod context;
#[cfg(test)]
mod example_rules;
pub mod expansion;
mod facts;
mod fix;
pub mod formula;
pub mod given;
mod inactive_words;
pub mod loop_invariant;
pub mod march;
mod option;
mod page;
pub mod prelude;
mod rule;
mod run;
mod same;
pub mod sample;
pub mod screen;
mod settings;
mod suppress;
mod words;

pub use broken::{Broken, Obstacles};
pub use checked_spans::CheckedSpans;
pub use context::{Context, Finding};
pub use facts::{CachedFacts, Facts, ShaderContext};
pub use fix::indent;
pub use fix::look::{Look, Shown};
pub use fix::removal::{remove_declaration, remove_lines, remove_statement, without_statement};
pub use fix::{Allow, Fixed, Proof, failing_fixes, fix, keep_comments, without_images};
pub use inactive_words::InactiveWords;
pub use option::{OptionType, OptionValue, RuleOption, Setting};
pub use page::{Fence, FenceKind, Page};
pub use rule::{
    ALIASES, BinaryExpr, Builtin, Check, DeclaredName, DeclaredVariable, Group, Named, Rule,
    RulePreset, Shape, kebab, rule_name,
};
pub use run::{SkippedRules, lint, lint_within};
pub use same::{code_hash, same_code};
pub use settings::{
    Failing, Infos, Reach, Renderer, Settings, UnknownRule, nearest_name, nearest_rule,
};
pub use suppress::Allows;
