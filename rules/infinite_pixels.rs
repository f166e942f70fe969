//! Pixels that come out infinitely bright.

use crate::diagnostic::Severity;
use crate::exec::Kind;
use crate::lint::trial::report_broken;
use crate::lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "infinite-pixels",
    group: Group::Runtime,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("infinite_pixels.md"),
    checks: &[Check::Run(check)],
};

fn check(cx: &mut Context) {
    let what = "infinite, and a NaN as soon as it is blended or filtered";
    report_broken(cx, Kind::Infinite, f32::is_infinite, what);
}
