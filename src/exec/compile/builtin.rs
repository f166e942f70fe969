//! Built-in functions.
//!
//! What they are made of follows SwiftShader, which draws without a GPU in the browser: `normalize`
//! multiplies by the reciprocal of the root, `mix(a, b, t)` is `(b - a) * t + a`.

use super::Watch;
use super::emit::{Compiler, Made, Regs, Value};
use super::op::less;
use crate::code::{Checked, F1, F2, F3, Reg};
use shaderlint_ir::OpId;
use shaderlint_semantic::builtins::{Axis, BuiltinId, BuiltinKind};
use shaderlint_semantic::{Scalar, Type};

impl Compiler<'_> {
    /// A call of a built-in function; gives what it returns.
    pub fn builtin(
        &mut self,
        id: OpId,
        function: BuiltinId,
        operands: &[OpId],
        ty: Type,
    ) -> Made<Value> {
        match function.kind() {
            BuiltinKind::Lookup(lookup) => return self.lookup(lookup, operands, ty),
            BuiltinKind::Size => return self.size(operands),
            BuiltinKind::Derivative(axis) => {
                let a = self.operand(*operands.first()?);
                let made = self.each(a.len, |c, n| {
                    let a = c.reg(a, n);
                    c.check(id, Checked::Neighbours, a, &[a]);
                    c.derivative(axis, a)
                });
                return self.given(made);
            }
            BuiltinKind::Math => {}
        }
        let arguments: Vec<Regs> = operands.iter().map(|op| self.operand(*op)).collect();
        let scalar = operands.first().and_then(|op| self.module.scalar(*op));
        let scalar = scalar.unwrap_or(Scalar::Float);
        let third = operands.get(2).and_then(|op| self.module.scalar(*op));
        // `mix` with truth values chooses.
        let chooses = third == Some(Scalar::Bool);
        let made = match self.by_component(function, scalar, chooses, &arguments) {
            Some(made) => made,
            None => self.whole(id, function, operands, &arguments)?,
        };
        if self.watches(Watch::Comparisons) {
            self.watch_threshold(id, function, &arguments);
        }
        if self.watches(Watch::Faults) {
            for n in 0..made.len() as u32 {
                let operands: Vec<Reg> = arguments.iter().map(|a| self.spread(*a, n)).collect();
                self.watch_operands(id, function.undefined(), scalar, &operands);
            }
            if ty.scalar_kind() == Some(Scalar::Float) {
                self.watch_results(id, &made, &arguments);
            }
        }
        self.given(made)
    }

    /// Has what `step` and `smoothstep` of a scalar compare looked at: whether it is past the edge.
    fn watch_threshold(&mut self, id: OpId, function: BuiltinId, arguments: &[Regs]) {
        if let Some((value, edge)) = function.comparison(arguments)
            && (edge.len, value.len) == (1, 1)
        {
            let (edge, value) = (self.reg(edge, 0), self.reg(value, 0));
            let result = self.s2(F2::Less, edge, value);
            self.watch_comparison(id, result, [value, edge], Scalar::Float);
        }
    }

    /// Has what a function gives looked at.
    fn watch_results(&mut self, id: OpId, made: &[Reg], arguments: &[Regs]) {
        let is_each = arguments
            .iter()
            .all(|a| a.len == made.len() as u32 || a.len == 1);
        for (n, result) in (0..).zip(made) {
            let operands: Vec<Reg> = match is_each {
                true => arguments.iter().map(|a| self.spread(*a, n)).collect(),
                false => arguments
                    .iter()
                    .flat_map(|a| self.list(*a))
                    .copied()
                    .collect(),
            };
            self.check(id, Checked::Float, *result, &operands);
        }
    }

    /// The registers of a result, held once; what was made on the way is given back.
    fn given(&mut self, made: Vec<Reg>) -> Made<Value> {
        made.iter().for_each(|reg| self.registers.retain(*reg));
        for reg in std::mem::take(&mut self.scratch) {
            self.registers.release(reg);
        }
        Some(Value::Regs(self.listed(made)))
    }

    fn s1(&mut self, f: F1, a: Reg) -> Reg {
        let made = self.one(f, a);
        self.scratch.push(made);
        made
    }

    pub fn s2(&mut self, f: F2, a: Reg, b: Reg) -> Reg {
        let made = self.two(f, a, b);
        self.scratch.push(made);
        made
    }

    fn s3(&mut self, f: F3, a: Reg, b: Reg, c: Reg) -> Reg {
        let made = self.three(f, a, b, c);
        self.scratch.push(made);
        made
    }

    fn products(&mut self, pairs: &[(Reg, Reg)]) -> Reg {
        let made = self.sum_of_products(pairs);
        self.scratch.push(made);
        made
    }

    fn each(&mut self, count: u32, mut make: impl FnMut(&mut Self, u32) -> Reg) -> Vec<Reg> {
        (0..count).map(|n| make(self, n)).collect()
    }

    fn derivative(&mut self, axis: Axis, a: Reg) -> Reg {
        match axis {
            Axis::X => self.s1(F1::DifferenceX, a),
            Axis::Y => self.s1(F1::DifferenceY, a),
            Axis::Both => {
                let x = self.s1(F1::DifferenceX, a);
                let y = self.s1(F1::DifferenceY, a);
                let (x, y) = (self.s1(F1::Abs, x), self.s1(F1::Abs, y));
                self.s2(F2::Add, x, y)
            }
        }
    }

    /// Functions that work on each component by itself; `None` for others.
    fn by_component(
        &mut self,
        function: BuiltinId,
        scalar: Scalar,
        chooses: bool,
        arguments: &[Regs],
    ) -> Option<Vec<Reg>> {
        use BuiltinId as B;
        let count = arguments.iter().map(|a| a.len).max()?;
        let at = |c: &Self, k: usize, n: u32| {
            let regs = arguments.get(k).copied().unwrap_or_default();
            c.spread(regs, n)
        };
        if let (Some(f), 1) = (one_of(function, scalar), arguments.len()) {
            return Some(self.each(count, |c, n| {
                let a = at(c, 0, n);
                c.s1(f, a)
            }));
        }
        if let (Some(f), 2) = (two_of(function, scalar), arguments.len()) {
            return Some(self.each(count, |c, n| {
                let (a, b) = (at(c, 0, n), at(c, 1, n));
                c.s2(f, a, b)
            }));
        }
        let made = match function {
            B::GreaterThan | B::GreaterThanEqual => {
                let f = less(scalar, function == B::GreaterThanEqual);
                self.each(count, |c, n| {
                    let (a, b) = (at(c, 1, n), at(c, 0, n));
                    c.s2(f, a, b)
                })
            }
            B::Radians | B::Degrees => {
                let pi = std::f32::consts::PI;
                let factor = match function {
                    B::Radians => pi / 180.0,
                    _ => 180.0 / pi,
                };
                let factor = self.float(factor);
                self.each(count, |c, n| {
                    let a = at(c, 0, n);
                    c.s2(F2::Multiply, a, factor)
                })
            }
            B::Clamp => {
                let (low, high) = match scalar {
                    Scalar::Float => (F2::Max, F2::Min),
                    Scalar::Uint => (F2::UintMax, F2::UintMin),
                    _ => (F2::IntMax, F2::IntMin),
                };
                self.each(count, |c, n| {
                    let (x, a, b) = (at(c, 0, n), at(c, 1, n), at(c, 2, n));
                    let x = c.s2(low, x, a);
                    c.s2(high, x, b)
                })
            }
            B::Mix | B::Smoothstep => {
                let [a, b, t] = arguments else {
                    return None;
                };
                self.each(count, |c, n| {
                    let (a, b, t) = (c.spread(*a, n), c.spread(*b, n), c.spread(*t, n));
                    match function {
                        B::Mix if chooses => c.s3(F3::Select, t, b, a),
                        B::Mix => c.s3(F3::Mix, a, b, t),
                        _ => c.s3(F3::Smoothstep, a, b, t),
                    }
                })
            }
            B::FloatBitsToInt | B::FloatBitsToUint | B::IntBitsToFloat | B::UintBitsToFloat => {
                self.each(count, |c, n| at(c, 0, n))
            }
            _ => return None,
        };
        Some(made)
    }

    /// Functions of whole values.
    fn whole(
        &mut self,
        id: OpId,
        function: BuiltinId,
        operands: &[OpId],
        arguments: &[Regs],
    ) -> Made<Vec<Reg>> {
        use BuiltinId as B;
        let none = Regs::default();
        let (a, b) = match *arguments {
            [] => (none, none),
            [a] => (a, none),
            [a, b, ..] => (a, b),
        };
        let size = operands
            .first()
            .and_then(|op| self.module.ty(*op).numeric());
        let (_, columns, rows) = size.unwrap_or((Scalar::Float, 1, 1));
        Some(match function {
            B::Length => vec![self.length(a)],
            B::Distance => {
                let difference = self.each(a.len, |c, n| {
                    let (a, b) = (c.reg(a, n), c.reg(b, n));
                    c.s2(F2::Subtract, a, b)
                });
                let difference = self.listed(difference);
                vec![self.length(difference)]
            }
            B::Dot => vec![self.dot(a, b)],
            B::Cross => self.cross(a, b),
            B::Normalize => {
                let square = self.dot(a, a);
                let inverse = self.s1(F1::InverseSqrt, square);
                self.each(a.len, |c, n| {
                    let a = c.reg(a, n);
                    c.s2(F2::Multiply, a, inverse)
                })
            }
            B::FaceForward | B::Reflect | B::Refract => self.bent(function, arguments),
            B::Any | B::All => {
                let f = if function == B::Any { F2::Or } else { F2::And };
                let mut made = self.reg(a, 0);
                for n in 1..a.len {
                    let next = self.reg(a, n);
                    made = self.s2(f, made, next);
                }
                vec![made]
            }
            B::Modf => {
                let whole = self.each(a.len, |c, n| {
                    let a = c.reg(a, n);
                    c.one(F1::Trunc, a)
                });
                let made = self.each(a.len, |c, n| {
                    let whole = whole.get(n as usize).copied().unwrap_or(0);
                    let a = c.reg(a, n);
                    c.s2(F2::Subtract, a, whole)
                });
                let whole = self.listed(whole);
                self.taken_back.insert((id, 1), Value::Regs(whole));
                made
            }
            _ => return self.of_matrices(function, [columns, rows], a, b),
        })
    }

    /// Functions of matrices.
    fn of_matrices(
        &mut self,
        function: BuiltinId,
        [columns, rows]: [u8; 2],
        a: Regs,
        b: Regs,
    ) -> Made<Vec<Reg>> {
        use BuiltinId as B;
        Some(match function {
            B::OuterProduct => {
                let mut made = Vec::new();
                for c in 0..b.len {
                    for r in 0..a.len {
                        let (x, y) = (self.reg(a, r), self.reg(b, c));
                        made.push(self.s2(F2::Multiply, x, y));
                    }
                }
                made
            }
            B::Transpose => {
                let (columns, rows) = (columns as u32, rows as u32);
                let turned = (0..rows).flat_map(|r| (0..columns).map(move |c| c * rows + r));
                turned.map(|n| self.reg(a, n)).collect()
            }
            B::Determinant => {
                let m = self.list(a).to_vec();
                vec![self.determinant(&m, columns as usize)]
            }
            B::Inverse => {
                let m = self.list(a).to_vec();
                self.inverse(&m, columns as usize)
            }
            _ => return self.of_bits(function, a),
        })
    }

    /// Functions that pack two numbers into one.
    fn of_bits(&mut self, function: BuiltinId, a: Regs) -> Made<Vec<Reg>> {
        use BuiltinId as B;
        Some(match function {
            B::PackHalf2x16 | B::PackSnorm2x16 | B::PackUnorm2x16 => {
                let f = match function {
                    B::PackHalf2x16 => F2::PackHalf,
                    B::PackSnorm2x16 => F2::PackSnorm,
                    _ => F2::PackUnorm,
                };
                let (low, high) = (self.reg(a, 0), self.reg(a, 1));
                vec![self.s2(f, low, high)]
            }
            B::UnpackHalf2x16 | B::UnpackSnorm2x16 | B::UnpackUnorm2x16 => {
                let (low, high) = match function {
                    B::UnpackHalf2x16 => (F1::HalfLow, F1::HalfHigh),
                    B::UnpackSnorm2x16 => (F1::SnormLow, F1::SnormHigh),
                    _ => (F1::UnormLow, F1::UnormHigh),
                };
                let a = self.reg(a, 0);
                vec![self.s1(low, a), self.s1(high, a)]
            }
            other => return self.refuse(format!("`{}`", other.name())),
        })
    }

    fn dot(&mut self, a: Regs, b: Regs) -> Reg {
        let pairs: Vec<(Reg, Reg)> = (0..a.len)
            .map(|n| (self.reg(a, n), self.reg(b, n)))
            .collect();
        self.products(&pairs)
    }

    fn length(&mut self, a: Regs) -> Reg {
        if a.len == 1 {
            let a = self.reg(a, 0);
            return self.s1(F1::Abs, a);
        }
        let square = self.dot(a, a);
        self.s1(F1::Sqrt, square)
    }

    fn cross(&mut self, a: Regs, b: Regs) -> Vec<Reg> {
        self.each(3, |c, n| {
            let (i, j) = ((n + 1) % 3, (n + 2) % 3);
            let (ai, aj, bi, bj) = (c.reg(a, i), c.reg(a, j), c.reg(b, i), c.reg(b, j));
            c.difference_of_products(ai, bj, aj, bi)
        })
    }

    fn difference_of_products(&mut self, a: Reg, b: Reg, c: Reg, d: Reg) -> Reg {
        let (left, right) = (self.s2(F2::Multiply, a, b), self.s2(F2::Multiply, c, d));
        self.s2(F2::Subtract, left, right)
    }

    /// `faceforward`, `reflect` and `refract`.
    fn bent(&mut self, function: BuiltinId, arguments: &[Regs]) -> Vec<Reg> {
        let (Some(&first), Some(&second)) = (arguments.first(), arguments.get(1)) else {
            return Vec::new();
        };
        let third = arguments.get(2).copied().unwrap_or_default();
        let zero = self.constant(0);
        match function {
            BuiltinId::FaceForward => {
                let product = self.dot(third, second);
                let faces = self.s2(F2::Less, product, zero);
                self.each(first.len, |c, n| {
                    let along = c.reg(first, n);
                    let against = c.s1(F1::Negate, along);
                    c.s3(F3::Select, faces, along, against)
                })
            }
            BuiltinId::Reflect => {
                let product = self.dot(first, second);
                let twice = self.s2(F2::Add, product, product);
                self.each(first.len, |c, n| {
                    let (i, normal) = (c.reg(first, n), c.reg(second, n));
                    let back = c.s2(F2::Multiply, twice, normal);
                    c.s2(F2::Subtract, i, back)
                })
            }
            _ => {
                let (eta, one) = (self.reg(third, 0), self.float(1.0));
                let product = self.dot(second, first);
                let square = self.s2(F2::Multiply, product, product);
                let rest = self.s2(F2::Subtract, one, square);
                let eta_square = self.s2(F2::Multiply, eta, eta);
                let scaled = self.s2(F2::Multiply, eta_square, rest);
                let k = self.s2(F2::Subtract, one, scaled);
                let is_total = self.s2(F2::Less, k, zero);
                let root = self.s1(F1::Sqrt, k);
                let along = self.s2(F2::Multiply, eta, product);
                let along = self.s2(F2::Add, along, root);
                self.each(first.len, |c, n| {
                    let (i, normal) = (c.reg(first, n), c.reg(second, n));
                    let kept = c.s2(F2::Multiply, eta, i);
                    let bent = c.s2(F2::Multiply, along, normal);
                    let made = c.s2(F2::Subtract, kept, bent);
                    c.s3(F3::Select, is_total, zero, made)
                })
            }
        }
    }

    /// The matrix of `size` columns without a column and a row.
    fn minor(m: &[Reg], size: usize, column: usize, row: usize) -> Vec<Reg> {
        let kept = (0..size * size).filter(|n| n / size != column && n % size != row);
        kept.filter_map(|n| m.get(n).copied()).collect()
    }

    fn determinant(&mut self, m: &[Reg], size: usize) -> Reg {
        match *m {
            [one] => one,
            [a, b, c, d] => self.difference_of_products(a, d, c, b),
            _ => {
                let mut sum: Option<Reg> = None;
                for (column, factor) in m.iter().step_by(size).copied().enumerate() {
                    let minor = Self::minor(m, size, column, 0);
                    let inner = self.determinant(&minor, size - 1);
                    let term = self.s2(F2::Multiply, factor, inner);
                    sum = Some(match sum {
                        None => term,
                        Some(sum) if column % 2 == 1 => self.s2(F2::Subtract, sum, term),
                        Some(sum) => self.s2(F2::Add, sum, term),
                    });
                }
                sum.unwrap_or(0)
            }
        }
    }

    fn inverse(&mut self, m: &[Reg], size: usize) -> Vec<Reg> {
        let determinant = self.determinant(m, size);
        let one = self.float(1.0);
        let scale = self.s2(F2::Divide, one, determinant);
        let mut made = Vec::with_capacity(size * size);
        for column in 0..size {
            for row in 0..size {
                let minor = Self::minor(m, size, row, column);
                let mut cofactor = self.determinant(&minor, size - 1);
                if (column + row) % 2 == 1 {
                    cofactor = self.s1(F1::Negate, cofactor);
                }
                made.push(self.s2(F2::Multiply, cofactor, scale));
            }
        }
        made
    }
}

