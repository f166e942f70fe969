//! The probe: outputs a variable or value in addition to the outputs of the shader.

use super::emit::{Compiler, Made, Probed, Value};
use crate::bytecode::{Instr, OutputSlot};
use crate::options::Probe;
use shaderlint_ir::{OpId, OpKind};
use shaderlint_semantic::Type;
use shaderlint_text::Span;

/// Maximum number of scalars that are output.
const SHOWN: u32 = 4;

impl Compiler<'_> {
    /// Allocates the registers of the probe.
    pub fn open_probe(&mut self) -> Made<()> {
        let ty = match self.options.probe? {
            Probe::Variable { variable, .. } => self.module.variable(variable)?.ty,
            Probe::Value(op) | Probe::Part(op, _) => self.module.ty(op),
        };
        let count = self
            .scalars_of(ty)?
            .saturating_sub(self.probed_from())
            .min(SHOWN);
        let fresh: Vec<_> = (0..count + 1).map(|_| self.registers.fresh()).collect();
        let reached = *fresh.last()?;
        let all = self.listed(fresh);
        self.zero(all);
        self.probed = Some(Probed {
            ty,
            scalars: Compiler::part(all, 0, count),
            reached,
        });
        Some(())
    }

    /// Copies the probed value, if this operation is to be observed.
    pub fn probe(&mut self, op: OpId) -> Made<()> {
        let value = match self.options.probe? {
            Probe::Value(probed) | Probe::Part(probed, _) if probed == op => self.value(op),
            Probe::Value(_) | Probe::Part(..) => return None,
            Probe::Variable { variable, within } => {
                let place = match self.module.op(op).kind {
                    OpKind::Load(place) | OpKind::Store(place, _) => place,
                    _ => return None,
                };
                let is_it = self.module.place(place).variable == variable;
                let at = self.place_in_text(op).filter(|_| is_it)?;
                let is_within = within.start <= at.start && at.start < within.end;
                is_within.then(|| self.variable_value(variable))?
            }
        };
        let (Value::Regs(from), Some(probed)) = (value, self.probed) else {
            return None;
        };
        let to = probed.scalars;
        let first = self.probed_from();
        for n in 0..to.len.min(from.len.saturating_sub(first)) {
            let (to, from) = (self.reg(to, n), self.reg(from, first + n));
            self.push(Instr::MoveActive(to, from));
        }
        let holds = self.constant(u32::MAX);
        self.push(Instr::MoveActive(probed.reached, holds));
        Some(())
    }

    /// The first scalar that is output.
    const fn probed_from(&self) -> u32 {
        match self.options.probe {
            Some(Probe::Part(_, from)) => from,
            _ => 0,
        }
    }

    fn place_in_text(&self, op: OpId) -> Option<Span> {
        let extent = self.module.provenance(op).extent(&self.program.tree)?;
        Some(self.program.token(extent.first)?.span)
    }

    /// Appends the probe to the outputs.
    pub fn close_probe(&mut self) {
        let Some(probed) = self.probed else {
            return;
        };
        let name = match self.options.probe {
            Some(Probe::Variable { variable, .. }) => self.program.variable(variable),
            _ => None,
        };
        let name = name.map_or("", |v| self.program.names.text(v.name));
        let (name, regs) = (name.to_string(), self.list(probed.scalars).to_vec());
        let value = OutputSlot {
            name,
            ty: probed.ty,
            regs,
        };
        let reached = OutputSlot {
            name: "reached".to_string(),
            ty: Type::BOOL,
            regs: vec![probed.reached],
        };
        self.code.outputs.extend([value, reached]);
    }
}
