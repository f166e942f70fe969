//! One variable passed to two output parameters, or passed and used as a global.

use shaderlint_lint::prelude::*;
use shaderlint_semantic::swizzled;

rule! { inout_alias, Numeric, Warning, Recommended, Expr(&[Shape::Call], check) }

fn check(cx: &mut Context, id: ExprId) {
    let program = cx.program;
    let ExprKind::Call(_, args) = program.tree.expr(id).kind else {
        return;
    };
    let Resolution::Function(callee) = program.expr(id).resolution else {
        return;
    };
    let Some(function) = program.function(callee) else {
        return;
    };
    let args = program.tree.args(args).iter().zip(&function.params);
    let written: Vec<(ExprId, Direction)> = args
        .filter(|(_, p)| p.direction.writes())
        .map(|(&a, p)| (a, p.direction))
        .collect();
    let name = program.names.text(function.name);
    for (i, &(arg, _)) in written.iter().enumerate() {
        let Some(part) = part(cx, arg) else { continue };
        let before = written.iter().take(i);
        let twin = before
            .filter_map(|(e, _)| self::part(cx, *e))
            .find(|p| overlap(*p, part));
        let text = program.expr_text(arg).to_string();
        if twin.is_some() {
            if !is_read(cx, id, arg) {
                return;
            }
            cx.report_expr(
                arg,
                format!("`{text}` is passed to two output parameters of `{name}`"),
            )
            .note(
                "outputs are copied back in an undefined order (section 6.1.1), so either value \
                may remain",
            );
            return;
        }
        if is_global(cx, part.0) && names_it(cx, callee, part.0) {
            cx.report_expr(
                arg,
                format!("`{text}` is passed to `{name}`, which also uses it as a global"),
            )
            .note(
                "the parameter is a copy: writes to one are not visible in the other until the function \
                returns",
            );
            return;
        }
    }
}

/// The variable that an argument names and a mask of its components; `None` if the argument is an
/// array element or a struct member, which may not be known statically.
fn part(cx: &Context, arg: ExprId) -> Option<(VariableId, u8)> {
    let program = cx.program;
    let arg = program.tree.unparen(arg);
    match program.tree.expr(arg).kind {
        ExprKind::Name(_) => Some((program.variable_of(arg)?, 0xff)),
        ExprKind::Member(object, name) => {
            let mask = swizzled(program, object, name)?;
            Some((program.variable_of(object)?, mask))
        }
        _ => None,
    }
}

fn overlap(a: (VariableId, u8), b: (VariableId, u8)) -> bool {
    a.0 == b.0 && a.1 & b.1 != 0
}

fn is_global(cx: &Context, id: VariableId) -> bool {
    let variable = cx.program.variable(id);
    variable.is_some_and(|v| v.storage == Storage::Global)
}

/// Whether the value that a call writes to an argument is read; a variable may only collect outputs
/// that are not needed.
fn is_read(cx: &Context, id: ExprId, arg: ExprId) -> bool {
    let (module, defs, live) = (
        cx.facts.module(),
        cx.facts.reaching_definitions(),
        cx.facts.liveness(),
    );
    let ExprKind::Call(_, args) = cx.program.tree.expr(id).kind else {
        return true;
    };
    let position = cx.program.tree.args(args).iter().position(|a| *a == arg);
    module
        .op_of(id)
        .zip(position)
        .is_none_or(|(call, position)| {
            let mut lanes = 0..defs.layout.lanes(cx.program.ty(arg));
            lanes.any(|lane| live.is_taken(module, call, position, lane))
        })
}

/// Whether the body of a function names a variable.
fn names_it(cx: &Context, function: FunctionRef, id: VariableId) -> bool {
    let program = cx.program;
    let function = program.function(function).and_then(|f| f.definition);
    let Some(extent) = function
        .and_then(|d| program.tree.function(d))
        .map(|d| d.extent)
    else {
        return false;
    };
    cx.facts.mentions().is_in(program, id, extent)
}
