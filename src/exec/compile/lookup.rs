//! Lowering of texture lookups.

use super::emit::{Compiler, Made, Value};
use crate::bytecode::{F2, Instr, LookupQuery, LookupSite, Reg};
use shaderlint_ir::OpId;
use shaderlint_semantic::builtins::{Level, Lookup};
use shaderlint_semantic::{Sampler, Type};

/// The number of coordinates of a sampler type, and whether it compares depth.
const fn taken(sampler: Sampler) -> (usize, bool) {
    use Sampler::*;
    match sampler {
        Sampler2D | Isampler2D | Usampler2D => (2, false),
        Sampler3D | Isampler3D | Usampler3D | SamplerCube | IsamplerCube | UsamplerCube
        | Sampler2DArray | Isampler2DArray | Usampler2DArray => (3, false),
        Sampler2DShadow => (2, true),
        SamplerCubeShadow | Sampler2DArrayShadow => (3, true),
    }
}

impl Compiler<'_> {
    /// The index and type of the sampler that an operand holds.
    fn sampler(&mut self, op: OpId) -> Made<(u32, Sampler)> {
        let Value::Samplers(number) = self.value(op) else {
            return self.refuse("an unknown sampler");
        };
        match self.module.ty(op).as_sampler() {
            Some(sampler) => Some((number, sampler)),
            None => self.refuse("an unknown sampler"),
        }
    }

    /// Compiles `textureSize`.
    pub fn size(&mut self, operands: &[OpId]) -> Made<Value> {
        let (number, sampler) = self.sampler(*operands.first()?)?;
        let level = self.operand(*operands.get(1)?);
        let level = vec![self.reg(level, 0)];
        use Sampler::*;
        let count = match sampler {
            Sampler3D | Isampler3D | Usampler3D | Sampler2DArray | Isampler2DArray
            | Usampler2DArray | Sampler2DArrayShadow => 3,
            _ => 2,
        };
        let site = LookupSite {
            sampler: number as u16,
            query: LookupQuery::Size,
            coordinates: Vec::new(),
            reference: None,
            level,
            offset: [0; 3],
            results: Vec::new(),
        };
        Some(self.asked(site, count))
    }

    /// Compiles a lookup. The operands are the sampler, coordinates, level or gradients, offset and
    /// bias.
    pub fn lookup(&mut self, lookup: Lookup, operands: &[OpId], ty: Type) -> Made<Value> {
        let (number, sampler) = self.sampler(*operands.first()?)?;
        let (count, compares) = taken(sampler);
        let point = self.operand(*operands.get(1)?);
        let mut point: Vec<Reg> = self.list(point).to_vec();
        let mut made_here = Vec::new();
        if lookup.is_projective
            && let Some(divisor) = point.pop()
        {
            for at in &mut point {
                *at = self.two(F2::Divide, *at, divisor);
                made_here.push(*at);
            }
        }
        let reference = compares.then(|| point.get(count).copied()).flatten();
        point.truncate(count);
        let mut rest = operands.iter().skip(2).copied();
        let mut level = Vec::new();
        let mut query = match lookup.level {
            Level::Implicit => LookupQuery::Implicit,
            Level::Explicit => LookupQuery::Explicit,
            Level::Gradient => LookupQuery::Gradient,
            Level::Fetch => LookupQuery::Fetch,
        };
        let given = match lookup.level {
            Level::Implicit => 0,
            Level::Explicit | Level::Fetch => 1,
            Level::Gradient => 2,
        };
        for op in rest.by_ref().take(given) {
            let regs = self.operand(op);
            level.extend_from_slice(self.list(regs));
        }
        let mut offset = [0; 3];
        if lookup.has_offset {
            let constants = rest.next().map_or(&[][..], |op| self.module.constant(op));
            for (slot, value) in offset.iter_mut().zip(constants) {
                *slot = value.as_int();
            }
        }
        if let (LookupQuery::Implicit, Some(bias)) = (query, rest.next()) {
            let regs = self.operand(bias);
            level.extend_from_slice(self.list(regs));
        }
        // Vertex shaders have no implicit derivatives.
        if query == LookupQuery::Implicit
            && self.module.stage == Some(shaderlint_semantic::Stage::Vertex)
        {
            query = LookupQuery::Explicit;
            level = vec![self.constant(0)];
        }
        let site = LookupSite {
            sampler: number as u16,
            query,
            coordinates: point,
            reference,
            level,
            offset,
            results: Vec::new(),
        };
        let made = self.asked(site, ty.components());
        made_here
            .into_iter()
            .for_each(|reg| self.registers.release(reg));
        Some(made)
    }

    fn asked(&mut self, mut site: LookupSite, count: u32) -> Value {
        let fresh: Vec<Reg> = (0..count).map(|_| self.registers.fresh()).collect();
        site.results = fresh.clone();
        let number = self.code.lookups.len() as u32;
        self.code.lookups.push(site);
        self.push(Instr::Lookup(number));
        Value::Regs(self.listed(fresh))
    }
}
