//! Arithmetic instructions.

#![expect(clippy::needless_range_loop, reason = "the registers may alias")]

use super::following::Following;
use super::{Bank, Vm};
use crate::bytecode::{F1, F2, F3, Instr, Reg};
use crate::gpu_profile;
use crate::row::{PARTS, Row, floats, of_floats, of_unsigned, unsigned};
use shaderlint_math as math;
use wide::{f32x8, i32x8};

/// The bits of a comparison result in eight lanes.
#[inline(always)]
fn truth(lanes: f32x8) -> i32x8 {
    of_floats(lanes)
}

#[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
#[inline(always)]
fn one(bank: &mut Bank, to: Reg, a: Reg, f: impl Fn(i32x8) -> i32x8) {
    for part in 0..PARTS {
        bank[to as usize][part] = f(bank[a as usize][part]);
    }
}

#[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
#[inline(always)]
fn two(bank: &mut Bank, to: Reg, a: Reg, b: Reg, f: impl Fn(i32x8, i32x8) -> i32x8) {
    for part in 0..PARTS {
        bank[to as usize][part] = f(bank[a as usize][part], bank[b as usize][part]);
    }
}

#[expect(clippy::indexing_slicing, reason = "every register index is in bounds")]
#[inline(always)]
fn three(bank: &mut Bank, [to, a, b, c]: [Reg; 4], f: impl Fn(i32x8, i32x8, i32x8) -> i32x8) {
    for part in 0..PARTS {
        bank[to as usize][part] = f(
            bank[a as usize][part],
            bank[b as usize][part],
            bank[c as usize][part],
        );
    }
}

/// A binary operation on floats, and all that follow with the same operation.
#[inline(always)]
fn float_twos(
    bank: &mut Bank,
    following: &mut Following<'_>,
    (f, mut to, mut a, mut b): (F2, Reg, Reg, Reg),
    apply: impl Fn(f32x8, f32x8) -> f32x8,
) {
    loop {
        float_two(bank, to, a, b, &apply);
        let next = following.next_if(|instr| match instr {
            Instr::Two(other, to, a, b) if other == f => Some((to, a, b)),
            _ => None,
        });
        match next {
            Some(regs) => (to, a, b) = regs,
            None => return,
        }
    }
}

/// A unary operation on floats.
#[inline(always)]
fn float_one(bank: &mut Bank, to: Reg, a: Reg, f: impl Fn(f32x8) -> f32x8) {
    one(bank, to, a, |a| of_floats(f(floats(a))));
}

/// A binary operation on floats.
#[inline(always)]
fn float_two(bank: &mut Bank, to: Reg, a: Reg, b: Reg, f: impl Fn(f32x8, f32x8) -> f32x8) {
    two(bank, to, a, b, |a, b| of_floats(f(floats(a), floats(b))));
}

/// Flips the sign bits, so that a signed comparison orders unsigned numbers.
#[inline(always)]
fn sign_flipped(lanes: i32x8) -> i32x8 {
    lanes ^ i32x8::splat(i32::MIN)
}

impl Vm<'_> {
    /// Executes an instruction that does not jump.
    #[inline(always)]
    pub(super) fn straight(&mut self, instr: &Instr, following: &mut Following<'_>) {
        match *instr {
            Instr::Move(to, a) => self.set(to, Row(self.get(a))),
            Instr::MoveActive(to, a) => {
                if self.active == u32::MAX {
                    self.set(to, Row(self.get(a)));
                } else {
                    let (kept, new) = (self.get(to), self.get(a));
                    let lanes = self.expanded().lanes;
                    let mut made = kept;
                    for (((made, kept), new), lanes) in
                        made.iter_mut().zip(kept).zip(new).zip(lanes)
                    {
                        *made = lanes.bitselect(new, kept);
                    }
                    self.set(to, Row(made));
                }
            }
            Instr::Two(f, to, a, b) => apply_two(&mut self.bank, following, f, [to, a, b]),
            Instr::Three(f, to, a, b, c) => {
                apply_three(&mut self.bank, following, f, [to, a, b, c]);
            }
            Instr::One(f, to, a) => apply_one(&mut self.bank, f, to, a),
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
                self.expanded();
                self.watched.iterate(number, &self.expanded);
            }
            Instr::Exhaust(number, condition) => {
                let ends = self.active & !super::mask_of(&self.get(condition));
                self.watched.exhaust(number, ends & self.requested);
            }
            Instr::Leave(number) => self.watched.leave(number, self.requested),
            Instr::Branch(number, condition) => {
                let holds = super::mask_of(&self.get(condition));
                self.expanded();
                self.watched.branch(number, &self.expanded, holds);
            }
            Instr::Spend { cost, by } => {
                self.expanded();
                self.watched.spend([cost, by], &self.expanded);
            }
            Instr::Check(check_operands) => self.check_operands(check_operands),
            Instr::Compare(number) => self.compare(number),
            _ => {}
        }
    }
}

