//! Nested loops with too many iterations per pixel.

use shaderlint_lint::prelude::*;

rule! { nested_iterations, Budget, Info, Recommended, [Number(&ITERATIONS)], Program(check) }

static ITERATIONS: Setting<f64> = Setting::new(
    "turns",
    100_000.0,
    "Maximum iterations of all innermost loops per pixel",
)
.on_swiftshader(1000.0);

/// Maximum number of enclosing loops that get a label.
const MAX_LABELS: usize = 6;

fn check(cx: &mut Context) {
    let Some(entry) = cx.facts.entry() else {
        return;
    };
    let iterations = cx.facts.work().iterations(entry);
    let most = cx.option(&ITERATIONS);
    if iterations <= most {
        return;
    }
    let program = cx.program;
    let nests = cx.facts.work().heaviest(cx.facts.module(), entry);
    let Some(inner) = nests.last() else {
        return;
    };
    let keyword = |stmt| Extent::token(program.tree.stmt(stmt).extent.first);
    let chain: Vec<String> = nests.iter().map(|n| n.iterations.to_string()).collect();
    let total = if iterations < 1e15 {
        (iterations as u64).to_string()
    } else {
        format!("{iterations:.0e}")
    };
    let mut finding = cx
        .report(
            keyword(inner.stmt),
            format!("up to {total} loop iterations per pixel; the limit is {most}"),
        )
        .mark(format!("{} iterations", inner.iterations));
    for nest in nests.iter().rev().skip(1).take(MAX_LABELS) {
        let is_loop = !matches!(program.tree.stmt(nest.stmt).kind, StmtKind::Block(_));
        if is_loop {
            finding = finding.label(
                program.span(keyword(nest.stmt)),
                format!("multiplied by {} iterations", nest.iterations),
            );
        }
    }
    if chain.len() > 1 {
        finding = finding.note(format!(
            "the most expensive nest runs {} iterations",
            chain.join(" × ")
        ));
    }
    finding.help("reduce the iterations of one of the loops, or exit early with `break`");
}
