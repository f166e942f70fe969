//! Arithmetic instructions.

use super::following::Following;
use super::{Bank, Vm};
use crate::bytecode::{F1, F2, F3, Instr, Reg};
use crate::gpu_profile;
use crate::row::{PARTS, Row, bit_select, floats, inlined, of_floats, of_signed, signed, truth};
use fearless_simd::{f32x8, mask32x8, prelude::*, u32x8};
use shaderlint_math as math;

/// The registers, for operations on eight lanes at a time with the instructions `S`.
struct Parts<'b, S> {
    simd: S,
    bank: &'b mut Bank,
}

impl<S: Simd> Parts<'_, S> {
    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    #[inline(always)]
    fn part(&self, reg: Reg, part: usize) -> u32x8<S> {
        self.bank[reg as usize].part(self.simd, part)
    }

    #[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
    #[inline(always)]
    fn set(&mut self, reg: Reg, part: usize, bits: u32x8<S>) {
        self.bank[reg as usize].set_part(part, bits);
    }

    /// A unary operation on bits.
    #[inline(always)]
    fn one(&mut self, to: Reg, a: Reg, f: impl Fn(u32x8<S>) -> u32x8<S>) {
        for part in 0..PARTS {
            self.set(to, part, f(self.part(a, part)));
        }
    }

    /// A binary operation on bits.
    #[inline(always)]
    fn two(&mut self, [to, a, b]: [Reg; 3], f: impl Fn(u32x8<S>, u32x8<S>) -> u32x8<S>) {
        for part in 0..PARTS {
            self.set(to, part, f(self.part(a, part), self.part(b, part)));
        }
    }

    /// A ternary operation on bits.
    #[inline(always)]
    fn three(
        &mut self,
        [to, a, b, c]: [Reg; 4],
        f: impl Fn(u32x8<S>, u32x8<S>, u32x8<S>) -> u32x8<S>,
    ) {
        for part in 0..PARTS {
            let [a, b, c] = [a, b, c].map(|reg| self.part(reg, part));
            self.set(to, part, f(a, b, c));
        }
    }

    /// A unary operation on floats.
    #[inline(always)]
    fn float_one(&mut self, to: Reg, a: Reg, f: impl Fn(f32x8<S>) -> f32x8<S>) {
        self.one(to, a, inlined!(|a| of_floats(f(floats(a)))));
    }

    /// A binary operation on floats.
    #[inline(always)]
    fn float_two(&mut self, regs: [Reg; 3], f: impl Fn(f32x8<S>, f32x8<S>) -> f32x8<S>) {
        self.two(regs, inlined!(|a, b| of_floats(f(floats(a), floats(b)))));
    }

    /// A comparison of floats.
    #[inline(always)]
    fn float_test(&mut self, regs: [Reg; 3], f: impl Fn(f32x8<S>, f32x8<S>) -> mask32x8<S>) {
        self.two(regs, inlined!(|a, b| truth(f(floats(a), floats(b)))));
    }

    /// A ternary operation on floats.
    #[inline(always)]
    fn float_three(
        &mut self,
        regs: [Reg; 4],
        f: impl Fn(f32x8<S>, f32x8<S>, f32x8<S>) -> f32x8<S>,
    ) {
        self.three(
            regs,
            inlined!(|a, b, c| of_floats(f(floats(a), floats(b), floats(c)))),
        );
    }

    /// A binary operation on floats, and all that follow with the same operation.
    #[inline(always)]
    fn float_twos(
        &mut self,
        following: &mut Following<'_>,
        (f, mut regs): (F2, [Reg; 3]),
        apply: impl Fn(f32x8<S>, f32x8<S>) -> f32x8<S>,
    ) {
        loop {
            self.float_two(regs, &apply);
            let next = following.next_if(|instr| match instr {
                Instr::Two(other, to, a, b) if other == f => Some([to, a, b]),
                _ => None,
            });
            match next {
                Some(next) => regs = next,
                None => return,
            }
        }
    }
}

