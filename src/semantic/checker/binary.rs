//! Operators between two operands (GLSL ES 3.00 section 5.9).

use super::super::constant::Value;
use super::*;
use std::cmp::Ordering;

/// Why two operands do not fit an operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::semantic) enum Misfit {
    /// One has no value.
    Void,
    /// One is a sampler.
    Sampler,
    /// One is a struct or block and the operator is not for those, or they are of two types.
    Struct,
    /// A struct that holds an array or a sampler cannot be compared or assigned.
    StructInside,
    /// One is an array, the other is not; or arrays have no such operator.
    Array,
    /// Two arrays of different sizes.
    ArraySize,
    /// `int`, `uint`, `float` or `bool` mixed.
    Scalars,
    /// Vectors or matrices of sizes that do not fit.
    Shape,
    /// The operator is for integers.
    NeedsInteger,
    /// The operator is for numbers.
    NeedsNumber,
    /// The operator is for single truth values.
    NeedsBool,
    /// The operator compares single numbers.
    NeedsScalar,
}

impl Checker<'_> {
    pub(super) fn binary(
        &mut self,
        id: ExprId,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
    ) -> ExprInfo {
        let (l, r) = (self.info(left), self.info(right));
        if l.ty.is_error() || r.ty.is_error() {
            return self.poisoned(op);
        }
        let is_of_integers = op.is_bitwise() || op == BinaryOp::Rem;
        if is_of_integers && !self.has(Feature::IntegerOperators) {
            self.require(
                Feature::IntegerOperators,
                id,
                &format!("the operator `{}`", op.symbol()),
            );
        }
        match self.binary_type(op, l.ty, r.ty, false) {
            Ok(ty) => {
                let constant = if l.is_const && r.is_const {
                    self.fold_binary(op, l, r)
                } else {
                    Constant::NONE
                };
                self.result(ty, [l, r], constant)
            }
            Err(misfit) => {
                let d = self.explain_operands(id, op, left, right, misfit);
                self.report(d);
                self.poisoned(op)
            }
        }
    }

    /// The result of an operator whose operands were reported.
    fn poisoned(&self, op: BinaryOp) -> ExprInfo {
        if op.compares() || op.is_logical() {
            ExprInfo {
                ty: Type::BOOL,
                ..ExprInfo::ERROR
            }
        } else {
            ExprInfo::ERROR
        }
    }

    /// Type of `l op r`. `assigns` is set for `l op= r`, where the result must fit `l`.
    pub(super) fn binary_type(
        &self,
        op: BinaryOp,
        l: Type,
        r: Type,
        assigns: bool,
    ) -> Result<Type, Misfit> {
        use BinaryOp as B;
        self.check_aggregates(matches!(op, B::Equal | B::NotEqual), false, l, r)?;
        if l.is_array() || matches!(l.base, Base::Struct(_)) {
            return Ok(Type::BOOL);
        }
        let (Some((ls, lc, lr)), Some((rs, rc, rr))) = (l.numeric(), r.numeric()) else {
            return Err(Misfit::Struct);
        };
        let is_shift = matches!(op, B::ShiftLeft | B::ShiftRight);
        if op.is_bitwise() && (!ls.is_integer() || (is_shift && !rs.is_integer())) {
            return Err(Misfit::NeedsInteger);
        }
        if ls != rs && !is_shift {
            return Err(Misfit::Scalars);
        }
        let same_shape = (lc, lr) == (rc, rr);
        match op {
            B::Equal | B::NotEqual => {
                if same_shape {
                    Ok(Type::BOOL)
                } else {
                    Err(Misfit::Shape)
                }
            }
            B::Less | B::Greater | B::LessEqual | B::GreaterEqual => {
                if !l.is_scalar() || !r.is_scalar() {
                    Err(Misfit::NeedsScalar)
                } else if ls == Scalar::Bool {
                    Err(Misfit::NeedsNumber)
                } else {
                    Ok(Type::BOOL)
                }
            }
            B::And | B::Or | B::Xor => {
                if l == Type::BOOL && r == Type::BOOL {
                    Ok(Type::BOOL)
                } else {
                    Err(Misfit::NeedsBool)
                }
            }
            _ if ls == Scalar::Bool => Err(Misfit::NeedsNumber),
            B::Mul => product(l, r, assigns).ok_or(Misfit::Shape),
            B::Rem if !ls.is_integer() => Err(Misfit::NeedsInteger),
            _ => {
                let mixed = (l.is_matrix() && r.is_vector()) || (l.is_vector() && r.is_matrix());
                if same_shape {
                    Ok(l)
                } else if mixed
                    || !(l.is_scalar() || r.is_scalar())
                    || (!r.is_scalar() && (assigns || is_shift))
                {
                    Err(Misfit::Shape)
                } else {
                    Ok(if l.is_scalar() { r } else { l })
                }
            }
        }
    }

    /// What holds for every operator: no `void`, no sampler, structs and arrays only compared and
    /// assigned.
    pub(super) fn check_aggregates(
        &self,
        compares: bool,
        assigns: bool,
        l: Type,
        r: Type,
    ) -> Result<(), Misfit> {
        if l.is_void() || r.is_void() {
            return Err(Misfit::Void);
        }
        if l.is_sampler() || r.is_sampler() {
            return Err(Misfit::Sampler);
        }
        let is_struct = |t: Type| matches!(t.base, Base::Struct(_) | Base::Block(_));
        if is_struct(l) || is_struct(r) {
            let is_block = matches!(l.base, Base::Block(_)) || matches!(r.base, Base::Block(_));
            if is_block || !(compares || assigns) || l != r {
                return Err(Misfit::Struct);
            }
            let inside = self.inside(l.element());
            if (!self.has(Feature::ArrayValues) && inside.array) || inside.sampler {
                return Err(Misfit::StructInside);
            }
        }
        if l.is_array() != r.is_array() {
            return Err(Misfit::Array);
        }
        if l.is_array() {
            if !self.has(Feature::ArrayValues) || !(compares || assigns) {
                return Err(Misfit::Array);
            }
            if l.array != r.array {
                return Err(Misfit::ArraySize);
            }
            if l.base != r.base {
                let scalars = |t: Type| t.element().scalar_kind();
                let mixed = scalars(l) != scalars(r);
                return Err(if mixed {
                    Misfit::Scalars
                } else {
                    Misfit::Shape
                });
            }
        }
        Ok(())
    }

    pub(super) fn fold_binary(&mut self, op: BinaryOp, l: ExprInfo, r: ExprInfo) -> Constant {
        let left = self.pool.values(l.constant);
        let right = self.pool.values(r.constant);
        if left.is_empty() || right.is_empty() {
            return Constant::NONE;
        }
        // Few characters compare two large arrays.
        let length = left.len().min(right.len());
        let Some(comparable) = self.comparable.checked_sub(length) else {
            return Constant::NONE;
        };
        self.comparable = comparable;
        let values = match op {
            BinaryOp::Equal => vec![Value::Bool(left == right)],
            BinaryOp::NotEqual => vec![Value::Bool(left != right)],
            BinaryOp::Mul if l.ty.is_matrix() || r.ty.is_matrix() => {
                match multiply(l.ty, left, r.ty, right) {
                    Some(values) => values,
                    None => return Constant::NONE,
                }
            }
            _ => {
                let len = left.len().max(right.len());
                let at = |v: &[Value], i: usize| {
                    let one = if v.len() == 1 { v.first() } else { v.get(i) };
                    one.copied().unwrap_or(Value::Int(0))
                };
                (0..len)
                    .map(|i| fold_scalar(op, at(left, i), at(right, i)))
                    .collect()
            }
        };
        self.pool.add(values)
    }
}

