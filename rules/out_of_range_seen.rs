//! Indices that were out of range in a sample run.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::FaultKind;
use shaderlint_lint::{Check, Context, Group, Rule, RulePreset};

pub static RULE: Rule = Rule {
    name: "out-of-range-seen",
    group: Group::Runtime,
    severity: Severity::Warning,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("out_of_range_seen.md"),
    checks: &[Check::Run(check)],
};

fn check(cx: &mut Context) {
    for fault in cx
        .facts
        .unreported_faults(FaultKind::OutOfRange, |_, _| true)
    {
        let message = match fault.number.witness.operands.first() {
            Some(index) => format!("index {index} is out of range"),
            None => "index is out of range".to_string(),
        };
        let finding = cx.report_op(fault.number.op, message);
        finding.note(fault.words).note(fault.sampled);
    }
}
