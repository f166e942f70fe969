//! Samplers of data that are read in the lowest precision.

use crate::diagnostic::Severity;
use crate::lint::{Check, Context, Group, Rule};
use crate::semantic::{Base, BuiltinId, Sampler, Storage};
use crate::syntax::ast::*;
use rustc_hash::FxHashSet;

pub static RULE: Rule = Rule {
    name: "precision-missing-for-sampler",
    group: Group::Portability,
    severity: Severity::Info,
    default: true,
    options: &[],
    page: include_str!("precision_missing_for_sampler.md"),
    check: Check::Program(check),
};

fn check(cx: &mut Context) {
    let program = cx.program;
    let tree = &program.tree;
    // What is fetched texel by texel is data, not a picture.
    let mut fetched = FxHashSet::default();
    for (i, expr) in tree.exprs.iter().enumerate() {
        let ExprKind::Call(_, args) = expr.kind else {
            continue;
        };
        if program.builtin_called(ExprId(i as u32)) == Some(BuiltinId::TexelFetch) {
            let sampler = tree
                .args(args)
                .first()
                .and_then(|s| program.variable_of(*s));
            fetched.extend(sampler);
        }
    }
    for item in &tree.items {
        let Item::Decl(id) = item else { continue };
        let Some(DeclKind::Variables {
            qualifiers,
            declarators,
            ty,
        }) = tree.decl(*id).map(|d| d.kind)
        else {
            continue;
        };
        let is_set = |q: &Qualifier| {
            use QualifierKind::*;
            matches!(q.kind, Lowp | Mediump | Highp)
        };
        if tree.qualifiers(qualifiers).iter().any(is_set) {
            continue;
        }
        let from = declarators.start as usize;
        let declared = program.declared.get(from..).unwrap_or(&[]);
        for (declarator, variable) in tree.declarators(declarators).iter().zip(declared) {
            let Some(found) = variable.filter(|v| fetched.contains(v)) else {
                continue;
            };
            let Some(variable) = program.variable(found) else {
                continue;
            };
            let Base::Sampler(sampler @ (Sampler::Sampler2D | Sampler::SamplerCube)) =
                variable.ty.base
            else {
                continue;
            };
            let token = declarator.ident.token;
            let is_users = program.token(token).is_some_and(|t| cx.is_users(t.span));
            if variable.storage == Storage::Uniform && is_users && !has_default(tree, ty) {
                let name = sampler.name();
                cx.report(Extent::token(token), format!("`{name}` is `lowp` unless it says otherwise"))
                    .note("texels are fetched from it one by one, as data; `lowp` keeps 8 bits of them where it is taken at its word")
                    .help(format!("write `uniform highp {name}`, or `precision highp {name};` once"));
            }
        }
    }
}

/// Whether the shader gives a default precision for a type.
fn has_default(tree: &Tree, wanted: TypeId) -> bool {
    let base = tree.ty(wanted).base;
    tree.decls.iter().any(|d| match d.kind {
        DeclKind::Precision { ty, .. } => tree.ty(ty).base == base,
        _ => false,
    })
}
