//! Images that depend on the last digits of a sine, a square root or a division.

use shaderlint_exec::{CompileOptions, ErrorDirection, GpuProfile};
use shaderlint_lint::prelude::*;

rule! { gpu_dependent_picture, Runtime, Info, Strict, Run(check) }

/// Least share of the pixels that look different.
const SEEN: f64 = 0.2;
/// The same share of the first pixels: smaller than in such an image by chance.
const LIKELY: f64 = 0.08;
/// How many quads are run at each instant.
const QUADS: usize = 32;

fn check(cx: &mut Context) {
    if !cx.facts.is_image_known() {
        return;
    }
    let module = cx.facts.module();
    let hashes = |(op, number): (&shaderlint_ir::Op, u32)| {
        let is_fract = matches!(op.kind, OpKind::Builtin(BuiltinId::Fract, _));
        is_fract && cx.facts.is_reported(shaderlint_ir::OpId(number))
    };
    if module.ops.iter().zip(0..).any(hashes) {
        return;
    }
    let imprecise = CompileOptions {
        gpu_profile: GpuProfile::Inexact(ErrorDirection::Either),
        ..CompileOptions::default()
    };
    let Some(imprecise) = cx.facts.compiled(&imprecise) else {
        return;
    };
    let is_likely = |share: f64| share >= LIKELY;
    let few = cx.facts.changed_in(Round::First, &imprecise);
    if !few.is_some_and(is_likely) {
        return;
    }
    let Some((bench, _)) = cx.facts.bench() else {
        return;
    };
    let changed = cx.facts.difference([bench.watched(), &imprecise], QUADS);
    let Some(changed) = changed.filter(|share| *share >= SEEN) else {
        return;
    };
    let Some(sample_run) = cx.facts.sample_run() else {
        return;
    };
    let note = sample_run.sampled_note();
    let changed = rounded_percent(changed);
    let finding = cx.report_image("the image depends on rounding that differs between GPUs");
    finding
        .note(format!(
            "{changed} of the sampled pixels change on a GPU with the largest errors that the \
            conformance suite allows"
        ))
        .note(note)
        .help("use integer hashes, and keep the arguments of `sin` small");
}
