//! Findings in the text of a file, in stages.

pub mod chunks;
mod comments;
mod contract;
mod group;
mod inactive;
pub mod partner;
mod place;
mod removed;
pub mod report;
mod required;
mod rules;
pub mod stage;
mod style;
mod surroundings;
mod typo;
mod unknown;
pub mod upgrade;
mod version;
mod whole_file;

use stage::FindingStage;
use stage::FindingStage::{File, Shader};

/// All stages, in order. A shader comes with the errors of the checker, read as its host completes it,
/// and goes through the stages of a shader; after all shaders follow the stages of their file.
pub const STAGES: &[FindingStage] = &[
    // First, because these are errors of the checker that it left open: they count as errors for all
    // stages below.
    Shader(unknown::decide_severity),
    // Errors of the host, also before the others are counted.
    Shader(chunks::report),
    // What the host of the shader does not accept, although the checker does.
    Shader(required::apply_version),
    Shader(required::add_limits),
    // A missing `#version` is an error of its own.
    Shader(version::report_missing),
    // After it: the other findings about a text without `#version` may be no errors of its host.
    Shader(version::lower_reserved_words),
    // Only in a shader without errors, so after all stages that add or lower errors.
    Shader(inactive::report),
    // Errors that hold only in the right surroundings are lowered before errors are counted.
    Shader(surroundings::keep_of_excerpt),
    Shader(surroundings::expect_trimmed),
    // Counts the errors, and drops those that a comment expects. Rules do not see these.
    Shader(comments::expect_errors),
    // Rules do not run where errors are left.
    Shader(rules::run),
    // After the rules: they do not run where the checker found an error, reported or not.
    Shader(surroundings::keep_under_hosts),
    Shader(surroundings::ask_before_renaming),
    // Changes all findings of the shader, so after the last stage that adds one.
    Shader(surroundings::name_hosts),
    Shader(comments::keep_in_fixes),
    // Last, because it drops errors only if nothing else is wrong.
    Shader(surroundings::drop_repaired),
    // One info for all shaders of the file.
    File(unknown::list_unresolved),
    // Only shaders without errors are linked.
    File(partner::link_all),
    // What scripts set, against what all their shaders declare.
    File(contract::report),
    // Comments are unused after all stages that comments may suppress.
    File(comments::report_unused),
    // What was found when the file was read.
    File(whole_file::add_problems),
    // Only where nothing else is found.
    File(whole_file::report_damage),
    // Only what is reported is sorted and counted.
    File(whole_file::drop_hushed),
    File(whole_file::sort),
    // Lowers errors, before infos are counted.
    File(whole_file::lower_in_tests),
    File(whole_file::keep_expected_faults),
    File(whole_file::count_infos),
    // Last, because these decide on all fixes.
    File(whole_file::ask_before_porting),
    File(style::apply),
    File(whole_file::note_fixes),
];
