//! Components of vectors and elements of local arrays whose number is computed.

use shaderlint_diagnostic::Severity;
use shaderlint_lint::{Check, Context, Group, Rule, Shape};
use shaderlint_semantic::Storage;
use shaderlint_syntax::ast::*;

pub static RULE: Rule = Rule {
    name: "component-by-index",
    group: Group::Portability,
    severity: Severity::Info,
    default: false,
    options: &[],
    page: include_str!("component_by_index.md"),
    checks: &[Check::Expr(&[Shape::Index], check)],
};

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Index(object, index) = program.tree.expr(id).kind else {
        return;
    };
    let ty = program.ty(object);
    let is_known = program.expr(index).is_const || program.scalar(index).is_some();
    if is_known {
        return;
    }
    let text = program.expr_text(object);
    if ty.is_vector() {
        let message = format!("which component of `{text}` this is, is computed");
        cx.report_expr(id, message)
            .note("drivers of Adreno have mixed such components up, and compilers of Direct3D refuse writes to them in loops")
            .help("choose among `.x`, `.y` and `.z` with conditions");
        return;
    }
    let variable = program
        .variable_of(object)
        .and_then(|v| program.variable(v));
    let is_own = variable.is_some_and(|v| v.storage == Storage::Local && !v.is_const);
    if ty.is_array() && is_own {
        let message = format!("which element of the local array `{text}` this is, is computed");
        cx.report_expr(id, message)
            .note("Safari 15 has drawn such elements wrong; elsewhere the whole array may move to slow memory")
            .help("choose with conditions, or keep the numbers in a vector, a `const` array or a texture");
    }
}
