//! Vector components and elements of local arrays selected by a non-constant index.

use shaderlint_lint::prelude::*;

rule! { component_by_index, Portability, Info, Strict, Expr(&[Shape::Index], check) }

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
        let message = format!("vector `{text}` is indexed by a non-constant expression");
        cx.report_expr(id, message)
            .note(
                "some Adreno drivers return the wrong component, and Direct3D compilers reject writes to \
                one in a loop",
            )
            .help("select `.x`, `.y` or `.z` with conditions");
        return;
    }
    let variable = program
        .variable_of(object)
        .and_then(|v| program.variable(v));
    let is_own = variable.is_some_and(|v| v.storage == Storage::Local && !v.is_const);
    if ty.is_array() && is_own {
        let message = format!("local array `{text}` is indexed by a non-constant expression");
        cx.report_expr(id, message)
            .note(
                "Safari 15 has read wrong elements of such arrays; other compilers may place the array in \
                slow memory",
            )
            .help(
                "select with conditions, or store the values in a vector, a `const` array or a \
                texture",
            );
    }
}
