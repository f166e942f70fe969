//! `shaderlint.toml` as data, how it is read, and which one applies to a file.

mod layer;
mod load;
mod project;
#[cfg(feature = "cli")]
mod read;
mod search;
mod selection;

pub use layer::{Adjustment, Config, Layer};
pub use load::{ConfigProblem, FILE, LastGood};
pub use project::ProjectLimit;
#[cfg(feature = "cli")]
pub use read::{ConfigError, parse, schema};
pub use search::{ConfigArgs, ConfigSource, Configs, Exclusion};
pub use selection::{Selection, options, style};
