//! Parameters that the function never uses.

use shaderlint_lint::prelude::*;
use shaderlint_semantic::starts_a_shader;

rule! { unused_parameter, Tidy, Info, Strict, Function(check) }

fn check(cx: &mut Context, function: FunctionRef) {
    let program = cx.program;
    let Some(function) = program.function(function) else {
        return;
    };
    let name = program.names.text(function.name);
    let definition = function.definition.and_then(|d| program.tree.function(d));
    let Some(definition) = definition.filter(|_| !starts_a_shader(name)) else {
        return;
    };
    let from = definition.params.start as usize;
    for at in from..from + definition.params.len as usize {
        let Some(id) = program.declared_params.get(at).copied().flatten() else {
            continue;
        };
        let Some(param) = program.variable(id) else {
            continue;
        };
        let writes = cx.facts.writes();
        // The caller reads what is assigned to an `out` parameter.
        let is_used = writes.is_read(id)
            || matches!(param.storage, Storage::Param(d) if d == Direction::Out)
            || (matches!(param.storage, Storage::Param(d) if d.writes())
                && !writes.idle(id).is_empty());
        let own = program.names.text(param.name);
        let Some(token) = param.token else { continue };
        let is_direct = program.is_direct(Extent::token(token));
        if is_used || own.starts_with('_') || !is_direct || cx.facts.inactive_words().has(own) {
            continue;
        }
        cx.report(
            Extent::token(token),
            format!("parameter `{own}` of `{name}` is never used"),
        )
        .help(format!(
            "remove it, or rename it to `_{own}` if the signature must stay"
        ));
    }
}
