//! All lint rules. Each is a pair of files: `NAME.rs` implements it, `NAME.md` is its page. `errors/` has
//! the pages of the compile errors.

/// Declares the rule of a file: its name, group, severity, preset, options if it has some, and what it is
/// called for, as [`Check`](shaderlint_lint::Check) lists it. The page is in the file beside it.
macro_rules! rule {
    (
        $name:ident, $group:ident, $severity:ident, $preset:ident,
        $([$($option:ident($setting:expr)),+],)?
        $($check:ident $(($($argument:expr),+))?),+
    ) => {
        pub static RULE: shaderlint_lint::Rule = shaderlint_lint::Rule {
            name: {
                const NAME: &str = stringify!($name);
                const KEBAB: [u8; NAME.len()] = shaderlint_lint::kebab(NAME);
                match str::from_utf8(&KEBAB) {
                    Ok(name) => name,
                    Err(_) => NAME,
                }
            },
            group: shaderlint_lint::Group::$group,
            severity: shaderlint_diagnostic::Severity::$severity,
            preset: shaderlint_lint::RulePreset::$preset,
            options: &[$($(shaderlint_lint::RuleOption::$option($setting)),+)?],
            page: include_str!(concat!(stringify!($name), ".md")),
            checks: &[$(shaderlint_lint::Check::$check $(($($argument),+))?),+],
        };
    };
}

mod aspect_ellipse;
mod assignment_in_condition;
mod backend_keyword;
mod black_silhouette;
mod camera_inside;
mod clamp_bounds;
mod comment_continues;
mod component_by_index;
mod constant_condition;
mod contradiction;
mod copied_component;
mod could_be_const;
mod dangling_else;
mod dark_frame;
mod dead_code;
mod dead_store;
mod define_with_call;
mod degrees_in_trig;
mod derivative_in_divergent_flow;
mod derivative_of_jump;
mod derivative_of_uniform;
mod division_by_zero_seen;
mod double_gamma;
mod double_underscore;
mod duplicate_branch;
mod empty_body;
mod endless_rays;
mod errors;
mod exp_overflow;
mod extension_not_enabled;
mod flat_frame;
mod float_counter_drift;
mod float_equality;
mod gpu_dependent_picture;
mod gradient_in_loop;
mod gray_picture;
mod half_texel;
mod identity_operation;
mod index_range;
mod infinite_pixels;
mod inout_alias;
mod integer_division;
mod inverse_trig_range;
mod isnan_optimised;
mod known_comparison;
mod legacy_extension;
mod length_compare;
mod log_nonpositive;
mod loop_invariant_call;
mod loop_invariant_math;
mod loop_never_runs;
mod luma_weights;
mod macro_parentheses;
mod macro_statements;
mod mainimage_qualifiers;
mod manual_builtin;
mod map_inlining;
mod mediump_noise;
mod misleading_indentation;
mod misplaced_sign;
mod missed_surface;
mod missing_return_path;
mod mistyped_constant;
mod mouse_sign;
mod nan_compare;
mod nan_pixels;
mod needless_bool;
mod negative_remainder;
mod negative_to_uint;
mod nested_iterations;
mod no_early_exit;
mod no_effect;
mod normal_length;
mod normalize_zero;
mod octal_literal;
mod octave_budget;
mod old_version;
mod out_of_range_seen;
mod output_not_written;
mod overwritten_parameter;
mod period_jump;
mod pow_in_loop;
mod pow_negative_base;
mod precision_missing_for_sampler;
mod redundant_constructor;
mod redundant_normalize;
mod repeated_call;
mod rounded_away;
mod same_operands;
mod self_assignment;
mod shadow_steps;
mod shadowed_name;
mod shadows_builtin;
mod shared_counter;
mod shift_precedence;
mod shift_range;
mod short_steps;
mod sin_hash;
mod single_turn_loop;
mod six_sample_normal;
mod smoothstep_edges;
mod sqrt_negative;
mod static_picture;
mod step_budget;
mod steps_exhausted;
mod swapped_arguments;
mod switch_fallthrough;
mod switch_return;
mod texel_out_of_range;
mod texture_seam;
mod texture_units;
mod time_precision;
mod truncated_cell;
mod tunable_range;
mod unbounded_loop;
mod undefined_constant;
mod undefined_seen;
mod uniform_without_effect;
mod uninitialized_read;
mod uninitialized_seen;
mod unknown_uniform;
mod unreachable_case;
mod unreachable_height;
mod unsigned_underflow;
mod unused_allow;
mod unused_function;
mod unused_macro;
mod unused_parameter;
mod unused_uniform;
mod unused_variable;
mod useless_clamp;
mod vec2_resolution;
mod vector_times_matrix;
mod washed_out;
mod webgl1_context;
mod zero_division;

use shaderlint_lint::{Rule, rule_name};

pub use errors::error_page;

/// The rule with a name or alias.
pub fn rule(name: &str) -> Option<&'static Rule> {
    let name = rule_name(name);
    RULES.iter().find(|rule| rule.name == name).copied()
}

