//! The same expensive call twice in one statement, where compilers do not merge the calls.

use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_lint::prelude::*;
use shaderlint_semantic::each_expr;
use std::collections::hash_map::Entry;

rule! { repeated_call, Budget, Info, Recommended, [Number(&OPERATIONS)], Program(check) }

static OPERATIONS: Setting<f64> = Setting::new(
    "operations",
    60.0,
    "Minimum cost of a reported call, in operations",
)
.on_swiftshader(20.0);

fn check(cx: &mut Context) {
    let program = cx.program;
    let facts = cx.facts;
    let merged = merged(cx);
    // By statement, function and spelling.
    let mut first: FxHashMap<(StmtId, FunctionRef, Vec<Word>), ExprId> = FxHashMap::default();
    for call in &program.calls {
        if facts.work().operations(call.callee) < cx.option(&OPERATIONS)
            || !facts.effects().is_pure(call.callee)
            || merged.get(call.callee.0 as usize) != Some(&false)
        {
            continue;
        }
        let Some(stmt) = facts.structure().stmt_of(call.expr) else {
            continue;
        };
        let extent = program.tree.expr(call.expr).extent;
        // Long calls are rarely written twice, and comparing all of them takes time.
        if extent.last - extent.first > MAX_TOKENS || is_taken_apart(cx, stmt) {
            continue;
        }
        let spelling = spelling(program, extent);
        match first.entry((stmt, call.callee, spelling)) {
            Entry::Vacant(slot) => {
                slot.insert(call.expr);
            }
            Entry::Occupied(found) => {
                report(cx, call.callee, *found.get(), call.expr);
            }
        }
    }
}

/// Most iterations of a loop that compilers unroll.
const UNROLLED: u64 = 32;

/// By function: whether compilers merge two calls with the same arguments. They inline every call and
/// compute equal values once, but do not compare loops.
fn merged(cx: &Context) -> Vec<bool> {
    let loops = cx.facts.loops().all.iter();
    let is_kept = |l: &&LoopFacts| l.bound.iterations().is_none_or(|n| n > UNROLLED);
    let kept: FxHashSet<FunctionRef> = loops.filter(is_kept).map(|l| l.function).collect();
    let reaching = cx.facts.calls().graph.reaching(|f| kept.contains(&f));
    reaching.into_iter().map(|is_kept| !is_kept).collect()
}

/// Maximum length of a call that is compared, in tokens.
const MAX_TOKENS: u32 = 64;

fn report(cx: &mut Context, callee: FunctionRef, before: ExprId, again: ExprId) {
    let program = cx.program;
    let Some(function) = program.function(callee) else {
        return;
    };
    let name = program.names.text(function.name);
    let before = program.expr_span(before);
    let uses = program.macros_at(program.tree.expr(again).extent.first);
    let mut finding = cx.report_expr(
        again,
        format!("repeated call of `{name}` with the same arguments"),
    );
    if program.expr_span(again) != before {
        finding = finding.label(before, "first call");
    }
    match uses.last() {
        Some(used) => {
            let name = used.name.clone();
            finding.help(format!(
                "store the result in a variable: `{name}` repeats its argument"
            ))
        }
        None => finding.help("store the result in a variable"),
    };
}

/// A token without its position.
type Word = (TokenKind, u32);

/// The tokens of a node.
fn spelling(program: &Program, extent: Extent) -> Vec<Word> {
    (extent.first..=extent.last)
        .filter_map(|t| program.token(t))
        .map(|t| (t.kind, t.value))
        .collect()
}

/// Whether a statement assigns while it is evaluated, so that two calls in it may differ, or
/// evaluates only one of two operands.
fn is_taken_apart(cx: &Context, stmt: StmtId) -> bool {
    let program = cx.program;
    let tree = &program.tree;
    let mut roots = Vec::new();
    each_expr(tree, tree.stmt(stmt), |e| roots.push(e));
    let is_assignment = |e: ExprId| matches!(tree.expr(e).kind, ExprKind::Assign(..));
    let mut todo = Vec::new();
    for root in roots {
        match tree.expr(root).kind {
            ExprKind::Assign(_, target, value) => todo.extend([target, value]),
            _ => todo.push(root),
        }
    }
    while let Some(e) = todo.pop() {
        let writes = is_assignment(e) || !cx.facts.writes().by(e).is_empty();
        if writes || matches!(tree.expr(e).kind, ExprKind::Ternary(..)) {
            return true;
        }
        each_operand(tree, tree.expr(e), |child| todo.push(child));
    }
    false
}
