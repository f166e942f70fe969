//! Frames of one colour, and frames in which no ray hits anything.

use shaderlint_lint::march::MarchOutcome;
use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::is_too_bright;

rule! { flat_frame, Runtime, Warning, Recommended, Run(check) }

/// Channels that differ by less than this look the same.
const NEAR: f32 = 1.5 / 255.0;

fn check(cx: &mut Context) {
    // Two different pixels are enough, unless rays that miss draw a background.
    let is_flat = |sample_run: &SampleRun| sample_run.all(is_flat);
    let missed = match cx.facts.is_image_known() {
        true => cx.facts.missing_marches(),
        false => return,
    };
    if missed.is_empty() && !cx.facts.may_look(is_flat) {
        return;
    }
    let Some(sample_run) = cx.facts.sampled_image() else {
        return;
    };
    if sample_run.all(is_black) {
        return;
    }
    // Other rules report the cause.
    let is_reported = !cx.facts.stuck_marches().is_empty()
        || sample_run.drawn().all(|pixel| is_too_bright(&pixel));
    if is_reported {
        return;
    }
    if !report_missed(cx, &missed, sample_run)
        && !sample_run.shows_a_number()
        && cx.facts.is_computed()
        && cx.facts.is_seen(is_flat)
        && cx.facts.is_seen_later(is_flat)
    {
        cx.facts.mark_blank();
        let note = sample_run.sampled_note();
        let message = "the image has one colour although it depends on the pixel position";
        cx.report_image(message).note(note);
    }
}

/// Reports the condition that ends rays at a hit, if all rays from the camera miss; returns whether they
/// do.
fn report_missed(cx: &mut Context, missed: &[MarchOutcome], sample_run: &SampleRun) -> bool {
    let Some(first) = missed.first() else {
        return false;
    };
    cx.facts.mark_blank();
    if missed.iter().any(MarchOutcome::is_exhausted) {
        return true;
    }
    let MarchOutcome { test, counts, .. } = first;
    let note = sample_run.sampled_note();
    let message = "no ray hits anything; only the background is drawn";
    let finding = cx.report_op(test.condition, message);
    finding
        .note(format!(
            "0 of {} rays from the camera end here, in {} tests",
            grouped(counts.rays),
            grouped(counts.tests)
        ))
        .note(note)
        .help(
            "check the camera position and direction, and whether the scene distance ever gets \
            near zero",
        );
    true
}

fn is_black(frame: &SampleFrame) -> bool {
    frame
        .drawn()
        .all(|pixel| pixel.shown().iter().all(|lane| *lane < NEAR))
}

fn is_flat(frame: &SampleFrame) -> bool {
    let Some(first) = frame.drawn().next() else {
        return false;
    };
    frame.drawn().all(|pixel| is_near(&pixel, &first))
}

fn is_near(a: &SampledPixel, b: &SampledPixel) -> bool {
    let mut lanes = a.shown().into_iter().zip(b.shown());
    lanes.all(|(a, b)| (a - b).abs() < NEAR)
}
