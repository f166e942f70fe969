//! Every lint rule: a pair of files each, `NAME.rs` for what it does and `NAME.md` for what it
//! means. `errors/` holds the pages of the compile errors.

mod backend_keyword;
mod bright_light;
mod derivative_in_divergent_flow;
mod directional_only_indoors;
mod double_underscore;
mod float_equality;
mod fog_unclamped;
mod gradient_in_loop;
mod gray_material;
mod height_band_spacing;
mod isnan_optimised;
mod loop_invariant_call;
mod low_ambient;
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
    &bright_light::RULE,
    &derivative_in_divergent_flow::RULE,
    &directional_only_indoors::RULE,
    &double_underscore::RULE,
    &float_equality::RULE,
    &fog_unclamped::RULE,
    &gradient_in_loop::RULE,
    &gray_material::RULE,
    &height_band_spacing::RULE,
    &isnan_optimised::RULE,
    &loop_invariant_call::RULE,
    &low_ambient::RULE,
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
