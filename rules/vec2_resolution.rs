//! `uniform vec2 iResolution`.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::{Scalar, Storage, Type};
use crate::syntax::ast::{DeclKind, Extent, Item};

pub static RULE: Rule = Rule {
    name: "vec2-resolution",
    group: Group::Webgl2,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("vec2_resolution.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let program = cx.program;
    if program.dialect.is_shadertoy() {
        return;
    }
    for item in &program.tree.items {
        let Item::Decl(decl) = *item else { continue };
        let Some(decl) = program.tree.decl(decl) else {
            continue;
        };
        let DeclKind::Variables { declarators, .. } = decl.kind else {
            continue;
        };
        for (i, declarator) in program.tree.declarators(declarators).iter().enumerate() {
            let id = program.declared.get(declarators.start as usize + i);
            let variable = id.copied().flatten().and_then(|v| program.variable(v));
            let is_it = variable.is_some_and(|v| {
                v.storage == Storage::Uniform
                    && v.ty == Type::vector(Scalar::Float, 2)
                    && program.names.text(v.name) == "iResolution"
            });
            if !is_it {
                continue;
            }
            cx.report(
                Extent::token(declarator.ident.token),
                "`iResolution` is a `vec2` here, and a `vec3` in ShaderToy",
            )
            .note("code from there that reads its `z` or hands it on does not compile")
            .note("its page sets it with `uniform2f`; what `uniform3f` sets does not arrive")
            .help("for code from ShaderToy declare a `vec3`, and set it with `uniform3f(location, width, height, 1)`");
        }
    }
}
