//! What of the image depends on the initial values of variables that the code does not set.

use crate::facts::Facts;
use shaderlint_exec::CompileOptions;
use shaderlint_flow::UnassignedVariable;
use shaderlint_ir::{OpId, OpKind};

/// Bits of 7.25, an initial value that shaders do not use themselves.
const RUBBISH: u32 = 0x40e8_0000;

impl Facts<'_> {
    /// The share of pixels that change visibly if one variable, or all for `None`, start with another
    /// value than 0; `None` if none do.
    pub fn changed_by_initial_value(&self, undefined_at: Option<OpId>) -> Option<f64> {
        let options = CompileOptions {
            undefined: RUBBISH,
            undefined_at,
            ..CompileOptions::default()
        };
        let (bench, _) = self.bench()?;
        let rubbish = self.compiled(&options)?;
        let changed = self.difference([bench.watched(), &rubbish], self.fewer_quads()?)?;
        (changed > 0.0).then_some(changed)
    }

    /// The operation that leaves a variable without a value where it is declared.
    pub fn initial_value(&self, unset: UnassignedVariable) -> Option<OpId> {
        let module = self.module();
        module.ops.iter().find_map(|op| match op.kind {
            OpKind::Store(place, value) => {
                let is_own = module.place(place).variable == unset.variable;
                (is_own && module.op(value).kind == OpKind::Undef).then_some(value)
            }
            _ => None,
        })
    }
}
