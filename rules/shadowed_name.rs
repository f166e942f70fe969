//! Variables that take the name of one outside.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::{Storage, Variable};
use crate::syntax::ast::Extent;
use crate::text::Role;

pub static RULE: Rule = Rule {
    name: "shadowed-name",
    group: Group::Tidy,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("shadowed_name.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let program = cx.program;
    for variable in &program.variables {
        let hidden = variable.hides.and_then(|h| program.variable(h));
        let (Some(token), Some(hidden)) = (variable.token, hidden) else {
            continue;
        };
        let is_direct = program.token(token).is_some_and(|t| t.is_direct());
        let name = program.names.text(variable.name);
        if !is_direct || !is_confusing(variable, hidden) || name.starts_with('_') {
            continue;
        }
        let what = match hidden.storage {
            Storage::Param(_) => "parameter",
            Storage::Uniform => "uniform",
            Storage::Input => "input",
            Storage::Output => "output",
            Storage::Global => "global variable",
            Storage::Local => "variable",
        };
        let outside = hidden.token.and_then(|t| program.token(t)).map(|t| t.span);
        let file = outside.and_then(|s| program.sources.file_at(s.start));
        let is_user = file.is_some_and(|f| f.role == Role::User);
        // What a host declares besides its uniforms is not known to who writes for it.
        if !is_user && hidden.storage != Storage::Uniform {
            continue;
        }
        let finding = cx.report(
            Extent::token(token),
            format!("`{name}` hides the {what} of the same name outside"),
        );
        let finding = match outside.filter(|_| is_user) {
            Some(span) => finding.label(span, "this one"),
            None => finding.note("ShaderToy declares it"),
        };
        finding.help("give one of them another name");
    }
}

/// Whether a reader may take one for the other. A function that names a parameter like some global
/// variable has no use for that one.
fn is_confusing(inner: &Variable, hidden: &Variable) -> bool {
    let is_param = |v: &Variable| matches!(v.storage, Storage::Param(_));
    let is_near = is_param(hidden) || hidden.storage == Storage::Local;
    is_near || !is_param(inner)
}
