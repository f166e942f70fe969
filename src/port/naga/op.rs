//! Lowers operations to naga's expressions.

use super::body::{Body, Emitted};
use super::target::{Res, Value};
use super::types::{Sink, literal, scalar, size};
use ::naga::{
    BinaryOperator as Op, Expression, Literal, MathFunction, RelationalFunction, ScalarKind,
    Statement, UnaryOperator,
};
use shaderlint_ir::{Binary, OpId, OpKind, Provenance, Unary};
use shaderlint_semantic::{Scalar, Type, Value as Constant};
use std::slice;

impl Body<'_, '_> {
    pub(super) fn operation(&mut self, id: OpId) -> Res<()> {
        self.check_limits()?;
        let form = self.lowerer.form;
        self.lowerer.stand_at(form.provenance(id));
        let ty = form.ty(id);
        let value = match form.op(id).kind {
            OpKind::Unknown => return self.lowerer.refuse("this could not be resolved"),
            OpKind::Store(place, value) => return self.write(place, value),
            // These are created on use.
            OpKind::Undef | OpKind::Splat(_) => None,
            OpKind::Load(_) if self.lowerer.inside(ty).sampler => None,
            OpKind::Call(function, operands) => self.user_call(id, function, operands)?,
            OpKind::Returned(call, parameter) => self.returned(call, parameter)?,
            OpKind::Builtin(function, operands) => {
                Some(self.builtin(id, function, form.operands(operands))?)
            }
            _ => Some(self.computed(id, ty)?),
        };
        self.keep(id, value);
        Ok(())
    }

