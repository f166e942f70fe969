//! Every lint rule: a pair of files each, `NAME.rs` for what it does and `NAME.md` for what it
//! means. `errors/` holds the pages of the compile errors.

mod assignment_in_condition;
mod constant_condition;
mod dead_code;
mod define_with_call;
mod duplicate_branch;
mod float_equality;
mod legacy_extension;
mod mainimage_qualifiers;
mod manual_builtin;
mod no_effect;
mod redundant_constructor;
mod self_assignment;
mod shadowed_name;
mod step_budget;
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
    &constant_condition::RULE,
    &dead_code::RULE,
    &define_with_call::RULE,
    &duplicate_branch::RULE,
    &float_equality::RULE,
    &legacy_extension::RULE,
    &mainimage_qualifiers::RULE,
    &manual_builtin::RULE,
    &no_effect::RULE,
    &redundant_constructor::RULE,
    &self_assignment::RULE,
    &shadowed_name::RULE,
    &step_budget::RULE,
    &unused_function::RULE,
    &unused_macro::RULE,
    &unused_parameter::RULE,
    &unused_uniform::RULE,
    &unused_variable::RULE,
    &vec2_resolution::RULE,
];
