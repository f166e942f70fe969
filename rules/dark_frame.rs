//! Frames in which almost nothing is visible.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::trial::{Trial, TrialShot, luminance, percent, share};
use shaderlint_lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "dark-frame",
    group: Group::Runtime,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("dark_frame.md"),
    checks: &[Check::Run(check)],
};

/// A luminance up to this value looks black on most screens.
const DARK: f32 = 12.0 / 255.0;
/// Share of pixels that may be brighter although the frame counts as dark.
const LIT: f64 = 0.001;
/// The same share for frames in which rays hit surfaces in many pixels.
const LIT_SURFACE: f64 = 0.03;
/// Share of pixels whose rays hit a surface from which `LIT_SURFACE` applies.
const SURFACE: f64 = 0.25;

fn check(cx: &mut Context) {
    let Some(trial) = cx.facts.picture() else {
        return;
    };
    // A constant colour is intended.
    if trial.shows_a_number() || !cx.facts.is_computed() {
        return;
    }
    let surfaces = |trial: &Trial| {
        let seen = cx
            .facts
            .hits()
            .iter()
            .filter_map(|hit| hit.seen(&trial.seen));
        let most = seen.map(|(hits, _)| hits as f64 / trial.pixels.max(1) as f64);
        most.fold(0.0, f64::max)
    };
    let lit = |trial: &Trial| match surfaces(trial) >= SURFACE {
        true => LIT_SURFACE,
        false => LIT,
    };
    if !cx.facts.is_seen(|trial| is_dark(trial, lit(trial))) {
        return;
    }
    cx.facts.tell_blank();
    let brightest = trial
        .drawn()
        .map(|l| luminance(l.shown()))
        .fold(0.0, f32::max);
    let told = trial.told();
    let brightest = (brightest * 255.0).round();
    let lit = share(trial.drawn(), |l| luminance(l.shown()) > DARK);
    let message = match brightest {
        0.0 => "the image is black".to_string(),
        _ if lit > LIT => format!("{} of the image is nearly black", percent(1.0 - lit)),
        _ => format!("the image is nearly black: the maximum brightness is {brightest} of 255"),
    };
    let finding = cx.report_picture(message).note(told);
    finding.help(
        "check for a light that reaches nothing, a colour multiplied by zero, or a camera that \
        faces away",
    );
}

/// Whether at most this share of the pixels is lit at every instant.
fn is_dark(trial: &Trial, lit: f64) -> bool {
    trial.all(|shot: &TrialShot| share(shot.drawn(), |l| luminance(l.shown()) > DARK) <= lit)
}