impl Vm<'_> {
    /// Executes an instruction that does not jump.
    #[inline(always)]
    pub(super) fn straight<S: Simd>(
        &mut self,
        simd: S,
        instr: &Instr,
        following: &mut Following<'_>,
    ) {
        match *instr {
            Instr::MoveActive(to, a) if self.active != u32::MAX => self.move_active(simd, to, a),
            Instr::Move(to, a) | Instr::MoveActive(to, a) => self.parts(simd).one(to, a, |a| a),
            Instr::Two(f, to, a, b) => apply_two(self.parts(simd), following, f, [to, a, b]),
            Instr::Three(f, to, a, b, c) => {
                apply_three(self.parts(simd), following, f, [to, a, b, c]);
            }
            Instr::One(f, to, a) => apply_one(self.parts(simd), f, to, a),
            Instr::Word(to, at) => {
                let bits = self.draw.memory.get(at as usize).copied().unwrap_or(0);
                self.set(to, Row::splat(bits));
            }
            Instr::Gather { to, index, site } => self.gather(to, index, site),
            Instr::Scatter { from, index, site } => self.scatter(from, index, site),
            Instr::Table { to, index, site } => self.table(to, index, site),
            Instr::Lookup(site) => self.ask(site),
            Instr::Enter(number) => self.watched.enter(number, self.active),
            Instr::Iterate(number) => {
                self.expand();
                self.watched.iterate(number, &self.expanded);
            }
            Instr::Exhaust(number, condition) => {
                let ends = self.active & !self.mask(simd, condition);
                self.watched.exhaust(number, ends & self.requested);
            }
            Instr::Leave(number) => self.watched.leave(number, self.requested),
            Instr::Branch(number, condition) => {
                let holds = self.mask(simd, condition);
                self.expand();
                self.watched.branch(number, &self.expanded, holds);
            }
            Instr::Spend { cost, by } => {
                self.expand();
                self.watched.spend([cost, by], &self.expanded);
            }
            Instr::Trace(site) => self.record(site),
            Instr::Check(check_operands) => self.check_operands(simd, check_operands),
            Instr::Compare(number) => self.compare(simd, number),
            _ => {}
        }
    }

    #[inline(always)]
    fn parts<S: Simd>(&mut self, simd: S) -> Parts<'_, S> {
        Parts {
            simd,
            bank: &mut self.bank,
        }
    }

    /// Copies the active lanes.
    #[inline(always)]
    fn move_active<S: Simd>(&mut self, simd: S, to: Reg, a: Reg) {
        self.expand();
        let mut parts = Parts {
            simd,
            bank: &mut self.bank,
        };
        for part in 0..PARTS {
            let lanes = self.expanded.lanes.part(simd, part);
            let made = bit_select(lanes, parts.part(a, part), parts.part(to, part));
            parts.set(to, part, made);
        }
    }
}

/// As [`apply_two`].
#[inline(always)]
fn apply_one<S: Simd>(mut parts: Parts<'_, S>, f: F1, to: Reg, a: Reg) {
    match f {
        F1::Negate => parts.float_one(to, a, |x| -x),
        F1::Abs => parts.float_one(to, a, |x| x.abs()),
        F1::Sqrt => parts.float_one(to, a, inlined!(|x| math::sqrt(x))),
        F1::Not => parts.one(to, a, |a| !a),
        _ => apply_one_rarer(parts, f, to, a),
    }
}

#[inline(never)]
fn apply_one_rarer<S: Simd>(parts: Parts<'_, S>, f: F1, to: Reg, a: Reg) {
    parts.simd.vectorize(
        #[inline(always)]
        || rarer_one(parts, f, to, a),
    );
}

