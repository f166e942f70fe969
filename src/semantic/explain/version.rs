//! What the version of the language has not.

use super::*;

impl ExplainContext<'_> {
    /// An operator or method that comes with a later version.
    pub(crate) fn explain_later(&self, id: ExprId) -> Diagnostic {
        let what = match self.tree.expr(id).kind {
            ExprKind::Unary(op, _) => format!("the operator `{}`", op.symbol()),
            ExprKind::Binary(op, ..) => format!("the operator `{}`", op.symbol()),
            ExprKind::Assign(Some(op), ..) => format!("the operator `{}=`", op.symbol()),
            _ => "`.length()`".to_string(),
        };
        let message = format!("{what} comes with {}", Version::NEWEST.profile().name);
        self.explain_lack(id, message)
    }

    /// A number of a type that a later version has.
    pub(crate) fn explain_unsigned(&self, id: ExprId) -> Diagnostic {
        let language = self.version.profile().name;
        self.explain_lack(id, format!("{language} has no unsigned integers"))
    }

    fn explain_lack(&self, id: ExprId, message: String) -> Diagnostic {
        let directive = Version::NEWEST.profile().directive.trim_end();
        self.error_expr(error::NEEDS_WEBGL2, id, message)
            .help(format!("start the shader with `{directive}`"))
    }

    /// The suffix of a number, at the end of its token, where the version has none.
    pub(crate) fn explain_suffix(&self, id: ExprId, end: u32) -> Diagnostic {
        let edit = Edit::delete(Span::new(end - 1, end));
        let message = format!("{} has no suffix `f`", self.version.profile().name);
        self.error_expr(error::NEEDS_WEBGL2, id, message)
            .fix(Fix::safe("take the suffix away", vec![edit]))
    }
}
