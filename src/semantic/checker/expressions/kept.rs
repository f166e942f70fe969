//! What the browser's compiler removes from an expression, and what it keeps, before its checks.

use crate::checker::*;

impl Checker<'_> {
    /// Whether an expression writes to anything, or calls a function of the shader.
    pub(super) fn has_side_effects(&self, id: ExprId) -> bool {
        self.subtree(id)
            .any(|(_, info, expr)| match (info.resolution, expr.kind) {
                (Resolution::Function(_), _) => true,
                (Resolution::Builtin(id), _) => {
                    self.builtins.overload(id).is_some_and(|o| o.out != 0)
                }
                (_, ExprKind::Assign(..) | ExprKind::Postfix(..)) => true,
                (_, ExprKind::Unary(op, _)) => op.assigns(),
                _ => false,
            })
    }

    /// The operand that the browser keeps of an operator, so that it can be written to: the right
    /// one of a `,` if the left has no side effects, and the branch of `? :` that a constant
    /// selects. It keeps only local variables, and after `,` no constants.
    pub(super) fn kept_operand(&self, id: ExprId) -> Option<ExprId> {
        let kept = match self.tree.expr(id).kind {
            ExprKind::Comma(left, right) => {
                return (self.is_temporary(right) && !self.has_side_effects(left)).then_some(right);
            }
            ExprKind::Ternary(condition, yes, no) => {
                let info = self.info(condition);
                match self.pool.scalar(info.constant).filter(|_| info.is_const)? {
                    chosen if chosen.as_bool() => yes,
                    _ => no,
                }
            }
            _ => return None,
        };
        self.is_local(kept).then_some(kept)
    }

    /// Whether an expression is a local variable, or not a variable at all.
    fn is_local(&self, id: ExprId) -> bool {
        let variable = self.variable_of(id);
        let variable = variable.and_then(|v| self.variables.get(v.0 as usize));
        variable.is_none_or(|v| v.storage == Storage::Local)
    }

    /// Whether an expression is a temporary for the browser's compiler: neither a constant nor a
    /// variable that is not local.
    pub(super) fn is_temporary(&self, id: ExprId) -> bool {
        !self.info(id).is_const && self.is_local(id)
    }

    /// The variable that the browser reduces an expression to.
    pub(in crate::checker) fn base_variable(&self, id: ExprId) -> Option<VariableId> {
        let mut at = self.tree.unparen(id);
        while let Some(kept) = self.kept_operand(at) {
            at = self.tree.unparen(kept);
        }
        self.variable_of(at)
    }
}
