//! Frames in which almost nothing is visible.

use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::luminance;

rule! { dark_frame, Runtime, Warning, Recommended, Run(check) }

/// A luminance up to this value looks black on most screens.
const DARK: f32 = 12.0 / 255.0;
/// Share of pixels that may be brighter although the frame counts as dark.
const LIT: f64 = 0.001;
/// The same share for frames in which rays hit surfaces in many pixels.
const LIT_SURFACE: f64 = 0.03;
/// Share of pixels whose rays hit a surface from which `LIT_SURFACE` applies.
const SURFACE: f64 = 0.25;

fn check(cx: &mut Context) {
    if !cx.facts.may_look(may_be_dark) {
        return;
    }
    let Some(sample_run) = cx.facts.sampled_image() else {
        return;
    };
    // A constant colour is intended.
    if sample_run.shows_a_number() || !cx.facts.is_computed() {
        return;
    }
    let surfaces = |sample_run: &SampleRun| {
        let seen = cx
            .facts
            .hits()
            .iter()
            .filter_map(|hit| hit.seen(&sample_run.seen));
        let most = seen.map(|(hits, _)| hits as f64 / sample_run.pixels.max(1) as f64);
        most.fold(0.0, f64::max)
    };
    let lit = |sample_run: &SampleRun| match surfaces(sample_run) >= SURFACE {
        true => LIT_SURFACE,
        false => LIT,
    };
    let is_dark =
        |sample_run: &SampleRun, factor: f64| is_dark(sample_run, factor * lit(sample_run));
    // Later instants are sampled with fewer pixels.
    let is_lasting = |sample_run: &SampleRun| is_dark(sample_run, 2.0);
    if !cx.facts.is_seen(|sample_run| is_dark(sample_run, 1.0))
        || !cx.facts.is_seen_later(is_lasting)
    {
        return;
    }
    cx.facts.mark_blank();
    let brightest = sample_run
        .drawn()
        .map(|l| luminance(l.shown()))
        .fold(0.0, f32::max);
    let note = sample_run.sampled_note();
    let brightest = (brightest * 255.0).round();
    let lit = share(sample_run.drawn(), |l| luminance(l.shown()) > DARK);
    let message = match brightest {
        0.0 => "the image is black".to_string(),
        _ if lit > LIT => format!(
            "{} of the image is nearly black",
            rounded_percent(1.0 - lit)
        ),
        _ => format!("the image is nearly black: the maximum brightness is {brightest} of 255"),
    };
    let finding = cx.report_image(message).note(note);
    finding.help(
        "check for a light that reaches nothing, a colour multiplied by zero, or a camera that \
        faces away",
    );
}

/// Whether few of the first pixels are lit: more than in a dark frame by chance.
fn may_be_dark(first: &SampleRun) -> bool {
    share(first.drawn(), |l| luminance(l.shown()) > DARK) <= 4.0 * LIT_SURFACE
}

/// Whether at most this share of the pixels is lit at every instant.
fn is_dark(sample_run: &SampleRun, lit: f64) -> bool {
    sample_run
        .all(|frame: &SampleFrame| share(frame.drawn(), |l| luminance(l.shown()) > DARK) <= lit)
}
