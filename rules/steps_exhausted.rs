//! Marching loops that reach their step limit before they find a hit.

use shaderlint_flow::RayKind;
use shaderlint_lint::prelude::*;

rule! { steps_exhausted, Runtime, Warning, Recommended, Run(check) }

/// Loops with fewer steps take samples, and do not search.
const LEAST_STEPS: u64 = 10;
/// Smallest share of pixels that run out of steps.
const OFTEN: f64 = 0.005;
/// Smallest share of pixels that change visibly with twice as many steps.
const SEEN: f64 = 0.01;

fn check(cx: &mut Context) {
    if !cx.facts.is_image_known() {
        return;
    }
    let marches = cx.facts.marches().iter();
    let searches = |l: &LoopFacts| {
        let steps = l.bound.iterations();
        l.ends_early && steps.is_some_and(|steps| steps >= LEAST_STEPS)
    };
    // Loops of fixed steps may sum up a volume, which is never complete.
    let marches = marches.filter(|m| m.ray.kind != RayKind::Fixed);
    let loops: Vec<LoopFacts> = marches.map(|m| m.looped).filter(searches).collect();
    for looped in loops {
        let Some(given) = looped.given else { continue };
        let exhausted = |sample_run: &SampleRun| {
            let seen = cx.facts.loop_observation(&sample_run.seen, looped.stmt);
            seen.map_or(0.0, |l| {
                l.exhausted_pixels as f64 / sample_run.pixels.max(1) as f64
            })
        };
        // Only pixels that ran out of steps can change; fewer of the first ones may by chance.
        let may_be = |few: &SampleRun| exhausted(few) >= SEEN / 3.0;
        let is_often = |sample_run: &SampleRun| exhausted(sample_run) >= OFTEN;
        if !cx.facts.round(Round::Second).is_some_and(may_be) {
            continue;
        }
        let Some(changed) = cx
            .facts
            .change_by_more_iterations(&looped)
            .filter(|c| *c >= SEEN)
        else {
            continue;
        };
        if !cx.facts.is_seen(is_often) {
            continue;
        }
        let Some(sample_run) = cx.facts.sample_run() else {
            continue;
        };
        let (out, note) = (
            rounded_percent(exhausted(sample_run)),
            sample_run.sampled_note(),
        );
        let message = format!("marching loop runs out of steps in {out} of the pixels");
        let finding = cx.report_expr(given, message);
        finding
            .note(format!(
                "{} of the pixels change visibly with twice as many steps",
                rounded_percent(changed)
            ))
            .note(note)
            .help("use more steps, take longer steps, or end rays beyond a maximum distance as misses");
    }
}
