//! Cell indices by truncation, combined with `fract` of the same value.

use shaderlint_flow::is_same;
use shaderlint_lint::prelude::*;

rule! { truncated_cell, Numeric, Warning, Recommended, Expr(&[Shape::Construct], check) }

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Construct(_, args) = program.tree.expr(id).kind else {
        return;
    };
    let &[arg] = program.tree.args(args) else {
        return;
    };
    let is_cut = program.ty(id).scalar_kind() == Some(Scalar::Int)
        && program.ty(arg).scalar_kind() == Some(Scalar::Float);
    if !is_cut || !cx.facts.range(arg).any(|r| r.reaches_below(0.0)) {
        return;
    }
    let Some(beside) = cx
        .facts
        .module()
        .op_of(arg)
        .and_then(|op| fraction_of(cx, id, op))
    else {
        return;
    };
    let Some(extent) = cx.facts.module().provenance(beside).extent(&program.tree) else {
        return;
    };
    let at = program.span(extent);
    let (text, name) = (program.expr_text(arg), program.type_name(program.ty(id)));
    let fix = cx.is_direct(arg).then(|| {
        let span = program.expr_span(arg);
        let edits = vec![
            Edit::insert(span.start, "floor("),
            Edit::insert(span.end, ")"),
        ];
        Fix::suggestion(format!("use `floor({text})`"), edits)
    });
    cx.report_expr(
        id,
        format!("`{name}` rounds towards zero, but `fract` rounds down"),
    )
    .label(at, "position inside the cell")
    .note("for negative values cell and position do not match, and cell 0 is twice as wide")
    .fix(fix);
}

/// The `fract` of the same value, in the same function.
fn fraction_of(cx: &Context, id: ExprId, op: OpId) -> Option<OpId> {
    let (module, defs) = (cx.facts.module(), cx.facts.reaching_definitions());
    let function = cx.facts.structure().function_of_expr(id)?;
    module.function(function)?.ops.ops().find(|other| {
        let OpKind::Builtin(BuiltinId::Fract, operands) = module.op(*other).kind else {
            return false;
        };
        matches!(module.operands(operands), [of] if is_same(module, defs, *of, op))
    })
}
