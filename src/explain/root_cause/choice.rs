//! `v < w ? a : b` of vectors: each component is chosen.

use super::candidate::RepairCandidate;
use super::{FaultyShader, MAX_LOOKED_AT};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_semantic::{Scalar, Type};
use shaderlint_syntax::ast::ExprKind;
use shaderlint_text::Edit;

impl FaultyShader<'_> {
    /// Choices whose condition compares vectors.
    pub(super) fn choices(&self) -> Vec<RepairCandidate> {
        let errors = self.errors.iter().take(MAX_LOOKED_AT);
        let compared = errors.filter(|d| d.is(error::TYPE_MISMATCH) && d.fix.is_some());
        compared.filter_map(|d| self.choice(d)).collect()
    }

    fn choice(&self, d: &Diagnostic) -> Option<RepairCandidate> {
        let (program, tree) = (self.program, &self.program.tree);
        let (whole, then, other) = tree.exprs.iter().find_map(|e| match e.kind {
            ExprKind::Ternary(condition, then, other) => {
                let is_it = program.expr_span(tree.unparen(condition)) == d.span;
                is_it.then_some((e, then, other))
            }
            _ => None,
        })?;
        let ty = program.ty(then);
        let is_vector = ty.is_vector() && ty.scalar_kind() == Some(Scalar::Float);
        if !is_vector || ty != program.ty(other) || !program.is_direct(whole.extent) {
            return None;
        }
        // The fix of the comparison alone is `all(lessThan(v, w))`.
        let all = &d.fix.as_ref()?.edits.first()?.text;
        let compared = all.strip_prefix("all(")?.strip_suffix(')')?;
        let [then, other] = [then, other].map(|e| program.expr_text(tree.unparen(e)));
        let name = program.type_name(Type::vector(Scalar::Float, ty.components() as u8));
        let text = format!("mix({other}, {then}, {name}({compared}))");
        let edits = vec![Edit::replace(program.span(whole.extent), text)];
        let fix = Fix::suggestion("choose each component with `mix`", edits);
        Some(RepairCandidate::of_error(d, fix))
    }
}