/// As [`apply_two`].
#[inline(always)]
fn apply_one(bank: &mut Bank, f: F1, to: Reg, a: Reg) {
    match f {
        F1::Negate => float_one(bank, to, a, |x| -x),
        F1::Abs => float_one(bank, to, a, |x| x.abs()),
        F1::Sqrt => float_one(bank, to, a, math::sqrt),
        F1::Not => one(bank, to, a, |a| !a),
        _ => apply_one_rarer(bank, f, to, a),
    }
}

#[inline(never)]
fn apply_one_rarer(bank: &mut Bank, f: F1, to: Reg, a: Reg) {
    use math as m;
    match f {
        F1::Sign => float_one(bank, to, a, m::sign),
        F1::Floor => float_one(bank, to, a, m::floor),
        F1::Ceil => float_one(bank, to, a, m::ceil),
        F1::Trunc => float_one(bank, to, a, m::trunc),
        F1::RoundEven => float_one(bank, to, a, m::round_even),
        F1::Fract => float_one(bank, to, a, m::fract),
        F1::InverseSqrt => float_one(bank, to, a, m::inverse_sqrt),
        F1::Sin => float_one(bank, to, a, m::sin),
        F1::Cos => float_one(bank, to, a, m::cos),
        F1::Tan => float_one(bank, to, a, m::tan),
        F1::Asin => float_one(bank, to, a, m::asin),
        F1::Acos => float_one(bank, to, a, m::acos),
        F1::Atan => float_one(bank, to, a, m::atan),
        F1::Sinh => float_one(bank, to, a, m::sinh),
        F1::Cosh => float_one(bank, to, a, m::cosh),
        F1::Tanh => float_one(bank, to, a, m::tanh),
        F1::Asinh => float_one(bank, to, a, m::asinh),
        F1::Acosh => float_one(bank, to, a, m::acosh),
        F1::Atanh => float_one(bank, to, a, m::atanh),
        F1::Exp => float_one(bank, to, a, m::exp),
        F1::Log => float_one(bank, to, a, m::log),
        F1::Exp2 => float_one(bank, to, a, m::exp2),
        F1::Log2 => float_one(bank, to, a, m::log2),
        F1::IsNan => one(bank, to, a, |a| truth(floats(a).is_nan())),
        F1::IsInf => one(bank, to, a, |a| {
            truth(floats(a).abs().simd_eq(f32x8::splat(f32::INFINITY)))
        }),
        F1::IntNegate => one(bank, to, a, |a| i32x8::ZERO - a),
        F1::IntAbs => one(bank, to, a, |a| a.abs()),
        F1::IntSign => one(bank, to, a, |a| {
            let (low, high) = (a.simd_lt(i32x8::ZERO), a.simd_gt(i32x8::ZERO));
            low - high
        }),
        F1::FloatOfInt => one(bank, to, a, |a| of_floats(m::float_of_int(a))),
        F1::FloatOfUint => one(bank, to, a, |a| of_floats(m::float_of_uint(unsigned(a)))),
        F1::IntOfFloat => one(bank, to, a, |a| m::int_of_float(floats(a))),
        F1::UintOfFloat => one(bank, to, a, |a| of_unsigned(m::uint_of_float(floats(a)))),
        F1::HalfLow => unpacked(bank, to, a, |p| m::unpack_half(unsigned(p)), 0),
        F1::HalfHigh => unpacked(bank, to, a, |p| m::unpack_half(unsigned(p)), 1),
        F1::SnormLow => unpacked(bank, to, a, |p| m::unpack_snorm(unsigned(p)), 0),
        F1::SnormHigh => unpacked(bank, to, a, |p| m::unpack_snorm(unsigned(p)), 1),
        F1::UnormLow => unpacked(bank, to, a, |p| m::unpack_unorm(unsigned(p)), 0),
        F1::UnormHigh => unpacked(bank, to, a, |p| m::unpack_unorm(unsigned(p)), 1),
        F1::Half => float_one(bank, to, a, |x| {
            let [low, _] = m::unpack_half(m::pack_half(x, f32x8::ZERO));
            low
        }),
        F1::DifferenceX => one(bank, to, a, |a| difference(a, 1)),
        F1::DifferenceY => one(bank, to, a, |a| difference(a, 2)),
        // Part of the loop.
        F1::Negate | F1::Abs | F1::Sqrt | F1::Not => {}
    }
}

