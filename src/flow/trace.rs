//! Traces a component of a value back to its origins: through variables, swizzles, constructors and
//! function parameters.

use super::reaching_definitions::{Def, DefId, ReachingDefinitions};
use shaderlint_ir::{Module, OpId, OpKind};
use shaderlint_semantic::VariableId;

/// Maximum number of steps per query.
const BUDGET: u32 = 64;

/// An origin of a component, where tracing ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Start {
    /// Computed by an operation.
    Made(OpId, u32),
    /// The initial value of a variable, as of a uniform or an input.
    Given(VariableId, u32),
}

/// Calls `visit` with every origin of a component, copies followed. Where `visit` returns `true`,
/// tracing goes on through the operands: to their component with the same index, or to the whole of
/// a scalar. Returns whether all origins were visited within the budget.
pub fn trace(
    module: &Module,
    defs: &ReachingDefinitions,
    (op, lane): (OpId, u32),
    mut visit: impl FnMut(Start) -> bool,
) -> bool {
    let mut trail = Trail {
        module,
        defs,
        todo: vec![TracePoint::Lane(op, lane)],
        seen: Vec::new(),
    };
    for _ in 0..BUDGET {
        let Some(at) = trail.todo.pop() else {
            return true;
        };
        if trail.seen.contains(&at) {
            continue;
        }
        trail.seen.push(at);
        match at {
            TracePoint::Lane(op, lane) => trail.lane(op, lane, &mut visit),
            TracePoint::Def(def) => trail.def(def, &mut visit),
        }
    }
    trail.todo.is_empty()
}

/// The only origin of a component, copies followed; `None` where there may be several.
pub fn origin(module: &Module, defs: &ReachingDefinitions, op: OpId, lane: u32) -> Option<Start> {
    let (mut first, mut count) = (None, 0);
    let is_all = trace(module, defs, (op, lane), |origin| {
        first = first.or(Some(origin));
        count += 1;
        false
    });
    first.filter(|_| is_all && count == 1)
}

#[derive(Clone, Copy, PartialEq)]
enum TracePoint {
    Lane(OpId, u32),
    Def(DefId),
}

struct Trail<'a> {
    module: &'a Module,
    defs: &'a ReachingDefinitions,
    todo: Vec<TracePoint>,
    seen: Vec<TracePoint>,
}

impl Trail<'_> {
    fn lane(&mut self, op: OpId, lane: u32, visit: &mut impl FnMut(Start) -> bool) {
        let (module, defs) = (self.module, self.defs);
        let found = module.op(op);
        if let OpKind::Load(_) = found.kind {
            let def = defs.unrefined(defs.seen(op, lane));
            return match defs.get(def) {
                Def::Unknown => {
                    visit(Start::Made(op, lane));
                }
                _ => self.todo.push(TracePoint::Def(def)),
            };
        }
        if let Some((part, lane)) = defs.part_of(module, op, lane) {
            return self.todo.push(TracePoint::Lane(part, lane));
        }
        if let OpKind::Select {
            then, otherwise, ..
        } = found.kind
        {
            self.todo
                .extend([then, otherwise].map(|side| TracePoint::Lane(side, lane)));
            return;
        }
        if let OpKind::Call(function, _) = found.kind
            && let [value] = defs.returns_of(function)
        {
            return self.todo.push(TracePoint::Lane(*value, lane));
        }
        if visit(Start::Made(op, lane)) {
            module.each_operand(op, |operand| {
                let own = module.operand_lane(operand, lane);
                self.todo.push(TracePoint::Lane(operand, own));
            });
        }
    }

    fn def(&mut self, def: DefId, visit: &mut impl FnMut(Start) -> bool) {
        let (module, defs) = (self.module, self.defs);
        match defs.get(def) {
            Def::Stored { value, lane } => self.todo.push(TracePoint::Lane(value, lane)),
            Def::Merge { sides, .. } => {
                let sides = defs.list(sides).iter();
                self.todo
                    .extend(sides.map(|side| TracePoint::Def(defs.unrefined(*side))));
            }
            Def::Head { init, back, .. } => {
                self.todo
                    .extend([init, back].map(|side| TracePoint::Def(defs.unrefined(side))));
            }
            Def::Refined { of, .. } => self.todo.push(TracePoint::Def(of)),
            Def::Entry(slot) => {
                let (variable, lane) = defs.variable_at(slot);
                match (defs.passed(module, slot), defs.global_writes(slot)) {
                    (Some(passed), _) if passed.args().len() == 1 => {
                        let args = passed.args();
                        self.todo
                            .extend(args.map(|arg| TracePoint::Lane(arg, passed.lane)));
                    }
                    (None, &[written]) => self.todo.push(TracePoint::Def(defs.unrefined(written))),
                    _ => {
                        visit(Start::Given(variable, lane));
                    }
                }
            }
            Def::Measured(_) | Def::Unknown => {}
        }
    }
}
