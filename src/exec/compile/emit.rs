//! The compiler state: values, registers and instructions.

use super::plan::{CompilePlan, Releasable};
use super::registers::Registers;
use super::statements::Statements;
use crate::bytecode::{
    Bytecode, CallPath, CheckSite, F1, F2, F3, ImpreciseOp, Instr, InstrIndex, MaskSlot, Reg,
};
use crate::options::{CompileOptions, GpuProfile, Refusal, Watch};
use rustc_hash::FxHashMap;
use shaderlint_ir::{Layout, Module, OpId, Provenance};
use shaderlint_semantic::{FunctionRef, Program, Type, VariableId};
use shaderlint_syntax::ast::{Extent, TokenId};

/// Maximum number of instructions of a shader.
const MAX_INSTRS: usize = 400_000;

/// Maximum number of scalars of a constant that are kept in registers; larger ones go to memory.
pub(super) const MAX_KEPT: usize = 16;

/// The result of a compilation step; `None` after a failure, which is recorded in
/// [`Compiler::failure`].
pub(super) type Made<T> = Option<T>;

/// A list of registers, as a range of [`Compiler::lists`].
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) struct Regs {
    pub start: u32,
    pub len: u32,
}

/// The registers of the probe.
#[derive(Clone, Copy)]
pub(super) struct Probed {
    pub ty: Type,
    pub scalars: Regs,
    /// All bits set where the probed operation was executed.
    pub reached: Reg,
}

/// The registers of the ray probe.
#[derive(Clone, Copy)]
pub(super) struct RayRegisters {
    /// All bits set in pixels that have entered the loop, and while they march for the first time.
    pub entered: Reg,
    pub marches: Reg,
    /// The moved scalars before the loop.
    pub start: Regs,
    /// The distances from the start at the last two iterations, latest first.
    pub places: [Reg; 2],
    /// Whether the last test was a hit, and the distance from the start there.
    pub hit: Reg,
    pub tested: Reg,
    /// The distance from the start of the last place that was no hit.
    pub passed: Reg,
    /// The largest slope, and the largest change of the distance relative to itself.
    pub slope: Reg,
    pub change: Reg,
    /// The point on the ray.
    pub point: [Reg; 3],
    pub has_point: Reg,
    /// The point and the distance at the last evaluation, and whether there was one.
    pub last_point: [Reg; 3],
    pub last_field: Reg,
    pub was_evaluated: Reg,
}

/// The location of a value.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) enum Value {
    #[default]
    Nothing,
    /// One register per scalar.
    Regs(Regs),
    Memory {
        /// The first word.
        at: u32,
        /// The number of words.
        len: u32,
    },
    /// Samplers, starting with this index.
    Samplers(u32),
}

/// A function that is being inlined.
pub(super) struct CallFrame {
    pub function: FunctionRef,
    /// The index of the call path, if costs are recorded.
    pub path: u32,
    pub clock: u32,
    /// The number of entries of `CompilePlan::ends` already processed.
    pub ended: usize,
    /// The result registers, if the function has early returns.
    pub result: Option<Regs>,
    /// The lanes that entered the function and those that returned early, if it has early returns.
    pub came: MaskSlot,
    pub left: MaskSlot,
    /// The result, if it is only returned at the end.
    pub returned: Value,
    /// By enclosing loop: the slot of the lanes that wait after `continue`.
    pub waiting: Vec<MaskSlot>,
    /// The statement that was marked last.
    pub stop: Option<Extent>,
    /// Variables that a debugger may read until the function ends.
    pub kept: Vec<VariableId>,
}