/// One of the two halves of a packed value.
#[inline(always)]
fn unpacked(bank: &mut Bank, to: Reg, a: Reg, f: impl Fn(i32x8) -> [f32x8; 2], half: usize) {
    one(bank, to, a, |a| {
        let halves = f(a);
        of_floats(halves.get(half).copied().unwrap_or(f32x8::ZERO))
    });
}

/// The derivative of each quad, for all of its lanes: a neighbour of the first lane minus the first
/// lane, as software renderers in browsers compute it. The specification permits one derivative per
/// quad.
#[inline(always)]
fn difference(a: i32x8, neighbour: usize) -> i32x8 {
    let lanes: [f32; 8] = floats(a).to_array();
    let mut made = [0.0; 8];
    for (quad, lanes) in made.chunks_exact_mut(4).zip(lanes.chunks_exact(4)) {
        let at = |n: usize| lanes.get(n).copied().unwrap_or(0.0);
        quad.fill(at(neighbour) - at(0));
    }
    of_floats(f32x8::new(made))
}

/// The most frequent binary operations are part of the VM's loop: a call took longer than they do.
#[inline(always)]
fn apply_two(bank: &mut Bank, following: &mut Following<'_>, f: F2, [to, a, b]: [Reg; 3]) {
    use math as m;
    match f {
        F2::Add => float_twos(bank, following, (F2::Add, to, a, b), |x, y| x + y),
        F2::Subtract => float_twos(bank, following, (F2::Subtract, to, a, b), |x, y| x - y),
        F2::Multiply => float_twos(bank, following, (F2::Multiply, to, a, b), |x, y| x * y),
        F2::Divide => float_two(bank, to, a, b, |x, y| x / y),
        F2::Min => float_two(bank, to, a, b, m::min),
        F2::Max => float_two(bank, to, a, b, m::max),
        F2::Less => float_two(bank, to, a, b, |x, y| x.simd_lt(y)),
        F2::LessEqual => float_two(bank, to, a, b, |x, y| x.simd_le(y)),
        F2::IntAdd => two(bank, to, a, b, |a, b| a + b),
        F2::IntLess => two(bank, to, a, b, |a, b| a.simd_lt(b)),
        F2::And => two(bank, to, a, b, |a, b| a & b),
        F2::Or => two(bank, to, a, b, |a, b| a | b),
        F2::Xor => two(bank, to, a, b, |a, b| a ^ b),
        _ => apply_two_rarer(bank, f, to, a, b),
    }
}

