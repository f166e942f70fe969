//! Samplers of data that default to `lowp`.

use shaderlint_lint::prelude::*;
use shaderlint_semantic::{Base, Sampler};

rule! { precision_missing_for_sampler, Portability, Info, Recommended, Declaration(check) }

fn check(cx: &mut Context, declared: &DeclaredVariable) {
    use QualifierKind::{Highp, Lowp, Mediump};
    let program = cx.program;
    let tree = &program.tree;
    let variable = program.variable(declared.variable);
    let Some(variable) = variable.filter(|v| v.storage == Storage::Uniform) else {
        return;
    };
    let Base::Sampler(sampler @ (Sampler::Sampler2D | Sampler::SamplerCube)) = variable.ty.base
    else {
        return;
    };
    let mut qualifiers = tree.qualifiers(declared.qualifiers).iter();
    let is_set = qualifiers.any(|q| matches!(q.kind, Lowp | Mediump | Highp));
    let Some(declarator) = declared.declarator() else {
        return;
    };
    if is_set || has_default(tree, declared.ty) || !is_fetched(cx, declared.variable) {
        return;
    }
    let name = sampler.name();
    cx.report(
        Extent::token(declarator.ident.token),
        format!("`{name}` without a precision qualifier defaults to `lowp`"),
    )
    .note("its texels are read as data with `texelFetch`; a true `lowp` keeps only 8 bits of them")
    .help(format!(
        "use `uniform highp {name}`, or add `precision highp {name};`"
    ));
}

/// Whether a sampler is read with `texelFetch`, and so holds data rather than an image.
fn is_fetched(cx: &Context, sampler: VariableId) -> bool {
    let program = cx.program;
    cx.facts.mentions().all(sampler).iter().any(|&mention| {
        let call = cx.facts.structure().parent(mention);
        call.is_some_and(|call| program.builtin_called(call) == Some(BuiltinId::TexelFetch))
    })
}

/// Whether the shader declares a default precision for a type.
fn has_default(tree: &Tree, expected: TypeId) -> bool {
    let base = tree.ty(expected).base;
    tree.decls.iter().any(|d| match d.kind {
        DeclKind::Precision { ty, .. } => tree.ty(ty).base == base,
        _ => false,
    })
}
