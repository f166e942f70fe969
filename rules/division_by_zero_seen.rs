//! Divisions by zero that occurred in a sample run.

use shaderlint_exec::NumberObservation;
use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::OFTEN;

rule! { division_by_zero_seen, Runtime, Warning, Recommended, Run(check) }

fn check(cx: &mut Context) {
    let facts = cx.facts;
    let is_float = |op: OpId| facts.module().scalar(op) == Some(Scalar::Float);
    let concerns = |number: &NumberObservation, share: f64| share >= OFTEN || !is_float(number.op);
    for fault in facts.unreported_faults(FaultKind::DivisionByZero, concerns) {
        let op = fault.number.op;
        let is_float = is_float(op);
        let is_nothing = fault.number.witness.operands.first() == Some(&0.0);
        let what = match (is_float, is_nothing) {
            (false, _) => "the divisor is zero; the result is undefined",
            (true, true) => "zero is divided by zero; the result is NaN",
            (true, false) => "the divisor is zero; the result is infinite",
        };
        let finding = cx.report_op(op, what).note(fault.words).note(fault.sampled);
        if is_float && !is_nothing {
            finding.lower();
        }
    }
}
