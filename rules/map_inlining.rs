//! Large scene functions that one function calls many times.

use shaderlint_lint::prelude::*;
use std::collections::BTreeMap;

rule! { map_inlining, Budget, Info, Recommended, [Count(&CALLS), Number(&SIZE)], Function(check) }

static CALLS: Setting<u64> = Setting::new(
    "calls",
    4,
    "Minimum number of calls of one function in another",
);
static SIZE: Setting<f64> = Setting::new(
    "size",
    3000.0,
    "Minimum size of all inlined copies together, in operations",
);

/// Maximum number of further calls that get a label.
const MAX_LABELS: usize = 7;

fn check(cx: &mut Context, function: FunctionRef) {
    let program = cx.program;
    let mut by_callee: BTreeMap<FunctionRef, Vec<ExprId>> = BTreeMap::new();
    for call in cx.facts.calls().calls_by(function) {
        by_callee.entry(call.callee).or_default().push(call.expr);
    }
    for (callee, calls) in by_callee {
        let takes_place = program
            .function(callee)
            .is_some_and(|f| f.params.iter().any(|p| p.ty.components() >= 2));
        let is_many = calls.len() as u64 >= cx.option(&CALLS);
        if !is_many || !takes_place {
            continue;
        }
        let size = cx.facts.work().size(callee);
        let count = calls.len();
        let copied = size * count as f64;
        let (Some(name), true) = (program.function(callee), copied >= cx.option(&SIZE)) else {
            continue;
        };
        let name = program.names.text(name.name);
        let Some(first) = calls.first() else {
            continue;
        };
        let mut finding = cx
            .report_expr(
                *first,
                format!("`{name}` is called {count} times here and inlined at each call"),
            )
            .mark(format!("{size:.0} operations"));
        for call in calls.iter().skip(1).take(MAX_LABELS) {
            finding = finding.label(program.expr_span(*call), "inlined again");
        }
        finding
            .note(format!(
                "compilers inline every call: the copies have {} operations, and compiling them \
                takes long",
                grouped(copied as u64)
            ))
            .help(format!(
                "call `{name}` once, in a loop that starts at `min(iFrame, 0)` and so \
                is never unrolled"
            ));
    }
}
