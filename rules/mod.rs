//! Every lint rule: a pair of files each, `NAME.rs` for what it does and `NAME.md` for what it
//! means. `errors/` holds the pages of the compile errors.

mod assignment_in_condition;
mod backend_keyword;
mod bright_light;
mod constant_condition;
mod dead_code;
mod define_with_call;
mod derivative_in_divergent_flow;
mod directional_only_indoors;
mod double_underscore;
mod duplicate_branch;
mod float_equality;
mod fog_unclamped;
mod gradient_in_loop;
mod gray_material;
mod height_band_spacing;
mod isnan_optimised;
mod legacy_extension;
mod loop_invariant_call;
mod low_ambient;
mod mainimage_qualifiers;
mod manual_builtin;
mod map_inlining;
mod mediump_noise;
mod nested_iterations;
mod no_early_exit;
mod no_effect;
mod octave_budget;
mod precision_missing_for_sampler;
mod redundant_constructor;
mod repeated_call;
mod self_assignment;
mod shadow_steps;
mod shadowed_name;
mod shadows_builtin;
mod sin_hash;
mod step_budget;
mod switch_return;
mod tunable_range;
mod unbounded_loop;
mod unused_function;
mod unused_macro;
mod unused_parameter;
mod unused_uniform;
mod unused_variable;
mod vec2_resolution;

use crate::lint::Rule;

/// All rules, by name.
#[rustfmt::skip]
pub static RULES: &[&Rule] = &[
    &assignment_in_condition::RULE,
    &backend_keyword::RULE,
    &bright_light::RULE,
    &constant_condition::RULE,
    &dead_code::RULE,
    &define_with_call::RULE,
    &derivative_in_divergent_flow::RULE,
    &directional_only_indoors::RULE,
    &double_underscore::RULE,
    &duplicate_branch::RULE,
    &float_equality::RULE,
    &fog_unclamped::RULE,
    &gradient_in_loop::RULE,
    &gray_material::RULE,
    &height_band_spacing::RULE,
    &isnan_optimised::RULE,
    &legacy_extension::RULE,
    &loop_invariant_call::RULE,
    &low_ambient::RULE,
    &mainimage_qualifiers::RULE,
    &manual_builtin::RULE,
    &map_inlining::RULE,
    &mediump_noise::RULE,
    &nested_iterations::RULE,
    &no_early_exit::RULE,
    &no_effect::RULE,
    &octave_budget::RULE,
    &precision_missing_for_sampler::RULE,
    &redundant_constructor::RULE,
    &repeated_call::RULE,
    &self_assignment::RULE,
    &shadow_steps::RULE,
    &shadowed_name::RULE,
    &shadows_builtin::RULE,
    &sin_hash::RULE,
    &step_budget::RULE,
    &switch_return::RULE,
    &tunable_range::RULE,
    &unbounded_loop::RULE,
    &unused_function::RULE,
    &unused_macro::RULE,
    &unused_parameter::RULE,
    &unused_uniform::RULE,
    &unused_variable::RULE,
    &vec2_resolution::RULE,
];
