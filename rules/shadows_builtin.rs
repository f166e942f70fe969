//! Variables and functions that shadow a built-in function.

use shaderlint_lint::Named;
use shaderlint_lint::prelude::*;
use shaderlint_semantic::builtins::Builtins;

rule! { shadows_builtin, Portability, Info, Strict, Name(check) }

fn check(cx: &mut Context, declared: &DeclaredName) {
    let program = cx.program;
    let name = declared.text;
    let builtins = Builtins::of(program.version, program.stage);
    if declared.what == Named::Struct || builtins.function(name).is_none() {
        return;
    }
    let is_local = match declared.what {
        Named::Variable(id) => program
            .variable(id)
            .is_some_and(|v| matches!(v.storage, Storage::Local | Storage::Param(_))),
        Named::Function(_) | Named::Struct => false,
    };
    cx.report(
        Extent::token(declared.token),
        format!("`{name}` shadows the built-in function `{name}`"),
    )
    .note(match is_local {
        true => "the function cannot be called while this declaration is in scope",
        false => {
            "WebGL accepts this; other GLSL ES compilers keep both in one scope and reject the shader"
        }
    })
    .help(format!("rename `{name}`"));
}