#[inline(always)]
fn rarer_one<S: Simd>(mut parts: Parts<'_, S>, f: F1, to: Reg, a: Reg) {
    use math as m;
    match f {
        F1::Sign => parts.float_one(to, a, inlined!(|x| m::sign(x))),
        F1::Floor => parts.float_one(to, a, inlined!(|x| m::floor(x))),
        F1::Ceil => parts.float_one(to, a, inlined!(|x| m::ceil(x))),
        F1::Trunc => parts.float_one(to, a, inlined!(|x| m::trunc(x))),
        F1::RoundEven => parts.float_one(to, a, inlined!(|x| m::round_even(x))),
        F1::Fract => parts.float_one(to, a, inlined!(|x| m::fract(x))),
        F1::InverseSqrt => parts.float_one(to, a, inlined!(|x| m::inverse_sqrt(x))),
        F1::Sin => parts.float_one(to, a, inlined!(|x| m::sin(x))),
        F1::Cos => parts.float_one(to, a, inlined!(|x| m::cos(x))),
        F1::Tan => parts.float_one(to, a, inlined!(|x| m::tan(x))),
        F1::Asin => parts.float_one(to, a, inlined!(|x| m::asin(x))),
        F1::Acos => parts.float_one(to, a, inlined!(|x| m::acos(x))),
        F1::Atan => parts.float_one(to, a, inlined!(|x| m::atan(x))),
        F1::Sinh => parts.float_one(to, a, inlined!(|x| m::sinh(x))),
        F1::Cosh => parts.float_one(to, a, inlined!(|x| m::cosh(x))),
        F1::Tanh => parts.float_one(to, a, inlined!(|x| m::tanh(x))),
        F1::Asinh => parts.float_one(to, a, inlined!(|x| m::asinh(x))),
        F1::Acosh => parts.float_one(to, a, inlined!(|x| m::acosh(x))),
        F1::Atanh => parts.float_one(to, a, inlined!(|x| m::atanh(x))),
        F1::Exp => parts.float_one(to, a, inlined!(|x| m::exp(x))),
        F1::Log => parts.float_one(to, a, inlined!(|x| m::log(x))),
        F1::Exp2 => parts.float_one(to, a, inlined!(|x| m::exp2(x))),
        F1::Log2 => parts.float_one(to, a, inlined!(|x| m::log2(x))),
        F1::IsNan => parts.one(to, a, |a| truth(floats(a).is_nan())),
        F1::IsInf => parts.one(to, a, |a| truth(floats(a).is_infinite())),
        F1::BitsOfFloat => parts.one(to, a, |a| {
            let nan = u32x8::splat(a.token(), math::bits_of(f32::NAN));
            bit_select(truth(floats(a).is_nan()), nan, a)
        }),
        F1::IntNegate => parts.one(to, a, |a| 0 - a),
        F1::IntAbs => parts.one(to, a, inlined!(|a| of_signed(signed(a).abs()))),
        F1::IntSign => parts.one(to, a, |a| {
            let (low, high) = (truth(signed(a).simd_lt(0)), truth(signed(a).simd_gt(0)));
            low - high
        }),
        F1::FloatOfInt => parts.one(to, a, inlined!(|a| of_floats(m::float_of_int(signed(a))))),
        F1::FloatOfUint => parts.one(to, a, inlined!(|a| of_floats(m::float_of_uint(a)))),
        F1::IntOfFloat => parts.one(to, a, inlined!(|a| of_signed(m::int_of_float(floats(a))))),
        F1::UintOfFloat => parts.one(to, a, inlined!(|a| m::uint_of_float(floats(a)))),
        F1::HalfLow => unpacked(parts, to, a, inlined!(|p| m::unpack_half(p)), 0),
        F1::HalfHigh => unpacked(parts, to, a, inlined!(|p| m::unpack_half(p)), 1),
        F1::SnormLow => unpacked(parts, to, a, inlined!(|p| m::unpack_snorm(p)), 0),
        F1::SnormHigh => unpacked(parts, to, a, inlined!(|p| m::unpack_snorm(p)), 1),
        F1::UnormLow => unpacked(parts, to, a, inlined!(|p| m::unpack_unorm(p)), 0),
        F1::UnormHigh => unpacked(parts, to, a, inlined!(|p| m::unpack_unorm(p)), 1),
        F1::Half => parts.float_one(to, a, |x| {
            let [low, _] = m::unpack_half(m::pack_half(x, x));
            low
        }),
        F1::DifferenceX => parts.one(to, a, inlined!(|a| difference(a, 1))),
        F1::DifferenceY => parts.one(to, a, inlined!(|a| difference(a, 2))),
        // Part of the loop.
        F1::Negate | F1::Abs | F1::Sqrt | F1::Not => {}
    }
}

