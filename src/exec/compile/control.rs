//! Control flow: masks of the lanes that take part.

use super::Watch;
use super::emit::Frame;
use super::emit::{Compiler, Value};
use super::plan::GLOBALS;
use crate::code::{CallPath, EMPTY, F1, F2, Instr, Reg, Slot, Target};
use shaderlint_ir::{CaseLabel, LoopId, Module, OpId, Region, Step, SwitchId};
use shaderlint_semantic::FunctionRef;

impl Compiler<'_> {
    /// Makes the code: initial values of globals, then the entry.
    pub fn run(&mut self, entry: FunctionRef) {
        self.clear_outer();
        self.open_probe();
        let globals = self.frame(GLOBALS);
        self.frames.push(globals);
        self.region(self.module.globals);
        self.frames.pop();
        if self.entry_parameters(entry).is_none() {
            return;
        }
        let Some(body) = self.module.function(entry).and_then(|f| f.body) else {
            let _: Option<()> = self.refuse("a shader without `main`");
            return;
        };
        let frame = self.frame(entry);
        self.frames.push(frame);
        self.begin_frame();
        self.region(body);
        let returned = self.end_frame();
        if let Value::Regs(regs) = returned {
            let ty = self.module.function(entry).map(|f| f.returns);
            let regs = self.list(regs).to_vec();
            self.code.outputs.push(crate::code::OutputSlot {
                name: String::new(),
                ty: ty.unwrap_or(shaderlint_semantic::Type::VOID),
                regs,
            });
        }
        self.close_probe();
    }

    /// Code for a region; of one whose lanes all come back, the rest is passed over when none are
    /// left.
    pub fn region(&mut self, region: Region) {
        let steps = self.module.steps(region);
        let mut skips: Vec<Target> = Vec::new();
        for (at, step) in steps.iter().enumerate() {
            if self.has_failed() {
                return;
            }
            if let (Step::Run(run), true) = (step, self.watches(Watch::Flow)) {
                let by = self.frames.last().map_or(0, |f| f.path);
                let cost = run.len;
                self.push(Instr::Spend { cost, by });
            }
            self.step(step);
            let is_last = at + 1 == steps.len();
            if !is_last && leaves(self.module, step) {
                skips.push(self.push(Instr::SkipIfNone(0)));
            }
        }
        for skip in skips {
            self.land(skip);
        }
    }

    fn step(&mut self, step: &Step) {
        match *step {
            Step::Run(run) => {
                for op in run.ops() {
                    self.op = op;
                    self.tick();
                    let value = self.operation(op).unwrap_or_default();
                    let value = self.narrowed(op, value);
                    if let Some(slot) = self.values.get_mut(op.0 as usize) {
                        *slot = value;
                    }
                    self.probe(op);
                    self.tidy();
                    if self.has_failed() {
                        return;
                    }
                }
            }
            Step::If {
                condition,
                then,
                otherwise,
                origin,
            } => {
                self.tick();
                let condition = self.condition(condition);
                if self.watches(Watch::Flow) {
                    let known = self.code.branches.len() as u32;
                    let site = *self.branch_sites.entry(origin).or_insert(known);
                    if site == known {
                        self.code.branches.push(origin);
                    }
                    self.push(Instr::Branch(site, condition));
                }
                self.parted(condition, then, otherwise);
            }
            Step::Loop(id) => self.looped(id),
            Step::Switch(id) => self.switch(id),
            Step::Break(_) => {
                self.tick();
                self.push(Instr::Halt);
            }
            Step::Continue(_) => {
                self.tick();
                let waiting = self.frames.last().and_then(|f| f.waiting.last()).copied();
                self.push(Instr::Wait(waiting.unwrap_or(EMPTY)));
            }
            Step::Return(value, _) => self.returns(value),
            Step::Discard(_) => {
                self.tick();
                self.push(Instr::Discard);
            }
        }
        self.tidy();
    }

    fn condition(&mut self, op: OpId) -> Reg {
        let regs = self.operand(op);
        self.reg(regs, 0)
    }

    fn parted(&mut self, condition: Reg, then: Region, otherwise: Region) {
        let mark = self.slots();
        let others = self.slot();
        let mut jump = self.push(Instr::If {
            condition,
            others,
            to: 0,
        });
        self.tidy();
        self.region(then);
        if !self.module.steps(otherwise).is_empty() {
            self.land(jump);
            jump = self.push(Instr::Else { others, to: 0 });
            self.region(otherwise);
        }
        self.land(jump);
        self.push(Instr::EndIf { others });
        self.give_back_slots(mark);
    }

    fn looped(&mut self, id: LoopId) {
        self.tick();
        let Some(l) = self.module.looped(id).copied() else {
            return;
        };
        let mark = self.slots();
        let (came, waiting) = (self.slot(), self.slot());
        self.push(Instr::Keep(came));
        self.push(Instr::Clear(waiting));
        let watched = self.watches(Watch::Flow).then(|| {
            let number = self.code.loops.iter().position(|l| *l == id);
            let number = number.unwrap_or_else(|| {
                self.code.loops.push(id);
                self.code.loops.len() - 1
            }) as u32;
            self.push(Instr::Enter(number));
            number
        });
        let head = self.here();
        let mut exits = Vec::new();
        if l.tests_first {
            self.test(l.test, l.condition, watched, &mut exits);
        }
        if let Some(number) = watched {
            self.push(Instr::Turn(number));
        }
        if let Some(frame) = self.frames.last_mut() {
            frame.waiting.push(waiting);
        }
        self.region(l.body);
        if let Some(frame) = self.frames.last_mut() {
            frame.waiting.pop();
        }
        self.push(Instr::Resume(waiting));
        exits.push(self.push(Instr::SkipIfNone(0)));
        match l.tests_first {
            true => self.region(l.step),
            false => self.test(l.test, l.condition, watched, &mut exits),
        }
        self.push(Instr::Back(head));
        for exit in exits {
            self.land(exit);
        }
        if let Some(number) = watched {
            self.push(Instr::Leave(number));
        }
        let left = self.frames.last().map_or(EMPTY, |f| f.left);
        self.push(Instr::Restore {
            came,
            left,
            others: EMPTY,
        });
        self.give_back_slots(mark);
        self.tick();
    }

    fn test(
        &mut self,
        test: Region,
        condition: Option<OpId>,
        watched: Option<u32>,
        exits: &mut Vec<Target>,
    ) {
        self.region(test);
        self.tick();
        if let Some(condition) = condition {
            let condition = self.condition(condition);
            if let Some(number) = watched {
                self.push(Instr::Exhaust(number, condition));
            }
            exits.push(self.push(Instr::While { condition, to: 0 }));
        }
        self.tidy();
    }

    fn switch(&mut self, id: SwitchId) {
        self.tick();
        let module = self.module;
        let Some(switch) = module.switch(id) else {
            return;
        };
        let mark = self.slots();
        let selector = self.condition(switch.selector);
        let marks = self.case_marks(id, selector);
        let (came, waiting) = (self.slot(), self.slot());
        self.push(Instr::Keep(came));
        self.push(Instr::Keep(waiting));
        self.push(Instr::Halt);
        self.tidy();
        for (case, marked) in module.cases(switch).iter().zip(marks) {
            let jump = self.push(Instr::Case {
                waiting,
                marked,
                to: 0,
            });
            self.region(case.body);
            self.land(jump);
        }
        let frame = self.frames.last();
        let left = frame.map_or(EMPTY, |f| f.left);
        let others = frame.and_then(|f| f.waiting.last()).copied();
        self.push(Instr::Restore {
            came,
            left,
            others: others.unwrap_or(EMPTY),
        });
        self.give_back_slots(mark);
    }

    /// By case: where the lanes are marked that begin there.
    fn case_marks(&mut self, id: SwitchId, selector: Reg) -> Vec<Slot> {
        let module = self.module;
        let Some(switch) = module.switch(id) else {
            return Vec::new();
        };
        let mut all: Option<Reg> = None;
        let mut marks = Vec::new();
        let mut default = None;
        for case in module.cases(switch) {
            let slot = self.slot();
            marks.push(slot);
            let mut own: Option<Reg> = None;
            for label in module.labels(case) {
                match *label {
                    CaseLabel::Value(bits) => {
                        let bits = self.constant(bits);
                        let hit = self.two(F2::SameBits, selector, bits);
                        own = Some(self.either(own, hit));
                        self.registers.retain(hit);
                        all = Some(self.either(all, hit));
                    }
                    CaseLabel::Default => default = Some(slot),
                }
            }
            if default == Some(slot) {
                continue;
            }
            let own = own.unwrap_or_else(|| self.constant(0));
            self.push(Instr::Mark(slot, own));
            self.registers.release(own);
        }
        if let Some(slot) = default {
            // Labels beside `default` lead to the same place.
            let mut rest = all.unwrap_or_else(|| self.constant(0));
            let shared = module
                .cases(switch)
                .iter()
                .zip(&marks)
                .find(|(_, s)| **s == slot);
            for label in shared.map_or(&[][..], |(case, _)| module.labels(case)) {
                if let CaseLabel::Value(bits) = *label {
                    let bits = self.constant(bits);
                    let other = self.two(F2::OtherBits, selector, bits);
                    rest = self.then_two(F2::And, rest, other);
                    self.registers.release(other);
                }
            }
            let rest = self.then_one(F1::Not, rest);
            self.push(Instr::Mark(slot, rest));
            self.registers.release(rest);
        } else if let Some(all) = all {
            self.registers.release(all);
        }
        marks
    }

    fn either(&mut self, known: Option<Reg>, hit: Reg) -> Reg {
        match known {
            None => hit,
            Some(known) => {
                let made = self.then_two(F2::Or, known, hit);
                self.registers.release(hit);
                made
            }
        }
    }

    /// What stands for a function.
    pub fn frame(&mut self, function: FunctionRef) -> Frame {
        Frame {
            function,
            path: self.call_path(function),
            clock: self.plan.start(function),
            ended: 0,
            result: None,
            came: EMPTY,
            left: EMPTY,
            returned: Value::Nothing,
            waiting: Vec::new(),
        }
    }

    /// The number of the calls that lead to a function, called from where code is being made.
    fn call_path(&mut self, function: FunctionRef) -> u32 {
        if !self.watches(Watch::Flow) {
            return 0;
        }
        let path = CallPath {
            function: (function != GLOBALS).then_some(function),
            caller: self.frames.last().map(|f| f.path),
        };
        let known = self.code.calls.len() as u32;
        let number = *self.call_paths.entry(path).or_insert(known);
        if number == known {
            self.code.calls.push(path);
        }
        number
    }
}

/// Whether some lanes may not come out of a step.
fn leaves(module: &Module, step: &Step) -> bool {
    let inner = |region| module.steps(region).iter().any(|s| leaves(module, s));
    match *step {
        Step::Run(_) => false,
        Step::Break(_) | Step::Continue(_) | Step::Return(..) | Step::Discard(_) => true,
        Step::If {
            then, otherwise, ..
        } => inner(then) || inner(otherwise),
        Step::Loop(id) => module.looped(id).is_some_and(|l| inner(l.body)),
        Step::Switch(id) => module
            .switch(id)
            .is_some_and(|s| module.cases(s).iter().any(|c| inner(c.body))),
    }
}
