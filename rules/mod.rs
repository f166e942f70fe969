//! Every lint rule: a pair of files each, `NAME.rs` for what it does and `NAME.md` for what it
//! means. `errors/` holds the pages of the compile errors.

mod backend_keyword;
mod derivative_in_divergent_flow;
mod double_underscore;
mod float_equality;
mod gradient_in_loop;
mod isnan_optimised;
mod loop_invariant_call;
mod map_inlining;
mod mediump_noise;
mod nested_iterations;
mod no_early_exit;
mod octave_budget;
mod precision_missing_for_sampler;
mod repeated_call;
mod shadow_steps;
mod shadows_builtin;
mod sin_hash;
mod step_budget;
mod switch_return;
mod tunable_range;
mod unbounded_loop;

use crate::lint::Rule;

/// All rules, by name.
#[rustfmt::skip]
pub static RULES: &[&Rule] = &[
    &backend_keyword::RULE,
    &derivative_in_divergent_flow::RULE,
    &double_underscore::RULE,
    &float_equality::RULE,
    &gradient_in_loop::RULE,
    &isnan_optimised::RULE,
    &loop_invariant_call::RULE,
    &map_inlining::RULE,
    &mediump_noise::RULE,
    &nested_iterations::RULE,
    &no_early_exit::RULE,
    &octave_budget::RULE,
    &precision_missing_for_sampler::RULE,
    &repeated_call::RULE,
    &shadow_steps::RULE,
    &shadows_builtin::RULE,
    &sin_hash::RULE,
    &step_budget::RULE,
    &switch_return::RULE,
    &tunable_range::RULE,
    &unbounded_loop::RULE,
];
