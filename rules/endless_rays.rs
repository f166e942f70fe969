//! Marching loops without a maximum distance, in which rays that miss take all steps.

use shaderlint_flow::{HitTest, RayKind};
use shaderlint_lint::march::March;
use shaderlint_lint::prelude::*;

rule! { endless_rays, Budget, Info, Recommended, Run(check) }

/// Fewest steps that are worth saving.
const LEAST_STEPS: u64 = 32;
/// Least share of pixels with a ray that takes all steps.
const OFTEN: f64 = 0.1;
/// Least distance of rays that have left the scene, so that they did not run out of steps inside it.
const FAR: f64 = 1000.0;
/// Largest distance that is shown as a number.
const SHOWN: f64 = 1_000_000.0;

fn check(cx: &mut Context) {
    let facts = cx.facts;
    for (march, hit) in facts.camera_marches() {
        let March { looped, ray, .. } = march;
        let Some(steps) = looped.bound.iterations() else {
            continue;
        };
        let is_open = ray.kind == RayKind::Distance && !ray.ends_far;
        if !is_open || steps < LEAST_STEPS || !facts.is_known(hit.condition) {
            continue;
        }
        let share = |sample_run: &SampleRun| {
            let seen = facts.loop_observation(&sample_run.seen, looped.stmt);
            seen.map_or(0.0, |l| {
                l.exhausted_pixels as f64 / sample_run.pixels.max(1) as f64
            })
        };
        let may_be = |few: &SampleRun| share(few) >= OFTEN / 2.0;
        if !facts.round(Round::Second).is_some_and(may_be)
            || !facts.is_seen(|sample_run| share(sample_run) >= OFTEN)
        {
            continue;
        }
        let Some(sample_run) = facts.sample_run() else {
            continue;
        };
        let Some(distance) = farthest(cx, hit).filter(|distance| *distance >= FAR) else {
            continue;
        };
        let head = Extent::token(cx.program.tree.stmt(looped.stmt).extent.first);
        let message =
            format!("rays that miss take all {steps} steps: there is no maximum distance");
        let shown = match distance < SHOWN {
            true => format!("the distance reached {distance:.0}"),
            false => format!("the distance exceeded {}", grouped(SHOWN as u64)),
        };
        cx.report(head, message)
            .note(format!(
                "{} of the pixels have a ray that took all steps; {shown}",
                rounded_percent(share(sample_run))
            ))
            .note(sample_run.sampled_note())
            .help("end the loop beyond the scene, as in `if (t > 20.0) break;`");
    }
}

/// The largest distance that was compared in a small run: it doubles with each step away from a scene.
fn farthest(cx: &Context, hit: HitTest) -> Option<f64> {
    let sample_run = cx.facts.smaller_runs(Watch::Comparisons).next()??;
    let mut compared = sample_run.seen.compared.iter();
    let seen = compared.find(|c| c.op == hit.condition)?;
    Some(f64::max(seen.left[1], seen.right[1]))
}
