//! What a lint rule is, and how rules are run. No rule is in here; they are in `rules/`.

mod context;
mod facts;
mod fix;
mod page;
mod rule;
mod run;
mod settings;
mod suppress;

pub use context::{Context, Finding};
pub use facts::Facts;
pub use fix::{Allow, Fixed, Look, fix};
pub use page::{Fence, FenceKind, Page};
pub use rule::{Binary, Builtin, Check, Group, Rule, RuleOption};
pub use run::{lint, lint_within};
pub use settings::{Settings, Target, UnknownRule, nearest_rule};
pub use suppress::Allows;
