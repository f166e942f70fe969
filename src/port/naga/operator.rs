//! Operators between two values, and conversions.

use super::body::Body;
use super::types::Sink;
use super::{Res, Value};
use crate::semantic::{Base, Scalar, Type};
use crate::syntax::ast::BinaryOp;
use ::naga::{BinaryOperator as Op, Expression, RelationalFunction, ScalarKind, UnaryOperator};

/// A value and its type.
pub(super) type Typed = (Value, Type);

impl Body<'_, '_> {
    /// `left op right`.
    pub(super) fn binary(&mut self, op: BinaryOp, left: Typed, right: Typed) -> Res<Value> {
        let ((l, left_ty), (r, right_ty)) = (left, right);
        match op {
            BinaryOp::Equal => self.equal(l, r, left_ty),
            BinaryOp::NotEqual => {
                let equal = self.equal(l, r, left_ty)?;
                let op = UnaryOperator::LogicalNot;
                Ok(self.add(Expression::Unary { op, expr: equal }))
            }
            BinaryOp::Xor => Ok(self.op(Op::NotEqual, l, r)),
            BinaryOp::ShiftLeft | BinaryOp::ShiftRight => Ok(self.shift(op, left, right)),
            _ if left_ty.is_matrix() || right_ty.is_matrix() => self.matrix(op, left, right),
            BinaryOp::Mul if left_ty.scalar_kind() == Some(Scalar::Float) => {
                Ok(self.op(Op::Multiply, l, r))
            }
            _ => {
                let wide = if left_ty.is_vector() {
                    left_ty
                } else {
                    right_ty
                };
                let l = self.widen(l, left_ty, wide);
                let r = self.widen(r, right_ty, wide);
                Ok(self.op(simple(op), l, r))
            }
        }
    }

    /// An operator of naga.
    pub(super) fn op(&mut self, op: Op, left: Value, right: Value) -> Value {
        self.add(Expression::Binary { op, left, right })
    }

    /// A number as a vector where the other operand is one.
    pub(super) fn widen(&mut self, value: Value, ty: Type, wanted: Type) -> Value {
        if ty.is_scalar() {
            self.splat(value, wanted)
        } else {
            value
        }
    }

    /// Shifts go by unsigned numbers, as many as are shifted.
    fn shift(&mut self, op: BinaryOp, left: Typed, right: Typed) -> Value {
        let ((l, left_ty), (r, right_ty)) = (left, right);
        let by = match right_ty.scalar_kind() {
            Some(Scalar::Uint) => r,
            _ => self.convert(r, Scalar::Uint),
        };
        let by = self.widen(by, right_ty, left_ty);
        let op = match op {
            BinaryOp::ShiftLeft => Op::ShiftLeft,
            _ => Op::ShiftRight,
        };
        self.op(op, l, by)
    }

    /// Whether two values of one type are equal, all parts of them.
    pub(super) fn equal(&mut self, l: Value, r: Value, ty: Type) -> Res<Value> {
        if ty.is_scalar() {
            return Ok(self.op(Op::Equal, l, r));
        }
        if ty.is_vector() {
            let argument = self.op(Op::Equal, l, r);
            let fun = RelationalFunction::All;
            return Ok(self.add(Expression::Relational { fun, argument }));
        }
        self.check_limits()?;
        let mut all: Option<Value> = None;
        for (i, part) in super::types::parts(self.lowerer, ty)
            .into_iter()
            .enumerate()
        {
            let (a, b) = (self.part(l, i as u32), self.part(r, i as u32));
            let equal = self.equal(a, b, part)?;
            all = Some(match all {
                Some(before) => self.op(Op::LogicalAnd, before, equal),
                None => equal,
            });
        }
        match all {
            Some(value) => Ok(value),
            None => self.lowerer.refuse("these cannot be compared"),
        }
    }

    /// `-value`
    pub(super) fn negate(&mut self, value: Value, ty: Type) -> Res<Value> {
        if let (Base::Numeric { .. }, true) = (ty.base, ty.is_matrix()) {
            let minus = self.float(-1.0);
            return Ok(self.op(Op::Multiply, value, minus));
        }
        // Unsigned numbers wrap around; naga only knows the sign of signed ones.
        if ty.scalar_kind() == Some(Scalar::Uint) {
            let zero = self.zero(ty)?;
            return Ok(self.op(Op::Subtract, zero, value));
        }
        let op = UnaryOperator::Negate;
        Ok(self.add(Expression::Unary { op, expr: value }))
    }

    /// A number or vector made of something else.
    pub(super) fn convert(&mut self, value: Value, scalar: Scalar) -> Value {
        let to = super::types::scalar(scalar);
        self.cast(value, to.kind, Some(to.width))
    }

    /// Without a width the bits stay what they are.
    pub(super) fn cast(&mut self, expr: Value, kind: ScalarKind, convert: Option<u8>) -> Value {
        self.add(Expression::As {
            expr,
            kind,
            convert,
        })
    }
}

/// The operator of naga that does the same to numbers and vectors.
pub(super) fn simple(op: BinaryOp) -> Op {
    match op {
        BinaryOp::Mul => Op::Multiply,
        BinaryOp::Div => Op::Divide,
        BinaryOp::Rem => Op::Modulo,
        BinaryOp::Add => Op::Add,
        BinaryOp::Sub => Op::Subtract,
        BinaryOp::ShiftLeft => Op::ShiftLeft,
        BinaryOp::ShiftRight => Op::ShiftRight,
        BinaryOp::Less => Op::Less,
        BinaryOp::Greater => Op::Greater,
        BinaryOp::LessEqual => Op::LessEqual,
        BinaryOp::GreaterEqual => Op::GreaterEqual,
        BinaryOp::Equal => Op::Equal,
        BinaryOp::NotEqual | BinaryOp::Xor => Op::NotEqual,
        BinaryOp::BitAnd => Op::And,
        BinaryOp::BitXor => Op::ExclusiveOr,
        BinaryOp::BitOr => Op::InclusiveOr,
        BinaryOp::And => Op::LogicalAnd,
        BinaryOp::Or => Op::LogicalOr,
    }
}
