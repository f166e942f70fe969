//! Functions that may end without returning a value.

use shaderlint_lint::prelude::*;

rule! { missing_return_path, Numeric, Warning, Recommended, Function(check) }

fn check(cx: &mut Context, id: FunctionRef) {
    let program = cx.program;
    let reaches_end = cx
        .facts
        .definite_assignment()
        .get(id)
        .is_some_and(|f| f.reaches_end);
    let Some(function) = program
        .function(id)
        .filter(|f| reaches_end && !f.returns.is_void())
    else {
        return;
    };
    let decl = function.definition.and_then(|d| program.tree.function(d));
    let Some(decl) = decl else { return };
    let (name, ty) = (
        program.names.text(function.name),
        program.type_name(function.returns),
    );
    let end = program.token(decl.extent.last).map(|t| t.span);
    let header = program.span(decl.header);
    let finding = cx
        .report_span(header, format!("not all paths of `{name}` return a value"))
        .note(format!(
            "without a `return`, the `{ty}` result is undefined (section 6.1)"
        ));
    if let Some(end) = end {
        finding.label(end, "reached without `return`");
    }
}
