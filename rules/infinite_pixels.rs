//! Pixels with infinite colour values.

use shaderlint_lint::prelude::*;
use shaderlint_lint::sample::report_broken;

rule! { infinite_pixels, Runtime, Info, Recommended, Run(check) }

fn check(cx: &mut Context) {
    let what = "infinite and become NaN when blended or filtered";
    report_broken(cx, FaultKind::Infinite, f32::is_infinite, what);
}
