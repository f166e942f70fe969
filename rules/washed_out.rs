//! Images that are brighter than white nearly everywhere.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::trial::{Trial, is_too_bright, share};
use shaderlint_lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "washed-out",
    group: Group::Runtime,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("washed_out.md"),
    checks: &[Check::Run(check)],
};

/// Smallest share of pixels that are too bright.
const MOST: f64 = 0.9;

fn check(cx: &mut Context) {
    let Some(trial) = cx.facts.picture() else {
        return;
    };
    let is_washed = |trial: &Trial| trial.all(|shot| share(shot.drawn(), is_too_bright) >= MOST);
    if trial.shows_a_number() || !cx.facts.is_seen(is_washed) {
        return;
    }
    let percent = (share(trial.drawn(), is_too_bright) * 100.0).floor();
    let told = trial.told();
    let finding = cx.report_picture(format!("{percent} % of the image is brighter than white"));
    finding
        .note(told)
        .help("reduce lights and colours, or apply tone mapping, e.g. `color / (1.0 + color)`");
}
