//! Constructors that convert nothing: `vec3(v)` of a `vec3`, `float(1.0)`.

use shaderlint_lint::prelude::*;

rule! { redundant_constructor, Tidy, Info, Strict, Expr(&[Shape::Construct], check) }

/// Maximum length of code that a message quotes, in bytes.
const LONGEST: usize = 40;

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let tree = &program.tree;
    let expr = tree.expr(id);
    let ExprKind::Construct(_, args) = expr.kind else {
        return;
    };
    let &[arg] = tree.args(args) else {
        return;
    };
    let ty = program.ty(id);
    if ty.is_error() || ty.is_array() || ty != program.ty(arg) || !program.is_direct(expr.extent) {
        return;
    }
    let name = program.type_name(ty);
    let extent = program.span(expr.extent);
    let inner = program.expr_span(arg);
    let edits = if needs_parentheses(cx, id, arg) {
        let open = program.token(tree.expr(arg).extent.first.saturating_sub(1));
        let Some(open) = open else { return };
        vec![Edit::delete(Span::new(extent.start, open.span.start))]
    } else {
        vec![
            Edit::delete(Span::new(extent.start, inner.start)),
            Edit::delete(Span::new(inner.end, extent.end)),
        ]
    };
    let text = program.expr_text(arg);
    let has_comment = |e: &Edit| program.sources.text(e.span).contains('/');
    let fix = (!edits.iter().any(has_comment)).then(|| Fix::safe("remove the constructor", edits));
    let what = match text.len() {
        0..=LONGEST if !text.contains('\n') => format!("`{text}`"),
        _ => "the argument".to_string(),
    };
    cx.report_expr(
        id,
        format!("redundant constructor: {what} already has type `{name}`"),
    )
    .fix(fix);
}

/// Whether the argument needs parentheses to remain one operand.
fn needs_parentheses(cx: &Context, id: ExprId, arg: ExprId) -> bool {
    let tree = &cx.program.tree;
    match tree.expr(arg).kind {
        ExprKind::Unary(..)
        | ExprKind::Binary(..)
        | ExprKind::Assign(..)
        | ExprKind::Ternary(..)
        | ExprKind::Comma(..) => {}
        _ => return false,
    }
    let Some(parent) = cx.facts.structure().parent(id) else {
        return false;
    };
    match tree.expr(parent).kind {
        ExprKind::Paren(_) | ExprKind::Call(..) | ExprKind::Construct(..) => false,
        ExprKind::Assign(_, _, value) => value != id,
        ExprKind::Index(_, index) => index != id,
        _ => true,
    }
}