/// The page of a rule or a compile error, in Markdown.
pub fn page(name: &str) -> Option<&'static str> {
    rule(name).map_or_else(|| error_page(name), |rule| Some(rule.page))
}

/// All rules, sorted by name.
#[rustfmt::skip]
pub static RULES: &[&Rule] = &[
    &aspect_ellipse::RULE,
    &assignment_in_condition::RULE,
    &backend_keyword::RULE,
    &black_silhouette::RULE,
    &camera_inside::RULE,
    &clamp_bounds::RULE,
    &comment_continues::RULE,
    &component_by_index::RULE,
    &constant_condition::RULE,
    &contradiction::RULE,
    &copied_component::RULE,
    &could_be_const::RULE,
    &dangling_else::RULE,
    &dark_frame::RULE,
    &dead_code::RULE,
    &dead_store::RULE,
    &define_with_call::RULE,
    &degrees_in_trig::RULE,
    &derivative_in_divergent_flow::RULE,
    &derivative_of_jump::RULE,
    &derivative_of_uniform::RULE,
    &division_by_zero_seen::RULE,
    &double_gamma::RULE,
    &double_underscore::RULE,
    &duplicate_branch::RULE,
    &empty_body::RULE,
    &endless_rays::RULE,
    &exp_overflow::RULE,
    &extension_not_enabled::RULE,
    &flat_frame::RULE,
    &float_counter_drift::RULE,
    &float_equality::RULE,
    &gpu_dependent_picture::RULE,
    &gradient_in_loop::RULE,
    &gray_picture::RULE,
    &half_texel::RULE,
    &identity_operation::RULE,
    &index_range::RULE,
    &infinite_pixels::RULE,
    &inout_alias::RULE,
    &integer_division::RULE,
    &inverse_trig_range::RULE,
    &isnan_optimised::RULE,
    &known_comparison::RULE,
    &legacy_extension::RULE,
    &length_compare::RULE,
    &log_nonpositive::RULE,
    &loop_invariant_call::RULE,
    &loop_invariant_math::RULE,
    &loop_never_runs::RULE,
    &luma_weights::RULE,
    &macro_parentheses::RULE,
    &macro_statements::RULE,
    &mainimage_qualifiers::RULE,
    &manual_builtin::RULE,
    &map_inlining::RULE,
    &mediump_noise::RULE,
    &misleading_indentation::RULE,
    &misplaced_sign::RULE,
    &missed_surface::RULE,
    &missing_return_path::RULE,
    &mistyped_constant::RULE,
    &mouse_sign::RULE,
    &nan_compare::RULE,
    &nan_pixels::RULE,
    &needless_bool::RULE,
    &negative_remainder::RULE,
    &negative_to_uint::RULE,
    &nested_iterations::RULE,
    &no_early_exit::RULE,
    &no_effect::RULE,
    &normal_length::RULE,
    &normalize_zero::RULE,
    &octal_literal::RULE,
    &octave_budget::RULE,
    &old_version::RULE,
    &out_of_range_seen::RULE,
    &output_not_written::RULE,
    &overwritten_parameter::RULE,
    &period_jump::RULE,
    &pow_in_loop::RULE,
    &pow_negative_base::RULE,
    &precision_missing_for_sampler::RULE,
    &redundant_constructor::RULE,
    &redundant_normalize::RULE,
    &repeated_call::RULE,
    &rounded_away::RULE,
    &same_operands::RULE,
    &self_assignment::RULE,
    &shadow_steps::RULE,
    &shadowed_name::RULE,
    &shadows_builtin::RULE,
    &shared_counter::RULE,
    &shift_precedence::RULE,
    &shift_range::RULE,
    &short_steps::RULE,
    &sin_hash::RULE,
    &single_turn_loop::RULE,
    &six_sample_normal::RULE,
    &smoothstep_edges::RULE,
    &sqrt_negative::RULE,
    &static_picture::RULE,
    &step_budget::RULE,
    &steps_exhausted::RULE,
    &swapped_arguments::RULE,
    &switch_fallthrough::RULE,
    &switch_return::RULE,
    &texel_out_of_range::RULE,
    &texture_seam::RULE,
    &texture_units::RULE,
    &time_precision::RULE,
    &truncated_cell::RULE,
    &tunable_range::RULE,
    &unbounded_loop::RULE,
    &undefined_constant::RULE,
    &undefined_seen::RULE,
    &uniform_without_effect::RULE,
    &uninitialized_read::RULE,
    &uninitialized_seen::RULE,
    &unknown_uniform::RULE,
    &unreachable_case::RULE,
    &unreachable_height::RULE,
    &unsigned_underflow::RULE,
    &unused_allow::RULE,
    &unused_function::RULE,
    &unused_macro::RULE,
    &unused_parameter::RULE,
    &unused_uniform::RULE,
    &unused_variable::RULE,
    &useless_clamp::RULE,
    &vec2_resolution::RULE,
    &vector_times_matrix::RULE,
    &washed_out::RULE,
    &webgl1_context::RULE,
    &zero_division::RULE,
];
