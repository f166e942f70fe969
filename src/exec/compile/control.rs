//! Lowering of control flow to execution masks.

use super::emit::CallFrame;
use super::emit::{Compiler, Value};
use super::plan::GLOBALS;
use crate::bytecode::{CallPath, Charge, EMPTY, F1, F2, Instr, InstrIndex, MaskSlot, Reg};
use crate::options::Watch;
use shaderlint_ir::{
    CaseLabel, Loop, LoopId, Module, OpId, Provenance, Region, Run, Step, Switch, Visit,
};
use shaderlint_semantic::FunctionRef;
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::SetAt;

impl<'m> Visit<'m> for Compiler<'m> {
    type Out = ();

    fn module(&self) -> &'m Module {
        self.module
    }

    /// Compiles a region. After a step that lanes may not leave normally, the rest is skipped if no
    /// lane is active.
    fn region(&mut self, region: Region) {
        let module = self.module;
        let steps = module.steps(region);
        let mut skips: Vec<InstrIndex> = Vec::new();
        let stretches = steps.split_inclusive(|step| leaves(module, step));
        for (number, stretch) in stretches.enumerate() {
            if number > 0 {
                skips.push(self.push(Instr::SkipIfNone(0)));
            }
            self.spend(stretch);
            for step in stretch {
                if self.has_failed() {
                    return;
                }
                self.step(step);
            }
        }
        for skip in skips {
            self.land(skip);
        }
    }

    fn run(&mut self, run: Run) {
        for op in run.ops() {
            self.op = op;
            self.stop_at(op);
            self.tick();
            let value = self.operation(op).unwrap_or_default();
            let value = self.narrowed(op, value);
            let value = self.rescaled(op, value);
            self.values.set_at(op.0 as usize, value);
            self.probe(op);
            self.note_ray(op);
            self.trace_write(op);
            self.tidy();
            if self.has_failed() {
                return;
            }
        }
        self.tidy();
    }

    fn branch(&mut self, condition: OpId, sides: [Region; 2], origin: Provenance) {
        self.tick();
        let condition = self.condition(condition);
        if self.watches(Watch::Faults) {
            let known = self.code.branches.len() as u32;
            let site = *self.branch_sites.entry(origin).or_insert(known);
            if site == known {
                self.code.branches.push(origin);
            }
            self.push(Instr::Branch(site, condition));
        }
        self.divergent_branch(condition, sides);
        self.tidy();
    }

    fn looped(&mut self, id: LoopId, l: &'m Loop) {
        self.tick();
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
        self.enter_rays(id);
        self.forget_stop();
        let head = self.here();
        let mut exits = Vec::new();
        if l.tests_first {
            self.test(l.test, l.condition, watched, &mut exits);
        }
        if let Some(number) = watched {
            self.push(Instr::Iterate(number));
        }
        self.iterate_rays(id);
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

    fn switch(&mut self, switch: &'m Switch) {
        self.tick();
        let module = self.module;
        let mark = self.slots();
        let selector = self.condition(switch.selector);
        let marks = self.case_marks(switch, selector);
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

    fn breaks(&mut self, stmt: StmtId) {
        self.stop_before(Provenance::Stmt(stmt));
        self.tick();
        self.push(Instr::Halt);
        self.tidy();
    }

    fn continues(&mut self, stmt: StmtId) {
        self.stop_before(Provenance::Stmt(stmt));
        self.tick();
        let waiting = self.frames.last().and_then(|f| f.waiting.last()).copied();
        self.push(Instr::Wait(waiting.unwrap_or(EMPTY)));
        self.tidy();
    }

    fn returns(&mut self, value: Option<OpId>, stmt: StmtId) {
        self.stop_before(Provenance::Stmt(stmt));
        self.returned(value);
        self.tidy();
    }

    fn discards(&mut self, stmt: StmtId) {
        self.stop_before(Provenance::Stmt(stmt));
        self.tick();
        self.push(Instr::Discard);
        self.tidy();
    }
}

impl Compiler<'_> {
    /// Compiles the whole shader: global initialisers, then the entry point.
    pub fn run(&mut self, entry: FunctionRef) {
        self.clear_outer();
        self.open_probe();
        self.open_rays();
        let globals = self.frame(GLOBALS, None);
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
        let frame = self.frame(entry, None);
        self.frames.push(frame);
        self.begin_frame();
        self.region(body);
        let returned = self.end_frame();
        if let Value::Regs(regs) = returned {
            let ty = self.module.function(entry).map(|f| f.returns);
            let regs = self.list(regs).to_vec();
            self.code.outputs.push(crate::bytecode::OutputSlot {
                name: String::new(),
                ty: ty.unwrap_or(shaderlint_semantic::Type::VOID),
                regs,
            });
        }
        self.close_probe();
        self.close_rays();
    }

    fn condition(&mut self, op: OpId) -> Reg {
        let regs = self.operand(op);
        self.reg(regs, 0)
    }

    fn divergent_branch(&mut self, condition: Reg, [then, otherwise]: [Region; 2]) {
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

    fn test(
        &mut self,
        test: Region,
        condition: Option<OpId>,
        watched: Option<u32>,
        exits: &mut Vec<InstrIndex>,
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

    /// Computes the lanes that enter each case, and stores them in one mask slot per case.
    fn case_marks(&mut self, switch: &Switch, selector: Reg) -> Vec<MaskSlot> {
        let module = self.module;
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
            // Labels next to `default` lead to the same case.
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

    /// A new call frame for a function. `call` calls it, unless it is the entry point.
    pub fn frame(&mut self, function: FunctionRef, call: Option<OpId>) -> CallFrame {
        CallFrame {
            function,
            path: self.call_path(function, call),
            clock: self.plan.start(function),
            ended: 0,
            result: None,
            came: EMPTY,
            left: EMPTY,
            returned: Value::Nothing,
            waiting: Vec::new(),
            stop: None,
            kept: Vec::new(),
        }
    }

    /// Charges for steps that the same lanes execute.
    fn spend(&mut self, steps: &[Step]) {
        if !self.options.cost {
            return;
        }
        let module = self.module;
        let parts: Vec<_> = steps.iter().flat_map(|s| module.step_costs(s)).collect();
        let cost: u32 = parts.iter().map(|(_, cost)| cost).sum();
        if cost > 0 {
            let path = self.frames.last().map_or(0, |f| f.path);
            let by = self.code.charges.len() as u32;
            self.code.charges.push(Charge { path, parts });
            self.push(Instr::Spend { cost, by });
        }
    }

    /// The index of the call path from the current position to a function.
    fn call_path(&mut self, function: FunctionRef, call: Option<OpId>) -> u32 {
        if !self.options.cost && !self.options.steps {
            return 0;
        }
        let path = CallPath {
            function: (function != GLOBALS).then_some(function),
            call,
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

/// Whether some lanes may not continue after a step.
fn leaves(module: &Module, step: &Step) -> bool {
    let mut inside = module.inside(step).into_iter();
    step.is_jump() || inside.any(|r| module.steps(r).iter().any(|s| leaves(module, s)))
}
