//! Messages for [`InterfaceError`].

use crate::messages::*;

impl Explain for InterfaceError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use InterfaceError as E;
        let report = |message: &str| c.error(error::INTERFACE_TYPE, at, message);
        match self {
            E::Type(storage, ty) => report(&format!(
                "`{}` variables cannot have type `{}`",
                storage.name(),
                c.name_of(ty)
            )),
            E::Bool(storage) => report(&format!(
                "`{}` variables cannot have type `bool`",
                storage.name()
            )),
            E::Struct(storage) => {
                report(&format!("`{}` variables cannot be structs", storage.name()))
            }
            E::InputArray => report("a vertex shader input cannot be an array"),
            E::OutputMatrix => report("a fragment shader output cannot be a matrix"),
            E::NotFlat(storage) => {
                let word = if storage.is_input() { "in" } else { "out" };
                let d = report(&format!(
                    "an integer passed between stages must be `flat {word}`"
                ));
                d.note("integers are not interpolated (section 4.3.9)")
                    .fix(c.make_flat(at))
            }
            E::ArrayOfStructs => report("an array of structs cannot be passed between stages"),
            E::ArrayInside => {
                report("a struct containing an array cannot be passed between stages")
            }
            E::StructInside => {
                report("a struct containing a struct cannot be passed between stages")
            }
            E::BoolInside => report("a struct containing a `bool` cannot be passed between stages"),
        }
    }
}

impl ExplainContext<'_> {
    /// Adds `flat` to the declaration that contains these tokens, in place of `smooth`.
    fn make_flat(&self, at: Extent) -> Option<Fix> {
        let holds = |d: &&Declaration| d.extent.first <= at.first && at.last <= d.extent.last;
        let decl = self.tree.decls.iter().find(holds)?;
        let DeclKind::Variables { qualifiers, .. } = decl.kind else {
            return None;
        };
        let qualifiers = self.tree.qualifiers(qualifiers);
        if !self.is_direct(decl.extent) {
            return None;
        }
        let smooth = qualifiers.iter().find(|q| q.kind == QualifierKind::Smooth);
        let storage = qualifiers.iter().find(|q| {
            matches!(
                q.kind,
                QualifierKind::In | QualifierKind::Out | QualifierKind::Centroid
            )
        });
        let edit = match (smooth, storage) {
            (Some(smooth), _) => Edit::replace(self.span(smooth.extent), "flat"),
            (None, Some(storage)) => Edit::insert(self.span(storage.extent).start, "flat "),
            (None, None) => return None,
        };
        Some(Fix::suggestion("add `flat`", vec![edit]))
    }
}