pub(super) struct Compiler<'p> {
    pub program: &'p Program,
    pub layout: Layout,
    pub module: &'p Module,
    pub plan: &'p CompilePlan,
    pub options: CompileOptions,
    pub code: Bytecode,
    pub registers: Registers,
    pub lists: Vec<Reg>,
    /// By operation.
    pub values: Vec<Value>,
    pub variables: Vec<Value>,
    pub frames: Vec<CallFrame>,
    /// Values that calls write back to `out` parameters, until they are stored.
    pub taken_back: FxHashMap<(OpId, u32), Value>,
    /// The instructions already in the prologue (value numbering).
    known: FxHashMap<Instr, Reg>,
    constants: FxHashMap<u32, Reg>,
    /// By uniform: the index of its first sampler.
    pub samplers_of: FxHashMap<VariableId, u32>,
    /// By index into the constant pool: the memory address of a large constant.
    pub tables: FxHashMap<usize, u32>,
    /// Indices of the check sites.
    pub check_sites: FxHashMap<CheckSite, u32>,
    /// Indices of the comparisons.
    pub compared_sites: FxHashMap<OpId, u32>,
    /// Indices of the call paths.
    pub call_paths: FxHashMap<CallPath, u32>,
    /// Indices of the branches.
    pub branch_sites: FxHashMap<Provenance, u32>,
    /// The registers of the probe, if there is one.
    pub probed: Option<Probed>,
    /// By first token: the index of the statement.
    pub statement_sites: FxHashMap<TokenId, u32>,
    /// The statements at which a debugger can stop; none without [`CompileOptions::steps`].
    pub statements: Statements,
    /// The registers of the ray probe, if there is one.
    pub rays: Option<RayRegisters>,
    next_slot: MaskSlot,
    /// Intermediate results of the current built-in function.
    pub scratch: Vec<Reg>,
    /// The operation being compiled.
    pub op: OpId,
    pub failure: Option<Refusal>,
}

