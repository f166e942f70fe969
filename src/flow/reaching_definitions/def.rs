//! Definitions, and queries on the reaching definitions of a shader.

use rustc_hash::FxHashMap;
use shaderlint_ir::{Layout, LoopId, Module, OpId, OpKind, Root};
use shaderlint_semantic::lists::Lists;
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::List;

/// Index of a [`Def`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct DefId(pub u32);

/// A scalar component of a variable.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Slot(pub u32);

/// The constraint that a comparison puts on a value: the path from the comparison down to a load of
/// the value. Each hop goes to an operand of an operation that can be inverted.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Refinement {
    /// The comparison.
    pub comparison: OpId,
    /// Whether the comparison is true.
    pub truth: bool,
    /// Whether the value is on the right side of the comparison.
    pub is_right: bool,
    /// The compared component.
    pub lane: u8,
    /// The operand index of each hop, two bits each, the first hop in the lowest bits.
    pub(super) path: u32,
    pub(super) hops: u8,
    /// The call of the function that contains the comparison, if it is another function.
    pub(super) call: Option<OpId>,
}

/// A comparison, or other atomic condition, that is known to be true or false.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Premise {
    /// The operation.
    pub comparison: OpId,
    /// Whether it is true.
    pub truth: bool,
    /// The call of the function that contains it, if the condition calls one.
    pub call: Option<OpId>,
}

/// A component of an operation on the path from a comparison to the constrained load.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hop {
    /// The operation.
    pub op: OpId,
    /// The component of its value.
    pub lane: u32,
    /// The index of the next operand on the path; `None` at the load.
    pub choice: Option<u8>,
}

/// The value of one component of a variable (an SSA definition).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Def {
    /// The value on entry to the function, or after a call that may have written to it.
    Entry(Slot),
    /// A component of a stored value.
    Stored {
        /// The stored value.
        value: OpId,
        /// The component.
        lane: u32,
    },
    /// The length of a vector whose components were written separately: the definitions of these.
    Measured(List),
    /// A merge of several definitions (a phi).
    Merge {
        /// The incoming definitions.
        sides: List,
        /// The branch condition of a two-way merge: the first definition holds if it is true.
        condition: Option<OpId>,
        /// Whether it merges the sides of `?:`, `&&` or `||`, so that both values are intended.
        is_choice: bool,
    },
    /// The value at the start of a loop iteration (the phi at the loop head).
    Head {
        /// The loop.
        of: LoopId,
        /// The component of the variable.
        slot: Slot,
        /// The definition before the loop.
        init: DefId,
        /// The definition at the end of an iteration.
        back: DefId,
    },
    /// A definition constrained by a comparison (e-SSA).
    Refined {
        /// The definition before the comparison.
        of: DefId,
        /// The constraint.
        by: Refinement,
    },
    /// Not known.
    Unknown,
}

/// A condition that controls an operation: it is known to be true or false there.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Guard {
    /// The condition.
    pub condition: OpId,
    /// Whether it is true.
    pub truth: bool,
    pub(super) around: Option<u32>,
}

/// The arguments passed to a component of a parameter by all calls of its function.
#[derive(Clone, Copy, Debug)]
pub struct Passed<'m> {
    pub(super) module: &'m Module,
    pub(super) calls: &'m [OpId],
    pub(super) position: usize,
    /// The component of each argument.
    pub lane: u32,
}

impl<'m> Passed<'m> {
    /// The arguments, one per call.
    pub fn args(self) -> impl ExactSizeIterator<Item = OpId> + 'm {
        let Passed {
            module,
            calls,
            position,
            ..
        } = self;
        calls.iter().map(move |call| match module.op(*call).kind {
            OpKind::Call(_, list) => module
                .operands(list)
                .get(position)
                .copied()
                .unwrap_or(*call),
            _ => *call,
        })
    }
}

/// The reaching definitions of a shader, in SSA form.
#[derive(Debug)]
pub struct ReachingDefinitions {
    /// The layout of values in components.
    pub layout: Layout,
    /// By variable: its first slot; the last entry is the number of slots.
    pub(super) slots: Vec<u32>,
    /// By slot: the variable that it belongs to.
    pub(super) variables: Vec<u32>,
    /// By operation: its first component; the last entry is the number of components.
    pub(super) lanes: Vec<u32>,
    /// By component: the operation that it belongs to.
    pub(super) owners: Vec<u32>,
    /// By component of a load: the definition that reaches it.
    pub(super) seen: Vec<DefId>,
    pub(super) defs: Vec<Def>,
    /// By definition: the same without refinements.
    pub(super) unrefined: Vec<DefId>,
    pub(super) lists: Vec<DefId>,
    pub(super) calls: Lists<OpId>,
    /// By function: its return values.
    pub(super) returns: Lists<OpId>,
    /// By function: its only return value, if it has no visible side effects.
    pub(super) values: Vec<Option<OpId>>,
    /// By function: whether it is pure.
    pub(super) pure: Vec<bool>,
    /// By slot of an `out` or `inout` parameter: the definition at the end of the function; of an
    /// output: at the end of the entry point.
    pub(super) exits: FxHashMap<Slot, DefId>,
    /// By slot of a global: all definitions stored there.
    pub(super) global_writes: Lists<DefId>,
    /// By loop: the range of definitions made in it; the heads are consecutive.
    pub(super) loop_defs: Vec<(DefId, DefId)>,
    /// By loop: whether an iteration may be followed by another.
    pub(super) repeats: Vec<bool>,
    pub(super) guards: Vec<Guard>,
    /// By first operation of a range: the innermost guard of the range.
    pub(super) guarded: Vec<(OpId, Option<u32>)>,
    /// Whether the whole shader was analysed; `false` if it exceeds the size limit.
    pub is_complete: bool,
}

