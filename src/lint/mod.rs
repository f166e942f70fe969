//! What a lint rule is, and how rules are run. No rule is in here; they are in `rules/`.

mod context;
mod facts;
mod fix;
mod page;
mod removal;
mod rule;
mod run;
mod same;
mod settings;
mod words;

pub use context::{Context, Finding};
pub use facts::Facts;
pub use fix::{Allow, Fixed, Look, fix};
pub use page::{Fence, FenceKind, Page};
pub use removal::{remove_declarator, remove_lines, remove_statement};
pub use rule::{Binary, Builtin, Check, Group, Rule, RuleOption};
pub use run::lint;
pub use same::{code_hash, same_code};
pub use settings::{Settings, Target, UnknownRule};
pub use words::{Counts, Unseen};
