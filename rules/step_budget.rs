//! Ray marching loops that take more steps than a software renderer can.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule, RuleOption};
use crate::semantic::flow::{Loop, each_operand};
use crate::semantic::tunable::{Range, range_behind};
use crate::semantic::{FunctionRef, Resolution};
use crate::syntax::ast::{ExprId, StmtKind};
use crate::text::Span;

pub static RULE: Rule = Rule {
    name: "step-budget",
    group: Group::Budget,
    severity: Severity::Warning,
    default: true,
    options: &[
        RuleOption {
            name: "main",
            default: 64.0,
            on_gpu: 256.0,
            about: "Most steps of a loop that looks for what a pixel shows",
        },
        RuleOption {
            name: "shadow",
            default: 16.0,
            on_gpu: 64.0,
            about: "Most steps of a loop that looks for what stands before a light",
        },
        RuleOption {
            name: "sum",
            default: 80.0,
            on_gpu: 512.0,
            about: "Most steps of all marching loops together",
        },
    ],
    page: include_str!("step_budget.md"),
    check: Check::Program(check),
};

/// A marching loop, and how many steps it may take.
struct March {
    looped: Loop,
    steps: u64,
    allowed: u64,
    is_shadow: bool,
    documented: Option<Range>,
}

fn check(cx: &mut Context) {
    let Some(entry) = cx.facts.entry() else {
        return;
    };
    let reached = cx.facts.calls().reached_from(entry);
    let is_reached = |f: FunctionRef| reached.get(f.0 as usize).copied().unwrap_or(false);
    let loops = cx.facts.loops().all.iter();
    let marches: Vec<March> = loops
        .filter(|l| is_reached(l.function))
        .filter_map(|l| march(cx, l))
        .collect();
    let mut is_over = false;
    for march in &marches {
        if march.steps > march.allowed {
            is_over = true;
            report(cx, march, entry);
        }
    }
    let counted: Vec<&March> = marches.iter().filter(|m| m.documented.is_none()).collect();
    let sum = counted.iter().map(|m| m.steps).sum();
    if !is_over && sum > cx.option("sum") as u64 {
        report_sum(cx, &counted, sum);
    }
}

/// A loop that marches: it calls a function of the shader at each step, and what it finds there
/// ends it.
fn march(cx: &Context, looped: &Loop) -> Option<March> {
    let steps = looped.turns?;
    let limit = looped.limit?;
    if !looped.ends_early || !calls_function(cx, looped) {
        return None;
    }
    let documented = documented(cx, limit);
    let name = cx.program.function(looped.function)?.name;
    let is_shadow = cx
        .program
        .names
        .text(name)
        .to_lowercase()
        .contains("shadow");
    let usual = cx.option(if is_shadow { "shadow" } else { "main" }) as u64;
    Some(March {
        looped: *looped,
        steps,
        allowed: documented.as_ref().map_or(usual, |r| r.max as u64),
        is_shadow,
        documented,
    })
}

/// Whether a loop's body calls a function of the shader with a place in space.
fn calls_function(cx: &Context, looped: &Loop) -> bool {
    let program = cx.program;
    let StmtKind::For { body, .. } = program.tree.stmt(looped.stmt).kind else {
        return false;
    };
    let extent = program.tree.stmt(body).extent;
    cx.facts.calls().calls_by(looped.function).any(|call| {
        let expr = program.tree.expr(call.expr);
        let is_inside = extent.first <= expr.extent.first && expr.extent.last <= extent.last;
        is_inside && takes_place(cx, call.expr)
    })
}

fn takes_place(cx: &Context, call: ExprId) -> bool {
    let program = cx.program;
    let Resolution::Function(callee) = program.expr(call).resolution else {
        return false;
    };
    program
        .function(callee)
        .is_some_and(|f| f.params.iter().any(|p| p.ty.components() >= 2))
}

