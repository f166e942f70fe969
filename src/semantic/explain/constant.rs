//! What should be constant and is not.

use super::*;
use crate::checker::Wanted;

impl ExplainContext<'_> {
    /// The initial value of a constant or a global variable, which is not constant.
    pub(crate) fn explain_initial_value(
        &self,
        declarator: &Declarator,
        init: ExprId,
        storage: Wanted,
    ) -> Diagnostic {
        let name = self.text(declarator.ident.name);
        if storage == Wanted::Const {
            let message = format!("the value of the constant `{name}` is not constant");
            let d = self.error_expr(error::NOT_CONSTANT, init, message);
            let fix = match self.at_global_scope() {
                true => None,
                false => self.take_const_away(Some(declarator.ident.token)),
            };
            return self.explain_not_constant(d, init).fix(fix);
        }
        let message = format!("the initial value of the global variable `{name}` is not constant");
        let d = self
            .error_expr(error::NOT_CONSTANT, init, message)
            .note("GLSL ES 3.00 wants a constant expression here (section 4.3)")
            .help(
                "declare it without a value and set it at the start of `main`, or use a `#define`",
            );
        self.explain_not_constant(d, init)
    }

    /// The offset of a lookup, which is not constant.
    pub(crate) fn explain_dynamic_offset(&self, arg: ExprId) -> Diagnostic {
        let message = "the offset of a lookup must be a constant expression";
        let d = self
            .error_expr(error::NOT_CONSTANT, arg, message)
            .help("add the offset to the coordinates instead");
        self.explain_not_constant(d, arg)
    }

    /// The offset of a lookup, which is too large.
    pub(crate) fn explain_offset(&self, arg: ExprId, offset: i32) -> Diagnostic {
        let message = format!("the offset {offset} is out of range");
        self.error_expr(error::INDEX_OUT_OF_RANGE, arg, message)
            .note("a lookup can be moved by -8 to 7 texels")
    }

    /// Says which part of an expression is not constant.
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
                    Storage::Uniform => {
                        format!("`{name}` is a uniform, known only when the shader runs")
                    }
                    Storage::Input => format!("`{name}` is an input, different at each point"),
                    Storage::Param(_) => format!("`{name}` is a parameter"),
                    _ => format!("`{name}` is a variable, not declared `const`"),
                }
            }
            None => "a function of the shader is never constant".to_string(),
        };
        if span == d.span {
            d.mark(what)
        } else {
            d.label(span, what)
        }
    }
}
