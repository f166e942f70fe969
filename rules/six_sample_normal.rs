//! Normals by six calls where four do.

use rustc_hash::FxHashMap;
use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Context, Group, Rule, RuleOption, Setting, same_code};
use shaderlint_semantic::{FunctionRef, Program, Resolution};
use shaderlint_syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "six-sample-normal",
    group: Group::Budget,
    severity: Severity::Info,
    default: true,
    options: &[RuleOption::Number(&OPERATIONS)],
    page: include_str!("six_sample_normal.md"),
    checks: &[Check::Program(check)],
};

static OPERATIONS: Setting<f64> = Setting::new(
    "operations",
    20.0,
    "Fewest operations of a function that is reported",
);

/// The size of a scene function from which on its copies matter more than its calls.
const LARGE: f64 = 150.0;

fn check(cx: &mut Context) {
    let program = cx.program;
    let mut pairs: FxHashMap<(FunctionRef, FunctionRef), Vec<ExprId>> = FxHashMap::default();
    for call in &program.calls {
        let Some(caller) = call.caller else { continue };
        if let Some(difference) = difference(cx, call.expr, call.callee) {
            let found = pairs.entry((caller, call.callee)).or_default();
            if found.last() != Some(&difference) {
                found.push(difference);
            }
        }
    }
    let mut all: Vec<_> = pairs.into_iter().collect();
    all.sort_unstable();
    for ((_, callee), differences) in all {
        let &[first, .., last] = differences.as_slice() else {
            continue;
        };
        // A large scene is another finding, that of its copies.
        let work = cx.facts.work();
        let is_dear =
            work.operations(callee) >= cx.option(&OPERATIONS) && work.size(callee) < LARGE;
        let (Some(function), 3, true) = (program.function(callee), differences.len(), is_dear)
        else {
            continue;
        };
        let name = program.names.text(function.name);
        let last = program.expr_span(last);
        cx.report_expr(
            first,
            format!("three differences are six calls of `{name}`"),
        )
        .label(last, "the third")
        .help("four calls at the corners of a tetrahedron give the same normal");
    }
}

/// The difference `f(p + e) - f(p - e)` that a call is the left side of.
fn difference(cx: &Context, call: ExprId, callee: FunctionRef) -> Option<ExprId> {
    let program = cx.program;
    let tree = &program.tree;
    let structure = cx.facts.structure();
    let mut parent = structure.parent(call)?;
    let mut side = call;
    while let ExprKind::Member(..) | ExprKind::Paren(_) = tree.expr(parent).kind {
        side = parent;
        parent = structure.parent(parent)?;
    }
    let ExprKind::Binary(BinaryOp::Sub, left, right) = tree.expr(parent).kind else {
        return None;
    };
    let other = called(program, right).filter(|_| left == side)?;
    let is_same = program.expr(other).resolution == Resolution::Function(callee);
    let (p, plus) = shifted(program, call)?;
    let (q, minus) = shifted(program, other)?;
    let [a, b] = [p, q].map(|e| tree.expr(e).extent);
    let is_central = (plus, minus) == (BinaryOp::Add, BinaryOp::Sub)
        || (plus, minus) == (BinaryOp::Sub, BinaryOp::Add);
    (is_same && is_central && same_code(program, a, b)).then_some(parent)
}

/// The call that an expression is, or a member of.
fn called(program: &Program, expr: ExprId) -> Option<ExprId> {
    let tree = &program.tree;
    let mut at = tree.unparen(expr);
    while let ExprKind::Member(inner, _) = tree.expr(at).kind {
        at = tree.unparen(inner);
    }
    matches!(tree.expr(at).kind, ExprKind::Call(..)).then_some(at)
}

/// The place that the first argument of a call is a step from, and which way.
fn shifted(program: &Program, call: ExprId) -> Option<(ExprId, BinaryOp)> {
    let tree = &program.tree;
    let ExprKind::Call(_, args) = tree.expr(call).kind else {
        return None;
    };
    let first = *tree.args(args).first()?;
    match tree.expr(first).kind {
        ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), from, _) => Some((from, op)),
        _ => None,
    }
}
