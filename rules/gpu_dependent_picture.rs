//! Images that depend on the last digits of a sine, a square root or a division.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::{CompileOptions, Lean, Persona};
use shaderlint_ir::OpKind;
use shaderlint_lint::trial::percent;
use shaderlint_lint::{Check, Context, Group, Rule};
use shaderlint_semantic::BuiltinId;

pub static RULE: Rule = Rule {
    name: "gpu-dependent-picture",
    group: Group::Runtime,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("gpu_dependent_picture.md"),
    checks: &[Check::Run(check)],
};

/// Least share of the pixels that look different.
const SEEN: f64 = 0.2;
/// How many quads are run at each instant.
const QUADS: usize = 32;

fn check(cx: &mut Context) {
    let Some(trial) = cx.facts.picture() else {
        return;
    };
    let module = cx.facts.module();
    let hashes = |(op, number): (&shaderlint_ir::Op, u32)| {
        let is_fract = matches!(op.kind, OpKind::Builtin(BuiltinId::Fract, _));
        is_fract && cx.facts.is_told(shaderlint_ir::OpId(number))
    };
    if module.ops.iter().zip(0..).any(hashes) {
        return;
    }
    let inexact = CompileOptions {
        persona: Persona::Inexact(Lean::Either),
        ..CompileOptions::default()
    };
    let (Some(exact), Some(inexact)) = (cx.facts.unwatched(), cx.facts.compiled(&inexact)) else {
        return;
    };
    let changed = cx.facts.difference([exact, &inexact], QUADS);
    let Some(changed) = changed.filter(|share| *share >= SEEN) else {
        return;
    };
    let told = trial.told();
    let changed = percent(changed);
    let finding = cx.report_picture("the image depends on rounding that differs between GPUs");
    finding
        .note(format!(
            "{changed} of the sampled pixels change on a GPU with the largest errors that the \
            conformance suite allows"
        ))
        .note(told)
        .help("use integer hashes, and keep the arguments of `sin` small");
}
