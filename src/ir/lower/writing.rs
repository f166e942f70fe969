//! Which expressions may write to a variable.

use shaderlint_semantic::{Direction, Program, Resolution, Storage, each_operand};
use shaderlint_syntax::ast::{ExprId, ExprKind, PostfixOp};

/// The expressions that may write to a variable, by index.
pub(super) struct Writing(Vec<bool>);

impl Writing {
    /// Finds them in one pass, since operands come before the expressions that contain them.
    pub fn of(program: &Program) -> Writing {
        let is_shared = |s: Storage| matches!(s, Storage::Global | Storage::Output);
        let mut variables = program.variables.iter();
        let has_shared = variables.any(|v| v.written && is_shared(v.storage));
        let builtins = program.builtins();
        let exprs = &program.tree.exprs;
        let mut writing = Writing(Vec::with_capacity(exprs.len()));
        for (expr, id) in exprs.iter().zip(0..) {
            let mut writes = match expr.kind {
                ExprKind::Assign(..) => true,
                ExprKind::Postfix(PostfixOp::Increment | PostfixOp::Decrement, _) => true,
                ExprKind::Unary(op, _) => op.assigns(),
                ExprKind::Call(..) => match program.expr(ExprId(id)).resolution {
                    Resolution::Function(function) => {
                        let known = program.function(function);
                        let params = known.map_or(&[][..], |f| &f.params);
                        let is_in = |d| matches!(d, Direction::In | Direction::ConstIn);
                        has_shared || params.iter().any(|p| !is_in(p.direction))
                    }
                    Resolution::Builtin(overload) => {
                        let known = builtins.overload(overload);
                        known.is_some_and(|o| o.out != 0)
                    }
                    _ => false,
                },
                _ => false,
            };
            each_operand(&program.tree, expr, |operand| {
                writes |= writing.has(operand)
            });
            writing.0.push(writes);
        }
        writing
    }

    /// Whether an expression may write; unknown ones may.
    pub fn has(&self, id: ExprId) -> bool {
        self.0.get(id.0 as usize).copied().unwrap_or(true)
    }

    /// The number of operands that another one follows which may write.
    pub fn count_before(&self, operands: &[ExprId]) -> usize {
        let last = operands.iter().rposition(|operand| self.has(*operand));
        last.unwrap_or(0)
    }
}
