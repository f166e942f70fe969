//! Calls outside the domain of a built-in function that occurred in a sample run.

use shaderlint_exec::NumberObservation;
use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::OFTEN;

rule! { undefined_seen, Runtime, Warning, Recommended, Run(check) }

fn check(cx: &mut Context) {
    let module = cx.facts.module();
    let called = |op: OpId| match module.op(op).kind {
        OpKind::Builtin(function, _) => Some(function),
        _ => None,
    };
    let concerns = |number: &NumberObservation, share: f64| {
        let operands = &number.witness.operands;
        share >= OFTEN && called(number.op).is_some_and(|function| gives_nan(function, operands))
    };
    for fault in cx.facts.unreported_faults(FaultKind::Undefined, concerns) {
        let op = fault.number.op;
        let Some(function) = called(op) else {
            continue;
        };
        let operands = &fault.number.witness.operands;
        let name = function.name();
        let operands: Vec<String> = operands.iter().map(|n| decimals(*n, 6)).collect();
        let finding = cx.report_op(
            op,
            format!("`{name}({})` is undefined", operands.join(", ")),
        );
        let finding = match function {
            BuiltinId::Pow => finding.help("use `max(x, 0.0)` or `abs(x)` as the base"),
            _ => finding,
        };
        finding
            .note(format!(
                "the argument is outside the domain of `{name}` (section 8); many GPUs return NaN"
            ))
            .note(fault.words)
            .note(fault.sampled);
        cx.facts.mark_reported(Some(op));
    }
}

/// Whether the function is NaN for these operands on many GPUs. The logarithm of zero is infinite,
/// and `smoothstep` with reversed edges is what its formula says.
fn gives_nan(function: BuiltinId, operands: &[f64]) -> bool {
    use BuiltinId::*;
    match function {
        Log | Log2 | InverseSqrt => operands.first().is_some_and(|x| *x < 0.0),
        Pow | Sqrt | Asin | Acos | Acosh | Atanh => !operands.is_empty(),
        _ => false,
    }
}
