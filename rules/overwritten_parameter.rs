//! Parameters that the function overwrites before it reads them.

use shaderlint_lint::prelude::*;

rule! { overwritten_parameter, Tidy, Info, Recommended, Function(check) }

fn check(cx: &mut Context, id: FunctionRef) {
    let program = cx.program;
    let function = program.function(id);
    let definition = function.and_then(|f| program.tree.function(f.definition?));
    let (Some(function), Some(definition)) = (function, definition) else {
        return;
    };
    let from = definition.params.start as usize;
    for at in from..from + definition.params.len as usize {
        let found = program.declared_params.get(at).copied().flatten();
        let Some((variable, param)) = found.and_then(|v| Some((v, program.variable(v)?))) else {
            continue;
        };
        // `inout` may be a habit where `out` would do, so only `in` parameters count.
        let takes = param.storage == Storage::Param(Direction::In);
        let is_read = param.written && cx.facts.writes().is_read(variable);
        let (Some(token), true, true) = (param.token, takes, is_read) else {
            continue;
        };
        let (facts, ty) = (cx.facts, param.ty);
        let name = program.names.text(param.name);
        let is_plain = ty.is_scalar() || ty.is_vector();
        let lanes = facts.reaching_definitions().layout.lanes(ty);
        if !is_plain
            || !program.is_direct(Extent::token(token))
            || facts.inactive_words().has(name)
            || !facts
                .liveness()
                .is_unseen(facts.reaching_definitions(), variable, lanes)
        {
            continue;
        }
        let own = program.names.text(function.name);
        let write = facts.writes().to(variable).first();
        let write = write.map(|write| program.expr_span(*write));
        let message = format!("`{own}` overwrites parameter `{name}` before reading it");
        let finding = cx.report(Extent::token(token), message);
        if let Some(write) = write {
            finding.label(write, "overwritten here");
        }
    }
}
