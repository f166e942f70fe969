//! What a shader uses that its host does not accept.

use shaderlint_host::{Limit, Preset};
use shaderlint_semantic::{BuiltinId, Program, Scalar, Storage, Variable};
use shaderlint_syntax::ast::{DeclKind, ExprId, ExprKind};
use shaderlint_text::Span;

/// A use of something that a host does not accept.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BeyondLimit {
    /// Where it is used.
    pub span: Span,
    /// What it is, as the title of a finding.
    pub message: String,
    /// What the host does not accept.
    pub limit: Limit,
}

/// Everything in the user's code that a host does not accept, in the order of the code.
pub fn limits(program: &Program, host: &Preset) -> Vec<BeyondLimit> {
    let mut found = Vec::new();
    if host.limits.is_empty() {
        return found;
    }
    let has = |limit| host.limits.contains(&limit);
    for variable in &program.variables {
        let span = program
            .declared_at(variable)
            .filter(|s| program.is_user(*s));
        if let Some((span, (limit, message))) = span.zip(refused(program, variable, &has)) {
            found.push(BeyondLimit {
                span,
                message,
                limit,
            });
        }
    }
    if has(Limit::Blocks) {
        found.extend(blocks(program));
    }
    if has(Limit::Lookups) {
        let is_usual =
            |id, count| matches!(id, BuiltinId::Texture | BuiltinId::Texture2D) && count == 2;
        found.extend(lookups(program, is_usual));
    }
    found.sort_by_key(|beyond| beyond.span.start);
    found.dedup();
    found
}

/// Why a variable is not accepted.
fn refused(
    program: &Program,
    variable: &Variable,
    has: &impl Fn(Limit) -> bool,
) -> Option<(Limit, String)> {
    let name = program.names.text(variable.name);
    let ty = program.type_name(variable.ty);
    let kind = variable.ty.element().scalar_kind();
    let is_uniform = variable.storage == Storage::Uniform;
    let sampler = variable.ty.element().as_sampler();
    if sampler.is_some_and(|s| s.name() != "sampler2D") && has(Limit::Samplers) {
        return Some((Limit::Samplers, format!("`{name}` is of type `{ty}`")));
    }
    if variable.storage == Storage::Input && has(Limit::Varyings) {
        return Some((Limit::Varyings, format!("`{name}` is a varying")));
    }
    if kind == Some(Scalar::Uint) && has(Limit::Unsigned) {
        return Some((Limit::Unsigned, format!("`{name}` is of type `{ty}`")));
    }
    let is_number = kind.is_some_and(|k| k != Scalar::Float);
    if is_uniform && is_number && has(Limit::Numbers) {
        return Some((
            Limit::Numbers,
            format!("uniform `{name}` is of type `{ty}`"),
        ));
    }
    None
}

/// The uniform blocks.
fn blocks(program: &Program) -> Vec<BeyondLimit> {
    let decls = program.tree.decls.iter();
    let blocks = decls.filter_map(|decl| {
        let DeclKind::Block { members, .. } = decl.kind else {
            return None;
        };
        let ident = program.tree.structure(members)?.name?;
        let span = program.token(ident.token)?.span;
        program.is_user(span).then(|| BeyondLimit {
            span,
            message: format!("`{}` is a uniform block", program.names.text(ident.name)),
            limit: Limit::Blocks,
        })
    });
    blocks.collect()
}

/// The calls of texture functions that are not accepted with this number of arguments.
pub(super) fn lookups(
    program: &Program,
    is_accepted: impl Fn(BuiltinId, usize) -> bool,
) -> Vec<BeyondLimit> {
    let mut found = Vec::new();
    for (id, expr) in (0..).map(ExprId).zip(&program.tree.exprs) {
        let ExprKind::Call(_, args) = expr.kind else {
            continue;
        };
        let Some(called) = program.builtin_called(id) else {
            continue;
        };
        let args = program.tree.args(args);
        let has_sampler = args
            .first()
            .is_some_and(|arg| program.ty(*arg).as_sampler().is_some());
        let is_usual = is_accepted(called, args.len());
        let span = program.token(expr.extent.first).map(|t| t.span);
        let span = span.filter(|s| has_sampler && !is_usual && program.is_user(*s));
        if let Some(span) = span {
            let message = match called {
                BuiltinId::Texture => "`texture` has more than two arguments".to_string(),
                other => format!("`{}` is called", other.name()),
            };
            found.push(BeyondLimit {
                span,
                message,
                limit: Limit::Lookups,
            });
        }
    }
    found
}
