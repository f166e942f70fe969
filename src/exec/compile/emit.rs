//! Values, registers and instructions.

use super::options::{CompileOptions, Persona, Refusal, Watch};
use super::plan::{Held, Plan};
use super::registers::Registers;
use crate::code::{CallPath, CheckSite, Code, F1, F2, F3, Inexact, Instr, Reg, Slot, Target};
use rustc_hash::FxHashMap;
use shaderlint_ir::{Layout, Module, OpId, Provenance};
use shaderlint_semantic::{FunctionRef, Program, Type, VariableId};

/// Most instructions of a shader.
const MAX_INSTRS: usize = 400_000;

/// Most scalars of a constant that are kept in registers.
pub(super) const MAX_KEPT: usize = 16;

/// Made, or not for a reason that is kept.
pub(super) type Made<T> = Option<T>;

/// Some registers, in [`Compiler::lists`].
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) struct Regs {
    pub start: u32,
    pub len: u32,
}

/// Where what is looked at goes.
#[derive(Clone, Copy)]
pub(super) struct Probed {
    pub ty: Type,
    pub scalars: Regs,
    /// All bits set where there was something to look at.
    pub reached: Reg,
}

/// Where a value is.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) enum Value {
    /// There is none.
    #[default]
    Nothing,
    /// In registers, one for each scalar.
    Regs(Regs),
    /// In the memory.
    Memory {
        /// The first word.
        at: u32,
        /// How many.
        len: u32,
    },
    /// Samplers, from this one on.
    Samplers(u32),
}

/// A function whose code is being made.
pub(super) struct Frame {
    pub function: FunctionRef,
    /// The number of the calls that lead here, where these are watched.
    pub path: u32,
    pub clock: u32,
    /// How many of the plan's ends are behind.
    pub ended: usize,
    /// Where the result goes, if lanes leave early.
    pub result: Option<Regs>,
    /// Who came, and who left, if lanes leave early.
    pub came: Slot,
    pub left: Slot,
    /// The result, where it is given at the end alone.
    pub returned: Value,
    /// By loop and `switch` around: who waits for the next turn.
    pub waiting: Vec<Slot>,
}

/// Code that is being made.
pub(super) struct Compiler<'p> {
    pub program: &'p Program,
    pub layout: Layout,
    pub module: &'p Module,
    pub plan: &'p Plan,
    pub options: CompileOptions,
    pub code: Code,
    pub registers: Registers,
    pub lists: Vec<Reg>,
    /// By operation.
    pub values: Vec<Value>,
    /// By variable.
    pub variables: Vec<Value>,
    pub frames: Vec<Frame>,
    /// What calls left in parameters, until it is taken.
    pub taken_back: FxHashMap<(OpId, u32), Value>,
    /// What the prologue holds already.
    known: FxHashMap<Instr, Reg>,
    constants: FxHashMap<u32, Reg>,
    /// By uniform: the first of its samplers.
    pub samplers_of: FxHashMap<VariableId, u32>,
    /// By place in the pool: where large constants lie.
    pub tables: FxHashMap<usize, u32>,
    /// By what is checked: its number.
    pub check_sites: FxHashMap<CheckSite, u32>,
    /// By comparison: its number.
    pub compared_sites: FxHashMap<OpId, u32>,
    /// By function and caller: the number of the path.
    pub call_paths: FxHashMap<CallPath, u32>,
    /// By construct: the number of its branch.
    pub branch_sites: FxHashMap<Provenance, u32>,
    /// Where goes what is looked at.
    pub probed: Option<Probed>,
    next_slot: Slot,
    /// Intermediate results of a built-in function.
    pub scratch: Vec<Reg>,
    /// The operation that code is made for.
    pub op: OpId,
    pub failure: Option<Refusal>,
}

