//! Sums of more octaves of noise than anybody sees.

use crate::diagnostic::Severity;
use crate::lint::light::has_word;
use crate::lint::{Check, Context, Group, Rule, RuleOption, Setting};
use crate::semantic::tunable::range_behind;
use crate::semantic::{Resolution, VariableId};
use crate::syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "octave-budget",
    group: Group::Budget,
    severity: Severity::Info,
    default: true,
    options: &[RuleOption::Count(&OCTAVES)],
    page: include_str!("octave_budget.md"),
    checks: &[Check::Stmt(check)],
};

static OCTAVES: Setting<u64> =
    Setting::new("octaves", 6, "Most octaves of a sum of noise").on_gpu(12);

fn check(cx: &mut Context, stmt: StmtId) {
    let program = cx.program;
    let Some(looped) = cx.facts.loops().get(stmt).copied() else {
        return;
    };
    let (Some(turns), Some(given)) = (looped.bound.turns(), looped.given) else {
        return;
    };
    let most = cx.option(&OCTAVES);
    // A loop that leaves early sums as many octaves as its caller asks for.
    if looped.ends_early || turns <= most || !sums_octaves(cx, stmt) {
        return;
    }
    let uses = program.macros_at(program.tree.expr(given).extent.first);
    let body_end = uses.last().and_then(|used| {
        let mut macros = program.tokens.macros.iter();
        let found = macros.find(|m| m.name_span == used.definition)?;
        Some(found.body.last()?.token.span)
    });
    // The author's own range goes before.
    if let Some((range, _)) = body_end.and_then(|end| range_behind(program, end))
        && turns as f64 <= range.max
    {
        return;
    }
    cx.report_expr(
        given,
        format!("the noise is summed over {turns} octaves; {most} are allowed"),
    )
    .note("each octave costs as much as the one before and shows half as much of it; the last ones are smaller than a pixel")
    .help(format!("sum {most} octaves, and fewer far away"));
}

/// Whether a loop calls a noise at each turn and scales a place and an amplitude by numbers.
fn sums_octaves(cx: &Context, stmt: StmtId) -> bool {
    let program = cx.program;
    let extent = program.tree.stmt(stmt).extent;
    let inside = |e: &Expr| extent.first <= e.extent.first && e.extent.last <= extent.last;
    let Some(function) = cx.facts.structure().function_of(stmt) else {
        return false;
    };
    let calls_noise = cx.facts.calls().calls_by(function).any(|c| {
        let callee = program.function(c.callee);
        let name = callee.map_or("", |f| program.names.text(f.name));
        inside(program.tree.expr(c.expr)) && is_noise(name)
    });
    // Only then is it worth looking at every expression.
    calls_noise && scales(cx, &inside) >= 2
}

fn is_noise(name: &str) -> bool {
    has_word(
        name,
        &[
            "noise", "noised", "perlin", "simplex", "snoise", "vnoise", "gnoise",
        ],
    ) || name.to_lowercase().contains("noise")
}

/// How many variables are scaled by a number.
fn scales(cx: &Context, inside: &impl Fn(&Expr) -> bool) -> usize {
    let program = cx.program;
    let mut scaled: std::collections::BTreeSet<VariableId> = Default::default();
    for (i, expr) in program
        .tree
        .exprs
        .iter()
        .enumerate()
        .filter(|(_, e)| inside(e))
    {
        let is_scaling = match expr.kind {
            ExprKind::Assign(Some(BinaryOp::Mul | BinaryOp::Div), ..) => true,
            ExprKind::Assign(Some(BinaryOp::Add), target, by) => {
                program.variable_of(target).is_some()
                    && program.variable_of(target) == program.variable_of(by)
            }
            ExprKind::Assign(None, target, value) => mentions(program, value, target),
            _ => false,
        };
        if is_scaling {
            scaled.extend(cx.facts.writes().by(ExprId(i as u32)));
        }
    }
    scaled.len()
}

/// Whether a product holds the variable that it is assigned to: `p = m * p * 2.0`.
fn mentions(program: &crate::semantic::Program, value: ExprId, target: ExprId) -> bool {
    let Resolution::Variable(wanted) = program.expr(target).resolution else {
        return false;
    };
    let factors = crate::lint::light::factors(program, value);
    factors.len() > 1
        && factors
            .iter()
            .any(|f| program.variable_of(*f) == Some(wanted))
}
