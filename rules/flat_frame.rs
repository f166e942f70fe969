//! Frames of one colour, and frames in which no ray hits anything.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::trial::{Hit, SampledPixel, Trial, TrialShot, is_too_bright};
use shaderlint_lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "flat-frame",
    group: Group::Runtime,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("flat_frame.md"),
    checks: &[Check::Run(check)],
};

/// Channels that differ by less than this look the same.
const NEAR: f32 = 1.5 / 255.0;

fn check(cx: &mut Context) {
    let Some(trial) = cx.facts.picture() else {
        return;
    };
    if trial.all(is_black) {
        return;
    }
    // Other rules report the cause.
    let is_told =
        !cx.facts.stuck_marches().is_empty() || trial.drawn().all(|pixel| is_too_bright(&pixel));
    if is_told {
        return;
    }
    let is_flat = |trial: &Trial| trial.all(is_flat);
    if !missed(cx, trial)
        && !trial.shows_a_number()
        && cx.facts.is_computed()
        && cx.facts.is_seen(is_flat)
    {
        cx.facts.tell_blank();
        let told = trial.told();
        let message = "the image has one colour although it depends on the pixel position";
        cx.report_picture(message).note(told);
    }
}

/// Reports the condition that detects hits, if all rays miss; returns whether they do.
fn missed(cx: &mut Context, trial: &Trial) -> bool {
    let miss = |trial: &Trial, hit: &Hit| {
        let seen = hit.seen(&trial.seen);
        seen.is_some_and(|(hits, misses)| hits == 0 && misses > 0)
    };
    let facts = cx.facts;
    let is_missed =
        |hit: &&Hit| facts.is_known(hit.condition) && facts.is_seen(|trial| miss(trial, hit));
    let Some(hit) = facts.hits().iter().find(is_missed) else {
        return false;
    };
    facts.tell_blank();
    let told = trial.told();
    let message = "no ray hits anything; only the background is drawn";
    let finding = cx.report_op(hit.condition, message).note(told);
    finding.help(
        "check the camera position and direction, and whether the scene distance ever gets near \
        zero",
    );
    true
}

fn is_black(shot: &TrialShot) -> bool {
    shot.drawn()
        .all(|pixel| pixel.shown().iter().all(|lane| *lane < NEAR))
}

fn is_flat(shot: &TrialShot) -> bool {
    let Some(first) = shot.drawn().next() else {
        return false;
    };
    shot.drawn().all(|pixel| is_near(&pixel, &first))
}

fn is_near(a: &SampledPixel, b: &SampledPixel) -> bool {
    let mut lanes = a.shown().into_iter().zip(b.shown());
    lanes.all(|(a, b)| (a - b).abs() < NEAR)
}