#[inline(never)]
fn apply_two_rarer(bank: &mut Bank, f: F2, to: Reg, a: Reg, b: Reg) {
    use math as m;
    match f {
        F2::MinNumber => float_two(bank, to, a, b, m::min_number),
        F2::MaxNumber => float_two(bank, to, a, b, m::max_number),
        F2::Modulo => float_two(bank, to, a, b, m::modulo),
        F2::Pow => float_two(bank, to, a, b, m::pow),
        F2::Atan2 => float_two(bank, to, a, b, m::atan2),
        F2::Step => float_two(bank, to, a, b, m::step),
        F2::Equal => float_two(bank, to, a, b, |x, y| x.simd_eq(y)),
        F2::NotEqual => two(bank, to, a, b, |a, b| !truth(floats(a).simd_eq(floats(b)))),
        F2::IntSubtract => two(bank, to, a, b, |a, b| a - b),
        F2::IntMultiply => two(bank, to, a, b, |a, b| a * b),
        F2::IntDivide => two(bank, to, a, b, m::divide_int),
        F2::IntRemainder => two(bank, to, a, b, m::remainder_int),
        F2::UintDivide => two(bank, to, a, b, |a, b| {
            of_unsigned(m::divide_uint(unsigned(a), unsigned(b)))
        }),
        F2::UintRemainder => two(bank, to, a, b, |a, b| {
            of_unsigned(m::remainder_uint(unsigned(a), unsigned(b)))
        }),
        F2::IntLessEqual => two(bank, to, a, b, |a, b| !a.simd_gt(b)),
        F2::UintLess => two(bank, to, a, b, |a, b| {
            sign_flipped(a).simd_lt(sign_flipped(b))
        }),
        F2::UintLessEqual => two(bank, to, a, b, |a, b| {
            !sign_flipped(a).simd_gt(sign_flipped(b))
        }),
        F2::SameBits => two(bank, to, a, b, |a, b| a.simd_eq(b)),
        F2::OtherBits => two(bank, to, a, b, |a, b| !a.simd_eq(b)),
        F2::ShiftLeft => two(bank, to, a, b, |a, b| {
            of_unsigned(m::shift_left(unsigned(a), unsigned(b)))
        }),
        F2::ShiftRight => two(bank, to, a, b, |a, b| m::shift_right_int(a, unsigned(b))),
        F2::ShiftRightUnsigned => two(bank, to, a, b, |a, b| {
            of_unsigned(m::shift_right_uint(unsigned(a), unsigned(b)))
        }),
        F2::IntMin => two(bank, to, a, b, |a, b| a.min(b)),
        F2::IntMax => two(bank, to, a, b, |a, b| a.max(b)),
        F2::UintMin => two(bank, to, a, b, |a, b| {
            sign_flipped(sign_flipped(a).min(sign_flipped(b)))
        }),
        F2::UintMax => two(bank, to, a, b, |a, b| {
            sign_flipped(sign_flipped(a).max(sign_flipped(b)))
        }),
        F2::Imprecise(what, direction) => float_two(bank, to, a, b, |x, y| {
            gpu_profile::imprecise(what, direction, x, y)
        }),
        F2::PackHalf => two(bank, to, a, b, |a, b| {
            of_unsigned(m::pack_half(floats(a), floats(b)))
        }),
        F2::PackSnorm => two(bank, to, a, b, |a, b| {
            of_unsigned(m::pack_snorm(floats(a), floats(b)))
        }),
        F2::PackUnorm => two(bank, to, a, b, |a, b| {
            of_unsigned(m::pack_unorm(floats(a), floats(b)))
        }),
        // Part of the loop.
        F2::Add | F2::Subtract | F2::Multiply | F2::Divide | F2::Min | F2::Max => {}
        F2::Less | F2::LessEqual | F2::IntAdd | F2::IntLess | F2::And | F2::Or | F2::Xor => {}
    }
}

/// As [`apply_two`].
#[inline(always)]
fn apply_three(bank: &mut Bank, following: &mut Following<'_>, f: F3, mut regs: [Reg; 4]) {
    match f {
        F3::MultiplyAdd => loop {
            three(bank, regs, |a, b, c| {
                of_floats(floats(a) * floats(b) + floats(c))
            });
            let next = following.next_if(|instr| match instr {
                Instr::Three(F3::MultiplyAdd, to, a, b, c) => Some([to, a, b, c]),
                _ => None,
            });
            match next {
                Some(next) => regs = next,
                None => return,
            }
        },
        F3::Select => three(bank, regs, |a, b, c| a.bitselect(b, c)),
        F3::Mix => three(bank, regs, |a, b, c| {
            of_floats(math::mix(floats(a), floats(b), floats(c)))
        }),
        F3::Smoothstep => three(bank, regs, |a, b, c| {
            of_floats(math::smoothstep(floats(a), floats(b), floats(c)))
        }),
    }
}