impl ReachingDefinitions {
    pub(super) const UNKNOWN: DefId = DefId(0);

    /// A definition; [`Def::Unknown`] if the id belongs to another shader.
    pub fn get(&self, id: DefId) -> Def {
        self.defs
            .get(id.0 as usize)
            .copied()
            .unwrap_or(Def::Unknown)
    }

    /// The number of definitions.
    pub fn len(&self) -> u32 {
        self.defs.len() as u32
    }

    /// Whether there are no definitions.
    pub fn is_empty(&self) -> bool {
        self.defs.is_empty()
    }

    /// The definitions in a list.
    pub fn list(&self, list: List) -> &[DefId] {
        let start = list.start as usize;
        self.lists
            .get(start..start + list.len as usize)
            .unwrap_or(&[])
    }

    /// The number of components of all operations.
    pub fn lane_count(&self) -> u32 {
        self.lanes.last().copied().unwrap_or(0)
    }

    /// The index of an operation's first component among those of all operations.
    pub fn first_lane(&self, op: OpId) -> u32 {
        self.lanes.get(op.0 as usize).copied().unwrap_or(0)
    }

    /// The number of components of an operation's value.
    pub fn lanes_of(&self, op: OpId) -> u32 {
        let end = self.lanes.get(op.0 as usize + 1).copied().unwrap_or(0);
        end.saturating_sub(self.first_lane(op))
    }

    /// The operation that a component belongs to, and its index in that operation.
    pub fn op_at(&self, lane: u32) -> (OpId, u32) {
        let op = OpId(self.owners.get(lane as usize).copied().unwrap_or(0));
        (op, lane - self.first_lane(op))
    }

    /// The definition that reaches one component of a load.
    pub fn seen(&self, load: OpId, lane: u32) -> DefId {
        let at = self.first_lane(load) + lane;
        let seen = self.seen.get(at as usize).copied();
        seen.unwrap_or(ReachingDefinitions::UNKNOWN)
    }

    /// The variable that a slot belongs to, and the component.
    pub fn variable_at(&self, slot: Slot) -> (VariableId, u32) {
        let number = self.variables.get(slot.0 as usize).copied().unwrap_or(0);
        let first = self.slots.get(number as usize).copied().unwrap_or(0);
        (VariableId(number), slot.0.saturating_sub(first))
    }

    /// The slot of a component of a variable.
    pub fn slot(&self, variable: VariableId, lane: u32) -> Slot {
        Slot(self.slots.get(variable.0 as usize).copied().unwrap_or(0) + lane)
    }

    /// The calls of a function.
    pub fn calls_of(&self, function: FunctionRef) -> &[OpId] {
        self.calls.get(function.0)
    }

    /// The return values of a function.
    pub fn returns_of(&self, function: FunctionRef) -> &[OpId] {
        self.returns.get(function.0)
    }

    /// The only return value of a function that has no visible side effects.
    pub fn value_of(&self, function: FunctionRef) -> Option<OpId> {
        self.values.get(function.0 as usize).copied().flatten()
    }

    /// Whether a function is pure: it writes no shared state, and equal arguments give equal
    /// results.
    pub fn is_pure(&self, function: FunctionRef) -> bool {
        self.pure.get(function.0 as usize) == Some(&true)
    }

    /// The argument, and its component, that a call passes to a slot of a parameter.
    pub fn argument(&self, module: &Module, call: OpId, slot: Slot) -> Option<(OpId, u32)> {
        let (id, lane) = self.variable_at(slot);
        let OpKind::Call(function, list) = module.op(call).kind else {
            return None;
        };
        let parameters = module.parameters(module.function(function)?);
        let position = parameters.iter().position(|p| *p == id)?;
        let argument = module.operands(list).get(position)?;
        Some((*argument, lane))
    }

    /// The definition of a slot of an `out` or `inout` parameter at the end of its function, or of
    /// an output at the end of the entry point.
    pub fn exit(&self, slot: Slot) -> Option<DefId> {
        self.exits.get(&slot).copied()
    }

    /// All definitions stored in a slot of a global.
    pub fn global_writes(&self, slot: Slot) -> &[DefId] {
        self.global_writes.get(slot.0)
    }

