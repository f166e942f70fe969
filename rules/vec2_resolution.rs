//! `uniform vec2 iResolution`.

use shaderlint_lint::prelude::*;

rule! { vec2_resolution, Webgl2, Info, Recommended, Declaration(check) }

fn check(cx: &mut Context, declared: &DeclaredVariable) {
    let program = cx.program;
    let is_it = program.variable(declared.variable).is_some_and(|v| {
        v.storage == Storage::Uniform
            && v.ty == Type::vector(Scalar::Float, 2)
            && program.names.text(v.name) == "iResolution"
    });
    if !is_it || program.dialect.is_shadertoy() {
        return;
    }
    // A shader with a `main` of its own may declare any type.
    let mut functions = program.functions.iter();
    let is_toy = functions.any(|f| program.names.text(f.name) == "mainImage");
    let Some(declarator) = declared.declarator().filter(|_| is_toy) else {
        return;
    };
    cx.report(
        Extent::token(declarator.ident.token),
        "`iResolution` is declared as `vec2`, but ShaderToy uses `vec3`",
    )
    .note("ShaderToy code that reads `iResolution.z` or passes it as a `vec3` does not compile")
    .note("a `vec2` is set with `uniform2f`; `uniform3f` has no effect on it")
    .help("for ShaderToy code, declare a `vec3` and set it with `uniform3f(location, width, height, 1)`");
}
