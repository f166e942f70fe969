//! Variables that shadow a variable of an outer scope.

use shaderlint_lint::Named;
use shaderlint_lint::prelude::*;
use shaderlint_semantic::Variable;

rule! { shadowed_name, Tidy, Info, Strict, Name(check) }

fn check(cx: &mut Context, declared: &DeclaredName) {
    let program = cx.program;
    let Named::Variable(id) = declared.what else {
        return;
    };
    let variable = program.variable(id);
    let hidden = variable.and_then(|v| program.variable(v.hides?));
    let (Some(variable), Some(hidden)) = (variable, hidden) else {
        return;
    };
    let name = declared.text;
    if !is_confusing(variable, hidden) || name.starts_with('_') {
        return;
    }
    let what = match hidden.storage {
        Storage::Param(_) => "parameter",
        Storage::Uniform => "uniform",
        Storage::Input => "input",
        Storage::Output => "output",
        Storage::Global => "global variable",
        Storage::Local => "outer variable",
    };
    let outside = program.declared_at(hidden);
    let outside = outside.filter(|span| program.is_user(*span));
    // Authors cannot know the names that a host declares, except its uniforms.
    if outside.is_none() && hidden.storage != Storage::Uniform {
        return;
    }
    let finding = cx.report(
        Extent::token(declared.token),
        format!("`{name}` shadows the {what} of the same name"),
    );
    let finding = match outside {
        Some(span) => finding.label(span, "shadowed declaration"),
        None => finding.note(format!("ShaderToy declares `{name}`")),
    };
    finding.help("rename one of them");
}

/// Whether a reader may confuse the two. A parameter with the name of a global is not confusing:
/// the function does not use that global.
fn is_confusing(inner: &Variable, hidden: &Variable) -> bool {
    let is_param = |v: &Variable| matches!(v.storage, Storage::Param(_));
    let is_near = is_param(hidden) || hidden.storage == Storage::Local;
    is_near || !is_param(inner)
}
