//! Indices that were out of range in a sample run.

use shaderlint_lint::prelude::*;

rule! { out_of_range_seen, Runtime, Warning, Recommended, Run(check) }

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