/// One of the two halves of a packed value.
#[inline(always)]
fn unpacked<S: Simd>(
    mut parts: Parts<'_, S>,
    to: Reg,
    a: Reg,
    f: impl Fn(u32x8<S>) -> [f32x8<S>; 2],
    half: usize,
) {
    parts.one(to, a, |a| {
        let [low, high] = f(a);
        of_floats(if half == 0 { low } else { high })
    });
}

/// The derivative of each quad, for all of its lanes: a neighbour of the first lane minus the first
/// lane, as software renderers in browsers compute it. The specification permits one derivative per
/// quad.
#[inline(always)]
fn difference<S: Simd>(a: u32x8<S>, neighbour: usize) -> u32x8<S> {
    let lanes: [f32; 8] = floats(a).into();
    let mut made = [0.0; 8];
    for (quad, lanes) in made.chunks_exact_mut(4).zip(lanes.chunks_exact(4)) {
        let at = |n: usize| lanes.get(n).copied().unwrap_or(0.0);
        quad.fill(at(neighbour) - at(0));
    }
    of_floats(made.simd_into(a.token()))
}

/// The most frequent binary operations are part of the VM's loop: a call took longer than they do.
#[inline(always)]
fn apply_two<S: Simd>(
    mut parts: Parts<'_, S>,
    following: &mut Following<'_>,
    f: F2,
    regs: [Reg; 3],
) {
    use math as m;
    match f {
        F2::Add => parts.float_twos(following, (F2::Add, regs), |x, y| x + y),
        F2::Subtract => parts.float_twos(following, (F2::Subtract, regs), |x, y| x - y),
        F2::Multiply => parts.float_twos(following, (F2::Multiply, regs), |x, y| x * y),
        F2::Divide => parts.float_two(regs, |x, y| x / y),
        F2::Min => parts.float_two(regs, inlined!(|x, y| m::min(x, y))),
        F2::Max => parts.float_two(regs, inlined!(|x, y| m::max(x, y))),
        F2::Less => parts.float_test(regs, |x, y| x.simd_lt(y)),
        F2::LessEqual => parts.float_test(regs, |x, y| x.simd_le(y)),
        F2::IntAdd => parts.two(regs, |a, b| a + b),
        F2::IntLess => parts.two(regs, |a, b| truth(signed(a).simd_lt(signed(b)))),
        F2::And => parts.two(regs, |a, b| a & b),
        F2::Or => parts.two(regs, |a, b| a | b),
        F2::Xor => parts.two(regs, |a, b| a ^ b),
        _ => apply_two_rarer(parts, f, regs),
    }
}

#[inline(never)]
fn apply_two_rarer<S: Simd>(parts: Parts<'_, S>, f: F2, regs: [Reg; 3]) {
    parts.simd.vectorize(
        #[inline(always)]
        || rarer_two(parts, f, regs),
    );
}

