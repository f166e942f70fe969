//! Images that are brighter than white nearly everywhere.

use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::is_too_bright;

rule! { washed_out, Runtime, Warning, Recommended, Run(check) }

/// Smallest share of pixels that are too bright.
const MOST: f64 = 0.9;
/// The same share of the first pixels: fewer than in such an image by chance.
const LIKELY: f64 = 0.75;

fn check(cx: &mut Context) {
    let may_be = |first: &SampleRun| share(first.drawn(), is_too_bright) >= LIKELY;
    if !cx.facts.may_look(may_be) {
        return;
    }
    let Some(sample_run) = cx.facts.sampled_image() else {
        return;
    };
    let is_washed = |sample_run: &SampleRun| {
        sample_run.all(|frame| share(frame.drawn(), is_too_bright) >= MOST)
    };
    if sample_run.shows_a_number() || !cx.facts.is_seen(is_washed) {
        return;
    }
    let percent = rounded_percent(share(sample_run.drawn(), is_too_bright));
    let note = sample_run.sampled_note();
    let finding = cx.report_image(format!("{percent} of the image is brighter than white"));
    finding
        .note(note)
        .help("reduce lights and colours, or apply tone mapping, e.g. `color / (1.0 + color)`");
}
