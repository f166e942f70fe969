//! Images that look gray although their channels differ.

use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::luminance;

rule! { gray_picture, Runtime, Info, All, Run(check) }

/// Colours of at most this saturation look gray.
const GRAY: f32 = 0.08;
/// Least share of the pixels that look gray.
const MOST: f64 = 0.995;
/// Largest share of coloured pixels among the first ones: more than in a gray image by chance.
const FEW: f64 = 0.05;
/// Pixels up to this luminance show no colour.
const DARK: f32 = 12.0 / 255.0;

fn check(cx: &mut Context) {
    if !cx.facts.may_look(may_be_gray) {
        return;
    }
    let Some(sample_run) = cx.facts.sampled_image() else {
        return;
    };
    if !cx.facts.is_seen(is_gray) {
        return;
    }
    let note = sample_run.sampled_note();
    let finding =
        cx.report_image("the image is gray although its channels are computed separately");
    finding
        .note(note)
        .help("increase the differences between channels; a few hundredths look gray");
}

/// Whether nearly none of the first pixels has a visible colour.
fn may_be_gray(first: &SampleRun) -> bool {
    let is_colored = |l: &SampledPixel| luminance(l.shown()) > DARK && saturation(l.shown()) > GRAY;
    share(first.drawn(), is_colored) <= FEW
}

/// Whether no pixel has a visible colour, although the channels differ.
fn is_gray(sample_run: &SampleRun) -> bool {
    let lit = || sample_run.drawn().filter(|l| luminance(l.shown()) > DARK);
    let is_white = |pixel: &SampledPixel| pixel.shown().iter().all(|lane| *lane >= 1.0);
    let colored = || lit().filter(|l| !is_white(l));
    let has_two = colored().nth(16).is_some();
    // The same value in all channels is intended to be gray.
    let tinted = share(colored(), |l| !l.is_even());
    has_two && tinted > 0.5 && share(colored(), |l| saturation(l.shown()) <= GRAY) >= MOST
}

/// The difference between the largest and smallest channel, as a fraction of the largest.
fn saturation(color: [f32; 3]) -> f32 {
    let (least, most) = (
        color.iter().fold(1.0, |a, b| b.min(a)),
        color.iter().fold(0.0, |a, b| b.max(a)),
    );
    if most > 0.0 {
        (most - least) / most
    } else {
        0.0
    }
}
