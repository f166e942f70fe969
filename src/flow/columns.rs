//! The columns of a texture that a shader reads, where their numbers follow from constants.
//!
//! A column is computed for each chain of calls that leads to a lookup, with the arguments of these
//! calls: `pressed(37)` and `pressed(39)` read two columns through one lookup.

use super::calls::{Bodies, Calls};
use super::reaching_definitions::{Def, DefId, ReachingDefinitions};
use shaderlint_ir::{Binary, Module, OpId, OpKind, Root, Unary};
use shaderlint_semantic::builtins::{BuiltinKind, Level};
use shaderlint_semantic::{Scalar, VariableId};
use std::collections::BTreeSet;

/// Maximum number of steps for one texture.
const BUDGET: u32 = 1 << 14;

/// Maximum nesting of calls and expressions.
const MAX_DEPTH: u32 = 64;

/// Maximum number of values of one component.
const MAX_VALUES: usize = 64;

/// The columns of a texture that are read.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct ColumnReads {
    /// The known columns, from the left.
    pub columns: BTreeSet<u32>,
    /// Whether other columns may be read, too.
    pub reads_others: bool,
}

/// The columns that lookups read from the texture of a uniform, which has `width` columns.
pub fn column_reads(
    module: &Module,
    defs: &ReachingDefinitions,
    calls: &Calls,
    uniform: VariableId,
    width: u32,
) -> ColumnReads {
    let mut found = ColumnReads::default();
    let mut finder = ColumnFinder {
        module,
        defs,
        bodies: Bodies::of(module),
        left: BUDGET,
    };
    for op in (0..module.ops.len() as u32).map(OpId) {
        let OpKind::Builtin(id, list) = module.op(op).kind else {
            continue;
        };
        let BuiltinKind::Lookup(lookup) = id.kind() else {
            continue;
        };
        let [sampler, coordinates, ..] = module.operands(list) else {
            continue;
        };
        let scale = match lookup.level {
            Level::Fetch => 1.0,
            _ => f64::from(width),
        };
        let is_plain = !lookup.is_projective && !lookup.has_offset;
        let Some(chains) = finder.chains(calls, op) else {
            found.reads_others = true;
            continue;
        };
        for chain in chains {
            if finder.sampler(*sampler, &chain) != Some(uniform) {
                continue;
            }
            match finder.lane(*coordinates, 0, &chain, 0).filter(|_| is_plain) {
                Some(values) => found.columns.extend(columns(&values, scale, width)),
                None => found.reads_others = true,
            }
        }
    }
    found
}

/// The columns at coordinates, without those outside of the texture.
fn columns(values: &[f64], scale: f64, width: u32) -> impl Iterator<Item = u32> {
    let columns = values.iter().map(move |value| (value * scale).floor());
    let inside = columns.filter(move |column| (0.0..f64::from(width)).contains(column));
    inside.map(|column| column as u32)
}

struct ColumnFinder<'a> {
    module: &'a Module,
    defs: &'a ReachingDefinitions,
    bodies: Bodies<'a>,
    /// The remaining steps.
    left: u32,
}

