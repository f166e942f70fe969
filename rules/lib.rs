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

/// Lists the rules of these modules, sorted by name.
macro_rules! rules {
    ($($module:ident)+) => {
        /// All rules, sorted by name.
        pub static RULES: &[&Rule] = &[$(&$module::RULE),+];
    };
}

mod aspect_ellipse;
mod assignment_in_condition;
mod attribute_data;
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
mod program_state;
mod redundant_constructor;
mod redundant_normalize;
mod render_target;
mod repeated_call;
mod rounded_away;
mod same_operands;
mod screen_size;
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
mod uniform_access;
mod uniform_type;
mod uniform_without_effect;
mod uninitialized_read;
mod uninitialized_seen;
mod unknown_uniform;
mod unmatched_patch;
mod unreachable_case;
mod unreachable_height;
mod unset_uniform;
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

rules! {
    aspect_ellipse
    assignment_in_condition
    attribute_data
    backend_keyword
    black_silhouette
    camera_inside
    clamp_bounds
    comment_continues
    component_by_index
    constant_condition
    contradiction
    copied_component
    could_be_const
    dangling_else
    dark_frame
    dead_code
    dead_store
    define_with_call
    degrees_in_trig
    derivative_in_divergent_flow
    derivative_of_jump
    derivative_of_uniform
    division_by_zero_seen
    double_gamma
    double_underscore
    duplicate_branch
    empty_body
    endless_rays
    exp_overflow
    extension_not_enabled
    flat_frame
    float_counter_drift
    float_equality
    gpu_dependent_picture
    gradient_in_loop
    gray_picture
    half_texel
    identity_operation
    index_range
    infinite_pixels
    inout_alias
    integer_division
    inverse_trig_range
    isnan_optimised
    known_comparison
    legacy_extension
    length_compare
    log_nonpositive
    loop_invariant_call
    loop_invariant_math
    loop_never_runs
    luma_weights
    macro_parentheses
    macro_statements
    mainimage_qualifiers
    manual_builtin
    map_inlining
    mediump_noise
    misleading_indentation
    misplaced_sign
    missed_surface
    missing_return_path
    mistyped_constant
    mouse_sign
    nan_compare
    nan_pixels
    needless_bool
    negative_remainder
    negative_to_uint
    nested_iterations
    no_early_exit
    no_effect
    normal_length
    normalize_zero
    octal_literal
    octave_budget
    old_version
    out_of_range_seen
    output_not_written
    overwritten_parameter
    period_jump
    pow_in_loop
    pow_negative_base
    precision_missing_for_sampler
    program_state
    redundant_constructor
    redundant_normalize
    render_target
    repeated_call
    rounded_away
    same_operands
    screen_size
    self_assignment
    shadow_steps
    shadowed_name
    shadows_builtin
    shared_counter
    shift_precedence
    shift_range
    short_steps
    sin_hash
    single_turn_loop
    six_sample_normal
    smoothstep_edges
    sqrt_negative
    static_picture
    step_budget
    steps_exhausted
    swapped_arguments
    switch_fallthrough
    switch_return
    texel_out_of_range
    texture_seam
    texture_units
    time_precision
    truncated_cell
    tunable_range
    unbounded_loop
    undefined_constant
    undefined_seen
    uniform_access
    uniform_type
    uniform_without_effect
    uninitialized_read
    uninitialized_seen
    unknown_uniform
    unmatched_patch
    unreachable_case
    unreachable_height
    unset_uniform
    unsigned_underflow
    unused_allow
    unused_function
    unused_macro
    unused_parameter
    unused_uniform
    unused_variable
    useless_clamp
    vec2_resolution
    vector_times_matrix
    washed_out
    webgl1_context
    zero_division
}
