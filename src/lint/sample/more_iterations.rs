//! Change of the image if a loop may run more iterations.

use super::bench::colors;
use super::{INSTANTS, Round, SIZE, SampledPixel};
use crate::facts::Facts;
use shaderlint_exec::{Bytecode, CompileOptions, compile, quads_all_over};
use shaderlint_flow::LoopFacts;
use shaderlint_ir::{Module, OpKind};
use shaderlint_semantic::Value;

/// Smallest visible difference of a channel.
pub const APART: f32 = 8.0 / 255.0;

impl Facts<'_> {
    /// The share of sampled pixels that change visibly if a loop may run twice as many iterations; `None`
    /// where the limit is not a constant.
    pub fn change_by_more_iterations(&self, looped: &LoopFacts) -> Option<f64> {
        let (bench, _) = self.bench()?;
        let longer = self.with_doubled_iterations(looped)?;
        let after = compile(self.program(), &longer, &CompileOptions::default()).ok()?;
        // Most loops that run out of steps leave nothing to see.
        self.changed_in(Round::Second, &after)
            .filter(|c| *c > 0.0)?;
        self.difference([bench.watched(), &after], self.fewer_quads()?)
    }

    /// The share of the pixels of a round that look different with other bytecode.
    pub fn changed_in(&self, round: Round, code: &Bytecode) -> Option<f64> {
        let before = self.round(round)?;
        let (bench, supplier) = self.bench()?;
        let mut changed = 0;
        for frame in &before.frames {
            let after = bench.sample(code, supplier, &frame.instant, &frame.quads())?;
            let all = frame.colors.iter().zip(colors(code, &after));
            changed += all.filter(|(a, b)| is_apart(**a, *b)).count();
        }
        Some(changed as f64 / before.pixels.max(1) as f64)
    }

    /// The share of sampled pixels that differ visibly between two versions of the bytecode.
    pub fn difference(&self, codes: [&Bytecode; 2], quads: usize) -> Option<f64> {
        let (bench, supplier) = self.bench()?;
        let (mut all, mut other) = (0_u64, 0_u64);
        for (instant, number) in INSTANTS.iter().zip(0..) {
            let quads = quads_all_over(SIZE, quads, number);
            let [before, after] = codes.map(|code| {
                let sampled = bench.sample(code, supplier, instant, &quads)?;
                Some(colors(code, &sampled))
            });
            for (before, after) in before?.into_iter().zip(after?) {
                all += 1;
                other += u64::from(is_apart(before, after));
            }
        }
        Some(other as f64 / all.max(1) as f64)
    }

    /// The shader with a doubled iteration limit of a loop.
    fn with_doubled_iterations(&self, looped: &LoopFacts) -> Option<Module> {
        let op = self.module().op_of(looped.given?)?;
        let doubled = match self.module().constant(op) {
            [Value::Int(n)] => Value::Int(n.checked_mul(2)?),
            [Value::Uint(n)] => Value::Uint(n.checked_mul(2)?),
            [Value::Float(n)] => Value::Float(n * 2.0),
            _ => return None,
        };
        let mut module = self.module().clone();
        let constant = module.pool.add([doubled]);
        let slot = module.ops.get_mut(op.0 as usize)?;
        slot.kind = OpKind::Const(constant);
        Some(module)
    }
}

/// Whether two colours differ visibly.
pub fn is_apart(a: [f32; 3], b: [f32; 3]) -> bool {
    let shown = |color| SampledPixel { at: [0; 2], color }.shown();
    let mut lanes = shown(a).into_iter().zip(shown(b));
    lanes.any(|(a, b)| (a - b).abs() > APART)
}
