//! Messages for values that must be constant expressions.

use crate::messages::*;

impl ExplainContext<'_> {
    /// An initializer of a constant or a global variable that is not a constant expression.
    pub(crate) fn explain_initial_value(
        &self,
        declarator: &Declarator,
        init: ExprId,
        storage: StorageRequest,
    ) -> Diagnostic {
        let name = self.text(declarator.ident.name);
        if storage == StorageRequest::Const {
            let message = format!("initializer of constant `{name}` is not a constant expression");
            let d = self.error_expr(error::NOT_CONSTANT, init, message);
            let fix = match self.at_global_scope() {
                true => None,
                false => self.remove_const(Some(declarator.ident.token)),
            };
            return self.explain_not_constant(d, init).fix(fix);
        }
        let message = format!("initializer of global `{name}` is not a constant expression");
        let d = self
            .error_expr(error::NOT_CONSTANT, init, message)
            .note("GLSL ES 3.00 requires constant initializers at global scope (section 4.3)")
            .help(
                "remove the initializer and assign it at the start of `main`, or use a `#define`",
            );
        self.explain_not_constant(d, init)
    }

    /// A texture offset that is not a constant expression.
    pub(crate) fn explain_dynamic_offset(&self, arg: ExprId) -> Diagnostic {
        let message = "texture offset must be a constant expression";
        let d = self
            .error_expr(error::NOT_CONSTANT, arg, message)
            .help("add the offset to the coordinates instead");
        self.explain_not_constant(d, arg)
    }

    /// A texture offset outside of -8 to 7.
    pub(crate) fn explain_offset(&self, arg: ExprId, offset: i32) -> Diagnostic {
        let message = format!("texture offset {offset} is out of range");
        self.error_expr(error::INDEX_OUT_OF_RANGE, arg, message)
            .note("a texture offset must be between -8 and 7 texels (section 8.8)")
    }

    /// Labels the part of an expression that is not constant.
    pub(crate) fn explain_not_constant(&self, d: Diagnostic, id: ExprId) -> Diagnostic {
        let culprit = self
            .subtree(id)
            .filter(|(_, info, _)| !info.is_const)
            .filter_map(|(at, info, e)| match info.resolution {
                Resolution::Variable(v) if matches!(e.kind, ExprKind::Name(_)) => {
                    Some((at, Some(v)))
                }
                Resolution::Function(_) => Some((at, None)),
                _ => None,
            })
            .last();
        let Some((culprit, variable)) = culprit else {
            return d;
        };
        let span = self.expr_span(culprit);
        let what = match variable.and_then(|v| self.variables.get(v.0 as usize)) {
            Some(v) => {
                let name = self.text(v.name);
                match v.storage {
                    Storage::Uniform => format!("`{name}` is a uniform"),
                    Storage::Input => format!("`{name}` is a shader input"),
                    Storage::Param(_) => format!("`{name}` is a parameter"),
                    _ => format!("`{name}` is not `const`"),
                }
            }
            None => "call of a user-defined function".to_string(),
        };
        if span == d.span {
            d.mark(what)
        } else {
            d.label(span, what)
        }
    }
}