#[inline(always)]
fn rarer_two<S: Simd>(mut parts: Parts<'_, S>, f: F2, regs: [Reg; 3]) {
    use math as m;
    match f {
        F2::MinNumber => parts.float_two(regs, inlined!(|x, y| m::min_number(x, y))),
        F2::MaxNumber => parts.float_two(regs, inlined!(|x, y| m::max_number(x, y))),
        F2::Modulo => parts.float_two(regs, inlined!(|x, y| m::modulo(x, y))),
        F2::Pow => parts.float_two(regs, inlined!(|x, y| m::pow(x, y))),
        F2::Atan2 => parts.float_two(regs, inlined!(|x, y| m::atan2(x, y))),
        F2::Step => parts.float_two(regs, inlined!(|x, y| m::step(x, y))),
        F2::Equal => parts.float_test(regs, |x, y| x.simd_eq(y)),
        F2::NotEqual => parts.float_test(regs, |x, y| !x.simd_eq(y)),
        F2::IntSubtract => parts.two(regs, |a, b| a - b),
        F2::IntMultiply => parts.two(regs, |a, b| a * b),
        F2::IntDivide => parts.two(
            regs,
            inlined!(|a, b| of_signed(m::divide_int(signed(a), signed(b)))),
        ),
        F2::IntRemainder => parts.two(
            regs,
            inlined!(|a, b| of_signed(m::remainder_int(signed(a), signed(b)))),
        ),
        F2::UintDivide => parts.two(regs, inlined!(|a, b| m::divide_uint(a, b))),
        F2::UintRemainder => parts.two(regs, inlined!(|a, b| m::remainder_uint(a, b))),
        F2::IntLessEqual => parts.two(regs, |a, b| truth(signed(a).simd_le(signed(b)))),
        F2::UintLess => parts.two(regs, |a, b| truth(a.simd_lt(b))),
        F2::UintLessEqual => parts.two(regs, |a, b| truth(a.simd_le(b))),
        F2::SameBits => parts.two(regs, |a, b| truth(a.simd_eq(b))),
        F2::OtherBits => parts.two(regs, |a, b| truth(!a.simd_eq(b))),
        F2::ShiftLeft => parts.two(regs, inlined!(|a, b| m::shift_left(a, b))),
        F2::ShiftRight => parts.two(
            regs,
            inlined!(|a, b| of_signed(m::shift_right_int(signed(a), b))),
        ),
        F2::ShiftRightUnsigned => parts.two(regs, inlined!(|a, b| m::shift_right_uint(a, b))),
        F2::IntMin => parts.two(regs, inlined!(|a, b| of_signed(signed(a).min(signed(b))))),
        F2::IntMax => parts.two(regs, inlined!(|a, b| of_signed(signed(a).max(signed(b))))),
        F2::UintMin => parts.two(regs, |a, b| a.min(b)),
        F2::UintMax => parts.two(regs, |a, b| a.max(b)),
        F2::Imprecise(what, direction) => parts.float_two(
            regs,
            inlined!(|x, y| gpu_profile::imprecise(what, direction, x, y)),
        ),
        F2::PackHalf => parts.two(regs, inlined!(|a, b| m::pack_half(floats(a), floats(b)))),
        F2::PackSnorm => parts.two(regs, inlined!(|a, b| m::pack_snorm(floats(a), floats(b)))),
        F2::PackUnorm => parts.two(regs, inlined!(|a, b| m::pack_unorm(floats(a), floats(b)))),
        // Part of the loop.
        F2::Add | F2::Subtract | F2::Multiply | F2::Divide | F2::Min | F2::Max => {}
        F2::Less | F2::LessEqual | F2::IntAdd | F2::IntLess | F2::And | F2::Or | F2::Xor => {}
    }
}

/// As [`apply_two`].
#[inline(always)]
fn apply_three<S: Simd>(
    mut parts: Parts<'_, S>,
    following: &mut Following<'_>,
    f: F3,
    mut regs: [Reg; 4],
) {
    match f {
        F3::MultiplyAdd => loop {
            parts.float_three(regs, |a, b, c| a * b + c);
            let next = following.next_if(|instr| match instr {
                Instr::Three(F3::MultiplyAdd, to, a, b, c) => Some([to, a, b, c]),
                _ => None,
            });
            match next {
                Some(next) => regs = next,
                None => return,
            }
        },
        F3::Select => parts.three(regs, inlined!(|a, b, c| bit_select(a, b, c))),
        F3::Mix => parts.float_three(regs, inlined!(|x, y, z| math::mix(x, y, z))),
        F3::Smoothstep => parts.float_three(regs, inlined!(|x, y, z| math::smoothstep(x, y, z))),
    }
}