impl<'p> Compiler<'p> {
    pub fn new(
        program: &'p Program,
        module: &'p Module,
        plan: &'p CompilePlan,
        options: CompileOptions,
    ) -> Compiler<'p> {
        Compiler {
            program,
            layout: Layout::of(program),
            module,
            plan,
            options,
            code: Bytecode::default(),
            registers: Registers::default(),
            lists: Vec::with_capacity(module.ops.len() * 2),
            values: vec![Value::Nothing; module.ops.len()],
            variables: vec![Value::Nothing; module.variables.len()],
            frames: Vec::new(),
            taken_back: FxHashMap::default(),
            known: FxHashMap::default(),
            constants: FxHashMap::default(),
            samplers_of: FxHashMap::default(),
            tables: FxHashMap::default(),
            check_sites: FxHashMap::default(),
            compared_sites: FxHashMap::default(),
            call_paths: FxHashMap::default(),
            branch_sites: FxHashMap::default(),
            probed: None,
            statement_sites: FxHashMap::default(),
            statements: match options.steps {
                true => Statements::of(&program.tree),
                false => Statements::default(),
            },
            rays: None,
            // Slot 0 is `EMPTY`.
            next_slot: 1,
            scratch: Vec::new(),
            op: OpId(u32::MAX),
            failure: None,
        }
    }

    /// The finished code, or the reason for the refusal.
    pub fn finish(mut self) -> Result<Bytecode, Refusal> {
        if self.registers.is_full {
            let _: Made<()> = self.refuse("a shader that needs more than 65,536 registers");
        }
        match self.failure {
            Some(failure) => Err(failure),
            None => {
                if self.options.steps {
                    self.code.debug.lists = self.lists;
                }
                Ok(Bytecode {
                    registers: self.registers.count(),
                    ..self.code
                })
            }
        }
    }

    /// Records what cannot be run; only the first refusal is reported.
    pub fn refuse<T>(&mut self, what: impl Into<String>) -> Made<T> {
        let at = match self.op {
            OpId(u32::MAX) => Provenance::Language,
            op => self.module.provenance(op),
        };
        let what = what.into();
        self.failure.get_or_insert(Refusal { what, at });
        None
    }

    /// Whether compilation has failed or exceeded the instruction limit.
    pub fn has_failed(&mut self) -> bool {
        let most = self.options.most.map_or(MAX_INSTRS, |n| n.min(MAX_INSTRS));
        if self.code.body.len() + self.code.uniform_prologue.len() > most {
            let _: Made<()> = self.refuse(format!("a shader with more than {most} instructions"));
        }
        self.failure.is_some() || self.registers.is_full
    }

    /// Whether this level of statistics is recorded.
    pub fn watches(&self, what: Watch) -> bool {
        self.options.watch >= what
    }

    /// Allocates a mask slot, valid until [`Compiler::give_back_slots`].
    pub fn slot(&mut self) -> MaskSlot {
        let slot = self.next_slot;
        self.next_slot = self.next_slot.saturating_add(1);
        self.code.slots = self.code.slots.max(self.next_slot as u32);
        if self.next_slot == MaskSlot::MAX {
            let _: Made<()> = self.refuse("more than 65,535 nested constructs");
        }
        slot
    }

    /// The number of mask slots in use.
    pub const fn slots(&self) -> MaskSlot {
        self.next_slot
    }

    /// Frees all mask slots above a mark.
    pub const fn give_back_slots(&mut self, mark: MaskSlot) {
        self.next_slot = mark;
    }

    /// Advances the clock of the plan.
    pub fn tick(&mut self) {
        if let Some(frame) = self.frames.last_mut() {
            frame.clock += 1;
        }
    }

    /// Releases everything that is dead after this tick.
    pub fn tidy(&mut self) {
        loop {
            let Some(frame) = self.frames.last_mut() else {
                return;
            };
            let held = match self.plan.ends(frame.function).get(frame.ended) {
                Some((tick, held)) if *tick <= frame.clock => *held,
                _ => return,
            };
            frame.ended += 1;
            match held {
                Releasable::Value(op) => {
                    let value = self.values.get_mut(op.0 as usize).map(std::mem::take);
                    self.release(value.unwrap_or_default());
                }
                Releasable::Variable(variable) if self.options.steps => {
                    if let Some(frame) = self.frames.last_mut() {
                        frame.kept.push(variable);
                    }
                }
                Releasable::Variable(variable) => self.forget(variable),
            }
        }
    }

    pub fn forget(&mut self, variable: VariableId) {
        let value = self.variable_value(variable);
        self.set_variable(variable, Value::Nothing);
        match value {
            Value::Regs(regs) if self.plan.is_name(self.module, variable) => {
                self.release(Value::Regs(regs));
            }
            Value::Regs(regs) => {
                let first = self.reg(regs, 0);
                self.registers.release_row(first, regs.len);
            }
            _ => {}
        }
    }

    /// The registers of a list.
    pub fn list(&self, regs: Regs) -> &[Reg] {
        let start = regs.start as usize;
        self.lists
            .get(start..start + regs.len as usize)
            .unwrap_or(&[])
    }

    /// One register of a list.
    pub fn reg(&self, regs: Regs, at: u32) -> Reg {
        self.list(regs).get(at as usize).copied().unwrap_or(0)
    }

    /// A sublist.
    pub const fn part(regs: Regs, at: u32, len: u32) -> Regs {
        Regs {
            start: regs.start + at,
            len,
        }
    }

    /// Stores registers as a list.
    pub fn listed(&mut self, regs: impl IntoIterator<Item = Reg>) -> Regs {
        let start = self.lists.len() as u32;
        self.lists.extend(regs);
        Regs {
            start,
            len: self.lists.len() as u32 - start,
        }
    }

    /// Increments the reference count of all registers of a value.
    pub fn retain(&mut self, value: Value) -> Value {
        if let Value::Regs(regs) = value {
            for at in 0..regs.len {
                let reg = self.reg(regs, at);
                self.registers.retain(reg);
            }
        }
        value
    }

    /// Decrements the reference count of all registers of a value.
    pub fn release(&mut self, value: Value) {
        if let Value::Regs(regs) = value {
            for at in 0..regs.len {
                let reg = self.reg(regs, at);
                self.registers.release(reg);
            }
        }
    }

    /// The registers of an operand.
    pub fn operand(&mut self, op: OpId) -> Regs {
        let value = self.value(op);
        self.in_registers(value)
    }

    /// The location of an operation's value.
    pub fn value(&self, op: OpId) -> Value {
        self.values.get(op.0 as usize).copied().unwrap_or_default()
    }

    /// The registers of a value; a value in memory is loaded permanently.
    pub fn in_registers(&mut self, value: Value) -> Regs {
        match value {
            Value::Regs(regs) => regs,
            Value::Memory { at, len } => {
                let words: Vec<Reg> = (at..at + len).map(|at| self.word(at)).collect();
                self.listed(words)
            }
            Value::Nothing | Value::Samplers(_) => Regs::default(),
        }
    }

    /// Loads a word of memory.
    pub fn word(&mut self, at: u32) -> Reg {
        let table = at.checked_sub(self.code.uniform_words);
        let constant = table.and_then(|t| self.code.tables.get(t as usize));
        match constant {
            Some(bits) => self.constant(*bits),
            None => self.once(Instr::Word(0, at)),
        }
    }

    /// A register that always holds these bits.
    pub fn constant(&mut self, bits: u32) -> Reg {
        if let Some(reg) = self.constants.get(&bits) {
            return *reg;
        }
        let reg = self.registers.uniform();
        self.constants.insert(bits, reg);
        self.code.constants.push((reg, bits));
        reg
    }

    /// A register that always holds this number.
    pub fn float(&mut self, value: f32) -> Reg {
        self.constant(value.to_bits())
    }

    /// Emits a uniform instruction to the prologue, once (value numbering).
    fn once(&mut self, instr: Instr) -> Reg {
        if let Some(reg) = self.known.get(&instr) {
            return *reg;
        }
        let reg = self.registers.uniform();
        self.known.insert(instr, reg);
        self.code.uniform_prologue.push(instr.to(reg));
        reg
    }

    /// Emits an instruction without side effects: to the prologue if all operands are uniform, else
    /// to the body. The result register is retained once.
    pub fn pure(&mut self, instr: Instr, operands: &[Reg]) -> Reg {
        if operands.iter().all(|r| self.registers.is_uniform(*r)) {
            return self.once(instr);
        }
        self.fresh(instr)
    }

    /// Emits an instruction to the body. The result register is retained once.
    pub fn fresh(&mut self, instr: Instr) -> Reg {
        let reg = self.registers.fresh();
        self.code.body.push(instr.to(reg));
        reg
    }

    pub fn one(&mut self, f: F1, a: Reg) -> Reg {
        let made = self.pure(Instr::One(f, 0, a), &[a]);
        let what = match f {
            F1::Sqrt => ImpreciseOp::Quotient,
            F1::InverseSqrt => ImpreciseOp::InverseSqrt,
            F1::Exp | F1::Exp2 => ImpreciseOp::Exponential,
            F1::Log | F1::Log2 => ImpreciseOp::Logarithm,
            F1::Sin | F1::Cos => ImpreciseOp::Sine,
            F1::Atan | F1::Asin | F1::Acos => ImpreciseOp::ArcTangent,
            _ => return made,
        };
        self.imprecise(what, made, a)
    }

    pub fn two(&mut self, f: F2, a: Reg, b: Reg) -> Reg {
        if let (F2::Pow, GpuProfile::Inexact(_)) = (f, self.options.gpu_profile) {
            // As GPUs compute `pow`, with the errors of both steps.
            let log = self.one(F1::Log2, a);
            let product = self.then_two(F2::Multiply, log, b);
            return self.then_one(F1::Exp2, product);
        }
        let f = match (f, self.options.gpu_profile) {
            (F2::Min, GpuProfile::Inexact(_) | GpuProfile::Mobile) => F2::MinNumber,
            (F2::Max, GpuProfile::Inexact(_) | GpuProfile::Mobile) => F2::MaxNumber,
            _ => f,
        };
        let made = self.pure(Instr::Two(f, 0, a, b), &[a, b]);
        match f {
            F2::Divide => self.imprecise(ImpreciseOp::Quotient, made, b),
            F2::Atan2 => self.imprecise(ImpreciseOp::ArcTangent, made, b),
            _ => made,
        }
    }

    /// Applies the maximum error of the GPU profile to a result.
    fn imprecise(&mut self, what: ImpreciseOp, made: Reg, operand: Reg) -> Reg {
        let GpuProfile::Inexact(direction) = self.options.gpu_profile else {
            return made;
        };
        let f = F2::Imprecise(what, direction);
        let off = self.pure(Instr::Two(f, 0, made, operand), &[made, operand]);
        self.registers.release(made);
        off
    }

    pub fn three(&mut self, f: F3, a: Reg, b: Reg, c: Reg) -> Reg {
        self.pure(Instr::Three(f, 0, a, b, c), &[a, b, c])
    }

    /// Like [`Compiler::one`], and releases the operand.
    pub fn then_one(&mut self, f: F1, a: Reg) -> Reg {
        let made = self.one(f, a);
        self.registers.release(a);
        made
    }

    /// Like [`Compiler::two`], and releases the first operand.
    pub fn then_two(&mut self, f: F2, a: Reg, b: Reg) -> Reg {
        let made = self.two(f, a, b);
        self.registers.release(a);
        made
    }

    /// Appends an instruction to the body. Returns its index.
    pub fn push(&mut self, instr: Instr) -> InstrIndex {
        self.code.body.push(instr);
        self.code.body.len() as InstrIndex - 1
    }

    /// The index of the next instruction.
    pub fn here(&self) -> InstrIndex {
        self.code.body.len() as InstrIndex
    }

    /// Patches a jump to lead to the next instruction.
    pub fn land(&mut self, jump: InstrIndex) {
        let here = self.here();
        if let Some(instr) = self.code.body.get_mut(jump as usize) {
            instr.lead(here);
        }
    }
}

