//! Expensive calls that return the same value in every iteration of a loop.

use shaderlint_lint::loop_invariant::{
    InvariantLoops, Places, is_loop_invariant, runs_each_iteration,
};
use shaderlint_lint::prelude::*;

rule! { loop_invariant_call, Budget, Info, Recommended, [Number(&OPERATIONS)], Program(check) }

static OPERATIONS: Setting<f64> = Setting::new(
    "operations",
    40.0,
    "Minimum cost of a reported call, in operations",
)
.on_swiftshader(12.0);

fn check(cx: &mut Context) {
    let program = cx.program;
    let facts = cx.facts;
    let mut places: Option<Places> = None;
    for call in &program.calls {
        if program.expr(call.expr).is_const {
            continue;
        }
        let Some(stmt) = facts.structure().stmt_of(call.expr) else {
            continue;
        };
        let mut is_invariant_in = |looped: StmtId| {
            let places = places.get_or_insert_with(|| Places::of(program, facts.writes()));
            let extent = program.tree.stmt(looped).extent;
            runs_each_iteration(program, looped, call.expr)
                && is_loop_invariant(program, facts.writes(), places, call.expr, extent)
        };
        let outwards = || facts.structure().outwards(stmt);
        let is_loop = |stmt: &StmtId| program.tree.stmt(*stmt).kind.is_loop();
        // What the text shows comes first: costs and iterations need the ranges of all values.
        if !outwards().filter(is_loop).any(&mut is_invariant_in)
            || facts.work().operations(call.callee) < cx.option(&OPERATIONS)
            || !facts.effects().is_pure(call.callee)
        {
            continue;
        }
        let around = outwards()
            .filter_map(|s| facts.loops().get(s))
            .filter(|l| l.bound.iterations() != Some(1))
            .filter(|l| runs_each_iteration(program, l.stmt, call.expr));
        let is_invariant = |looped: &LoopFacts| is_invariant_in(looped.stmt);
        let Some(loops) = InvariantLoops::of(around.copied(), is_invariant) else {
            continue;
        };
        let Some(function) = program.function(call.callee) else {
            continue;
        };
        let name = program.names.text(function.name);
        let stmt = program.tree.stmt(loops.outermost.stmt);
        let head = program.span(Extent::token(stmt.extent.first));
        let label = match (loops.runs, loops.count) {
            (Some(runs), 1) => format!("loop of up to {runs} iterations"),
            (Some(runs), _) => format!("up to {runs} calls in this loop"),
            (None, _) => "in this loop".to_string(),
        };
        cx.report_expr(
            call.expr,
            format!("`{name}` returns the same value in every iteration"),
        )
        .label(head, label)
        .help(format!("call `{name}` once, {}", loops.before()));
    }
}
