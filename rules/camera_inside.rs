//! Rays that stop at their first step because the camera is inside an object.

use shaderlint_lint::march::RayCounts;
use shaderlint_lint::prelude::*;

rule! { camera_inside, Runtime, Warning, Recommended, Run(check) }

fn check(cx: &mut Context) {
    if !cx.facts.is_image_known() {
        return;
    }
    for outcome in cx.facts.stuck_marches() {
        let note = cx.facts.sample_run().map(SampleRun::sampled_note);
        let RayCounts { rays, hits, .. } = outcome.counts;
        let extent = cx.program.tree.stmt(outcome.march.looped.stmt).extent;
        cx.facts.mark_blank();
        let head = cx.program.token(extent.first).map(|t| t.span);
        let message = "the camera is inside an object: nearly all rays stop at the first step";
        let finding = cx.report_span(head.unwrap_or_default(), message);
        finding
            .note(format!(
                "{} of {} rays hit something at their first step",
                grouped(hits),
                grouped(rays)
            ))
            .note(note.unwrap_or_default())
            .help("move the camera to an empty part of the scene");
    }
}
