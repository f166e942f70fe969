//! Lowering of operations, scalar by scalar.

use super::emit::{Compiler, MAX_KEPT, Made, Regs, Value};
use crate::bytecode::{CheckSite, Comparison, F1, F2, F3, FaultCheck, Instr, OperandCheck, Reg};
use crate::options::{GpuProfile, Watch};
use shaderlint_ir::{Binary, OpId, OpKind, Precision, Unary};
use shaderlint_semantic::{Base, Scalar, Type, Undefined, Value as Constant};

impl Compiler<'_> {
    /// Compiles an operation. Returns its value, retained once.
    pub fn operation(&mut self, id: OpId) -> Made<Value> {
        let op = *self.module.op(id);
        let ty = op.ty;
        match op.kind {
            OpKind::Const(constant) => {
                let values = self.module.pool.values(constant);
                Some(self.constants_of(values))
            }
            OpKind::Undef => {
                if ty.is_void() || ty.is_sampler() {
                    return Some(Value::Nothing);
                }
                let count = self.scalars_of(ty)?;
                let is_chosen = self.options.undefined_at.is_none_or(|only| only == id);
                let bits = if is_chosen { self.options.undefined } else { 0 };
                let undefined = self.constant(bits);
                Some(Value::Regs(self.listed((0..count).map(|_| undefined))))
            }
            OpKind::Unknown if ty.is_void() => Some(Value::Nothing),
            OpKind::Unknown => self.refuse("an expression with an error"),
            OpKind::Load(place) => self.load(id, place),
            OpKind::Store(place, value) => {
                self.store(id, place, value)?;
                Some(Value::Nothing)
            }
            OpKind::Unary(unary, a) => {
                let f = unary_of(unary, self.module.scalar(a));
                self.each_one(f, a)
            }
            OpKind::Binary(binary, a, b) => self.binary(id, binary, a, b),
            OpKind::MatrixProduct(a, b) => self.matrix_product(a, b),
            OpKind::Same {
                negated,
                left,
                right,
            } => self.same(negated, left, right),
            OpKind::Select {
                condition,
                then,
                otherwise,
            } => Some(self.select(condition, then, otherwise)),
            OpKind::Convert(a) => self.convert(id, a, ty),
            OpKind::Splat(a) => {
                let regs = self.operand(a);
                let reg = self.reg(regs, 0);
                let count = self.scalars_of(ty)?;
                Some(self.named((0..count).map(|_| reg)))
            }
            OpKind::Swizzle(a, lanes) => {
                let regs = self.operand(a);
                let numbers = lanes.numbers().iter();
                let picked: Vec<Reg> = numbers.map(|n| self.reg(regs, *n as u32)).collect();
                Some(self.named(picked))
            }
            OpKind::Compose(parts) => {
                let mut all = Vec::new();
                for part in self.module.operands(parts) {
                    let regs = self.operand(*part);
                    all.extend_from_slice(self.list(regs));
                }
                Some(self.named(all))
            }
            OpKind::Extract(a, number) => self.extract(a, number),
            OpKind::ExtractComputed { base, index } => self.extract_computed(base, index),
            OpKind::Builtin(function, operands) => {
                self.builtin(id, function, self.module.operands(operands), ty)
            }
            OpKind::Call(function, operands) => self.call(id, function, operands),
            OpKind::Returned(call, number) => match self.taken_back.remove(&(call, number)) {
                Some(value) => Some(value),
                None => self.refuse("an `out` parameter that its call does not write"),
            },
        }
    }

    /// A value that aliases existing registers.
    fn named(&mut self, regs: impl IntoIterator<Item = Reg>) -> Value {
        let regs = self.listed(regs);
        self.retain(Value::Regs(regs))
    }

    fn select(&mut self, condition: OpId, then: OpId, otherwise: OpId) -> Value {
        let condition = self.operand(condition);
        let condition = self.reg(condition, 0);
        let (then, otherwise) = (self.operand(then), self.operand(otherwise));
        let made: Vec<Reg> = (0..then.len)
            .map(|n| {
                let (a, b) = (self.reg(then, n), self.reg(otherwise, n));
                self.three(F3::Select, condition, a, b)
            })
            .collect();
        Value::Regs(self.listed(made))
    }

    /// Rounds a value to 16 bits if it has `mediump` or `lowp` precision and the profile is a
    /// mobile GPU.
    pub fn narrowed(&mut self, id: OpId, value: Value) -> Value {
        let op = self.module.op(id);
        let is_narrow = matches!(op.precision, Precision::Low | Precision::Medium);
        let computes = matches!(
            op.kind,
            OpKind::Binary(..)
                | OpKind::Builtin(..)
                | OpKind::MatrixProduct(..)
                | OpKind::Convert(_)
        );
        let is_float = op.ty.scalar_kind() == Some(Scalar::Float);
        match value {
            Value::Regs(regs)
                if is_narrow
                    && computes
                    && is_float
                    && self.options.gpu_profile == GpuProfile::Mobile =>
            {
                let made: Vec<Reg> = (0..regs.len)
                    .map(|n| {
                        let reg = self.reg(regs, n);
                        self.then_one(F1::Half, reg)
                    })
                    .collect();
                Value::Regs(self.listed(made))
            }
            value => value,
        }
    }

    /// The location of a constant: small ones are in registers, large ones in memory.
    pub fn constants_of(&mut self, values: &[Constant]) -> Value {
        if values.len() <= MAX_KEPT {
            let regs: Vec<Reg> = values.iter().map(|v| self.constant(bits_of(*v))).collect();
            return Value::Regs(self.listed(regs));
        }
        let key = values.as_ptr() as usize;
        let at = match self.tables.get(&key) {
            Some(at) => *at,
            None => {
                let at = self.code.tables.len() as u32;
                self.code.tables.extend(values.iter().map(|v| bits_of(*v)));
                self.tables.insert(key, at);
                at
            }
        };
        Value::Memory {
            at: self.code.uniform_words + at,
            len: values.len() as u32,
        }
    }

    /// Emits a unary instruction per scalar.
    pub fn each_one(&mut self, f: F1, a: OpId) -> Made<Value> {
        let a = self.operand(a);
        let made: Vec<Reg> = (0..a.len)
            .map(|n| {
                let a = self.reg(a, n);
                self.one(f, a)
            })
            .collect();
        Some(Value::Regs(self.listed(made)))
    }

    /// Emits a binary instruction per component; a scalar operand is broadcast.
    pub fn each_two(&mut self, f: F2, a: Regs, b: Regs) -> Made<Value> {
        let made: Vec<Reg> = (0..a.len.max(b.len))
            .map(|n| {
                let (a, b) = (self.spread(a, n), self.spread(b, n));
                self.two(f, a, b)
            })
            .collect();
        Some(Value::Regs(self.listed(made)))
    }

    /// A component of a vector, or the scalar operand that is broadcast.
    pub fn spread(&self, regs: Regs, at: u32) -> Reg {
        self.reg(regs, if regs.len == 1 { 0 } else { at })
    }

    fn binary(&mut self, id: OpId, binary: Binary, a: OpId, b: OpId) -> Made<Value> {
        let scalar = self.module.scalar(a).unwrap_or(Scalar::Float);
        let (mut left, mut right) = (self.operand(a), self.operand(b));
        let (f, is_swapped) = binary_of(binary, scalar);
        if is_swapped {
            std::mem::swap(&mut left, &mut right);
        }
        let made = self.each_two(f, left, right)?;
        if self.watches(Watch::Faults)
            && let Value::Regs(made) = made
        {
            if self.watches(Watch::Comparisons) && binary.compares() && made.len == 1 {
                let sides = if is_swapped {
                    [right, left]
                } else {
                    [left, right]
                };
                let [left, right] = sides.map(|side| self.reg(side, 0));
                self.watch_comparison(id, self.reg(made, 0), [left, right], scalar);
            }
            for n in 0..made.len {
                let operands = [self.spread(left, n), self.spread(right, n)];
                let result = self.reg(made, n);
                self.watch_number(id, f, result, operands);
                self.watch_operands(id, undefined_of(binary, scalar), scalar, &operands);
            }
        }
        Some(made)
    }

    /// Adds a fault check to the result of an instruction.
    fn watch_number(&mut self, id: OpId, f: F2, result: Reg, operands: [Reg; 2]) {
        let what = match f {
            F2::Divide => FaultCheck::Quotient,
            F2::IntDivide | F2::IntRemainder => FaultCheck::Divisor(Scalar::Int),
            F2::UintDivide | F2::UintRemainder => FaultCheck::Divisor(Scalar::Uint),
            F2::Add | F2::Subtract | F2::Multiply => FaultCheck::Float,
            _ => return,
        };
        self.check(id, what, result, &operands);
    }

    /// Adds a check for operands with undefined results.
    pub fn watch_operands(
        &mut self,
        id: OpId,
        undefined: Undefined,
        scalar: Scalar,
        operands: &[Reg],
    ) {
        if let (Some(first), true) = (operands.first(), undefined != Undefined::NEVER) {
            self.check(
                id,
                FaultCheck::Operands(undefined, scalar),
                *first,
                operands,
            );
        }
    }

    /// Records the operands of a comparison.
    pub fn watch_comparison(&mut self, op: OpId, result: Reg, sides: [Reg; 2], scalar: Scalar) {
        let known = self.code.compared.len() as u32;
        let site = *self.compared_sites.entry(op).or_insert(known);
        if site == known {
            self.code.compared.push(op);
        }
        let number = self.code.comparisons.len() as u32;
        let [left, right] = sides;
        self.code.comparisons.push(Comparison {
            site,
            result,
            left,
            right,
            scalar,
        });
        self.push(Instr::Compare(number));
    }

    /// Whether an operation divides by constants other than zero.
    fn has_constant_divisor(&self, op: OpId) -> bool {
        let OpKind::Binary(_, _, divisor) = self.module.op(op).kind else {
            return false;
        };
        let lanes = self.module.constant(divisor);
        !lanes.is_empty() && lanes.iter().all(|lane| lane.as_float() != 0.0)
    }

    /// Adds a fault check.
    pub fn check(&mut self, op: OpId, checked: FaultCheck, result: Reg, operands: &[Reg]) {
        let checked = match checked {
            _ if self.watches(Watch::Numbers) => checked,
            _ if !self.watches(Watch::Faults) => return,
            FaultCheck::Float => return,
            FaultCheck::Quotient | FaultCheck::Divisor(_) if self.has_constant_divisor(op) => {
                return;
            }
            FaultCheck::Quotient => FaultCheck::Divisor(Scalar::Float),
            FaultCheck::Divisor(_)
            | FaultCheck::Index
            | FaultCheck::Neighbours
            | FaultCheck::Operands(..) => checked,
        };
        let known = self.code.checks.len() as u32;
        let what = CheckSite { op, checked };
        let site = *self.check_sites.entry(what).or_insert(known);
        if site == known {
            self.code.checks.push(what);
        }
        let number = self.code.looks.len() as u32;
        self.code.looks.push(OperandCheck {
            site,
            result,
            operands: operands.to_vec(),
        });
        self.push(Instr::Check(number));
    }

    /// A sum of products, evaluated in order.
    pub fn sum_of_products(&mut self, pairs: &[(Reg, Reg)]) -> Reg {
        let mut sum: Option<Reg> = None;
        for (a, b) in pairs {
            sum = Some(match sum {
                None => self.two(F2::Multiply, *a, *b),
                Some(sum) => {
                    let made = self.three(F3::MultiplyAdd, *a, *b, sum);
                    self.registers.release(sum);
                    made
                }
            });
        }
        sum.unwrap_or(0)
    }

    fn matrix_product(&mut self, a: OpId, b: OpId) -> Made<Value> {
        let size = |ty: Type| ty.numeric().map(|(_, columns, rows)| [columns, rows]);
        let (left, right) = (size(self.module.ty(a)), size(self.module.ty(b)));
        let (Some([a_columns, a_rows]), Some([b_columns, b_rows])) = (left, right) else {
            return self.refuse("a matrix product of operands that are not numeric");
        };
        let (x, y) = (self.operand(a), self.operand(b));
        // A vector on the left is a row vector: one column per component.
        let (inner, rows, columns) = match a_columns {
            1 => (a_rows, 1, b_columns),
            _ => (a_columns, a_rows, b_columns),
        };
        let mut made = Vec::new();
        for c in 0..columns as u32 {
            for r in 0..rows as u32 {
                let pairs: Vec<(Reg, Reg)> = (0..inner as u32)
                    .map(|k| {
                        let left = match a_columns {
                            1 => k,
                            _ => k * a_rows as u32 + r,
                        };
                        (self.reg(x, left), self.reg(y, c * b_rows as u32 + k))
                    })
                    .collect();
                made.push(self.sum_of_products(&pairs));
            }
        }
        Some(Value::Regs(self.listed(made)))
    }

    /// Whether all scalars of two values are equal, compared by type.
    fn same(&mut self, negated: bool, left: OpId, right: OpId) -> Made<Value> {
        let ty = self.module.ty(left);
        let mut kinds = Vec::new();
        self.kinds(ty, &mut kinds);
        let (left, right) = (self.operand(left), self.operand(right));
        let mut all: Option<Reg> = None;
        for (n, kind) in (0..).zip(kinds) {
            let f = match (kind, negated) {
                (Scalar::Float, false) => F2::Equal,
                (Scalar::Float, true) => F2::NotEqual,
                (_, false) => F2::SameBits,
                (_, true) => F2::OtherBits,
            };
            let (a, b) = (self.reg(left, n), self.reg(right, n));
            let one = self.two(f, a, b);
            all = Some(match all {
                None => one,
                Some(all) => {
                    let f = if negated { F2::Or } else { F2::And };
                    let made = self.then_two(f, all, one);
                    self.registers.release(one);
                    made
                }
            });
        }
        match all {
            Some(all) => Some(Value::Regs(self.listed([all]))),
            None => self.refuse("a comparison of values without scalars"),
        }
    }

    /// The scalar types of a type's components, in layout order.
    fn kinds(&self, ty: Type, kinds: &mut Vec<Scalar>) {
        for _ in 0..ty.array.max(1) {
            match ty.base {
                Base::Numeric {
                    scalar,
                    columns,
                    rows,
                } => kinds.extend((0..columns * rows).map(|_| scalar)),
                _ => {
                    let made = self.program.struct_of(ty.element());
                    for field in made.map_or(&[][..], |s| &s.fields) {
                        self.kinds(field.ty, kinds);
                    }
                }
            }
        }
    }

    fn convert(&mut self, id: OpId, a: OpId, ty: Type) -> Made<Value> {
        let from = self.module.scalar(a).unwrap_or(Scalar::Float);
        let to = ty.scalar_kind().unwrap_or(Scalar::Float);
        let regs = self.operand(a);
        let undefined = match (from, to) {
            (Scalar::Float, Scalar::Int) => Undefined::NO_INT,
            (Scalar::Float, Scalar::Uint) => Undefined::NO_UINT,
            _ => Undefined::NEVER,
        };
        for n in 0..regs.len {
            self.watch_operands(id, undefined, from, &[self.reg(regs, n)]);
        }
        let made: Vec<Reg> = (0..regs.len)
            .map(|n| {
                let reg = self.reg(regs, n);
                self.converted(reg, from, to)
            })
            .collect();
        Some(Value::Regs(self.listed(made)))
    }

    fn converted(&mut self, reg: Reg, from: Scalar, to: Scalar) -> Reg {
        use Scalar::*;
        match (from, to) {
            (Int | Uint, Int | Uint) | (Bool, Bool) | (Float, Float) => {
                self.registers.retain(reg);
                reg
            }
            (Bool, Float) => {
                let one = self.float(1.0);
                self.two(F2::And, reg, one)
            }
            (Bool, Int | Uint) => {
                let one = self.constant(1);
                self.two(F2::And, reg, one)
            }
            (Float, Bool) => {
                let zero = self.constant(0);
                self.two(F2::NotEqual, reg, zero)
            }
            (Int | Uint, Bool) => {
                let zero = self.constant(0);
                self.two(F2::OtherBits, reg, zero)
            }
            (Int, Float) => self.one(F1::FloatOfInt, reg),
            (Uint, Float) => self.one(F1::FloatOfUint, reg),
            (Float, Int) => self.one(F1::IntOfFloat, reg),
            (Float, Uint) => self.one(F1::UintOfFloat, reg),
        }
    }

    fn extract(&mut self, a: OpId, number: u32) -> Made<Value> {
        let found = self.part_at(self.module.ty(a), number);
        let Some((at, inner, count)) = found else {
            return self.refuse("part of a value with more than 32,768 scalars");
        };
        if number >= count {
            return self.refuse("an index that is out of bounds");
        }
        let len = self.scalars_of(inner)?;
        if let Value::Memory { at: first, .. } = self.value(a) {
            let part = Value::Memory {
                at: first + at,
                len,
            };
            return Some(Value::Regs(self.in_registers(part)));
        }
        let regs = Self::part(self.operand(a), at, len);
        Some(self.retain(Value::Regs(regs)))
    }
}