/// Type of `l * r`, if they can be multiplied.
fn product(l: Type, r: Type, assigns: bool) -> Option<Type> {
    let ((scalar, lc, lr), (_, rc, rr)) = (l.numeric()?, r.numeric()?);
    let result = match (l.is_matrix(), r.is_matrix()) {
        (true, true) if lc == rr => Type::matrix(rc, lr),
        (true, false) if r.is_vector() && lc == rr => Type::vector(scalar, lr),
        (false, true) if l.is_vector() && lr == rr => Type::vector(scalar, rc),
        (true, true) => return None,
        (true, false) if r.is_vector() => return None,
        (false, true) if l.is_vector() => return None,
        _ if l.is_scalar() => r,
        _ if r.is_scalar() || lr == rr => l,
        _ => return None,
    };
    (!assigns || result == l).then_some(result)
}

/// `l * r` where one is a matrix; matrices are stored column by column.
fn multiply(lt: Type, l: &[Value], rt: Type, r: &[Value]) -> Option<Vec<Value>> {
    let ((_, lc, lr), (_, rc, rr)) = (lt.numeric()?, rt.numeric()?);
    let f = |v: Option<&Value>| v.map_or(0.0, |v| v.as_float());
    if lt.is_scalar() || rt.is_scalar() {
        let (many, one) = if lt.is_scalar() {
            (r, f(l.first()))
        } else {
            (l, f(r.first()))
        };
        return Some(
            many.iter()
                .map(|v| Value::Float(v.as_float() * one))
                .collect(),
        );
    }
    // A vector on the left is a row, on the right a column.
    let (rows, inner) = if lt.is_vector() { (1, lr) } else { (lr, lc) };
    let columns = if rt.is_vector() { 1 } else { rc };
    let _ = rr;
    let mut out = Vec::new();
    for c in 0..columns as usize {
        for row in 0..rows as usize {
            let sum = (0..inner as usize)
                .map(|k| f(l.get(k * rows as usize + row)) * f(r.get(c * inner as usize + k)))
                .sum();
            out.push(Value::Float(sum));
        }
    }
    Some(out)
}

