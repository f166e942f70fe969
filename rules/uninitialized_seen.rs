//! Images that depend on a variable that was never assigned.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::CompileOptions;
use shaderlint_flow::UnassignedVariable;
use shaderlint_lint::sample::percent;
use shaderlint_lint::{Check, Context, Group, Rule, RulePreset};
use shaderlint_semantic::FunctionRef;

pub static RULE: Rule = Rule {
    name: "uninitialized-seen",
    group: Group::Runtime,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("uninitialized_seen.md"),
    checks: &[Check::Run(check)],
};

/// Bits of 7.25, an initial value that shaders do not use themselves.
const RUBBISH: u32 = 0x40e8_0000;

fn check(cx: &mut Context) {
    let Some(sample_run) = cx.facts.sampled_image() else {
        return;
    };
    let Some(unset) = suspect(cx) else { return };
    let options = CompileOptions {
        undefined: RUBBISH,
        ..CompileOptions::default()
    };
    let (Some(zeros), Some(rubbish)) = (cx.facts.unwatched(), cx.facts.compiled(&options)) else {
        return;
    };
    let quads = cx
        .facts
        .bench()
        .map_or(0, |(bench, _)| bench.quads.div_ceil(4));
    let changed = cx.facts.difference([zeros, &rubbish], quads);
    let Some(changed) = changed.filter(|share| *share > 0.0) else {
        return;
    };
    let note = sample_run.sampled_note();
    let variable = cx.program.variable(unset.variable);
    let name = variable.map_or("", |v| cx.program.names.text(v.name));
    let message = format!("`{name}` is read before it is assigned, and the image depends on it");
    let finding = cx.report(unset.at, message);
    finding
        .note(format!(
            "{} of the pixels change visibly if its initial value is 7.25 instead of 0.0",
            percent(changed)
        ))
        .note(note);
}

/// The first read of a variable that may be unassigned; `None` if `uninitialized-read` reports one, or
/// if it is an output of the entry function, which is zero in all browsers.
fn suspect(cx: &Context) -> Option<UnassignedVariable> {
    let functions = (0..cx.program.functions.len() as u32).map(FunctionRef);
    let outputs = cx.facts.outputs();
    let reads = functions
        .filter_map(|f| cx.facts.definite_assignment().get(f))
        .flat_map(|found| &found.reads);
    let reads: Vec<&UnassignedVariable> = reads.collect();
    if reads.iter().any(|u| outputs.contains(&u.variable)) {
        return None;
    }
    let is_reported = |u: &UnassignedVariable| u.always || !u.guarded;
    if reads.iter().any(|u| is_reported(u)) {
        return None;
    }
    reads.first().map(|u| **u)
}
