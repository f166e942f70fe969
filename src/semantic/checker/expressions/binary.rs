//! Operators between two operands (GLSL ES 3.00 section 5.9).

use crate::checker::*;
use crate::constant::Value;
use std::cmp::Ordering;

impl Checker<'_> {
    pub(in crate::checker) fn binary(
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
        match typing::binary(self.types(), op, l.ty, r.ty) {
            Ok(ty) => {
                if op.is_bitwise() || op == BinaryOp::Rem {
                    self.require(Feature::IntegerOperators, id);
                }
                let constant = if l.is_const && r.is_const {
                    self.fold_binary(op, l, r)
                } else {
                    Constant::NONE
                };
                self.result(ty, [l, r], constant)
            }
            Err(mismatch) => {
                let unknown = self.refuse(id, &[left, right], mismatch);
                match mismatch {
                    // A comparison of vectors may be meant for each component.
                    TypeMismatch::Operands(Clash::NeedsScalar) => unknown,
                    _ => self.poisoned(op),
                }
            }
        }
    }

    /// The result of an operator whose operands were reported.
    fn poisoned(&self, op: BinaryOp) -> ExprInfo {
        if op.compares() || op.is_logical() {
            ExprInfo::wrong(Type::BOOL)
        } else {
            ExprInfo::ERROR
        }
    }

    pub(super) fn fold_binary(&mut self, op: BinaryOp, l: ExprInfo, r: ExprInfo) -> Constant {
        let left = self.pool.values(l.constant);
        let right = self.pool.values(r.constant);
        if left.is_empty() || right.is_empty() {
            return Constant::NONE;
        }
        // A short expression can compare two large arrays: the work is limited.
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

/// One scalar operation. Division by zero and similar cases have the results of ANGLE.
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
        // Not equal if one is NaN.
        B::LessEqual => return Value::Bool(!matches!(l.partial_cmp(&r), Some(Ordering::Greater))),
        B::GreaterEqual => return Value::Bool(!matches!(l.partial_cmp(&r), Some(Ordering::Less))),
        _ => l,
    })
}

/// Folds operations of integers. Undefined quotients are the largest number, and undefined remainders 0.
macro_rules! fold_integers {
    ($name:ident, $integer:ident, $value:ident) => {
        fn $name(op: BinaryOp, l: $integer, r: $integer) -> Value {
            use BinaryOp as B;
            Value::$value(match op {
                B::Mul => l.wrapping_mul(r),
                B::Div => l.checked_div(r).unwrap_or($integer::MAX),
                B::Rem if r == 0 => $integer::MAX,
                B::Rem if i64::from(l) < 0 || i64::from(r) < 0 => 0,
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
    };
}

fold_integers!(fold_uint, u32, Uint);
fold_integers!(fold_int, i32, Int);

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
    fn matrices_are_multiplied_by_columns() {
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
}
