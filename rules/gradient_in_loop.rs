//! Textures with derivatives inside loops that pixels leave apart.

use shaderlint_diagnostic::Severity;
use shaderlint_flow::Parted;
use shaderlint_lint::{Check, Context, Group, Rule};
use shaderlint_syntax::ast::Extent;

pub static RULE: Rule = Rule {
    name: "gradient-in-loop",
    group: Group::Portability,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("gradient_in_loop.md"),
    checks: &[Check::Program(check)],
};

/// Most findings in one shader.
const MAX_FINDINGS: usize = 8;

fn check(cx: &mut Context) {
    let facts = cx.facts;
    let program = cx.program;
    let looped = facts.gradients().iter().filter_map(|g| match g.parted {
        Parted::Loop(looped) => Some((g, facts.module().looped(looped)?.stmt)),
        Parted::Branch(_) => None,
    });
    for (gradient, stmt) in looped.take(MAX_FINDINGS) {
        let head = program.span(Extent::token(program.tree.stmt(stmt).extent.first));
        let name = gradient.function.name();
        let finding = cx
            .report_op(
                gradient.call,
                format!("`{name}` takes derivatives in a loop that pixels leave apart"),
            )
            .label(head, "some pixels leave this loop before others")
            .note("they are undefined here, and Direct3D unrolls the loop for them or refuses it");
        if gradient.function.kind().is_texture() {
            finding.help(
                "use `textureLod` with a level of your own, or `textureGrad` with derivatives from before the loop",
            );
        } else {
            finding.help("take the derivative before the loop");
        }
    }
}
