//! What a lint rule is, and how rules are run. No rule is in here; they are in `rules/`.

mod context;
mod facts;
mod fix;
pub mod light;
pub mod march;
mod page;
mod removal;
mod rule;
mod run;
mod same;
mod settings;
mod suppress;
mod words;

pub use context::{Context, Finding};
pub use facts::Facts;
pub use fix::{Allow, Fixed, Look, fix};
pub use page::{Fence, FenceKind, Page};
pub use removal::{remove_declarator, remove_lines, remove_statement};
pub use rule::{Binary, Builtin, Check, Group, Rule, RuleOption, Shape};
pub use run::{lint, lint_within};
pub use same::{code_hash, same_code};
pub use settings::{Settings, Target, UnknownRule, nearest_rule};
pub use suppress::Allows;
pub use words::{Counts, Unseen};
