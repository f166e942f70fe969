//! Lowering of built-in functions.
//!
//! The expansions follow SwiftShader, the software renderer of Chromium: `normalize` multiplies by
//! the reciprocal square root, `mix(a, b, t)` is `(b - a) * t + a`.

use super::emit::{Compiler, Made, Regs, Value};
use super::op::less;
use crate::bytecode::{F1, F2, F3, FaultCheck, Reg};
use crate::options::Watch;
use shaderlint_ir::OpId;
use shaderlint_ir::expand::{self, Arithmetic, Operator};
use shaderlint_semantic::builtins::{Axis, BuiltinId, BuiltinKind};
use shaderlint_semantic::{Scalar, Type};

impl Compiler<'_> {
    /// Compiles a call of a built-in function. Returns its value.
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
                    c.check(id, FaultCheck::Neighbours, a, &[a]);
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
        // `mix` with a boolean third argument selects.
        let chooses = third == Some(Scalar::Bool);
        let recipe = recipe(function, scalar, arguments.len(), chooses);
        let Some(made) = self.follow(id, recipe, operands, &arguments) else {
            return self.refuse(format!("`{}`", function.name()));
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

    /// Records the comparison that a scalar `step` or `smoothstep` performs: whether the value is
    /// past the edge.
    fn watch_threshold(&mut self, id: OpId, function: BuiltinId, arguments: &[Regs]) {
        if let Some((value, edge)) = function.comparison(arguments)
            && (edge.len, value.len) == (1, 1)
        {
            let (edge, value) = (self.reg(edge, 0), self.reg(value, 0));
            let result = self.s2(F2::Less, edge, value);
            self.watch_comparison(id, result, [value, edge], Scalar::Float);
        }
    }

    /// Adds fault checks to the results of a function.
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
            self.check(id, FaultCheck::Float, *result, &operands);
        }
    }

    /// Retains the registers of a result, and releases the intermediate ones.
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

    /// Emits a function by its recipe; `None` if the arguments do not fit.
    fn follow(
        &mut self,
        id: OpId,
        recipe: Recipe,
        operands: &[OpId],
        arguments: &[Regs],
    ) -> Option<Vec<Reg>> {
        let count = arguments.iter().map(|a| a.len).max()?;
        let argument = |k: usize| arguments.get(k).copied().unwrap_or_default();
        let (a, b, c) = (argument(0), argument(1), argument(2));
        let size = operands
            .first()
            .and_then(|op| self.module.ty(*op).numeric());
        let (columns, rows) =
            size.map_or((1, 1), |(_, columns, rows)| (columns.into(), rows.into()));
        Some(match recipe {
            Recipe::One(f) => self.each(count, |c, n| {
                let a = c.spread(a, n);
                c.s1(f, a)
            }),
            Recipe::Two(f) => self.each(count, |c, n| {
                let (a, b) = (c.spread(a, n), c.spread(b, n));
                c.s2(f, a, b)
            }),
            Recipe::Swapped(f) => self.each(count, |c, n| {
                let (a, b) = (c.spread(b, n), c.spread(a, n));
                c.s2(f, a, b)
            }),
            Recipe::Three(f, [i, j, k]) => self.each(count, |c, n| {
                let [a, b, t] = [i, j, k].map(|k| c.spread(argument(k), n));
                c.s3(f, a, b, t)
            }),
            Recipe::Times(factor) => {
                let factor = self.float(factor);
                self.each(count, |c, n| {
                    let a = c.spread(a, n);
                    c.s2(F2::Multiply, a, factor)
                })
            }
            Recipe::Clamp(low, high) => self.each(count, |each, n| {
                let (x, from, to) = (each.spread(a, n), each.spread(b, n), each.spread(c, n));
                let x = each.s2(low, x, from);
                each.s2(high, x, to)
            }),
            Recipe::SameBits => self.each(count, |c, n| c.spread(a, n)),
            Recipe::AllOf(f) => vec![self.all_of(f, a)],
            Recipe::Pack(f) => {
                let (low, high) = (self.reg(a, 0), self.reg(a, 1));
                vec![self.s2(f, low, high)]
            }
            Recipe::Unpack(low, high) => {
                let a = self.reg(a, 0);
                vec![self.s1(low, a), self.s1(high, a)]
            }
            Recipe::Dot => vec![self.dot(a, b)],
            Recipe::Length => vec![self.length(a)],
            Recipe::Distance => vec![self.distance(a, b)],
            Recipe::Cross => self.cross(a, b),
            Recipe::Normalize => self.normalize(a),
            Recipe::Modf => self.modf(id, a),
            Recipe::Transpose => {
                let transposed = (0..rows).flat_map(|r| (0..columns).map(move |c| c * rows + r));
                transposed.map(|n| self.reg(a, n)).collect()
            }
            Recipe::OuterProduct => self.outer_product(a, b),
            Recipe::FaceForward | Recipe::Reflect | Recipe::Refract => {
                self.bent(recipe, [a, b, c])?
            }
            Recipe::Determinant => vec![self.determinant(a, columns as usize)?],
            Recipe::Inverse => self.inverse(a, columns as usize)?,
            Recipe::Apart => return None,
        })
    }

    /// Reduces all components to one.
    fn all_of(&mut self, f: F2, a: Regs) -> Reg {
        let mut made = self.reg(a, 0);
        for n in 1..a.len {
            let next = self.reg(a, n);
            made = self.s2(f, made, next);
        }
        made
    }

    fn outer_product(&mut self, column: Regs, row: Regs) -> Vec<Reg> {
        let cells = (0..row.len).flat_map(|c| (0..column.len).map(move |r| (r, c)));
        let product = |(r, c)| {
            let (x, y) = (self.reg(column, r), self.reg(row, c));
            self.s2(F2::Multiply, x, y)
        };
        cells.map(product).collect()
    }

    /// `faceforward`, `reflect` and `refract`.
    fn bent(&mut self, recipe: Recipe, arguments: [Regs; 3]) -> Option<Vec<Reg>> {
        let [a, b, c] = arguments.map(|regs| self.list(regs).to_vec());
        Some(match recipe {
            Recipe::FaceForward => expand::face_forward(self, [&a, &b, &c]),
            Recipe::Reflect => expand::reflect(self, &a, &b),
            _ => expand::refract(self, &a, &b, *c.first()?),
        })
    }

    fn distance(&mut self, a: Regs, b: Regs) -> Reg {
        let difference = self.each(a.len, |c, n| {
            let (a, b) = (c.reg(a, n), c.reg(b, n));
            c.s2(F2::Subtract, a, b)
        });
        let difference = self.listed(difference);
        self.length(difference)
    }

    fn normalize(&mut self, a: Regs) -> Vec<Reg> {
        let square = self.dot(a, a);
        let inverse = self.s1(F1::InverseSqrt, square);
        self.each(a.len, |c, n| {
            let a = c.reg(a, n);
            c.s2(F2::Multiply, a, inverse)
        })
    }

    /// `modf`: returns the fractional part; the integer part is written back to the second
    /// parameter.
    fn modf(&mut self, id: OpId, a: Regs) -> Vec<Reg> {
        let integral = self.each(a.len, |c, n| {
            let a = c.reg(a, n);
            c.one(F1::Trunc, a)
        });
        let made = self.each(a.len, |c, n| {
            let integral = integral.get(n as usize).copied().unwrap_or(0);
            let a = c.reg(a, n);
            c.s2(F2::Subtract, a, integral)
        });
        let integral = self.listed(integral);
        self.taken_back.insert((id, 1), Value::Regs(integral));
        made
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
            let (left, right) = (c.s2(F2::Multiply, ai, bj), c.s2(F2::Multiply, aj, bi));
            c.s2(F2::Subtract, left, right)
        })
    }

    fn determinant(&mut self, a: Regs, size: usize) -> Option<Reg> {
        let cells = self.list(a).to_vec();
        expand::determinant(self, &cells, size)
    }

    fn inverse(&mut self, a: Regs, size: usize) -> Option<Vec<Reg>> {
        let cells = self.list(a).to_vec();
        let determinant = self.determinant(a, size)?;
        let one = self.float(1.0);
        let scale = self.s2(F2::Divide, one, determinant);
        let cofactors = expand::adjugate(self, &cells, size)?.into_iter();
        Some(cofactors.map(|c| self.s2(F2::Multiply, c, scale)).collect())
    }
}

