//! Every lint rule: a pair of files each, `NAME.rs` for what it does and `NAME.md` for what it
//! means. `errors/` holds the pages of the compile errors.

mod clamp_bounds;
mod float_equality;
mod index_range;
mod inout_alias;
mod integer_division;
mod inverse_trig_range;
mod log_nonpositive;
mod missing_return_path;
mod nan_compare;
mod negative_to_uint;
mod normalize_zero;
mod output_not_written;
mod pow_negative_base;
mod shift_range;
mod smoothstep_edges;
mod sqrt_negative;
mod step_budget;
mod uninitialized_read;
mod zero_division;

use crate::lint::Rule;

/// All rules, by name.
#[rustfmt::skip]
pub static RULES: &[&Rule] = &[
    &clamp_bounds::RULE,
    &float_equality::RULE,
    &index_range::RULE,
    &inout_alias::RULE,
    &integer_division::RULE,
    &inverse_trig_range::RULE,
    &log_nonpositive::RULE,
    &missing_return_path::RULE,
    &nan_compare::RULE,
    &negative_to_uint::RULE,
    &normalize_zero::RULE,
    &output_not_written::RULE,
    &pow_negative_base::RULE,
    &shift_range::RULE,
    &smoothstep_edges::RULE,
    &sqrt_negative::RULE,
    &step_budget::RULE,
    &uninitialized_read::RULE,
    &zero_division::RULE,
];
