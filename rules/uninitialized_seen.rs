//! Images that depend on a variable that was never assigned.

use shaderlint_flow::UnassignedVariable;
use shaderlint_lint::prelude::*;

rule! { uninitialized_seen, Runtime, Warning, Recommended, Run(check) }

/// Most variables that are compared one by one.
const MAX_SUSPECTS: usize = 8;

/// A variable that may be read before it is assigned.
#[derive(Clone, Copy)]
struct Suspect {
    unset: UnassignedVariable,
    /// Whether a loop before the read assigns it on some path.
    is_in_loop: bool,
}

fn check(cx: &mut Context) {
    if !cx.facts.is_image_known() {
        return;
    }
    let suspects = suspects(cx);
    if suspects.is_empty() || cx.facts.changed_by_initial_value(None).is_none() {
        return;
    }
    let Some(note) = cx.facts.sample_run().map(SampleRun::sampled_note) else {
        return;
    };
    for Suspect { unset, is_in_loop } in suspects.into_iter().take(MAX_SUSPECTS) {
        let Some(op) = cx.facts.initial_value(unset) else {
            continue;
        };
        let Some(changed) = cx.facts.changed_by_initial_value(Some(op)) else {
            continue;
        };
        let variable = cx.program.variable(unset.variable);
        let name = variable.map_or("", |v| cx.program.names.text(v.name));
        let message =
            format!("`{name}` is read before it is assigned, and the image depends on it");
        let finding = cx.report(unset.at, message).note(format!(
            "{} of the pixels change visibly if its initial value is 7.25 instead of 0.0",
            rounded_percent(changed)
        ));
        let finding = match is_in_loop {
            true => finding.note("the loop before it does not assign it in every iteration"),
            false => finding,
        };
        finding.note(note.clone());
    }
}

/// The reads of variables that may be unassigned, without those that `uninitialized-read` reports and
/// outputs of the entry function, which are zero in all browsers.
fn suspects(cx: &Context) -> Vec<Suspect> {
    let functions = (0..cx.program.functions.len() as u32).map(FunctionRef);
    let outputs = cx.facts.outputs();
    let found: Vec<_> = functions
        .filter_map(|f| cx.facts.definite_assignment().get(f))
        .collect();
    let of = |unset: &UnassignedVariable, is_in_loop| Suspect {
        unset: *unset,
        is_in_loop,
    };
    let reads = found.iter().flat_map(|f| &f.reads);
    let guarded = reads.filter(|u| !u.always && u.guarded);
    let in_loops = found.iter().flat_map(|f| &f.loop_reads);
    let all = guarded
        .map(|u| of(u, false))
        .chain(in_loops.map(|u| of(u, true)));
    all.filter(|s| !outputs.contains(&s.unset.variable))
        .collect()
}
