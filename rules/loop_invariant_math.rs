//! Expensive built-in functions that return the same value in every iteration of a loop.

use shaderlint_flow::Bound;
use shaderlint_lint::loop_invariant::{
    InvariantLoops, Places, is_loop_invariant, runs_each_iteration,
};
use shaderlint_lint::prelude::*;

rule! { loop_invariant_math, Budget, Info, Performance, Program(check) }

/// Minimum iterations of a loop that is checked: a few samples per pixel cost little.
const FEWEST_ITERATIONS: u64 = 8;

/// Maximum number of enclosing expressions that are searched for a larger invariant call.
const MAX_OUTER: usize = 6;

fn check(cx: &mut Context) {
    let program = cx.program;
    let facts = cx.facts;
    let mut places: Option<Places> = None;
    let mut last: Option<StmtId> = None;
    for (expr, at) in program.tree.exprs.iter().zip(0..) {
        let id = ExprId(at);
        let ExprKind::Call(..) = expr.kind else {
            continue;
        };
        let is_call = program.builtin_called(id).is_some_and(is_dear);
        if !is_call || program.expr(id).is_const || !program.is_user(program.expr_span(id)) {
            continue;
        }
        let Some(stmt) = facts.structure().stmt_of(id) else {
            continue;
        };
        let around = facts
            .structure()
            .outwards(stmt)
            .filter_map(|s| facts.loops().get(s))
            .filter(|l| runs_each_iteration(program, l.stmt, id));
        let mut around = around.skip_while(|l| !is_long(l.bound)).copied().peekable();
        if around.peek().is_none() {
            continue;
        }
        let places = places.get_or_insert_with(|| Places::of(cx.program, facts.writes()));
        let extent = |looped: &LoopFacts| program.tree.stmt(looped.stmt).extent;
        let still = |e, looped: &LoopFacts| {
            is_loop_invariant(program, facts.writes(), places, e, extent(looped))
        };
        let Some(loops) = InvariantLoops::of(around, |looped| still(id, looped)) else {
            continue;
        };
        if calls_function(program, id) {
            continue;
        }
        // Only the largest invariant call is reported: that one is to be moved out.
        let outer = std::iter::successors(facts.structure().parent(id), |p| {
            facts.structure().parent(*p)
        });
        let is_larger = |p: &ExprId| program.builtin_called(*p).is_some_and(is_dear);
        if outer
            .take(MAX_OUTER)
            .any(|p| is_larger(&p) && still(p, &loops.outermost))
        {
            continue;
        }
        // One finding per statement.
        if last.replace(stmt) == Some(stmt) {
            continue;
        }
        let text = program.expr_text(id);
        let head = program.span(Extent::token(extent(&loops.outermost).first));
        let message = format!("`{text}` has the same value in every iteration");
        cx.report_expr(id, message)
            .label(head, "in this loop")
            .help(format!("compute it once, {}", loops.before()));
    }
}

fn is_long(bound: Bound) -> bool {
    bound
        .iterations()
        .is_none_or(|iterations| iterations >= FEWEST_ITERATIONS)
}

/// Whether an expression calls a user-defined function, which may have side effects.
fn calls_function(program: &Program, id: ExprId) -> bool {
    let mut todo = vec![id];
    while let Some(next) = todo.pop() {
        if let Resolution::Function(_) = program.expr(next).resolution {
            return true;
        }
        let tree = &program.tree;
        each_operand(tree, tree.expr(next), |child| todo.push(child));
    }
    false
}

/// Whether a built-in function is expensive.
const fn is_dear(function: BuiltinId) -> bool {
    use BuiltinId::*;
    matches!(
        function,
        Normalize | Sin | Cos | Tan | Asin | Acos | Atan | Pow | Exp | Log | Inverse
    )
}