impl Arithmetic for Compiler<'_> {
    type Value = Reg;

    fn number(&mut self, value: f32) -> Reg {
        self.float(value)
    }

    fn binary(&mut self, op: Operator, left: Reg, right: Reg) -> Reg {
        let f = match op {
            Operator::Add => F2::Add,
            Operator::Subtract => F2::Subtract,
            Operator::Multiply => F2::Multiply,
            Operator::Less => F2::Less,
        };
        self.s2(f, left, right)
    }

    fn negated(&mut self, value: Reg) -> Reg {
        self.s1(F1::Negate, value)
    }

    fn sqrt(&mut self, value: Reg) -> Reg {
        self.s1(F1::Sqrt, value)
    }

    fn choose(&mut self, condition: Reg, then: Reg, otherwise: Reg) -> Reg {
        self.s3(F3::Select, condition, then, otherwise)
    }

    fn dot(&mut self, left: &[Reg], right: &[Reg]) -> Reg {
        let pairs: Vec<(Reg, Reg)> = left.iter().copied().zip(right.iter().copied()).collect();
        self.products(&pairs)
    }
}

/// The expansion of a built-in function.
#[derive(Clone, Copy)]
enum Recipe {
    /// A unary operation per component.
    One(F1),
    /// A binary operation per component.
    Two(F2),
    /// A binary operation per component, with swapped operands.
    Swapped(F2),
    /// A ternary operation per component, on the arguments with these indices.
    Three(F3, [usize; 3]),
    /// Multiplication by a constant.
    Times(f32),
    /// The second operation after the first (`max`, then `min`).
    Clamp(F2, F2),
    /// A reinterpretation of the bits as a float.
    SameBits,
    /// A reduction of all components by a binary operation.
    AllOf(F2),
    /// Packs two components into one.
    Pack(F2),
    /// Unpacks one component into two.
    Unpack(F1, F1),
    /// Expansions of several instructions.
    Dot,
    Length,
    Distance,
    Cross,
    Normalize,
    FaceForward,
    Reflect,
    Refract,
    Modf,
    Transpose,
    OuterProduct,
    Determinant,
    Inverse,
    /// Texture lookups and derivatives, which are handled separately.
    Apart,
}