impl<'p> Compiler<'p> {
    pub fn new(
        program: &'p Program,
        module: &'p Module,
        plan: &'p Plan,
        options: CompileOptions,
    ) -> Compiler<'p> {
        Compiler {
            program,
            layout: Layout::of(program),
            module,
            plan,
            options,
            code: Code::default(),
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
            // The first is always empty.
            next_slot: 1,
            scratch: Vec::new(),
            op: OpId(u32::MAX),
            failure: None,
        }
    }

    /// The code, or why there is none.
    pub fn finish(mut self) -> Result<Code, Refusal> {
        if self.registers.is_full {
            let _: Made<()> = self.refuse("a shader that needs more than 65,536 registers");
        }
        match self.failure {
            Some(failure) => Err(failure),
            None => Ok(Code {
                registers: self.registers.count(),
                ..self.code
            }),
        }
    }

    /// Notes what cannot be run; the first of it is said.
    pub fn refuse<T>(&mut self, what: impl Into<String>) -> Made<T> {
        let at = match self.op {
            OpId(u32::MAX) => Provenance::Language,
            op => self.module.provenance(op),
        };
        let what = what.into();
        self.failure.get_or_insert(Refusal { what, at });
        None
    }

    /// Whether it makes no sense to go on.
    pub fn has_failed(&mut self) -> bool {
        let most = self.options.most.map_or(MAX_INSTRS, |n| n.min(MAX_INSTRS));
        if self.code.body.len() + self.code.prologue.len() > most {
            let _: Made<()> = self.refuse(format!("a shader of more than {most} instructions"));
        }
        self.failure.is_some() || self.registers.is_full
    }

    /// Whether something is watched.
    pub fn watches(&self, what: Watch) -> bool {
        self.options.watch >= what
    }

    /// A mask to keep aside, until [`Compiler::give_back_slots`].
    pub fn slot(&mut self) -> Slot {
        let slot = self.next_slot;
        self.next_slot = self.next_slot.saturating_add(1);
        self.code.slots = self.code.slots.max(self.next_slot as u32);
        if self.next_slot == Slot::MAX {
            let _: Made<()> = self.refuse("65,535 constructs in each other");
        }
        slot
    }

    /// How many masks are kept aside.
    pub const fn slots(&self) -> Slot {
        self.next_slot
    }

    /// Gives back masks, until there are as many as there were.
    pub const fn give_back_slots(&mut self, mark: Slot) {
        self.next_slot = mark;
    }

    /// The next tick of the plan.
    pub fn tick(&mut self) {
        if let Some(frame) = self.frames.last_mut() {
            frame.clock += 1;
        }
    }

    /// Gives back what is not needed behind this tick.
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
                Held::Value(op) => {
                    let value = self.values.get_mut(op.0 as usize).map(std::mem::take);
                    self.release(value.unwrap_or_default());
                }
                Held::Variable(variable) => self.forget(variable),
            }
        }
    }

    /// A variable is not needed any more.
    fn forget(&mut self, variable: VariableId) {
        let slot = self.variables.get_mut(variable.0 as usize);
        let value = slot.map(std::mem::take).unwrap_or_default();
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

    /// A register of a list.
    pub fn reg(&self, regs: Regs, at: u32) -> Reg {
        self.list(regs).get(at as usize).copied().unwrap_or(0)
    }

    /// A part of a list.
    pub const fn part(regs: Regs, at: u32, len: u32) -> Regs {
        Regs {
            start: regs.start + at,
            len,
        }
    }

    /// Keeps registers as a list.
    pub fn listed(&mut self, regs: impl IntoIterator<Item = Reg>) -> Regs {
        let start = self.lists.len() as u32;
        self.lists.extend(regs);
        Regs {
            start,
            len: self.lists.len() as u32 - start,
        }
    }

    /// One holder more.
    pub fn retain(&mut self, value: Value) -> Value {
        if let Value::Regs(regs) = value {
            for at in 0..regs.len {
                let reg = self.reg(regs, at);
                self.registers.retain(reg);
            }
        }
        value
    }

    /// One holder less.
    pub fn release(&mut self, value: Value) {
        if let Value::Regs(regs) = value {
            for at in 0..regs.len {
                let reg = self.reg(regs, at);
                self.registers.release(reg);
            }
        }
    }

    /// The registers of an operation's value.
    pub fn operand(&mut self, op: OpId) -> Regs {
        let value = self.value(op);
        self.in_registers(value)
    }

    /// Where an operation's value is.
    pub fn value(&self, op: OpId) -> Value {
        self.values.get(op.0 as usize).copied().unwrap_or_default()
    }

    /// The registers of a value; what is in the memory is fetched for good.
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

    /// A word of the memory.
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

    /// The same for all pixels: made once.
    fn once(&mut self, instr: Instr) -> Reg {
        if let Some(reg) = self.known.get(&instr) {
            return *reg;
        }
        let reg = self.registers.uniform();
        self.known.insert(instr, reg);
        self.code.prologue.push(instr.to(reg));
        reg
    }

    /// What an instruction without effect gives, in a register that is held once.
    pub fn pure(&mut self, instr: Instr, operands: &[Reg]) -> Reg {
        if operands.iter().all(|r| self.registers.is_uniform(*r)) {
            return self.once(instr);
        }
        self.fresh(instr)
    }

    /// What an instruction gives each group of pixels, in a register that is held once.
    pub fn fresh(&mut self, instr: Instr) -> Reg {
        let reg = self.registers.fresh();
        self.code.body.push(instr.to(reg));
        reg
    }

    pub fn one(&mut self, f: F1, a: Reg) -> Reg {
        let made = self.pure(Instr::One(f, 0, a), &[a]);
        let what = match f {
            F1::Sqrt => Inexact::Quotient,
            F1::InverseSqrt => Inexact::InverseRoot,
            F1::Exp | F1::Exp2 => Inexact::Exponential,
            F1::Log | F1::Log2 => Inexact::Logarithm,
            F1::Sin | F1::Cos => Inexact::Sine,
            F1::Atan | F1::Asin | F1::Acos => Inexact::ArcTangent,
            _ => return made,
        };
        self.off(what, made, a)
    }

    pub fn two(&mut self, f: F2, a: Reg, b: Reg) -> Reg {
        if let (F2::Pow, Persona::Inexact(_)) = (f, self.options.persona) {
            // As a GPU computes it, and as the errors add up.
            let log = self.one(F1::Log2, a);
            let product = self.then_two(F2::Multiply, log, b);
            return self.then_one(F1::Exp2, product);
        }
        let made = self.pure(Instr::Two(f, 0, a, b), &[a, b]);
        match f {
            F2::Divide => self.off(Inexact::Quotient, made, b),
            F2::Atan2 => self.off(Inexact::ArcTangent, made, b),
            _ => made,
        }
    }

    /// A result as a GPU may give it that is no more exact than it has to be.
    fn off(&mut self, what: Inexact, made: Reg, operand: Reg) -> Reg {
        let Persona::Inexact(lean) = self.options.persona else {
            return made;
        };
        let f = F2::Off(what, lean);
        let off = self.pure(Instr::Two(f, 0, made, operand), &[made, operand]);
        self.registers.release(made);
        off
    }

    pub fn three(&mut self, f: F3, a: Reg, b: Reg, c: Reg) -> Reg {
        self.pure(Instr::Three(f, 0, a, b, c), &[a, b, c])
    }

    /// The same, of an intermediate result that nothing else needs.
    pub fn then_one(&mut self, f: F1, a: Reg) -> Reg {
        let made = self.one(f, a);
        self.registers.release(a);
        made
    }

    /// The same, where the first operand is an intermediate result.
    pub fn then_two(&mut self, f: F2, a: Reg, b: Reg) -> Reg {
        let made = self.two(f, a, b);
        self.registers.release(a);
        made
    }

    /// Adds an instruction with an effect; gives its index.
    pub fn push(&mut self, instr: Instr) -> Target {
        self.code.body.push(instr);
        self.code.body.len() as Target - 1
    }

    /// Where the next instruction will stand.
    pub fn here(&self) -> Target {
        self.code.body.len() as Target
    }

    /// Makes a jump lead to the next instruction.
    pub fn land(&mut self, jump: Target) {
        let here = self.here();
        if let Some(instr) = self.code.body.get_mut(jump as usize) {
            instr.lead(here);
        }
    }
}

impl Instr {
    /// The same, with another register to write.
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

    /// The register that it writes and no more than writes, in all lanes.
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

    /// Whether it reads a register, as far as those that [`Instr::target`] knows are concerned.
    pub(crate) const fn reads(self, reg: Reg) -> bool {
        match self {
            Instr::Move(_, a) | Instr::MoveActive(_, a) | Instr::One(_, _, a) => a == reg,
            Instr::Two(_, _, a, b) => a == reg || b == reg,
            Instr::Three(_, _, a, b, c) => a == reg || b == reg || c == reg,
            Instr::Table { index, .. } => index == reg,
            // An element may be any register of a variable.
            Instr::Gather { .. } => true,
            _ => false,
        }
    }

    /// Makes a jump lead somewhere.
    const fn lead(&mut self, target: Target) {
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
