//! Ray marching loops with more steps than the target renderer can afford.

use shaderlint_lint::march::{March, MarchGoal, way};
use shaderlint_lint::prelude::*;
use shaderlint_semantic::tunable::{TunableRange, range_after};

rule! {
    step_budget, Budget, Info, Recommended,
    [Count(&MAIN), Count(&SHADOW), Count(&SUM)], Program(check)
}

static MAIN: Setting<u64> = Setting::new(
    "main",
    200,
    "Maximum steps of a marching loop that is not a shadow loop",
)
.on_swiftshader(64);
static SHADOW: Setting<u64> =
    Setting::new("shadow", 64, "Maximum steps of a shadow loop").on_swiftshader(16);
static SUM: Setting<u64> =
    Setting::new("sum", 512, "Maximum steps of all marching loops together").on_swiftshader(80);

/// Reason for the limit.
const WHY: &str = "each step evaluates the whole scene, and any pixel may take all steps";

/// A marching loop and its maximum number of steps.
struct Marched {
    march: March,
    /// The expression that gives the number of steps.
    given: ExprId,
    steps: u64,
    allowed: u64,
    documented: Option<TunableRange>,
}

fn check(cx: &mut Context) {
    let Some(entry) = cx.facts.entry() else {
        return;
    };
    let facts = cx.facts;
    let marches: Vec<Marched> = facts
        .marches()
        .iter()
        .filter_map(|m| marched(cx, m))
        .collect();
    let mut is_over = false;
    for march in &marches {
        if march.steps > march.allowed {
            is_over = true;
            report(cx, march, entry);
        }
    }
    let counted: Vec<&Marched> = marches.iter().filter(|m| m.documented.is_none()).collect();
    let sum = counted.iter().map(|m| m.steps).sum();
    if !is_over && sum > cx.option(&SUM) {
        report_sum(cx, &counted, sum);
    }
}

/// Counts the steps of a loop that a hit may end early; `None` where the number is not known.
fn marched(cx: &Context, march: &March) -> Option<Marched> {
    let steps = march.looped.bound.iterations()?;
    let given = march.looped.given?;
    if !march.looped.ends_early {
        return None;
    }
    let documented = documented(cx, given);
    let usual = match march.goal {
        MarchGoal::Image => cx.option(&MAIN),
        MarchGoal::Shadow => cx.option(&SHADOW),
    };
    Some(Marched {
        march: march.clone(),
        given,
        steps,
        allowed: documented.as_ref().map_or(usual, |r| r.max as u64),
        documented,
    })
}

/// The range in the comment after the definition of the number of steps: `// (80~400)`.
fn documented(cx: &Context, given: ExprId) -> Option<TunableRange> {
    let (definition, _) = definition(cx, given)?;
    range_after(cx.program, definition).map(|(range, _)| range)
}

/// The macro or constant that defines the number of steps: the span of its last token, and of its
/// name.
fn definition(cx: &Context, given: ExprId) -> Option<(Span, Span)> {
    let program = cx.program;
    let mut todo = vec![given];
    while let Some(next) = todo.pop() {
        let expr = program.tree.expr(next);
        // The outermost macro is the one that the loop names.
        if let Some(used) = program.macros_at(expr.extent.first).last() {
            let mut macros = program.tokens.macros.iter();
            let definition = macros.find(|m| m.name_span == used.definition)?;
            return Some((definition.body.last()?.token.span, used.definition));
        }
        if let Resolution::Variable(id) = program.expr(next).resolution
            && let Some(variable) = program.variable(id).filter(|v| v.is_const)
        {
            let declarator = program.declarator_of(id)?;
            let after = program.token(declarator.extent.last + 1)?.span;
            return Some((after, program.declared_at(variable)?));
        }
        each_operand(&program.tree, expr, |child| todo.push(child));
    }
    None
}

fn report(cx: &mut Context, marched: &Marched, entry: FunctionRef) {
    let Marched {
        ref march,
        given,
        steps,
        allowed,
        ..
    } = *marched;
    let looped = march.looped;
    let program = cx.program;
    let way = way(program, cx.facts.calls(), entry, looped.function);
    let definition = definition(cx, given);
    let role = march.goal.name();
    let seen = cx.facts.iterations_note(looped.stmt);
    let limit = looped.limit.filter(|l| *l != given);
    let definition = definition.filter(|_| marched.documented.is_none());
    let message = format!("{role} runs up to {steps} steps; the limit is {allowed}");
    let mut finding = cx
        .report_expr(given, message)
        .label(limit.map(|limit| program.expr_span(limit)), "loop bound")
        .label(definition.map(|(_, name)| name), "defined here");
    finding = match &marched.documented {
        Some(range) => finding.label(range.span, "documented range"),
        None => finding.note(WHY),
    };
    if let Some(way) = way {
        finding = finding.note(format!("call path: {way}"));
    }
    if let Some(seen) = seen {
        finding = finding.note(seen);
    }
    finding.help(format!("use at most {allowed} steps"));
}

fn report_sum(cx: &mut Context, marches: &[&Marched], sum: u64) {
    let Some(largest) = marches.iter().max_by_key(|m| m.steps) else {
        return;
    };
    let others: Vec<(Span, u64)> = marches
        .iter()
        .filter(|m| m.march.looped.stmt != largest.march.looped.stmt)
        .map(|m| (cx.program.expr_span(m.given), m.steps))
        .collect();
    let (main, shadow, most) = (cx.option(&MAIN), cx.option(&SHADOW), cx.option(&SUM));
    let mut finding = cx
        .report_expr(
            largest.given,
            format!("marching loops run up to {sum} steps in total; the limit is {most}"),
        )
        .mark(format!("{} steps", largest.steps));
    for (span, steps) in others {
        finding = finding.label(span, format!("{steps} steps"));
    }
    finding.note(WHY).help(format!(
        "use at most {main} steps for the image and {shadow} for shadows"
    ));
}