/// The recipe of a function, by the scalar type of its first argument and the number of arguments;
/// `chooses` if the third argument is boolean. The match is exhaustive, so that a new function
/// needs a recipe.
#[rustfmt::skip]
fn recipe(function: BuiltinId, scalar: Scalar, arguments: usize, chooses: bool) -> Recipe {
    use BuiltinId as B;
    use Recipe::*;
    let pi = std::f32::consts::PI;
    let is_float = scalar == Scalar::Float;
    let by_kind = |float: F2, uint: F2, int: F2| match scalar {
        Scalar::Float => float, Scalar::Uint => uint, _ => int,
    };
    let min = by_kind(F2::Min, F2::UintMin, F2::IntMin);
    let max = by_kind(F2::Max, F2::UintMax, F2::IntMax);
    match function {
        B::Radians => Times(pi / 180.0), B::Degrees => Times(180.0 / pi),
        B::Sin => One(F1::Sin), B::Cos => One(F1::Cos), B::Tan => One(F1::Tan),
        B::Asin => One(F1::Asin), B::Acos => One(F1::Acos),
        B::Atan if arguments == 1 => One(F1::Atan), B::Atan => Two(F2::Atan2),
        B::Sinh => One(F1::Sinh), B::Cosh => One(F1::Cosh), B::Tanh => One(F1::Tanh),
        B::Asinh => One(F1::Asinh), B::Acosh => One(F1::Acosh), B::Atanh => One(F1::Atanh),
        B::Pow => Two(F2::Pow), B::Exp => One(F1::Exp), B::Log => One(F1::Log),
        B::Exp2 => One(F1::Exp2), B::Log2 => One(F1::Log2),
        B::Sqrt => One(F1::Sqrt), B::InverseSqrt => One(F1::InverseSqrt),
        B::Abs => One(if is_float { F1::Abs } else { F1::IntAbs }),
        B::Sign => One(if is_float { F1::Sign } else { F1::IntSign }),
        B::Floor => One(F1::Floor), B::Trunc => One(F1::Trunc), B::Ceil => One(F1::Ceil),
        B::Round | B::RoundEven => One(F1::RoundEven), B::Fract => One(F1::Fract),
        B::Mod => Two(F2::Modulo), B::Modf => Modf,
        B::Min => Two(min), B::Max => Two(max), B::Clamp => Clamp(max, min),
        B::Mix if chooses => Three(F3::Select, [2, 1, 0]), B::Mix => Three(F3::Mix, [0, 1, 2]),
        B::Step => Two(F2::Step), B::Smoothstep => Three(F3::Smoothstep, [0, 1, 2]),
        B::IsNan => One(F1::IsNan), B::IsInf => One(F1::IsInf),
        B::FloatBitsToInt | B::FloatBitsToUint => One(F1::BitsOfFloat),
        B::IntBitsToFloat | B::UintBitsToFloat => SameBits,
        B::PackSnorm2x16 => Pack(F2::PackSnorm), B::PackUnorm2x16 => Pack(F2::PackUnorm),
        B::PackHalf2x16 => Pack(F2::PackHalf),
        B::UnpackSnorm2x16 => Unpack(F1::SnormLow, F1::SnormHigh),
        B::UnpackUnorm2x16 => Unpack(F1::UnormLow, F1::UnormHigh),
        B::UnpackHalf2x16 => Unpack(F1::HalfLow, F1::HalfHigh),
        B::Length => Length, B::Distance => Distance, B::Dot => Dot, B::Cross => Cross,
        B::Normalize => Normalize, B::FaceForward => FaceForward, B::Reflect => Reflect,
        B::Refract => Refract, B::MatrixCompMult => Two(F2::Multiply),
        B::OuterProduct => OuterProduct, B::Transpose => Transpose,
        B::Determinant => Determinant, B::Inverse => Inverse,
        B::LessThan => Two(less(scalar, false)), B::LessThanEqual => Two(less(scalar, true)),
        B::GreaterThan => Swapped(less(scalar, false)),
        B::GreaterThanEqual => Swapped(less(scalar, true)),
        B::Equal => Two(if is_float { F2::Equal } else { F2::SameBits }),
        B::NotEqual => Two(if is_float { F2::NotEqual } else { F2::OtherBits }),
        B::Any => AllOf(F2::Or), B::All => AllOf(F2::And), B::Not => One(F1::Not),
        B::TextureSize | B::Texture | B::TextureOffset | B::TextureLod | B::TextureLodOffset
        | B::TextureGrad | B::TextureGradOffset | B::TextureProj | B::TextureProjOffset
        | B::TextureProjLod | B::TextureProjLodOffset | B::TextureProjGrad
        | B::TextureProjGradOffset | B::TexelFetch | B::TexelFetchOffset | B::Texture2D
        | B::Texture2DProj | B::Texture2DLod | B::Texture2DProjLod | B::TextureCube
        | B::TextureCubeLod | B::Texture2DLodExt | B::Texture2DProjLodExt | B::TextureCubeLodExt
        | B::Texture2DGradExt | B::Texture2DProjGradExt | B::TextureCubeGradExt
        | B::InterpolateAtCentroid | B::InterpolateAtSample | B::InterpolateAtOffset
        | B::DFdx | B::DFdy | B::Fwidth => Apart,
    }
}
