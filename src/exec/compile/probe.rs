//! A variable that is given out beside what the shader gives.

use super::emit::{Compiler, Made, Value};
use crate::exec::code::{Instr, OutputSlot};
use crate::ir::{OpId, OpKind};
use crate::text::Span;

/// How many of its scalars are given out.
const SHOWN: u32 = 4;

impl Compiler<'_> {
    /// Makes room for the variable that is looked at.
    pub fn open_probe(&mut self) -> Made<()> {
        let probe = self.options.probe?;
        let ty = self.module.variable(probe.variable)?.ty;
        let count = self.scalars_of(ty)?.min(SHOWN);
        let fresh: Vec<_> = (0..count).map(|_| self.registers.fresh()).collect();
        let regs = self.listed(fresh);
        self.zero(regs);
        self.probed = Some(regs);
        Some(())
    }

    /// Gives out the variable if an operation reads or writes it where it is looked at.
    pub fn probe(&mut self, op: OpId) -> Made<()> {
        let probe = self.options.probe?;
        let place = match self.module.op(op).kind {
            OpKind::Load(place) | OpKind::Store(place, _) => place,
            _ => return None,
        };
        if self.module.place(place).variable != probe.variable {
            return None;
        }
        let at = self.place_in_text(op)?;
        let is_within = probe.within.start <= at.start && at.start < probe.within.end;
        let (Value::Regs(from), Some(to)) = (self.variable_value(probe.variable), self.probed)
        else {
            return None;
        };
        for n in 0..to.len.min(from.len) {
            if is_within {
                let (to, from) = (self.reg(to, n), self.reg(from, n));
                self.push(Instr::MoveActive(to, from));
            }
        }
        Some(())
    }

    fn place_in_text(&self, op: OpId) -> Option<Span> {
        let extent = self.module.provenance(op).extent(&self.program.tree)?;
        Some(self.program.token(extent.first)?.span)
    }

    /// Tells where it went.
    pub fn close_probe(&mut self) {
        let (Some(probe), Some(regs)) = (self.options.probe, self.probed) else {
            return;
        };
        let Some(variable) = self.module.variable(probe.variable) else {
            return;
        };
        let name = self.program.variable(probe.variable).map(|v| v.name);
        self.code.outputs.push(OutputSlot {
            name: name.map_or("", |n| self.program.names.text(n)).to_string(),
            ty: variable.ty,
            regs: self.list(regs).to_vec(),
        });
    }
}
