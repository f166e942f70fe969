//! Pixels with infinite colour values.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::FaultKind;
use shaderlint_lint::sample::report_broken;
use shaderlint_lint::{Check, Context, Group, Rule, RulePreset};

pub static RULE: Rule = Rule {
    name: "infinite-pixels",
    group: Group::Runtime,
    severity: Severity::Info,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("infinite_pixels.md"),
    checks: &[Check::Run(check)],
};

fn check(cx: &mut Context) {
    let what = "infinite and become NaN when blended or filtered";
    report_broken(cx, FaultKind::Infinite, f32::is_infinite, what);
}