/// The bits of a constant scalar.
fn bits_of(value: Constant) -> u32 {
    match value {
        Constant::Bool(v) => {
            if v {
                u32::MAX
            } else {
                0
            }
        }
        Constant::Int(v) => v as u32,
        Constant::Uint(v) => v,
        Constant::Float(v) => v.to_bits(),
    }
}

fn unary_of(unary: Unary, scalar: Option<Scalar>) -> F1 {
    match (unary, scalar) {
        (Unary::Negate, Some(Scalar::Float)) => F1::Negate,
        (Unary::Negate, _) => F1::IntNegate,
        (Unary::Not | Unary::BitNot, _) => F1::Not,
    }
}

/// The instruction of a binary operator, and whether its operands are swapped.
fn binary_of(binary: Binary, scalar: Scalar) -> (F2, bool) {
    use Scalar::{Float, Uint};
    let (f, is_swapped) = match (binary, scalar) {
        (Binary::Add, Float) => (F2::Add, false),
        (Binary::Add, _) => (F2::IntAdd, false),
        (Binary::Subtract, Float) => (F2::Subtract, false),
        (Binary::Subtract, _) => (F2::IntSubtract, false),
        (Binary::Multiply, Float) => (F2::Multiply, false),
        (Binary::Multiply, _) => (F2::IntMultiply, false),
        (Binary::Divide, Float) => (F2::Divide, false),
        (Binary::Divide, Uint) => (F2::UintDivide, false),
        (Binary::Divide, _) => (F2::IntDivide, false),
        (Binary::Remainder, Uint) => (F2::UintRemainder, false),
        (Binary::Remainder, _) => (F2::IntRemainder, false),
        (Binary::ShiftLeft, _) => (F2::ShiftLeft, false),
        (Binary::ShiftRight, Uint) => (F2::ShiftRightUnsigned, false),
        (Binary::ShiftRight, _) => (F2::ShiftRight, false),
        (Binary::BitAnd | Binary::And, _) => (F2::And, false),
        (Binary::BitOr | Binary::Or, _) => (F2::Or, false),
        (Binary::BitXor | Binary::Xor, _) => (F2::Xor, false),
        (Binary::Less, _) => (less(scalar, false), false),
        (Binary::LessEqual, _) => (less(scalar, true), false),
        (Binary::Greater, _) => (less(scalar, false), true),
        (Binary::GreaterEqual, _) => (less(scalar, true), true),
    };
    (f, is_swapped)
}

/// The operands for which the result of a binary operator is undefined.
const fn undefined_of(binary: Binary, scalar: Scalar) -> Undefined {
    match (binary, scalar) {
        (Binary::Remainder, Scalar::Int) => Undefined::NEGATIVE_REMAINDER,
        (Binary::ShiftLeft | Binary::ShiftRight, _) => Undefined::BEYOND_BITS,
        _ => Undefined::NEVER,
    }
}

/// The `<` or `<=` instruction of a scalar type.
pub(super) const fn less(scalar: Scalar, or_equal: bool) -> F2 {
    match (scalar, or_equal) {
        (Scalar::Float, false) => F2::Less,
        (Scalar::Float, true) => F2::LessEqual,
        (Scalar::Uint, false) => F2::UintLess,
        (Scalar::Uint, true) => F2::UintLessEqual,
        (_, false) => F2::IntLess,
        (_, true) => F2::IntLessEqual,
    }
}
