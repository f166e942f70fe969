//! Marching loops whose rays step over a surface.

use shaderlint_lint::march::{March, StepLength, limit_edit, step_edits};
use shaderlint_lint::prelude::*;

rule! { missed_surface, Runtime, Warning, Recommended, Run(check) }

fn check(cx: &mut Context) {
    let facts = cx.facts;
    for march in facts.marches() {
        let Some(found) = facts.stepped_over(march) else {
            continue;
        };
        let ([x, y], time, point) = found.first;
        let place = point.map_or(String::new(), |point| {
            let numbers = point.map(|n| decimals(f64::from(n), 3));
            format!(", where the surface is at ({})", numbers.join(", "))
        });
        let fix = found.repair.and_then(|length| fix(cx, march, length));
        let help = match (found.repair, &fix) {
            (_, Some(_)) => None,
            (Some(length), None) => Some(title(length)),
            (None, None) => Some("shorten the steps, or distort the scene less".to_string()),
        };
        let head = Extent::token(cx.program.tree.stmt(march.looped.stmt).extent.first);
        let (name, share) = (march.goal.name(), rounded_percent(found.share));
        let message = format!("{name} steps over the surface in {share} of the pixels");
        let finding = cx
            .report(head, message)
            .note(format!("first at pixel ({x}, {y}) at {time} s{place}"))
            .note("with a quarter and a tenth of the step length, these rays hit the surface, and the pixels change visibly")
            .note(found.sampled)
            .fix(fix);
        if let Some(help) = help {
            finding.help(help);
        }
    }
}

/// What to change, as a title.
fn title(StepLength { thousandths, times }: StepLength) -> String {
    let factor = f64::from(thousandths) / 1000.0;
    match times {
        1 => format!("multiply the step by {factor}"),
        times => format!("multiply the step by {factor}, and the number of steps by {times}"),
    }
}

fn fix(cx: &Context, march: &March, length: StepLength) -> Option<Fix> {
    let factor = f64::from(length.thousandths) / 1000.0;
    let mut edits = step_edits(cx.facts, march, factor)?;
    if length.times > 1 {
        edits.push(limit_edit(cx.facts, march, length.times)?);
    }
    Some(Fix::suggestion(title(length), edits))
}