impl Instr {
    /// The same instruction with another destination register.
    pub(crate) fn to(self, reg: Reg) -> Instr {
        match self {
            Instr::Move(_, a) => Instr::Move(reg, a),
            Instr::MoveActive(_, a) => Instr::MoveActive(reg, a),
            Instr::One(f, _, a) => Instr::One(f, reg, a),
            Instr::Two(f, _, a, b) => Instr::Two(f, reg, a, b),
            Instr::Three(f, _, a, b, c) => Instr::Three(f, reg, a, b, c),
            Instr::Word(_, at) => Instr::Word(reg, at),
            Instr::Gather { index, site, .. } => Instr::Gather {
                to: reg,
                index,
                site,
            },
            Instr::Table { index, site, .. } => Instr::Table {
                to: reg,
                index,
                site,
            },
            other => other,
        }
    }

    /// The destination register of an instruction that writes all lanes and has no other effect.
    pub(crate) const fn target(self) -> Option<Reg> {
        match self {
            Instr::Move(to, _)
            | Instr::One(_, to, _)
            | Instr::Two(_, to, ..)
            | Instr::Three(_, to, ..)
            | Instr::Gather { to, .. }
            | Instr::Table { to, .. } => Some(to),
            _ => None,
        }
    }

    /// Whether an instruction, of those with a [`Instr::target`], reads a register.
    pub(crate) const fn reads(self, reg: Reg) -> bool {
        match self {
            Instr::Move(_, a) | Instr::MoveActive(_, a) | Instr::One(_, _, a) => a == reg,
            Instr::Two(_, _, a, b) => a == reg || b == reg,
            Instr::Three(_, _, a, b, c) => a == reg || b == reg || c == reg,
            Instr::Table { index, .. } => index == reg,
            // A dynamic index may read any register of the variable.
            Instr::Gather { .. } => true,
            _ => false,
        }
    }

    /// Sets the target of a jump.
    const fn lead(&mut self, target: InstrIndex) {
        match self {
            Instr::If { to, .. }
            | Instr::Else { to, .. }
            | Instr::While { to, .. }
            | Instr::Case { to, .. }
            | Instr::SkipIfNone(to)
            | Instr::Back(to) => *to = target,
            _ => {}
        }
    }
}
