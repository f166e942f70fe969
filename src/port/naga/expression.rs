//! Expressions.

use super::body::{Body, Bound};
use super::place::Part;
use super::types::{Sink, compose, literal};
use super::{Res, Value};
use crate::semantic::{Resolution, Scalar, Type, Value as Constant};
use crate::syntax::ast::{BinaryOp, ExprId, ExprKind, PostfixOp, UnaryOp};
use ::naga::{Expression, UnaryOperator};

impl Body<'_, '_> {
    /// The value of an expression.
    pub(super) fn value(&mut self, id: ExprId) -> Res<Value> {
        let program = self.lowerer.program;
        let id = program.tree.unparen(id);
        self.depth += 1;
        self.check_limits()?;
        let outer = self.lowerer.place;
        self.lowerer.place = program.expr_span(id);
        let value = match self.known(id)? {
            Some(value) => value,
            None => self.computed(id)?,
        };
        self.lowerer.place = outer;
        self.depth -= 1;
        Ok(value)
    }

    /// The value of an expression that the compiler knows.
    fn known(&mut self, id: ExprId) -> Res<Option<Value>> {
        let program = self.lowerer.program;
        let ty = program.ty(id);
        let values = program.values(id);
        if ty.numeric().is_none() || values.len() != ty.components() as usize {
            return Ok(None);
        }
        if let Resolution::Variable(variable) = program.expr(id).resolution
            && matches!(
                self.lowerer.globals.get(&variable),
                Some(super::global::Global::Constant(_))
            )
        {
            return Ok(None);
        }
        self.constant(ty, values).map(Some)
    }

    /// A value that is known.
    fn constant(&mut self, ty: Type, values: &[Constant]) -> Res<Value> {
        let has_literal = |v: &Constant| literal(*v).is_some();
        if let [first, rest @ ..] = values
            && ty.is_vector()
            && has_literal(first)
            && rest.iter().all(|v| v == first)
        {
            let one = self.constant(Type::scalar(scalar_of(*first)), &[*first])?;
            return Ok(self.splat(one, ty));
        }
        if values.iter().all(has_literal) {
            return match compose(self, ty, &mut values.iter())? {
                Some(value) => Ok(value),
                None => self.lowerer.refuse("this value has no literal"),
            };
        }
        if let &[Constant::Float(value)] = values {
            return self.bits(value);
        }
        let mut values = values.iter();
        let mut parts = Vec::new();
        for part in super::types::parts(self.lowerer, ty) {
            let count = part.components() as usize;
            let own: Vec<Constant> = values.by_ref().take(count).copied().collect();
            parts.push(self.constant(part, &own)?);
        }
        self.compose(ty, parts)
    }

    /// An infinity, or what is no number. Other languages refuse to compile what yields one, so it is
    /// made out of its bits, behind a variable that their compilers do not look through.
    fn bits(&mut self, value: f32) -> Res<Value> {
        let bits = self.add(Expression::Literal(::naga::Literal::U32(value.to_bits())));
        let pointer = self.spill(bits, Type::UINT)?;
        let bits = self.load(pointer);
        Ok(self.cast(bits, ::naga::ScalarKind::Float, None))
    }

    fn computed(&mut self, id: ExprId) -> Res<Value> {
        let program = self.lowerer.program;
        match program.tree.expr(id).kind {
            ExprKind::Int(v) => Ok(self.int(v)),
            ExprKind::Uint(v) => Ok(self.add(Expression::Literal(::naga::Literal::U32(v)))),
            ExprKind::Float(v) => self.constant(Type::FLOAT, &[Constant::Float(v)]),
            ExprKind::Bool(v) => Ok(self.add(Expression::Literal(::naga::Literal::Bool(v)))),
            ExprKind::Name(_) => self.named(id),
            ExprKind::Paren(inner) => self.value(inner),
            ExprKind::Unary(op, inner) => self.unary(op, inner),
            ExprKind::Postfix(op, inner) => self.postfix(op, inner),
            ExprKind::Binary(op, l, r) if op.is_logical() => self.logical(op, l, r),
            ExprKind::Binary(op, l, r) => {
                let left = (self.value(l)?, program.ty(l));
                let right = (self.value(r)?, program.ty(r));
                self.binary(op, left, right)
            }
            ExprKind::Assign(op, l, r) => self.assign(op, l, r),
            ExprKind::Ternary(c, a, b) => self.ternary(id, c, a, b),
            ExprKind::Comma(l, r) => {
                self.run(l)?;
                self.value(r)
            }
            ExprKind::Call(_, args) => match self.called(id, args)? {
                Some(value) => Ok(value),
                None => self.refuse(id, "this call has no value"),
            },
            ExprKind::Construct(_, args) => self.construct(program.ty(id), args),
            ExprKind::Member(base, name) if !self.is_stored(base) => {
                let part = self.member(base, name)?;
                let value = self.value(base)?;
                Ok(match part {
                    Part::One(index) => self.part(value, index),
                    Part::Many(lanes) => self.swizzle(value, &lanes),
                })
            }
            ExprKind::Index(base, index) if !self.is_stored(base) => self.indexed(base, index),
            ExprKind::Member(..) | ExprKind::Index(..) => {
                let place = self.place(id)?;
                Ok(self.read(&place))
            }
            ExprKind::Method(object, ..) => Ok(self.int(program.ty(object).array as i32)),
            ExprKind::Error => self.refuse(id, "this could not be read"),
        }
    }

