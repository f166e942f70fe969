//! Indices that were out of range in a sample run.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::Kind;
use shaderlint_lint::trial::Trial;
use shaderlint_lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "out-of-range-seen",
    group: Group::Runtime,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("out_of_range_seen.md"),
    checks: &[Check::Run(check)],
};

fn check(cx: &mut Context) {
    let told = cx.facts.trial().map_or(String::new(), Trial::told);
    for fault in cx.facts.untold(Kind::OutOfRange) {
        let message = match fault.number.witness.operands.first() {
            Some(index) => format!("index {index} is out of range"),
            None => "index is out of range".to_string(),
        };
        let finding = cx.report_op(fault.number.op, message);
        finding.note(fault.words).note(told.clone());
    }
}