/// The range that the author wrote behind the number that the loop runs to.
fn documented(cx: &Context, limit: ExprId) -> Option<Range> {
    let (definition, _) = definition(cx, limit)?;
    range_behind(cx.program, definition).map(|(range, _)| range)
}

/// Where the number that a loop runs to is given, as a macro or a constant: its last token, and the
/// name.
fn definition(cx: &Context, limit: ExprId) -> Option<(Span, Span)> {
    let program = cx.program;
    let mut todo = vec![limit];
    while let Some(next) = todo.pop() {
        let expr = program.tree.expr(next);
        // The outermost macro is the one that stands in the loop.
        if let Some(used) = program.macros_at(expr.extent.first).last() {
            let mut macros = program.tokens.macros.iter();
            let definition = macros.find(|m| m.name_span == used.definition)?;
            return Some((definition.body.last()?.token.span, used.definition));
        }
        if let Resolution::Variable(id) = program.expr(next).resolution
            && let Some(variable) = program.variable(id).filter(|v| v.is_const)
        {
            let position = program.declared.iter().position(|d| *d == Some(id))?;
            let declarator = program.tree.declarator_lists.get(position)?;
            let behind = program.token(declarator.extent.last + 1)?.span;
            return Some((behind, program.token(variable.token?)?.span));
        }
        each_operand(&program.tree, expr, |child| todo.push(child));
    }
    None
}

fn report(cx: &mut Context, march: &March, entry: FunctionRef) {
    let Some(limit) = march.looped.limit else {
        return;
    };
    let March {
        steps,
        allowed,
        is_shadow,
        ..
    } = *march;
    let way = way(cx, entry, march.looped.function);
    let definition = definition(cx, limit);
    let role = if is_shadow {
        "shadow loop"
    } else {
        "marching loop"
    };
    let finding = cx.report_expr(
        limit,
        format!("the {role} takes up to {steps} steps; {allowed} are allowed"),
    );
    let finding = match definition {
        Some((_, name)) if march.documented.is_none() => finding.label(name, "defined here"),
        _ => finding,
    };
    let finding = match &march.documented {
        Some(range) => finding.label(range.span, "the range that its author gives"),
        None => finding.note("a software renderer takes too long for more, and shows nothing"),
    };
    let finding = match way {
        Some(way) => finding.note(format!("called as {way}")),
        None => finding,
    };
    finding.help(format!("take at most {allowed}"));
}

/// `mainImage` → `render` → `castRay`, where it is more than the entry alone.
fn way(cx: &Context, entry: FunctionRef, to: FunctionRef) -> Option<String> {
    let chain = cx.facts.calls().chain(entry, to)?;
    let names: Vec<String> = chain
        .iter()
        .filter_map(|f| cx.program.function(*f))
        .map(|f| format!("`{}`", cx.program.names.text(f.name)))
        .collect();
    (names.len() > 2).then(|| names.join(", "))
}

fn report_sum(cx: &mut Context, marches: &[&March], sum: u64) {
    let Some(largest) = marches.iter().max_by_key(|m| m.steps) else {
        return;
    };
    let Some(limit) = largest.looped.limit else {
        return;
    };
    let others: Vec<(Span, u64)> = marches
        .iter()
        .filter(|m| m.looped.stmt != largest.looped.stmt)
        .filter_map(|m| Some((cx.program.expr_span(m.looped.limit?), m.steps)))
        .collect();
    let (main, shadow, most) = (cx.option("main"), cx.option("shadow"), cx.option("sum"));
    let mut finding = cx
        .report_expr(
            limit,
            format!("the marching loops take up to {sum} steps together; {most} are allowed"),
        )
        .mark(format!("{} steps", largest.steps));
    for (span, steps) in others {
        finding = finding.label(span, format!("{steps} steps"));
    }
    finding
        .note("a software renderer takes too long for more, and shows nothing")
        .help(format!(
            "take at most {main} for the picture and {shadow} for shadows"
        ));
}
