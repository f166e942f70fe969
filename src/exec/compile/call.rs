//! Lowering of calls: every call is inlined.

use super::emit::{Compiler, Made, Value};
use crate::bytecode::{EMPTY, Instr};
use shaderlint_ir::{OpId, Root, Step, Visit};
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::List;

impl Compiler<'_> {
    /// Compiles a call. Returns its value.
    pub fn call(&mut self, id: OpId, callee: FunctionRef, arguments: List) -> Made<Value> {
        let module = self.module;
        let function = *module.function(callee)?;
        let Some(body) = function.body else {
            return self.refuse("a function without a definition");
        };
        let parameters = module.parameters(&function);
        for (&parameter, &argument) in parameters.iter().zip(module.operands(arguments)) {
            self.pass(parameter, argument)?;
        }
        let frame = self.frame(callee, Some(id));
        self.frames.push(frame);
        self.begin_frame();
        for &parameter in parameters {
            self.trace_parameter(parameter);
        }
        self.region(body);
        for (number, &parameter) in (0..).zip(parameters) {
            let root = module.variable(parameter).map(|v| v.root);
            if matches!(root, Some(Root::ParameterOut | Root::ParameterInout)) {
                let value = self.variable_value(parameter);
                self.retain(value);
                self.taken_back.insert((id, number), value);
            }
        }
        let returned = self.end_frame();
        self.op = id;
        self.stop_after(id, returned);
        Some(returned)
    }

    /// Passes an argument: as an alias if the parameter is never written to, as a copy otherwise.
    fn pass(&mut self, parameter: VariableId, argument: OpId) -> Made<()> {
        let known = *self.module.variable(parameter)?;
        let value = self.value(argument);
        if self.plan.is_name(self.module, parameter) || matches!(value, Value::Samplers(_)) {
            self.retain(value);
            self.set_variable(parameter, value);
            return Some(());
        }
        let Some(count) = self.scalars(known.ty) else {
            return self.refuse("a parameter with more than 32,768 scalars");
        };
        let from = self.in_registers(value);
        let first = self.registers.row(count, parameter, false);
        let regs = self.listed((0..count).map(|n| first.saturating_add(n as u16)));
        for at in 0..count {
            let (to, from) = (self.reg(regs, at), self.reg(from, at));
            self.push(Instr::Move(to, from));
        }
        self.set_variable(parameter, Value::Regs(regs));
        Some(())
    }

    /// Sets up a call frame; a function with early returns gets registers for its result and mask
    /// slots.
    pub fn begin_frame(&mut self) {
        let Some(function) = self.frames.last().map(|f| f.function) else {
            return;
        };
        if !self.plan.leaves_early(function) {
            return;
        }
        let (came, left) = (self.slot(), self.slot());
        self.push(Instr::Keep(came));
        self.push(Instr::Clear(left));
        let known = self.module.function(function).copied();
        let ty = known.map(|f| f.returns).filter(|t| !t.is_void());
        let result = ty.and_then(|ty| {
            let count = self.scalars(ty);
            if count.is_none() {
                let _: Made<()> = self.refuse("a return value with more than 32,768 scalars");
            }
            let fresh: Vec<_> = (0..count?).map(|_| self.registers.fresh()).collect();
            Some(self.listed(fresh))
        });
        let steps = known.and_then(|f| f.body).map(|b| self.module.steps(b));
        let always_returns = matches!(steps.and_then(|s| s.last()), Some(Step::Return(..)));
        if let (Some(result), false) = (result, always_returns) {
            self.zero(result);
        }
        if let Some(frame) = self.frames.last_mut() {
            (frame.came, frame.left, frame.result) = (came, left, result);
        }
    }

    /// Compiles a `return`.
    pub fn returned(&mut self, value: Option<OpId>) {
        self.tick();
        if let Some(op) = value {
            self.trace_return(op);
        }
        let Some(frame) = self.frames.last() else {
            return;
        };
        let (result, left, function) = (frame.result, frame.left, frame.function);
        if left == EMPTY {
            if let Some(op) = value {
                let value = self.value(op);
                let value = self.outlived(value, function);
                if let Some(frame) = self.frames.last_mut() {
                    frame.returned = value;
                }
            }
            return;
        }
        if let (Some(result), Some(op)) = (result, value) {
            let from = self.operand(op);
            for at in 0..result.len {
                let (to, from) = (self.reg(result, at), self.reg(from, at));
                self.push(Instr::MoveActive(to, from));
            }
        }
        self.push(Instr::Wait(left));
    }

    /// A value that outlives its function: registers of variables that live on are copied, as these
    /// may change.
    fn outlived(&mut self, value: Value, function: FunctionRef) -> Value {
        let Value::Regs(regs) = value else {
            return value;
        };
        let mut made = Vec::with_capacity(regs.len as usize);
        for at in 0..regs.len {
            let reg = self.reg(regs, at);
            let owner = self.registers.owner(reg);
            let owner = owner.and_then(|v| self.module.variable(v));
            match owner {
                Some(owner) if owner.function != Some(function) => {
                    made.push(self.fresh(Instr::Move(0, reg)));
                }
                _ => {
                    self.registers.retain(reg);
                    made.push(reg);
                }
            }
        }
        Value::Regs(self.listed(made))
    }

    /// Ends a function. Returns its result, retained once.
    pub fn end_frame(&mut self) -> Value {
        self.tick();
        self.tidy();
        let Some(frame) = self.frames.pop() else {
            return Value::Nothing;
        };
        if frame.left != EMPTY {
            self.push(Instr::Restore {
                came: frame.came,
                left: EMPTY,
                others: EMPTY,
            });
            self.give_back_slots(frame.came);
        }
        self.stop_at_end(&frame);
        for &variable in &frame.kept {
            self.forget(variable);
        }
        match frame.left {
            EMPTY => frame.returned,
            _ => frame.result.map_or(Value::Nothing, Value::Regs),
        }
    }

    /// The location of a variable.
    pub fn variable_value(&self, variable: VariableId) -> Value {
        let value = self.variables.get(variable.0 as usize);
        value.copied().unwrap_or_default()
    }
}