impl ColumnFinder<'_> {
    /// The uniform that a sampler operand is in a chain of calls.
    fn sampler(&self, operand: OpId, chain: &[OpId]) -> Option<VariableId> {
        let OpKind::Load(place) = self.module.op(operand).kind else {
            return None;
        };
        let variable = self.module.place(place).variable;
        if self.module.variable(variable)?.root == Root::Uniform {
            return Some(variable);
        }
        let (call, outer) = chain.split_last()?;
        let OpKind::Call(function, list) = self.module.op(*call).kind else {
            return None;
        };
        let parameters = self.module.parameters(self.module.function(function)?);
        let position = parameters.iter().position(|p| *p == variable)?;
        self.sampler(*self.module.operands(list).get(position)?, outer)
    }

    /// The chains of calls that lead from the entry point to an operation, innermost call last.
    /// `None` if there are too many.
    fn chains(&mut self, calls: &Calls, op: OpId) -> Option<Vec<Vec<OpId>>> {
        let mut done = Vec::new();
        let mut todo = vec![(self.bodies.around(op), Vec::new())];
        while let Some((function, mut chain)) = todo.pop() {
            self.left = self.left.checked_sub(1)?;
            let Some(function) = function.filter(|f| Some(*f) != self.module.entry) else {
                chain.reverse();
                done.push(chain);
                continue;
            };
            todo.extend(calls.calls_of(function).map(|call| {
                let mut longer = chain.clone();
                longer.push(call.op);
                (call.caller, longer)
            }));
        }
        Some(done)
    }

    /// The values that a component may have in a chain of calls; `None` if one is not known.
    fn lane(&mut self, op: OpId, lane: u32, chain: &[OpId], depth: u32) -> Option<Vec<f64>> {
        self.left = self.left.checked_sub(1)?;
        let depth = (depth < MAX_DEPTH).then_some(depth + 1)?;
        let module = self.module;
        if let Some((part, lane)) = self.defs.part_of(module, op, lane) {
            return self.lane(part, lane, chain, depth);
        }
        if self.defs.is_element(module, op) {
            return None;
        }
        let is_integer = module.ty(op).scalar_kind() != Some(Scalar::Float);
        match module.op(op).kind {
            OpKind::Const(_) => {
                let value = module.constant(op).get(lane as usize)?;
                Some(vec![value.as_double()])
            }
            OpKind::Load(_) => self.def(self.defs.seen(op, lane), chain, depth),
            OpKind::Convert(from) => {
                let values = self.lane(from, module.operand_lane(from, lane), chain, depth)?;
                let convert = |v: f64| if is_integer { v.trunc() } else { v };
                Some(values.into_iter().map(convert).collect())
            }
            OpKind::Unary(Unary::Negate, a) => {
                let values = self.lane(a, module.operand_lane(a, lane), chain, depth)?;
                Some(values.into_iter().map(|v| -v).collect())
            }
            OpKind::Binary(operator, a, b) => {
                let a = self.lane(a, module.operand_lane(a, lane), chain, depth)?;
                let b = self.lane(b, module.operand_lane(b, lane), chain, depth)?;
                let pairs = a.iter().flat_map(|a| b.iter().map(move |b| (*a, *b)));
                few(pairs.map(|(a, b)| computed(operator, a, b, is_integer)))
            }
            OpKind::Select {
                then, otherwise, ..
            } => {
                let then = self.lane(then, lane, chain, depth)?;
                let otherwise = self.lane(otherwise, lane, chain, depth)?;
                few(then.into_iter().chain(otherwise).map(Some))
            }
            OpKind::Call(function, _) => {
                let value = self.defs.value_of(function)?;
                let inner = [chain, &[op]].concat();
                self.lane(value, lane, &inner, depth)
            }
            _ => None,
        }
    }

    fn def(&mut self, def: DefId, chain: &[OpId], depth: u32) -> Option<Vec<f64>> {
        let defs = self.defs;
        match defs.get(defs.unrefined(def)) {
            Def::Stored { value, lane } => self.lane(value, lane, chain, depth),
            Def::Merge { sides, .. } => {
                let mut all = Vec::new();
                for side in defs.list(sides) {
                    all.extend(self.def(*side, chain, depth)?.into_iter().map(Some));
                }
                few(all.into_iter())
            }
            Def::Entry(slot) => {
                let (variable, _) = defs.variable_at(slot);
                if self.module.variable(variable)?.root == Root::Global {
                    return match defs.global_writes(slot) {
                        [only] => self.def(*only, &[], depth),
                        _ => None,
                    };
                }
                let (call, outer) = chain.split_last()?;
                let (value, lane) = defs.argument(self.module, *call, slot)?;
                self.lane(value, lane, outer, depth)
            }
            _ => None,
        }
    }
}

/// Different values, if all are known and there are few.
fn few(values: impl Iterator<Item = Option<f64>>) -> Option<Vec<f64>> {
    let mut all: Vec<f64> = Vec::new();
    for value in values {
        let value = value?;
        if !all.contains(&value) {
            all.push(value);
        }
    }
    (all.len() <= MAX_VALUES).then_some(all)
}

fn computed(operator: Binary, a: f64, b: f64, is_integer: bool) -> Option<f64> {
    let value = match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide if is_integer => (a / b).trunc(),
        Binary::Divide => a / b,
        _ => return None,
    };
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_shader::{TestShader, cases};

    /// The columns of `iChannel0` that a shader reads.
    fn read(code: &str) -> (Vec<u32>, bool) {
        let shader = TestShader::of(code);
        let program = &shader.program;
        let name = program.names.get("iChannel0").unwrap();
        let mut variables = (0..).map(VariableId).zip(&program.variables);
        let (uniform, _) = variables.find(|(_, v)| v.name == name).unwrap();
        let found = column_reads(&shader.module, &shader.defs, &shader.calls, uniform, 256);
        (found.columns.into_iter().collect(), found.reads_others)
    }

    #[test]
    fn read_columns_are_found() {
        for (code, expected) in cases(include_str!("columns.txt")) {
            let (columns, reads_others) = read(code);
            assert_eq!(format!("{columns:?} {reads_others}"), expected, "{code}");
        }
    }
}
