//! Messages for features that the version of the shader does not have.

use super::*;

impl ExplainContext<'_> {
    /// An operator or method that requires a later version.
    pub(crate) fn explain_later(&self, id: ExprId) -> Diagnostic {
        let what = match self.tree.expr(id).kind {
            ExprKind::Unary(op, _) => format!("operator `{}`", op.symbol()),
            ExprKind::Binary(op, ..) => format!("operator `{}`", op.symbol()),
            ExprKind::Assign(Some(op), ..) => format!("operator `{}=`", op.symbol()),
            _ => "`.length()`".to_string(),
        };
        let message = format!("{what} requires {}", Version::NEWEST.profile().name);
        self.explain_lack(id, message)
    }

    /// A literal of a type that requires a later version.
    pub(crate) fn explain_unsigned(&self, id: ExprId) -> Diagnostic {
        let language = self.version.profile().name;
        self.explain_lack(id, format!("{language} has no unsigned integers"))
    }

    fn explain_lack(&self, id: ExprId, message: String) -> Diagnostic {
        let directive = Version::NEWEST.profile().directive.trim_end();
        self.error_expr(error::NEEDS_WEBGL2, id, message)
            .help(format!("add `{directive}` as the first line"))
    }

    /// The `f` suffix of a literal that ends at `end`, in a version without suffixes.
    pub(crate) fn explain_suffix(&self, id: ExprId, end: u32) -> Diagnostic {
        let edit = Edit::delete(Span::new(end - 1, end));
        let message = format!("{} has no `f` suffix", self.version.profile().name);
        self.error_expr(error::NEEDS_WEBGL2, id, message)
            .fix(Fix::safe("remove the suffix", vec![edit]))
    }
}