/// The instruction of a function with one argument.
#[rustfmt::skip]
fn one_of(function: BuiltinId, scalar: Scalar) -> Option<F1> {
    use BuiltinId as B;
    Some(match (function, scalar) {
        (B::Sin, _) => F1::Sin, (B::Cos, _) => F1::Cos, (B::Tan, _) => F1::Tan,
        (B::Asin, _) => F1::Asin, (B::Acos, _) => F1::Acos, (B::Atan, _) => F1::Atan,
        (B::Sinh, _) => F1::Sinh, (B::Cosh, _) => F1::Cosh, (B::Tanh, _) => F1::Tanh,
        (B::Asinh, _) => F1::Asinh, (B::Acosh, _) => F1::Acosh, (B::Atanh, _) => F1::Atanh,
        (B::Exp, _) => F1::Exp, (B::Log, _) => F1::Log,
        (B::Exp2, _) => F1::Exp2, (B::Log2, _) => F1::Log2,
        (B::Sqrt, _) => F1::Sqrt, (B::InverseSqrt, _) => F1::InverseSqrt,
        (B::Abs, Scalar::Float) => F1::Abs, (B::Abs, _) => F1::IntAbs,
        (B::Sign, Scalar::Float) => F1::Sign, (B::Sign, _) => F1::IntSign,
        (B::Floor, _) => F1::Floor, (B::Trunc, _) => F1::Trunc, (B::Ceil, _) => F1::Ceil,
        (B::Round | B::RoundEven, _) => F1::RoundEven, (B::Fract, _) => F1::Fract,
        (B::IsNan, _) => F1::IsNan, (B::IsInf, _) => F1::IsInf, (B::Not, _) => F1::Not,
        _ => return None,
    })
}

/// The instruction of a function with two arguments.
#[rustfmt::skip]
fn two_of(function: BuiltinId, scalar: Scalar) -> Option<F2> {
    use BuiltinId as B;
    Some(match (function, scalar) {
        (B::Atan, _) => F2::Atan2, (B::Mod, _) => F2::Modulo, (B::Pow, _) => F2::Pow,
        (B::Step, _) => F2::Step, (B::MatrixCompMult, _) => F2::Multiply,
        (B::Min, Scalar::Float) => F2::Min, (B::Max, Scalar::Float) => F2::Max,
        (B::Min, Scalar::Uint) => F2::UintMin, (B::Max, Scalar::Uint) => F2::UintMax,
        (B::Min, _) => F2::IntMin, (B::Max, _) => F2::IntMax,
        (B::LessThan, _) => less(scalar, false), (B::LessThanEqual, _) => less(scalar, true),
        (B::Equal, Scalar::Float) => F2::Equal, (B::NotEqual, Scalar::Float) => F2::NotEqual,
        (B::Equal, _) => F2::SameBits, (B::NotEqual, _) => F2::OtherBits,
        _ => return None,
    })
}
