//! Derivatives of discontinuous values.

use shaderlint_lint::prelude::*;

rule! { derivative_of_jump, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::DFdx | BuiltinId::DFdy | BuiltinId::Fwidth, &[of]) = (call.function, call.args)
    else {
        return;
    };
    let program = cx.program;
    let Some(op) = cx.facts.module().op_of(of) else {
        return;
    };
    let mut lanes = 0..program.ty(of).components();
    let Some(jump) = lanes.find_map(|lane| cx.facts.jump(op, lane)) else {
        return;
    };
    let origin = cx.facts.module().provenance(jump.call);
    let Some(at) = origin.extent(&program.tree).map(|e| program.span(e)) else {
        return;
    };
    let (name, jumps) = (call.function.name(), jump.function.name());
    cx.report_expr(of, format!("`{name}` is applied to a discontinuous value"))
        .label(at, format!("`{jumps}` is discontinuous"))
        .note("at the discontinuity the derivative is very large, which draws a line of pixels")
        .help(match jump.function {
            BuiltinId::Atan => {
                "use the width of the position: `length(fwidth(p)) / length(p)`".to_string()
            }
            _ => format!("take the derivative of the argument of `{jumps}` instead"),
        });
}
