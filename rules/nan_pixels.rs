//! Pixels that are NaN.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::FaultKind;
use shaderlint_lint::sample::report_broken;
use shaderlint_lint::{Check, Context, Group, Rule, RulePreset};

pub static RULE: Rule = Rule {
    name: "nan-pixels",
    group: Group::Runtime,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("nan_pixels.md"),
    checks: &[Check::Run(check)],
};

fn check(cx: &mut Context) {
    let what = "NaN, drawn black on some GPUs and white on others";
    report_broken(cx, FaultKind::Nan, f32::is_nan, what);
}
