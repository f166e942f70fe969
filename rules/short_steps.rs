//! Marching loops whose steps are shorter than they need to be.

use shaderlint_lint::march::{factor_edits, step_factor};
use shaderlint_lint::prelude::*;

rule! { short_steps, Budget, Info, Recommended, Run(check) }

fn check(cx: &mut Context) {
    let facts = cx.facts;
    for march in facts.marches() {
        let Some(factor) = step_factor(facts, march) else {
            continue;
        };
        let Some(found) = facts.longer_steps(march, factor) else {
            continue;
        };
        let fix = factor_edits(facts, march, [factor, found.factor]).map(|edits| {
            let title = match found.factor < 1.0 {
                true => format!("multiply the distance by {}", decimals(found.factor, 6)),
                false => "step as far as the distance".to_string(),
            };
            Fix::suggestion(title, edits)
        });
        let head = Extent::token(cx.program.tree.stmt(march.looped.stmt).extent.first);
        let times = (found.factor / factor * 10.0).round() / 10.0;
        let [before, after] = found.iterations.map(f64::round);
        cx.report(head, format!("steps could be {times} times as long"))
            .note(format!(
                "{after} instead of {before} iterations per ray, and no pixel changes visibly"
            ))
            .note(found.sampled)
            .fix(fix);
    }
}
