//! Marching loops whose steps are shorter than they need to be.

use shaderlint_diagnostic::{Fix, Severity};
use shaderlint_flow::{DistanceField, Slope};
use shaderlint_lint::march::March;
use shaderlint_lint::step_edit::{factor_edits, step_factor};
use shaderlint_lint::{Check, Context, Group, Rule, RulePreset};
use shaderlint_syntax::ast::Extent;
use shaderlint_text::number::decimals;

pub static RULE: Rule = Rule {
    name: "short-steps",
    group: Group::Budget,
    severity: Severity::Info,
    preset: RulePreset::Recommended,
    options: &[],
    page: include_str!("short_steps.md"),
    checks: &[Check::Run(check)],
};

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
        let proved = proved(cx, march, found.factor);
        let mut finding = cx
            .report(head, format!("steps could be {times} times as long"))
            .note(format!(
                "{after} instead of {before} iterations per ray, and no pixel changes visibly"
            ))
            .note(found.sampled);
        if let Some(proved) = proved {
            finding = finding.note(proved);
        }
        finding.fix(fix);
    }
}

/// That the scene is nowhere too steep for steps with a factor, if it is proved.
fn proved(cx: &Context, march: &March, factor: f64) -> Option<String> {
    let own = DistanceField::of(cx.facts.ranges(), &march.ray)?;
    let mut slopes = cx.facts.slopes().iter();
    let (_, slope) = slopes.find(|(field, _)| *field == own)?;
    let Slope::AtMost(most) = *slope else {
        return None;
    };
    if most * factor > shaderlint_flow::STEEPEST_DISTANCE {
        return None;
    }
    let function = cx.program.function(own.function)?;
    let (name, most) = (
        cx.program.names.text(function.name),
        (most * 1e3).ceil() / 1e3,
    );
    Some(format!(
        "the slope of `{name}` is proved to be at most {}",
        decimals(most, 6)
    ))
}