    /// The arguments for a slot of an `in` or `inout` parameter; `None` if its function is never
    /// called or the slot is not such a parameter.
    pub fn passed<'m>(&'m self, module: &'m Module, slot: Slot) -> Option<Passed<'m>> {
        let (id, lane) = self.variable_at(slot);
        let variable = module.variable(id)?;
        if !matches!(variable.root, Root::Parameter | Root::ParameterInout) {
            return None;
        }
        let function = variable.function?;
        let parameters = module.parameters(module.function(function)?);
        let position = parameters.iter().position(|p| *p == id)?;
        let calls = self.calls_of(function);
        (!calls.is_empty()).then_some(Passed {
            module,
            calls,
            position,
            lane,
        })
    }

    /// The range of definitions made inside a loop.
    pub fn made_in(&self, looped: LoopId) -> std::ops::Range<DefId> {
        let found = self.loop_defs.get(looped.0 as usize).copied();
        let (first, end) = found.unwrap_or((DefId(0), DefId(0)));
        first..end
    }

    /// Whether an iteration of a loop may be followed by another: the loop is reachable, and some
    /// path through its body does not leave it.
    pub fn repeats(&self, looped: LoopId) -> bool {
        self.repeats.get(looped.0 as usize) == Some(&true)
    }

    /// The head definitions of a loop: one for each slot that it carries between iterations.
    pub fn heads(&self, looped: LoopId) -> impl Iterator<Item = DefId> + '_ {
        let made = self.made_in(looped);
        let all = (made.start.0..made.end.0).map(DefId);
        let is_head = move |d: &DefId| matches!(self.get(*d), Def::Head { of, .. } if of == looped);
        // Entry definitions of slots first used in the loop precede the heads.
        all.skip_while(move |d| !is_head(d)).take_while(is_head)
    }

    /// A definition without its refinements.
    pub fn unrefined(&self, id: DefId) -> DefId {
        self.unrefined.get(id.0 as usize).copied().unwrap_or(id)
    }

    /// The definition that a value originates from, copies followed.
    pub fn copied_from(&self, module: &Module, id: DefId) -> DefId {
        let mut id = self.unrefined(id);
        for _ in 0..16 {
            let Def::Stored { value, lane } = self.get(id) else {
                break;
            };
            let Some((value, lane)) = self.through(module, value, lane) else {
                break;
            };
            id = self.unrefined(self.seen(value, lane));
        }
        id
    }

    /// The load that a component of a value is a copy of, through swizzles, constructors and the
    /// like; `None` for a copy of an array element.
    pub fn through(&self, module: &Module, mut op: OpId, mut lane: u32) -> Option<(OpId, u32)> {
        for _ in 0..16 {
            if self.is_element(module, op) {
                return None;
            }
            if let OpKind::Load(_) = module.op(op).kind {
                return Some((op, lane));
            }
            (op, lane) = self.part_of(module, op, lane)?;
        }
        None
    }

    /// The component of another value that a component is a plain copy of.
    pub fn part_of(&self, module: &Module, op: OpId, lane: u32) -> Option<(OpId, u32)> {
        let found = module.op(op);
        match found.kind {
            OpKind::Splat(a) => {
                let rows = found.ty.numeric().map_or(1, |(_, _, rows)| rows as u32);
                (found.ty.is_vector() && lane < rows).then_some((a, 0))
            }
            OpKind::Swizzle(a, lanes) => {
                let number = *lanes.numbers().get(lane as usize)?;
                Some((a, number as u32))
            }
            OpKind::Extract(a, number) => Some((a, self.layout.lane(module.ty(a), number)? + lane)),
            OpKind::Compose(list) if found.ty.is_array() => {
                let one = module.operands(list);
                (one.len() == 1).then(|| one.first().map(|a| (*a, lane)))?
            }
            OpKind::Compose(list) => {
                let is_vector = found.ty.is_vector();
                let mut rest = lane;
                for &part in module.operands(list) {
                    let lanes = match is_vector {
                        true => module.ty(part).components(),
                        false => self.lanes_of(part),
                    };
                    if rest < lanes {
                        return Some((part, rest));
                    }
                    rest -= lanes;
                }
                None
            }
            _ => None,
        }
    }

    /// The conditions that control an operation, innermost first, with their indices.
    pub fn guards(&self, op: OpId) -> impl Iterator<Item = (u32, Guard)> + '_ {
        let at = self.guarded.partition_point(|(first, _)| *first <= op);
        let found = at.checked_sub(1).and_then(|i| self.guarded.get(i));
        let get = |number: Option<u32>| {
            let number = number?;
            Some((number, self.guards.get(number as usize).copied()?))
        };
        let first = get(found.and_then(|(_, guard)| *guard));
        std::iter::successors(first, move |(_, guard)| get(guard.around))
    }

    /// The number of guards.
    pub fn guard_count(&self) -> usize {
        self.guards.len()
    }
}
