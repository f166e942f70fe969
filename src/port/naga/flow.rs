//! What is evaluated only where its value is asked for: `?:`, `&&`, `||`.

use super::body::Body;
use super::types::Sink;
use super::{Res, Value};
use crate::semantic::Type;
use crate::syntax::ast::{BinaryOp, ExprId, ExprKind};
use ::naga::{BinaryOperator as Op, Block, Expression, Literal, Statement};

impl Body<'_, '_> {
    /// `condition ? a : b`
    pub(super) fn ternary(
        &mut self,
        id: ExprId,
        condition: ExprId,
        a: ExprId,
        b: ExprId,
    ) -> Res<Value> {
        let ty = self.lowerer.program.ty(id);
        let is_light = self.lowerer.weight(a).is_light() && self.lowerer.weight(b).is_light();
        let condition = self.value(condition)?;
        if is_light && (ty.is_scalar() || ty.is_vector()) {
            let accept = self.value(a)?;
            let reject = self.value(b)?;
            return Ok(self.select(condition, accept, reject));
        }
        let chosen = self.local(None, ty)?;
        let accept = self.nested(|body| {
            let value = body.value(a)?;
            body.store(chosen, value);
            Ok(())
        })?;
        let reject = self.nested(|body| {
            let value = body.value(b)?;
            body.store(chosen, value);
            Ok(())
        })?;
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        Ok(self.load(chosen))
    }

    /// One of two values, both of which are there.
    pub(super) fn select(&mut self, condition: Value, accept: Value, reject: Value) -> Value {
        self.add(Expression::Select {
            condition,
            accept,
            reject,
        })
    }

    /// `l && r`, `l || r`, `l ^^ r`
    pub(super) fn logical(&mut self, op: BinaryOp, l: ExprId, r: ExprId) -> Res<Value> {
        let left = self.value(l)?;
        let simple = match op {
            BinaryOp::And => Op::LogicalAnd,
            BinaryOp::Or => Op::LogicalOr,
            _ => Op::NotEqual,
        };
        if simple == Op::NotEqual || self.lowerer.weight(r).is_light() {
            let right = self.value(r)?;
            return Ok(self.op(simple, left, right));
        }
        let result = self.local(None, Type::BOOL)?;
        let asks = self.nested(|body| {
            let right = body.value(r)?;
            body.store(result, right);
            Ok(())
        })?;
        let is_settled = op == BinaryOp::Or;
        let settled = self.nested(|body| {
            let value = body.add(Expression::Literal(Literal::Bool(is_settled)));
            body.store(result, value);
            Ok(())
        })?;
        self.branch(left, is_settled, settled, asks);
        Ok(self.load(result))
    }

    /// Runs `first` where the condition is `wanted`, else `second`.
    fn branch(&mut self, condition: Value, wanted: bool, first: Block, second: Block) {
        let (accept, reject) = if wanted {
            (first, second)
        } else {
            (second, first)
        };
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
    }

    /// Evaluates an expression for what it does; it may be `void`.
    pub(super) fn run(&mut self, id: ExprId) -> Res<()> {
        let program = self.lowerer.program;
        let id = program.tree.unparen(id);
        self.depth += 1;
        self.check_limits()?;
        match program.tree.expr(id).kind {
            ExprKind::Comma(l, r) => {
                self.run(l)?;
                self.run(r)?;
            }
            ExprKind::Ternary(condition, a, b) => {
                let condition = self.value(condition)?;
                let accept = self.nested(|body| body.run(a))?;
                let reject = self.nested(|body| body.run(b))?;
                self.push(Statement::If {
                    condition,
                    accept,
                    reject,
                });
            }
            ExprKind::Call(_, args) => {
                self.lowerer.place = program.expr_span(id);
                self.called(id, args)?;
            }
            _ => {
                self.value(id)?;
            }
        }
        self.depth -= 1;
        Ok(())
    }
}
