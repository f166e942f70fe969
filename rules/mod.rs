//! Every lint rule: a pair of files each, `NAME.rs` for what it does and `NAME.md` for what it
//! means. `errors/` holds the pages of the compile errors.

mod float_equality;
mod step_budget;
mod unused_allow;
mod webgl1_context;

use crate::lint::Rule;

/// All rules, by name.
#[rustfmt::skip]
pub static RULES: &[&Rule] = &[
    &float_equality::RULE,
    &step_budget::RULE,
    &unused_allow::RULE,
    &webgl1_context::RULE,
];
