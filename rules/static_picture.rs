//! Pictures that read the time and do not move.

use shaderlint_diagnostic::Severity;
use shaderlint_exec::{Draw, quads_all_over};
use shaderlint_lint::trial::{Instant, SIZE};
use shaderlint_lint::{Check, Context, Group, Rule};

pub static RULE: Rule = Rule {
    name: "static-picture",
    group: Group::Runtime,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("static_picture.md"),
    checks: &[Check::Run(check)],
};

/// When the picture is looked at, no mouse near.
const TIMES: [f64; 8] = [0.0, 0.13, 0.71, 2.3, 5.9, 10.7, 23.3, 43.1];
/// How many quads are looked at: a few first, since most pictures move everywhere, and many before
/// it is told, since some move in a few places alone.
const QUADS: [usize; 3] = [8, 576, 4096];

fn check(cx: &mut Context) {
    if cx.facts.is_blank() || cx.facts.picture().is_none() {
        return;
    }
    let Some((bench, supplier)) = cx.facts.bench() else {
        return;
    };
    let Some(code) = cx.facts.unwatched() else {
        return;
    };
    let draw = |time: f64| -> Draw<'_> { supplier.draw(code, SIZE, &Instant::at(time)) };
    let [first, second] = [2.3, 10.7].map(draw);
    let moving: Vec<&str> = first
        .differences(&second)
        .map(|u| u.name.as_str())
        .collect();
    let Some(name) = moving.first().map(|name| name.to_string()) else {
        return;
    };
    for count in QUADS {
        let quads = quads_all_over(SIZE, count, 0);
        let pictures = TIMES.iter().map(|time| {
            let sampled = bench.sample(code, supplier, &Instant::at(*time), &quads)?;
            Some((sampled.outputs, sampled.covered))
        });
        let mut known = None;
        for picture in pictures {
            let Some(picture) = picture else { return };
            if known.get_or_insert_with(|| picture.clone()) != &picture {
                return;
            }
        }
    }
    let times = TIMES.map(|t| t.to_string()).join(", ");
    let message = format!("`{name}` is read, and the picture does not move");
    let finding = cx.report_picture(message);
    finding.note(format!("{} pixels are the same at {times} s", QUADS[2] * 4));
}
