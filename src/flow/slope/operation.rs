//! Operations without control flow, as nodes.

use super::execute::{Executed, ScalarValues, SymbolicExecution};
use super::form::{ScalarFunction, ScalarId};
use super::verdict::SlopeObstacle;
use shaderlint_ir::{Binary, Op, OpId, OpKind, Unary};
use shaderlint_semantic::builtins::BuiltinId;
use shaderlint_semantic::{Scalar as Kind, Type};
use std::f64::consts::{LN_2, PI};

impl SymbolicExecution<'_> {
    /// The value of an operation without side effects.
    pub fn compute(&mut self, id: OpId, op: &Op) -> Executed<ScalarValues> {
        Ok(match op.kind {
            OpKind::Unary(unary, a) => {
                let values = self.values(a)?;
                values.into_iter().map(|a| self.unary(unary, a)).collect()
            }
            OpKind::Binary(binary, a, b) => {
                let kind = self.module.ty(a).scalar_kind();
                let (a, b) = (self.values(a)?, self.values(b)?);
                let both = a.into_iter().zip(b);
                let both: Vec<(ScalarId, ScalarId)> = both.collect();
                let made = both.into_iter().map(|(a, b)| {
                    let value = self.binary(binary, kind, a, b);
                    self.without_overflow(kind, value)
                });
                made.collect()
            }
            OpKind::MatrixProduct(a, b) => self.matrix_product(a, b)?,
            OpKind::Same {
                negated,
                left,
                right,
            } => {
                let (a, b) = (self.values(left)?, self.values(right)?);
                let mut all = self.scalars.truth(true);
                for (a, b) in a.into_iter().zip(b) {
                    let same = self.is_equal(a, b);
                    all = self.scalars.and(all, same);
                }
                vec![if negated { self.scalars.not(all) } else { all }]
            }
            OpKind::Select {
                condition,
                then,
                otherwise,
            } => {
                let condition = self.values(condition)?.first().copied();
                let (a, b) = (self.values(then)?, self.values(otherwise)?);
                let Some(condition) = condition else {
                    return Err(self.blocked(SlopeObstacle::Value));
                };
                let is_condition = op.ty.scalar_kind() == Some(Kind::Bool);
                let both = a.into_iter().zip(b);
                let select = |(a, b)| match is_condition {
                    true => self.scalars.select_condition(condition, a, b),
                    false => self.scalars.select(condition, a, b),
                };
                both.map(select).collect()
            }
            OpKind::Convert(a) => {
                let from = self.module.ty(a).scalar_kind();
                let values = self.values(a)?;
                let to = op.ty.scalar_kind();
                values
                    .into_iter()
                    .map(|a| self.convert(a, from, to))
                    .collect()
            }
            _ => self.compose(id, op)?,
        })
    }

    /// The value of an operation that selects or joins components, or calls a built-in function.
    fn compose(&mut self, id: OpId, op: &Op) -> Executed<ScalarValues> {
        Ok(match op.kind {
            OpKind::Splat(a) => {
                let value = self.values(a)?.first().copied();
                let value = value.ok_or_else(|| self.blocked(SlopeObstacle::Value))?;
                vec![value; op.ty.components() as usize]
            }
            OpKind::Swizzle(a, lanes) => {
                let values = self.values(a)?;
                let all = lanes
                    .numbers()
                    .iter()
                    .map(|n| values.get(*n as usize).copied());
                let all: Option<ScalarValues> = all.collect();
                all.ok_or_else(|| self.blocked(SlopeObstacle::Value))?
            }
            OpKind::Compose(list) => {
                let mut all = ScalarValues::new();
                for operand in self.module.operands(list) {
                    all.extend(self.values(*operand)?);
                }
                all
            }
            OpKind::Extract(a, index) => self.part(a, index)?,
            OpKind::ExtractComputed { base, index } => {
                let known = self.values(index)?;
                match known.first().and_then(|id| self.scalars.value(*id)) {
                    Some(known) if known >= 0.0 => self.part(base, known as u32)?,
                    _ => {
                        let mut operands = self.values(base)?;
                        operands.extend(known);
                        self.any_of(op.ty, &operands)
                    }
                }
            }
            OpKind::Builtin(function, list) => self.builtin(function, list, op.ty)?,
            _ => {
                let mut operands = Vec::new();
                self.module
                    .each_operand(id, |operand| operands.push(operand));
                let mut all = ScalarValues::new();
                for operand in operands {
                    all.extend(self.values(operand)?);
                }
                self.any_of(op.ty, &all)
            }
        })
    }

    /// A value of which is known only what it depends on.
    fn any_of(&mut self, ty: Type, operands: &[ScalarId]) -> ScalarValues {
        let count = ty.components() * ty.array.max(1);
        match operands.iter().any(|id| self.scalars.varies(*id)) {
            true => self.unknown(count),
            false => self.fixed(count),
        }
    }

    fn part(&mut self, base: OpId, index: u32) -> Executed<ScalarValues> {
        let values = self.values(base)?;
        let part = self.layout.part(self.module.ty(base), index);
        let part = part.and_then(|part| {
            let first = part.scalar? as usize;
            let count = self.layout.scalars(part.ty)? as usize;
            values.get(first..first + count).map(<[ScalarId]>::to_vec)
        });
        part.ok_or_else(|| self.blocked(SlopeObstacle::Value))
    }

    fn unary(&mut self, unary: Unary, a: ScalarId) -> ScalarId {
        match unary {
            Unary::Negate => self.scalars.negate(a),
            Unary::Not => self.scalars.not(a),
            Unary::BitNot => self.any_of_one(&[a]),
        }
    }

    fn any_of_one(&mut self, operands: &[ScalarId]) -> ScalarId {
        match operands.iter().any(|id| self.scalars.varies(*id)) {
            true => self.scalars.unknown(),
            false => self.scalars.fixed(super::interval::RealSpan::ANY),
        }
    }

    fn binary(&mut self, binary: Binary, kind: Option<Kind>, a: ScalarId, b: ScalarId) -> ScalarId {
        let is_integer = kind.is_some_and(Kind::is_integer);
        let s = &mut *self.scalars;
        match binary {
            Binary::Add => s.add(a, b),
            Binary::Subtract => s.subtract(a, b),
            Binary::Multiply => s.multiply(a, b),
            Binary::Divide if !is_integer => s.divide(a, b),
            Binary::Divide | Binary::Remainder => match (s.value(a), s.value(b)) {
                (Some(a), Some(b)) if b != 0.0 => {
                    let whole = (a / b).trunc();
                    let is_quotient = binary == Binary::Divide;
                    s.number(if is_quotient { whole } else { a - b * whole })
                }
                _ => self.any_of_one(&[a, b]),
            },
            Binary::Less => s.is_less(a, b),
            Binary::Greater => s.is_less(b, a),
            Binary::LessEqual => {
                let above = s.is_less(b, a);
                s.not(above)
            }
            Binary::GreaterEqual => {
                let below = s.is_less(a, b);
                s.not(below)
            }
            Binary::And => s.and(a, b),
            Binary::Or => s.or(a, b),
            Binary::Xor => {
                let not = s.not(b);
                s.select_condition(a, not, b)
            }
            Binary::ShiftLeft
            | Binary::ShiftRight
            | Binary::BitAnd
            | Binary::BitOr
            | Binary::BitXor => match (s.value(a), s.value(b)) {
                (Some(a), Some(b)) => {
                    let (a, b) = (a as i64, b as i64);
                    let shift = (b & 31) as u32;
                    s.number(match binary {
                        Binary::ShiftLeft => f64::from((a as i32).wrapping_shl(shift)),
                        Binary::ShiftRight => (a >> shift) as f64,
                        Binary::BitAnd => (a & b) as f64,
                        Binary::BitOr => (a | b) as f64,
                        _ => (a ^ b) as f64,
                    })
                }
                _ => self.any_of_one(&[a, b]),
            },
        }
    }

    /// An integer that is known not to overflow; nothing is known of others.
    fn without_overflow(&mut self, kind: Option<Kind>, value: ScalarId) -> ScalarId {
        let (least, most) = match kind {
            Some(Kind::Int) => (f64::from(i32::MIN), f64::from(i32::MAX)),
            Some(Kind::Uint) => (0.0, f64::from(u32::MAX)),
            _ => return value,
        };
        let span = self.scalars.span(value);
        match span.lo >= least && span.hi <= most {
            true => value,
            false => self.any_of_one(&[value]),
        }
    }

    fn is_equal(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let (below, above) = (self.scalars.is_less(a, b), self.scalars.is_less(b, a));
        let differs = self.scalars.or(below, above);
        self.scalars.not(differs)
    }

    fn convert(&mut self, a: ScalarId, from: Option<Kind>, to: Option<Kind>) -> ScalarId {
        match (from, to) {
            (_, Some(Kind::Bool)) => {
                let zero = self.scalars.number(0.0);
                let is_zero = self.is_equal(a, zero);
                self.scalars.not(is_zero)
            }
            (Some(Kind::Float), Some(Kind::Int | Kind::Uint)) => self.truncate(a),
            (Some(Kind::Bool), Some(Kind::Float)) => {
                let (one, zero) = (self.scalars.number(1.0), self.scalars.number(0.0));
                self.scalars.select(a, one, zero)
            }
            _ => a,
        }
    }

    fn truncate(&mut self, a: ScalarId) -> ScalarId {
        let s = &mut *self.scalars;
        let floor = s.of(ScalarFunction::Floor, a);
        let minus = s.negate(a);
        let ceil = s.of(ScalarFunction::Floor, minus);
        let ceil = s.negate(ceil);
        let negative = s.is_negative(a);
        s.select(negative, ceil, floor)
    }

    fn matrix_product(&mut self, left: OpId, right: OpId) -> Executed<ScalarValues> {
        let size = |ty: Type| ty.numeric().map(|(_, columns, rows)| (columns, rows));
        let (ours, theirs) = (self.module.ty(left), self.module.ty(right));
        let (Some((columns, rows)), Some((others, inner))) = (size(ours), size(theirs)) else {
            return Err(self.blocked(SlopeObstacle::Value));
        };
        let (a, b) = (self.values(left)?, self.values(right)?);
        // A vector on the left is a row.
        let (columns, rows) = if columns == 1 {
            (rows, 1)
        } else {
            (columns, rows)
        };
        let (others, inner) = if others == 1 {
            (1, inner)
        } else {
            (others, inner)
        };
        let mut made = ScalarValues::new();
        for column in 0..others {
            for row in 0..rows {
                let mut sum = self.scalars.number(0.0);
                for k in 0..columns.min(inner) {
                    let x = a.get((k * rows + row) as usize).copied();
                    let y = b.get((column * inner + k) as usize).copied();
                    let (Some(x), Some(y)) = (x, y) else {
                        return Err(self.blocked(SlopeObstacle::Value));
                    };
                    let product = self.scalars.multiply(x, y);
                    sum = self.scalars.add(sum, product);
                }
                made.push(sum);
            }
        }
        Ok(made)
    }

    pub fn dot(&mut self, a: &[ScalarId], b: &[ScalarId]) -> ScalarId {
        let mut sum = self.scalars.number(0.0);
        for (a, b) in a.iter().zip(b) {
            let product = self.scalars.multiply(*a, *b);
            sum = self.scalars.add(sum, product);
        }
        sum
    }

    fn length(&mut self, a: &[ScalarId]) -> ScalarId {
        let square = self.dot(a, a);
        self.scalars.of(ScalarFunction::Sqrt, square)
    }

    fn builtin(
        &mut self,
        function: BuiltinId,
        list: shaderlint_syntax::ast::List,
        ty: Type,
    ) -> Executed<ScalarValues> {
        use BuiltinId::*;
        let mut arguments = Vec::new();
        for operand in self.module.operands(list) {
            arguments.push(self.values(*operand)?);
        }
        let vector = |n: usize| arguments.get(n).map_or(&[][..], Vec::as_slice);
        let (first, second) = (vector(0), vector(1));
        let done = match function {
            Length => vec![self.length(first)],
            Distance => {
                let both = first.iter().zip(second);
                let between: ScalarValues =
                    both.map(|(a, b)| self.scalars.subtract(*a, *b)).collect();
                vec![self.length(&between)]
            }
            Dot => vec![self.dot(first, second)],
            Cross => self.cross(first, second),
            Normalize => {
                let length = self.length(first);
                first
                    .iter()
                    .map(|a| self.scalars.divide(*a, length))
                    .collect()
            }
            Reflect => {
                let twice = self.dot(second, first);
                let twice = self.scalars.scale(twice, 2.0);
                let both = first.iter().zip(second);
                let reflected = both.map(|(i, n)| {
                    let back = self.scalars.multiply(twice, *n);
                    self.scalars.subtract(*i, back)
                });
                reflected.collect()
            }
            Transpose => {
                let (columns, rows) = ty.numeric().map_or((1, 1), |(_, c, r)| (c, r));
                let places = (0..columns).flat_map(|c| (0..rows).map(move |r| r * columns + c));
                places
                    .filter_map(|at| first.get(at as usize).copied())
                    .collect()
            }
            Any | All => {
                let mut made = self.scalars.truth(function == All);
                for a in first {
                    made = match function {
                        All => self.scalars.and(made, *a),
                        _ => self.scalars.or(made, *a),
                    };
                }
                vec![made]
            }
            _ => {
                let count = ty.components() as usize;
                let mut made = ScalarValues::new();
                for lane in 0..count {
                    let of = |values: &ScalarValues| {
                        let is_scalar = values.len() == 1;
                        values.get(if is_scalar { 0 } else { lane }).copied()
                    };
                    let lanes: ScalarValues = arguments.iter().filter_map(of).collect();
                    let is_whole = lanes.len() == arguments.len();
                    match is_whole.then(|| self.component(function, &lanes)).flatten() {
                        Some(value) => made.push(value),
                        None => {
                            let all: ScalarValues = arguments.concat();
                            return Ok(self.any_of(ty, &all));
                        }
                    }
                }
                made
            }
        };
        Ok(done)
    }

    fn cross(&mut self, a: &[ScalarId], b: &[ScalarId]) -> ScalarValues {
        let ([x, y, z], [u, v, w]) = (a, b) else {
            return ScalarValues::new();
        };
        let pairs = [(y, w, z, v), (z, u, x, w), (x, v, y, u)];
        let each = pairs.into_iter().map(|(a, b, c, d)| {
            let (first, second) = (self.scalars.multiply(*a, *b), self.scalars.multiply(*c, *d));
            self.scalars.subtract(first, second)
        });
        each.collect()
    }

    /// A component of a built-in function that works on each separately.
    fn component(&mut self, function: BuiltinId, arguments: &[ScalarId]) -> Option<ScalarId> {
        use BuiltinId::*;
        let s = &mut *self.scalars;
        Some(match (function, arguments) {
            (Radians, [a]) => s.scale(*a, PI / 180.0),
            (Degrees, [a]) => s.scale(*a, 180.0 / PI),
            (Sin, [a]) => s.of(ScalarFunction::Sin, *a),
            (Cos, [a]) => s.of(ScalarFunction::Cos, *a),
            (Tan, [a]) => s.of(ScalarFunction::Tan, *a),
            (Asin, [a]) => s.of(ScalarFunction::Asin, *a),
            (Acos, [a]) => s.of(ScalarFunction::Acos, *a),
            (Atan, [a]) => s.of(ScalarFunction::Atan, *a),
            (Atan, [a, b]) => s.arc_tangent(*a, *b),
            (Tanh, [a]) => s.of(ScalarFunction::Tanh, *a),
            (Pow, [a, b]) => s.power(*a, *b),
            (Exp, [a]) => s.of(ScalarFunction::Exp, *a),
            (Log, [a]) => s.of(ScalarFunction::Log, *a),
            (Exp2, [a]) => {
                let scaled = s.scale(*a, LN_2);
                s.of(ScalarFunction::Exp, scaled)
            }
            (Log2, [a]) => {
                let log = s.of(ScalarFunction::Log, *a);
                s.scale(log, 1.0 / LN_2)
            }
            (Sqrt, [a]) => s.of(ScalarFunction::Sqrt, *a),
            (InverseSqrt, [a]) => {
                let root = s.of(ScalarFunction::Sqrt, *a);
                s.product(vec![(root, -1)], 1.0)
            }
            (Abs, [a]) => s.of(ScalarFunction::Abs, *a),
            (Sign, [a]) => {
                let (one, minus, zero) = (s.number(1.0), s.number(-1.0), s.number(0.0));
                let (below, above) = (s.is_negative(*a), s.is_less(zero, *a));
                let rest = s.select(above, one, zero);
                s.select(below, minus, rest)
            }
            (Floor, [a]) => s.of(ScalarFunction::Floor, *a),
            (Trunc, [a]) => self.truncate(*a),
            (Round | RoundEven, [a]) => {
                let half = s.number(0.5);
                let moved = s.add(*a, half);
                s.of(ScalarFunction::Floor, moved)
            }
            (Ceil, [a]) => {
                let minus = s.negate(*a);
                let floor = s.of(ScalarFunction::Floor, minus);
                s.negate(floor)
            }
            (Fract, [a]) => {
                let floor = s.of(ScalarFunction::Floor, *a);
                s.subtract(*a, floor)
            }
            (Mod, [a, b]) => {
                let quotient = s.divide(*a, *b);
                let floor = s.of(ScalarFunction::Floor, quotient);
                let whole = s.multiply(*b, floor);
                s.subtract(*a, whole)
            }
            (Min, [a, b]) => s.min(*a, *b),
            (Max, [a, b]) => s.max(*a, *b),
            (Clamp, [a, lo, hi]) => {
                let above = s.max(*a, *lo);
                s.min(above, *hi)
            }
            _ => return self.blend(function, arguments),
        })
    }

    fn blend(&mut self, function: BuiltinId, arguments: &[ScalarId]) -> Option<ScalarId> {
        use BuiltinId::*;
        let s = &mut *self.scalars;
        Some(match (function, arguments) {
            (Mix, [a, b, t]) => {
                use super::form::ScalarForm::{And, IsNegative, Not};
                if matches!(s.get(*t), And(..) | IsNegative(_) | Not(_)) {
                    return Some(s.select(*t, *b, *a));
                }
                let one = s.number(1.0);
                let rest = s.subtract(one, *t);
                let (a, b) = (s.multiply(*a, rest), s.multiply(*b, *t));
                s.add(a, b)
            }
            (Step, [edge, a]) => {
                let (one, zero) = (s.number(1.0), s.number(0.0));
                let below = s.is_less(*a, *edge);
                s.select(below, zero, one)
            }
            (Smoothstep, [lo, hi, a]) => {
                let (one, zero) = (s.number(1.0), s.number(0.0));
                let (over, width) = (s.subtract(*a, *lo), s.subtract(*hi, *lo));
                let t = s.divide(over, width);
                let t = s.max(t, zero);
                let t = s.min(t, one);
                let three = s.number(3.0);
                let rest = s.combine((three, 1.0), (t, -2.0));
                let square = s.multiply(t, t);
                s.multiply(square, rest)
            }
            (LessThan, [a, b]) => s.is_less(*a, *b),
            (GreaterThan, [a, b]) => s.is_less(*b, *a),
            (LessThanEqual, [a, b]) => {
                let above = s.is_less(*b, *a);
                s.not(above)
            }
            (GreaterThanEqual, [a, b]) => {
                let below = s.is_less(*a, *b);
                s.not(below)
            }
            (Equal, [a, b]) => self.is_equal(*a, *b),
            (NotEqual, [a, b]) => {
                let same = self.is_equal(*a, *b);
                self.scalars.not(same)
            }
            (Not, [a]) => s.not(*a),
            (MatrixCompMult, [a, b]) => s.multiply(*a, *b),
            _ => return None,
        })
    }
}
