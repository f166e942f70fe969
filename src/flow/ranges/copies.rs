//! Bitwise copies: whether two values may originate from the same value.

use super::Query;
use crate::reaching_definitions::{Def, DefId, Slot};
use crate::same::is_same;
use rustc_hash::FxHashSet;
use shaderlint_ir::{OpId, OpKind};
use shaderlint_semantic::builtins::Transfer;

/// Maximum number of copies followed per query.
const MAX_COPIES: usize = 600;
/// Maximum number of results of operations that are compared with others.
const MAX_COMPUTED: usize = 8;

/// The origin of a value, copies followed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum CopyOrigin {
    Constant(u32),
    /// A definition.
    Def(DefId),
    /// A slot on entry to the function.
    Entry(Slot),
    /// The result of an operation.
    Computed(OpId),
}

/// A value still to be followed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Copy {
    Lane(OpId, u32),
    Def(DefId),
}

/// All values that a value may be a copy of.
type Origins = FxHashSet<CopyOrigin>;

impl Query<'_> {
    /// Whether two numbers may be copies of the same value, so that comparing them for equality is
    /// exact: a variable and a constant assigned to it, or `min(a, b)` and `a`.
    pub fn may_be_copies(&self, a: OpId, b: OpId, lane: u32) -> bool {
        let (left, right) = (self.origins(a, lane), self.origins(b, lane));
        if !left.is_disjoint(&right) {
            return true;
        }
        let computed = |origin: &CopyOrigin| match origin {
            CopyOrigin::Computed(op) => Some(*op),
            _ => None,
        };
        let few = |all: &Origins| -> Vec<OpId> {
            let found = all.iter().filter_map(computed);
            found.take(MAX_COMPUTED).collect()
        };
        let (left, right) = (few(&left), few(&right));
        let is_same = |a: &OpId| {
            right
                .iter()
                .any(|b| is_same(self.module, self.defs, *a, *b))
        };
        left.iter().any(is_same)
    }

    fn origins(&self, op: OpId, lane: u32) -> Origins {
        let mut found = Origins::default();
        let mut seen = FxHashSet::default();
        let mut todo = vec![Copy::Lane(op, lane)];
        while let Some(next) = todo.pop() {
            if seen.len() > MAX_COPIES {
                break;
            }
            if seen.insert(next) {
                match next {
                    Copy::Lane(op, lane) => self.copied(op, lane, &mut todo, &mut found),
                    Copy::Def(def) => self.held(def, &mut todo, &mut found),
                }
            }
        }
        found
    }

    fn copied(&self, op: OpId, lane: u32, todo: &mut Vec<Copy>, found: &mut Origins) {
        let (module, defs) = (self.module, self.defs);
        let own = |op: OpId| Copy::Lane(op, module.operand_lane(op, lane));
        match module.op(op).kind {
            OpKind::Const(_) => {
                let value = module.constant(op).get(lane as usize);
                // 0.0 and -0.0 compare equal.
                found.extend(value.map(|v| CopyOrigin::Constant((v.as_float() + 0.0).to_bits())));
            }
            OpKind::Load(_) => todo.push(Copy::Def(defs.seen(op, lane))),
            OpKind::Select {
                then, otherwise, ..
            } => todo.extend([Copy::Lane(then, lane), Copy::Lane(otherwise, lane)]),
            OpKind::Convert(a) => todo.push(Copy::Lane(a, lane)),
            OpKind::Compose(list) if module.ty(op).is_array() => {
                todo.extend(module.operands(list).iter().map(|a| Copy::Lane(*a, lane)));
            }
            OpKind::ExtractComputed { base, .. } if module.ty(base).is_vector() => {
                todo.extend((0..module.ty(base).components()).map(|c| Copy::Lane(base, c)));
            }
            OpKind::ExtractComputed { base, .. } => todo.push(Copy::Lane(base, lane)),
            OpKind::Call(function, _) => {
                let returns = defs.returns_of(function).iter();
                todo.extend(returns.map(|value| Copy::Lane(*value, lane)));
            }
            OpKind::Returned(call, number) => {
                if let OpKind::Call(function, _) = module.op(call).kind
                    && let Some(found) = module.function(function)
                    && let Some(id) = module.parameters(found).get(number as usize)
                {
                    todo.extend(defs.exit(defs.slot(*id, lane)).map(Copy::Def));
                }
            }
            OpKind::Builtin(function, list) => {
                let args = module.operands(list);
                match function.transfer() {
                    Transfer::Minimum | Transfer::Maximum | Transfer::Between => {
                        todo.extend(args.iter().map(|a| own(*a)));
                    }
                    Transfer::Blend => todo.extend(args.iter().take(2).map(|a| own(*a))),
                    Transfer::Magnitude | Transfer::Signum | Transfer::Threshold => {
                        todo.extend(args.last().map(|a| own(*a)));
                    }
                    _ => {
                        found.insert(CopyOrigin::Computed(op));
                    }
                }
            }
            _ => match defs.part_of(module, op, lane) {
                Some((op, lane)) => todo.push(Copy::Lane(op, lane)),
                None => {
                    found.insert(CopyOrigin::Computed(op));
                }
            },
        }
    }

    fn held(&self, def: DefId, todo: &mut Vec<Copy>, found: &mut Origins) {
        let defs = self.defs;
        let def = defs.unrefined(def);
        found.insert(CopyOrigin::Def(def));
        match defs.get(def) {
            Def::Stored { value, lane } => todo.push(Copy::Lane(value, lane)),
            Def::Merge { sides, .. } => {
                todo.extend(defs.list(sides).iter().map(|d| Copy::Def(*d)));
            }
            Def::Head { init, back, .. } => todo.extend([Copy::Def(init), Copy::Def(back)]),
            Def::Entry(slot) => {
                found.insert(CopyOrigin::Entry(slot));
                let writes = defs.global_writes(slot);
                let last = writes.len().saturating_sub(MAX_COPIES);
                todo.extend(writes.iter().skip(last).map(|d| Copy::Def(*d)));
                if let Some(passed) = defs.passed(self.module, slot) {
                    let args = passed.args().take(MAX_COPIES);
                    todo.extend(args.map(|arg| Copy::Lane(arg, passed.lane)));
                }
            }
            Def::Measured(_) | Def::Refined { .. } | Def::Unknown => {}
        }
    }
}
