//! Marks the values that a trace records.

use super::emit::{Compiler, Made, Value};
use super::plan::GLOBALS;
use crate::bytecode::{Instr, MAX_TRACED, TraceSite, TracedValue};
use shaderlint_ir::{OpId, OpKind, Root};
use shaderlint_semantic::{Type, VariableId};

impl Compiler<'_> {
    /// Records the variable that an operation writes.
    pub fn trace_write(&mut self, op: OpId) -> Made<()> {
        let OpKind::Store(place, _) = self.module.op(op).kind else {
            return None;
        };
        let variable = self.module.place(place).variable;
        let ty = self.traced_type(variable)?;
        let value = self.variable_value(variable);
        self.traced(TracedValue::Written(variable, op), ty, value)
    }

    /// Records a parameter at the start of a call.
    pub fn trace_parameter(&mut self, parameter: VariableId) -> Made<()> {
        let root = self.module.variable(parameter)?.root;
        let ty = self.traced_type(parameter)?;
        let is_given = matches!(root, Root::Parameter | Root::ParameterInout);
        let value = is_given.then(|| self.variable_value(parameter))?;
        self.traced(TracedValue::Parameter(parameter), ty, value)
    }

    /// Records the result of a call.
    pub fn trace_return(&mut self, op: OpId) -> Made<()> {
        let (ty, value) = (self.module.ty(op), self.value(op));
        self.traced(TracedValue::Returned(op), ty, value)
    }

    /// The type of a variable that the shader declares; temporaries are not traced.
    fn traced_type(&self, variable: VariableId) -> Made<Type> {
        let known = self.module.variable(variable)?;
        (known.root != Root::Temporary).then_some(known.ty)
    }

    fn traced(&mut self, traced: TracedValue, ty: Type, value: Value) -> Made<()> {
        if !self.options.trace {
            return None;
        }
        let regs = match value {
            Value::Regs(regs) => regs,
            Value::Memory { at, len } => self.in_registers(Value::Memory {
                at,
                len: len.min(MAX_TRACED as u32),
            }),
            Value::Nothing | Value::Samplers(_) => return None,
        };
        let function = self.frames.last().map(|frame| frame.function);
        let regs = self.list(regs).iter().copied().take(MAX_TRACED).collect();
        self.code.traces.push(TraceSite {
            value: traced,
            ty,
            function: function.filter(|function| *function != GLOBALS),
            regs,
        });
        let site = self.code.traces.len() as u32 - 1;
        self.push(Instr::Trace(site));
        Some(())
    }
}