/// One scalar operation. Division by zero and the like give what ANGLE gives.
fn fold_scalar(op: BinaryOp, l: Value, r: Value) -> Value {
    use BinaryOp as B;
    match (op, l, r) {
        (B::And, l, r) => Value::Bool(l.as_bool() && r.as_bool()),
        (B::Or, l, r) => Value::Bool(l.as_bool() || r.as_bool()),
        (B::Xor, l, r) => Value::Bool(l.as_bool() != r.as_bool()),
        (B::ShiftLeft | B::ShiftRight, l, r) => fold_shift(op, l, r),
        (_, Value::Float(l), Value::Float(r)) => fold_float(op, l, r),
        (_, Value::Uint(l), Value::Uint(r)) => fold_uint(op, l, r),
        (_, Value::Int(l), Value::Int(r)) => fold_int(op, l, r),
        (_, l, _) => l,
    }
}

fn fold_float(op: BinaryOp, l: f32, r: f32) -> Value {
    use BinaryOp as B;
    Value::Float(match op {
        B::Mul => l * r,
        B::Div => l / r,
        B::Add => l + r,
        B::Sub => l - r,
        B::Less => return Value::Bool(l < r),
        B::Greater => return Value::Bool(l > r),
        // Not the same where one is no number.
        B::LessEqual => return Value::Bool(!matches!(l.partial_cmp(&r), Some(Ordering::Greater))),
        B::GreaterEqual => return Value::Bool(!matches!(l.partial_cmp(&r), Some(Ordering::Less))),
        _ => l,
    })
}

fn fold_uint(op: BinaryOp, l: u32, r: u32) -> Value {
    use BinaryOp as B;
    Value::Uint(match op {
        B::Mul => l.wrapping_mul(r),
        B::Div => l.checked_div(r).unwrap_or(u32::MAX),
        B::Rem => l.checked_rem(r).unwrap_or(u32::MAX),
        B::Add => l.wrapping_add(r),
        B::Sub => l.wrapping_sub(r),
        B::BitAnd => l & r,
        B::BitOr => l | r,
        B::BitXor => l ^ r,
        B::Less => return Value::Bool(l < r),
        B::Greater => return Value::Bool(l > r),
        B::LessEqual => return Value::Bool(l <= r),
        B::GreaterEqual => return Value::Bool(l >= r),
        _ => l,
    })
}

fn fold_int(op: BinaryOp, l: i32, r: i32) -> Value {
    use BinaryOp as B;
    Value::Int(match op {
        B::Mul => l.wrapping_mul(r),
        B::Div => l.checked_div(r).unwrap_or(i32::MAX),
        B::Rem if r == 0 => i32::MAX,
        B::Rem if l < 0 || r < 0 => 0,
        B::Rem => l.wrapping_rem(r),
        B::Add => l.wrapping_add(r),
        B::Sub => l.wrapping_sub(r),
        B::BitAnd => l & r,
        B::BitOr => l | r,
        B::BitXor => l ^ r,
        B::Less => return Value::Bool(l < r),
        B::Greater => return Value::Bool(l > r),
        B::LessEqual => return Value::Bool(l <= r),
        B::GreaterEqual => return Value::Bool(l >= r),
        _ => l,
    })
}

fn fold_shift(op: BinaryOp, l: Value, r: Value) -> Value {
    let by = match r {
        Value::Uint(v) => v as i64,
        v => v.as_int() as i64,
    };
    let in_range = (0..32).contains(&by);
    let left = op == BinaryOp::ShiftLeft;
    match l {
        Value::Uint(_) if !in_range => Value::Uint(0),
        _ if !in_range => Value::Int(0),
        Value::Uint(v) => Value::Uint(if left { v << by } else { v >> by }),
        v => Value::Int(if left {
            v.as_int() << by
        } else {
            v.as_int() >> by
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_multiply_column_by_column() {
        let values = |v: &[f32]| v.iter().map(|&x| Value::Float(x)).collect::<Vec<_>>();
        let m = values(&[1.0, 2.0, 3.0, 4.0]);
        let v = values(&[5.0, 6.0]);
        let (mat, vec) = (Type::matrix(2, 2), Type::vector(Scalar::Float, 2));
        assert_eq!(multiply(mat, &m, vec, &v), Some(values(&[23.0, 34.0])));
        assert_eq!(multiply(vec, &v, mat, &m), Some(values(&[17.0, 39.0])));
        assert_eq!(
            multiply(mat, &m, mat, &m),
            Some(values(&[7.0, 10.0, 15.0, 22.0]))
        );
    }

    #[test]
    fn products_have_the_shape_that_section_5_9_gives() {
        let vec = |n| Type::vector(Scalar::Float, n);
        assert_eq!(product(Type::matrix(2, 3), vec(2), false), Some(vec(3)));
        assert_eq!(product(vec(3), Type::matrix(2, 3), false), Some(vec(2)));
        assert_eq!(
            product(Type::matrix(2, 3), Type::matrix(4, 2), false),
            Some(Type::matrix(4, 3))
        );
        assert_eq!(product(vec(2), vec(3), false), None);
        assert_eq!(product(vec(3), Type::matrix(2, 3), true), None);
    }
}
