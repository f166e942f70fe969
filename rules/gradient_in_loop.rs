//! Derivatives in loops that pixels exit at different iterations.

use shaderlint_flow::DivergenceCause;
use shaderlint_lint::prelude::*;

rule! { gradient_in_loop, Portability, Info, Recommended, Program(check) }

/// Most findings in one shader.
const MAX_FINDINGS: usize = 8;

fn check(cx: &mut Context) {
    let facts = cx.facts;
    let program = cx.program;
    let looped = facts.gradients().iter().filter_map(|g| match g.cause {
        DivergenceCause::Loop(looped) => Some((g, facts.module().looped(looped)?.stmt)),
        DivergenceCause::Branch(_) => None,
    });
    for (gradient, stmt) in looped.take(MAX_FINDINGS) {
        let head = program.span(Extent::token(program.tree.stmt(stmt).extent.first));
        let name = gradient.function.name();
        let finding = cx
            .report_op(
                gradient.call,
                format!("`{name}` is called in a loop that pixels exit at different iterations"),
            )
            .label(head, "some pixels exit earlier")
            .note(
                "its derivatives are undefined here; Direct3D unrolls the loop for them or \
                rejects it",
            );
        if gradient.function.kind().is_texture() {
            finding.help(
                "use `textureLod` with an explicit level, or `textureGrad` with derivatives from \
                before the loop",
            );
        } else {
            finding.help("compute the derivative before the loop");
        }
    }
}
