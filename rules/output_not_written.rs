//! Outputs that a function does not write.

use shaderlint_flow::PartMask;
use shaderlint_lint::prelude::*;

rule! { output_not_written, Numeric, Warning, Recommended, Function(check) }

/// All components of a colour, a bit each.
const ALL_CHANNELS: PartMask = 0b1111;
/// The bit of the alpha component.
const ALPHA: PartMask = 1 << 3;

fn check(cx: &mut Context, function: FunctionRef) {
    let program = cx.program;
    let Some(found) = cx.facts.definite_assignment().get(function) else {
        return;
    };
    let is_entry = cx.facts.entry() == Some(function);
    // ShaderToy's player ignores the alpha of the image.
    let is_image = program.dialect.host().hides_alpha && is_entry;
    let pass = Dialect::ShaderToy(Pass::Buffer);
    let is_buffer = is_entry
        && (program.dialect == pass || program.dialect == Dialect::ShaderToy(Pass::Cubemap));
    // A return value often tells the caller whether the outputs are valid.
    let returns_status = program
        .function(function)
        .is_some_and(|f| !f.returns.is_void());
    for unset in found.outputs.iter().filter(|u| u.always || !returns_status) {
        let ignored = if is_image { ALPHA } else { 0 };
        let missing = unset.missing & !ignored;
        // Only the other passes know which pixels and components of a buffer are used.
        if is_buffer && !(unset.always && missing == ALL_CHANNELS) {
            continue;
        }
        if !is_entry && !is_taken(cx, function, unset.variable, missing) {
            continue;
        }
        let Some(variable) = program.variable(unset.variable).filter(|_| missing != 0) else {
            continue;
        };
        let what = cx.name_of_parts(unset.variable, missing);
        let message = match unset.always {
            true => format!("output `{what}` is never written"),
            false => format!("output `{what}` is not written on every path"),
        };
        let declared = program.declared_at(variable);
        let is_own = declared.is_some_and(|span| program.is_user(span));
        // Whether it is the output of a host is only known if it is used.
        if declared.is_some() && !is_own && unset.always && missing == ALL_CHANNELS {
            continue;
        }
        let declared = declared.filter(|_| is_own);
        let left = program.span(unset.at);
        let finding = cx.report_span(declared.unwrap_or(left), message);
        let finding = match declared {
            Some(_) if !unset.always => finding.label(left, "exits without writing it"),
            _ => finding,
        };
        finding.note(
            "the value is undefined: browsers set it to zero, other programs keep the previous \
            contents",
        );
    }
}

/// Whether a caller reads what a function does not write; true for a function without callers.
fn is_taken(cx: &Context, function: FunctionRef, output: VariableId, missing: PartMask) -> bool {
    let (module, live) = (cx.facts.module(), cx.facts.liveness());
    let parameters = module.function(function).map(|f| module.parameters(f));
    let position = parameters.and_then(|p| p.iter().position(|p| *p == output));
    let Some(position) = position else {
        return true;
    };
    let ty = module.variable(output).map(|v| v.ty);
    let is_vector = ty.is_some_and(|ty| ty.is_vector());
    let lanes = ty.map_or(0, |ty| cx.facts.reaching_definitions().layout.lanes(ty));
    let is_missing = |lane: &u32| !is_vector || missing & 1 << lane != 0;
    let mut calls = cx.facts.calls().calls_of(function).peekable();
    calls.peek().is_none()
        || calls.any(|call| {
            let mut lanes = (0..lanes).filter(is_missing);
            lanes.any(|lane| live.is_taken(module, call.op, position, lane))
        })
}
