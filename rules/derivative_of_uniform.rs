//! Derivatives of values that are the same for all pixels.

use shaderlint_lint::prelude::*;

rule! { derivative_of_uniform, Numeric, Warning, Recommended, Builtin(check) }

fn check(cx: &mut Context, call: &Builtin) {
    let (BuiltinId::DFdx | BuiltinId::DFdy | BuiltinId::Fwidth, &[of]) = (call.function, call.args)
    else {
        return;
    };
    // Without an entry point or a caller, nothing is known to differ.
    let (Some(entry), Stage::Fragment) = (cx.facts.entry(), cx.program.stage) else {
        return;
    };
    let function = cx.facts.structure().function_of_expr(call.id);
    let reached = cx.facts.calls().graph.reached_from(entry);
    if function.is_none_or(|f| reached.get(f.0 as usize) != Some(&true)) {
        return;
    }
    let op = cx.facts.module().op_of(of);
    let is_known = !cx.program.values(of).is_empty();
    let varies = |op| cx.facts.uniformity().varies(Varying::Value(op));
    if !is_known && op.is_none_or(varies) {
        return;
    }
    let (name, text) = (call.function.name(), cx.program.expr_text(of));
    let message = format!("`{name}` is always zero: `{text}` is the same for all pixels");
    cx.report_expr(call.id, message);
}
