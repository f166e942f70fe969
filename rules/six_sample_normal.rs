//! Normals computed with six calls of the scene function where four are enough.

use rustc_hash::FxHashMap;
use shaderlint_lint::prelude::*;

rule! { six_sample_normal, Budget, Info, Recommended, [Number(&OPERATIONS)], Program(check) }

static OPERATIONS: Setting<f64> = Setting::new(
    "operations",
    20.0,
    "Smallest scene function that is reported, in operations per call",
);

/// Code size, in operations, from which inlining matters more than the calls: `map-inlining` reports six
/// copies of such a function.
const LARGE: f64 = 500.0;

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
        // A large scene function is reported by `map-inlining`.
        let work = cx.facts.work();
        let is_dear =
            work.operations(callee) >= cx.option(&OPERATIONS) && work.size(callee) < LARGE;
        let (Some(function), 3, true) = (program.function(callee), differences.len(), is_dear)
        else {
            continue;
        };
        let name = program.names.text(function.name);
        let last_span = program.expr_span(last);
        if differences.iter().all(|d| is_diagonal(cx, *d)) {
            cx.report_expr(
                first,
                "the differences of this normal are all in one direction",
            )
            .mark("first of three differences")
            .label(last_span, "the same offset again")
            .help("use `vec2 e = vec2(h, 0.0)` with the offsets `e.xyy`, `e.yxy` and `e.yyx`");
            continue;
        }
        cx.report_expr(
            first,
            format!("normal calls `{name}` 6 times where 4 calls are enough"),
        )
        .mark("first of three differences")
        .label(last_span, "third difference")
        .help(format!(
            "use the tetrahedron technique: 4 calls of `{name}` give the same normal"
        ));
    }
}

/// The difference `f(p + e) - f(p - e)` whose left side is this call.
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

/// Whether the offset `e` of the difference `f(p + e) - f(p - e)` is the same number on every axis.
fn is_diagonal(cx: &Context, difference: ExprId) -> bool {
    let program = cx.program;
    let tree = &program.tree;
    let ExprKind::Binary(_, left, _) = tree.expr(difference).kind else {
        return false;
    };
    let ExprKind::Call(_, args) =
        called(program, left).map_or(ExprKind::Error, |call| tree.expr(call).kind)
    else {
        return false;
    };
    let point = tree.args(args).first().map(|arg| tree.expr(*arg).kind);
    let Some(ExprKind::Binary(_, _, offset)) = point else {
        return false;
    };
    let mut axes = cx.facts.range(offset).map(|range| range.single());
    let first = axes.next().flatten();
    first.is_some_and(|first| first != 0.0) && axes.all(|axis| axis == first)
}

/// The call in `f(p)` or `f(p).x`.
fn called(program: &Program, expr: ExprId) -> Option<ExprId> {
    let tree = &program.tree;
    let mut at = tree.unparen(expr);
    while let ExprKind::Member(inner, _) = tree.expr(at).kind {
        at = tree.unparen(inner);
    }
    matches!(tree.expr(at).kind, ExprKind::Call(..)).then_some(at)
}

/// The point `p` and the direction of the first argument, `p + e` or `p - e`.
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