    fn named(&mut self, id: ExprId) -> Res<Value> {
        let Resolution::Variable(variable) = self.lowerer.program.expr(id).resolution else {
            return self.refuse(id, "this name is not known");
        };
        match self.bound(variable)? {
            Bound::Value(value) => Ok(value),
            Bound::Pointer(pointer) => Ok(self.load(pointer)),
            Bound::Sampler { .. } => self.refuse(id, "a sampler is no value here"),
        }
    }

    /// An element of a value. A matrix must lie in a variable if the index is computed.
    fn indexed(&mut self, base: ExprId, index: ExprId) -> Res<Value> {
        let ty = self.lowerer.program.ty(base);
        let value = self.value(base)?;
        if let Some(index) = self.known_index(index) {
            return Ok(self.part(value, index));
        }
        let base = if ty.is_matrix() {
            self.spill(value, ty)?
        } else {
            value
        };
        let index = self.value(index)?;
        let element = self.add(Expression::Access { base, index });
        Ok(if ty.is_matrix() {
            self.load(element)
        } else {
            element
        })
    }

    fn unary(&mut self, op: UnaryOp, inner: ExprId) -> Res<Value> {
        let ty = self.lowerer.program.ty(inner);
        let op = match op {
            UnaryOp::Plus => return self.value(inner),
            UnaryOp::Increment | UnaryOp::Decrement => {
                let is_up = op == UnaryOp::Increment;
                return self.step(inner, is_up).map(|(_, new)| new);
            }
            UnaryOp::Minus => {
                let value = self.value(inner)?;
                return self.negate(value, ty);
            }
            UnaryOp::Not => UnaryOperator::LogicalNot,
            UnaryOp::BitNot => UnaryOperator::BitwiseNot,
        };
        let expr = self.value(inner)?;
        Ok(self.add(Expression::Unary { op, expr }))
    }

    fn postfix(&mut self, op: PostfixOp, inner: ExprId) -> Res<Value> {
        let is_up = op == PostfixOp::Increment;
        self.step(inner, is_up).map(|(old, _)| old)
    }

    /// Counts up or down; gives the values before and after.
    fn step(&mut self, id: ExprId, is_up: bool) -> Res<(Value, Value)> {
        let ty = self.lowerer.program.ty(id);
        let place = self.place(id)?;
        let old = self.read(&place);
        let scalar = ty.scalar_kind().unwrap_or(Scalar::Int);
        let one = self.constant(Type::scalar(scalar), &[Constant::Int(1).to(scalar)])?;
        let op = if is_up { BinaryOp::Add } else { BinaryOp::Sub };
        let new = self.binary(op, (old, ty), (one, Type::scalar(scalar)))?;
        self.write(&place, new);
        Ok((old, new))
    }

    fn assign(&mut self, op: Option<BinaryOp>, l: ExprId, r: ExprId) -> Res<Value> {
        let program = self.lowerer.program;
        let place = self.place(l)?;
        let value = match op {
            None => self.value(r)?,
            Some(op) => {
                // What stands on the left is read before anything on the right can change it.
                let old = self.read(&place);
                let right = self.value(r)?;
                self.binary(op, (old, program.ty(l)), (right, program.ty(r)))?
            }
        };
        self.write(&place, value);
        Ok(value)
    }
}

fn scalar_of(value: Constant) -> Scalar {
    match value {
        Constant::Bool(_) => Scalar::Bool,
        Constant::Int(_) => Scalar::Int,
        Constant::Uint(_) => Scalar::Uint,
        Constant::Float(_) => Scalar::Float,
    }
}
