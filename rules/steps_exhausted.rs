//! Loops that run out of steps before they find what they look for.

use shaderlint_diagnostic::Severity;
use shaderlint_flow::LoopFacts;
use shaderlint_lint::trial::{Trial, percent};
use shaderlint_lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "steps-exhausted",
    group: Group::Runtime,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("steps_exhausted.md"),
    checks: &[Check::Run(check)],
};

/// A loop of fewer steps takes samples, and looks for nothing.
const LEAST_STEPS: u64 = 10;
/// The share of the pixels that have to run out of steps.
const OFTEN: f64 = 0.005;
/// The share of the picture that has to look otherwise with more of them.
const SEEN: f64 = 0.01;

fn check(cx: &mut Context) {
    let Some(trial) = cx.facts.picture() else {
        return;
    };
    let marches = cx.facts.marches().iter();
    let searches = |l: &LoopFacts| {
        let steps = l.bound.turns();
        l.ends_early && steps.is_some_and(|steps| steps >= LEAST_STEPS)
    };
    let loops: Vec<LoopFacts> = marches.map(|m| m.looped).filter(searches).collect();
    for looped in loops {
        let Some(given) = looped.given else { continue };
        let exhausted = |trial: &Trial| {
            let seen = cx.facts.loop_seen(&trial.seen, looped.stmt);
            seen.map_or(0.0, |l| {
                l.exhausted_pixels as f64 / trial.pixels.max(1) as f64
            })
        };
        if !cx.facts.is_seen(|trial| exhausted(trial) >= OFTEN) {
            continue;
        }
        let Some(changed) = cx.facts.change_by_longer(&looped).filter(|c| *c >= SEEN) else {
            continue;
        };
        let (out, told) = (percent(exhausted(trial)), trial.told());
        let message = format!("the loop runs out of steps at {out} of the pixels");
        let finding = cx.report_expr(given, message);
        finding.note(format!("with twice as many {} of the picture look otherwise", percent(changed))).note(told)
            .help("take more steps, make the steps longer, or let rays that go far end as such that hit nothing");
    }
}
