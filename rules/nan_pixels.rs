//! Pixels that are NaN.

use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::report_broken;

rule! { nan_pixels, Runtime, Warning, Recommended, Run(check) }

fn check(cx: &mut Context) {
    let what = "NaN, drawn black on some GPUs and white on others";
    report_broken(cx, FaultKind::Nan, f32::is_nan, what);
}
