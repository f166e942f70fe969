//! Variables and functions that hide a built-in function.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::Storage;
use crate::semantic::builtins::Builtins;
use crate::syntax::ast::{Extent, TokenId};

pub static RULE: Rule = Rule {
    name: "shadows-builtin",
    group: Group::Portability,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("shadows_builtin.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let program = cx.program;
    let mut found: Vec<(TokenId, Hidden)> = Vec::new();
    for variable in &program.variables {
        let hidden = match variable.storage {
            Storage::Local | Storage::Param(_) => Hidden::InScope,
            _ => Hidden::Everywhere,
        };
        found.extend(variable.token.map(|t| (t, hidden)));
    }
    for function in &program.functions {
        let decl = program.tree.function(function.declaration);
        found.extend(decl.map(|d| (d.ident.token, Hidden::Everywhere)));
    }
    found.sort_unstable_by_key(|(t, _)| *t);
    let builtins = Builtins::of(program.version, program.stage);
    for (token, hidden) in found {
        let Some(name) = cx.user_name(token) else {
            continue;
        };
        if builtins.function(name).is_none() {
            continue;
        }
        let finding = cx.report(
            Extent::token(token),
            format!("`{name}` hides the built-in function `{name}`"),
        );
        let finding = match hidden {
            Hidden::InScope => {
                finding.note("the function cannot be called where this name is seen")
            }
            Hidden::Everywhere => finding.note(
                "WebGL allows it, other compilers of GLSL ES take both for one name and refuse it",
            ),
        };
        finding.help("take another name");
    }
}

/// Where a built-in function is hidden.
#[derive(Clone, Copy)]
enum Hidden {
    InScope,
    Everywhere,
}