    fn computed(&mut self, id: OpId, ty: Type) -> Res<Value> {
        let form = self.lowerer.form;
        Ok(match form.op(id).kind {
            OpKind::Const(_) => return self.known(id),
            OpKind::Load(place) => return self.read(place),
            OpKind::Unary(op, inner) => return self.unary(op, inner),
            OpKind::Binary(op, left, right) => return self.binary(op, left, right),
            OpKind::MatrixProduct(left, right) => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                self.op(Op::Multiply, left, right)
            }
            OpKind::Same {
                negated,
                left,
                right,
            } => {
                let of = form.ty(left);
                let (left, right) = (self.value(left)?, self.value(right)?);
                match (negated, of.is_scalar()) {
                    (true, true) => self.op(Op::NotEqual, left, right),
                    (true, false) => {
                        let expr = self.equal(left, right, of)?;
                        let op = UnaryOperator::LogicalNot;
                        self.add(Expression::Unary { op, expr })
                    }
                    (false, _) => self.equal(left, right, of)?,
                }
            }
            OpKind::Select {
                condition,
                then,
                otherwise,
            } => {
                let condition = self.value(condition)?;
                let (accept, reject) = (self.value(then)?, self.value(otherwise)?);
                return self.chosen(condition, accept, reject, ty);
            }
            OpKind::Convert(inner) => {
                let value = self.value(inner)?;
                match ty.scalar_kind() {
                    Some(to) if form.scalar(inner) != Some(to) => self.convert(value, to),
                    _ => value,
                }
            }
            OpKind::Swizzle(inner, lanes) => {
                let value = self.value(inner)?;
                self.swizzle(value, lanes)
            }
            OpKind::Compose(operands) => {
                let operands = form.operands(operands).iter();
                let parts: Res<Vec<Value>> = operands.map(|part| self.value(*part)).collect();
                return self.compose(ty, parts?);
            }
            OpKind::Extract(base, index) => {
                let base = self.value(base)?;
                self.part(base, index)
            }
            OpKind::ExtractComputed { base, index } => return self.element(base, index),
            _ => return self.lowerer.refuse("this has no value"),
        })
    }

    /// The value of an operation.
    pub(super) fn value(&mut self, id: OpId) -> Res<Value> {
        if let Some(value) = self.lowerer.given(id).value {
            return Ok(value);
        }
        let form = self.lowerer.form;
        let ty = form.ty(id);
        match form.op(id).kind {
            OpKind::Undef => self.zero(ty),
            OpKind::Splat(number) => {
                let number = self.value(number)?;
                if !ty.is_matrix() {
                    return Ok(self.splat(number, ty));
                }
                let columns: Vec<Type> = self.lowerer.layout.parts(ty).collect();
                let columns = columns.into_iter();
                let columns = columns.map(|column| self.splat(number, column)).collect();
                self.compose(ty, columns)
            }
            _ if ty.is_sampler() => self.lowerer.refuse("a sampler cannot be used as a value"),
            _ => self.lowerer.refuse("this has no value"),
        }
    }

    /// Records the value of an operation. Deeply nested expressions get a name from time to time,
    /// to limit the nesting for naga's writers and for target compilers.
    fn keep(&mut self, id: OpId, value: Option<Value>) {
        const MAX_DEPTH: u32 = 60;
        let form = self.lowerer.form;
        let mut depth = 0;
        form.each_operand(id, |inner| {
            depth = depth.max(self.lowerer.given(inner).depth + 1);
        });
        if matches!(form.op(id).kind, OpKind::Load(_) | OpKind::Call(..)) {
            depth = 0;
        } else if let Some(value) = value.filter(|_| depth > MAX_DEPTH) {
            self.name(value, "part");
            depth = 0;
        }
        self.lowerer.give(id, Emitted { value, depth });
    }

    /// Names a value, unless it already has a name or is always inlined.
    pub(super) fn name(&mut self, value: Value, name: &str) {
        let is_free = self.function.expressions[value].needs_pre_emit();
        let names = &mut self.function.named_expressions;
        if !is_free && !names.contains_key(&value) {
            names.insert(value, name.to_string());
        }
    }

    /// A constant value, by the name of the constant that it was read from.
    fn known(&mut self, id: OpId) -> Res<Value> {
        let form = self.lowerer.form;
        let ty = form.ty(id);
        if let Provenance::Expr(read) = form.provenance(id)
            && let Some(variable) = self.lowerer.program.variable_of(read)
            && let Some(constant) = self.lowerer.named(variable)?
        {
            return Ok(self.add(Expression::Constant(constant)));
        }
        self.constant(ty, &mut form.constant(id))
    }

    /// Builds a constant of a type from the first of some scalars.
    fn constant(&mut self, ty: Type, values: &mut &[Constant]) -> Res<Value> {
        if ty.is_scalar() {
            let Some((first, rest)) = values.split_first() else {
                return self.lowerer.refuse("unknown value");
            };
            *values = rest;
            return match (literal(*first), *first) {
                (Some(literal), _) => Ok(self.add(Expression::Literal(literal))),
                (None, Constant::Float(value)) => self.bits(value),
                _ => self
                    .lowerer
                    .refuse("this value cannot be written as a literal"),
            };
        }
        if let Some((first, rest)) = values.split_at_checked(ty.components() as usize)
            && let [one, others @ ..] = first
            && let (true, Some(scalar)) = (ty.is_vector(), ty.scalar_kind())
            && others.iter().all(|v| v == one)
        {
            *values = rest;
            let one = self.constant(Type::scalar(scalar), &mut slice::from_ref(one))?;
            return Ok(self.splat(one, ty));
        }
        let parts: Vec<Type> = self.lowerer.layout.parts(ty).collect();
        let parts = parts.into_iter();
        let components: Res<Vec<Value>> = parts.map(|part| self.constant(part, values)).collect();
        self.compose(ty, components?)
    }

    /// An infinity or NaN. Target compilers reject constant expressions with such a value, so it is
    /// cast from its bits, which are hidden in a variable.
    fn bits(&mut self, value: f32) -> Res<Value> {
        let bits = self.add(Expression::Literal(Literal::U32(value.to_bits())));
        let pointer = self.spill(bits, Type::UINT)?;
        let bits = self.load(pointer);
        Ok(self.cast(bits, ScalarKind::Float, None))
    }

    /// An element of a value. A matrix must be in a variable.
    fn element(&mut self, base: OpId, index: OpId) -> Res<Value> {
        let ty = self.lowerer.form.ty(base);
        let (value, index) = (self.value(base)?, self.value(index)?);
        if !ty.is_matrix() {
            return Ok(self.add(Expression::Access { base: value, index }));
        }
        let base = self.spill(value, ty)?;
        let column = self.add(Expression::Access { base, index });
        Ok(self.load(column))
    }

    fn unary(&mut self, op: Unary, inner: OpId) -> Res<Value> {
        let expr = self.value(inner)?;
        let op = match op {
            Unary::Negate => return self.negate(expr, self.lowerer.form.ty(inner)),
            Unary::Not => UnaryOperator::LogicalNot,
            Unary::BitNot => UnaryOperator::BitwiseNot,
        };
        Ok(self.add(Expression::Unary { op, expr }))
    }

    fn binary(&mut self, op: Binary, left: OpId, right: OpId) -> Res<Value> {
        let ty = self.lowerer.form.ty(left);
        let (l, r) = match op {
            _ if ty.is_matrix() => return self.matrix(simple(op), left, right),
            // Naga multiplies vectors and scalars directly.
            Binary::Multiply if ty.scalar_kind() == Some(Scalar::Float) => {
                match (self.spread(left), self.spread(right)) {
                    (_, Some(number)) => (self.value(left)?, self.value(number)?),
                    (Some(number), None) => (self.value(number)?, self.value(right)?),
                    (None, None) => (self.value(left)?, self.value(right)?),
                }
            }
            // Shift amounts are unsigned.
            Binary::ShiftLeft | Binary::ShiftRight => (self.value(left)?, self.distance(right)?),
            _ => (self.value(left)?, self.value(right)?),
        };
        Ok(self.op(simple(op), l, r))
    }

    /// The shift amount as an unsigned value.
    fn distance(&mut self, by: OpId) -> Res<Value> {
        let form = self.lowerer.form;
        let unsigned = form.ty(by).with_scalar(Scalar::Uint);
        if let Some(number) = self.spread(by) {
            let number = self.distance(number)?;
            return Ok(self.splat(number, unsigned));
        }
        let known = form.constant(by);
        if !known.is_empty() {
            let known: Vec<Constant> = known.iter().map(|v| v.to(Scalar::Uint)).collect();
            return self.constant(unsigned, &mut &known[..]);
        }
        let value = self.value(by)?;
        match form.scalar(by) {
            Some(Scalar::Uint) => Ok(value),
            _ => Ok(self.convert(value, Scalar::Uint)),
        }
    }

    /// The scalar that all components of a value equal.
    pub(super) fn spread(&self, id: OpId) -> Option<OpId> {
        match self.lowerer.form.op(id).kind {
            OpKind::Splat(number) => Some(number),
            _ => None,
        }
    }

    /// Adds a binary expression.
    pub(super) fn op(&mut self, op: Op, left: Value, right: Value) -> Value {
        self.add(Expression::Binary { op, left, right })
    }

    /// Adds a call of a naga function.
    pub(super) fn math(&mut self, fun: MathFunction, args: &[Value]) -> Value {
        let arg = |i: usize| args.get(i).copied();
        match arg(0) {
            Some(first) => self.add(Expression::Math {
                fun,
                arg: first,
                arg1: arg(1),
                arg2: arg(2),
                arg3: arg(3),
            }),
            None => self.float(0.0),
        }
    }

    /// Selects one of two evaluated values.
    pub(super) fn select(&mut self, condition: Value, accept: Value, reject: Value) -> Value {
        self.add(Expression::Select {
            condition,
            accept,
            reject,
        })
    }

    /// Selects one of two values of any type; naga's select supports only scalars and vectors.
    fn chosen(&mut self, condition: Value, accept: Value, reject: Value, ty: Type) -> Res<Value> {
        if ty.is_scalar() || ty.is_vector() {
            return Ok(self.select(condition, accept, reject));
        }
        let chosen = self.local(None, ty)?;
        let mut storing = |value| {
            self.nested(|it| {
                it.store(chosen, value);
                Ok(())
            })
        };
        let (accept, reject) = (storing(accept)?, storing(reject)?);
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        Ok(self.load(chosen))
    }

    /// A vector with equal components, if the type is a vector.
    pub(super) fn splat(&mut self, value: Value, ty: Type) -> Value {
        match ty.numeric() {
            Some((_, 1, rows @ 2..)) => self.add(Expression::Splat {
                size: size(rows),
                value,
            }),
            _ => value,
        }
    }

    /// Whether two values of the same type are equal in all components.
    fn equal(&mut self, l: Value, r: Value, ty: Type) -> Res<Value> {
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
        let parts: Vec<Type> = self.lowerer.layout.parts(ty).collect();
        for (i, part) in (0..).zip(parts) {
            let (a, b) = (self.part(l, i), self.part(r, i));
            let equal = self.equal(a, b, part)?;
            all = Some(match all {
                Some(before) => self.op(Op::LogicalAnd, before, equal),
                None => equal,
            });
        }
        match all {
            Some(value) => Ok(value),
            None => self.lowerer.refuse("these values cannot be compared"),
        }
    }

    /// `-value`
    pub(super) fn negate(&mut self, value: Value, ty: Type) -> Res<Value> {
        if ty.is_matrix() {
            let minus = self.float(-1.0);
            return Ok(self.op(Op::Multiply, value, minus));
        }
        // Unsigned negation wraps; naga negates only signed values.
        if ty.scalar_kind() == Some(Scalar::Uint) {
            let zero = self.zero(ty)?;
            return Ok(self.op(Op::Subtract, zero, value));
        }
        let op = UnaryOperator::Negate;
        Ok(self.add(Expression::Unary { op, expr: value }))
    }

    /// Converts a scalar or vector to another scalar type.
    pub(super) fn convert(&mut self, value: Value, to: Scalar) -> Value {
        let to = scalar(to);
        self.cast(value, to.kind, Some(to.width))
    }

    /// Casts a value; without a width the bits are kept.
    pub(super) fn cast(&mut self, expr: Value, kind: ScalarKind, convert: Option<u8>) -> Value {
        self.add(Expression::As {
            expr,
            kind,
            convert,
        })
    }
}

/// The naga operator for scalars and vectors.
fn simple(op: Binary) -> Op {
    match op {
        Binary::Multiply => Op::Multiply,
        Binary::Divide => Op::Divide,
        Binary::Remainder => Op::Modulo,
        Binary::Add => Op::Add,
        Binary::Subtract => Op::Subtract,
        Binary::ShiftLeft => Op::ShiftLeft,
        Binary::ShiftRight => Op::ShiftRight,
        Binary::Less => Op::Less,
        Binary::Greater => Op::Greater,
        Binary::LessEqual => Op::LessEqual,
        Binary::GreaterEqual => Op::GreaterEqual,
        Binary::BitAnd => Op::And,
        Binary::BitXor => Op::ExclusiveOr,
        Binary::BitOr => Op::InclusiveOr,
        Binary::And => Op::LogicalAnd,
        Binary::Or => Op::LogicalOr,
        Binary::Xor => Op::NotEqual,
    }
}
