//! Variables that take the name of one outside.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::{Storage, Variable};
use crate::syntax::ast::Extent;

pub static RULE: Rule = Rule {
    name: "shadowed-name",
    group: Group::Tidy,
    severity: Severity::Warning,
    default: true,
    options: &[],
    page: include_str!("shadowed_name.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let program = cx.program;
    for variable in &program.variables {
        let Some(token) = variable.token else {
            continue;
        };
        let hidden = variable.hides.and_then(|h| program.variable(h));
        let Some(hidden) = hidden.filter(|h| is_confusing(variable, h)) else {
            continue;
        };
        let is_direct = program.token(token).is_some_and(|t| t.is_direct());
        let name = program.names.text(variable.name);
        if !is_direct || name.starts_with('_') {
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
        let is_user = |s| {
            program
                .sources
                .file_at(s)
                .is_some_and(|f| f.role == crate::text::Role::User)
        };
        let finding = cx.report(
            Extent::token(token),
            format!("`{name}` hides the {what} of the same name outside"),
        );
        let finding = match outside.filter(|s| is_user(s.start)) {
            Some(span) => finding.label(span, "from here on it is out of sight"),
            None => finding,
        };
        finding.help("give one of them another name");
    }
}

/// Whether a reader may take one for the other.
fn is_confusing(_inner: &Variable, _hidden: &Variable) -> bool {
    true
}
