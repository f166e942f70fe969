//! Definitions, and what may be asked of those of a shader.

use rustc_hash::FxHashMap;
use shaderlint_ir::{Layout, LoopId, Module, OpId, OpKind, Root};
use shaderlint_semantic::lists::Lists;
use shaderlint_semantic::{FunctionRef, VariableId};
use shaderlint_syntax::ast::List;

/// Index of a [`Def`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct DefId(pub u32);

/// A scalar lane of a variable.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Slot(pub u32);

/// What a comparison tells of a value: the way from the comparison down to a load of it. Each hop
/// goes to an operand, and each can be taken back by arithmetic.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Refinement {
    /// The comparison.
    pub comparison: OpId,
    /// Whether it is true.
    pub truth: bool,
    /// Whether the value is on its right.
    pub is_right: bool,
    /// The component that is compared.
    pub lane: u8,
    /// Which operand each hop takes, two bits each, the first lowest.
    pub(super) path: u32,
    pub(super) hops: u8,
    /// The call of the function that the comparison stands in, if it is another.
    pub(super) call: Option<OpId>,
}

/// A comparison, or other condition, that holds or does not.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Premise {
    /// The comparison.
    pub comparison: OpId,
    /// Whether it is true.
    pub truth: bool,
    /// The call of the function that it stands in, where a condition calls one.
    pub call: Option<OpId>,
}

/// A lane of an operation on the way from a comparison to what it tells of.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hop {
    /// The operation.
    pub op: OpId,
    /// Its lane.
    pub lane: u32,
    /// The operand that the way goes on to; `None` at its end.
    pub choice: Option<u8>,
}

/// What a lane of a variable holds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Def {
    /// What was there before the function, or behind a call that may have written to it.
    Entry(Slot),
    /// A lane of a value that was stored.
    Stored {
        /// The value.
        value: OpId,
        /// Its lane.
        lane: u32,
    },
    /// The length of a vector whose components were written one by one: their definitions.
    Measured(List),
    /// One of several.
    Merge {
        /// The definitions on the ways that come together.
        sides: List,
        /// The condition, where there are two sides: the first holds where it is true.
        condition: Option<OpId>,
        /// Whether it is the value of a `?:`, `&&` or `||`, so that each side is meant.
        is_choice: bool,
    },
    /// What a lane holds when a turn of a loop begins.
    Head {
        /// The loop.
        of: LoopId,
        /// The lane.
        slot: Slot,
        /// Before the loop.
        init: DefId,
        /// At the end of a turn.
        back: DefId,
    },
    /// The same where a comparison has told something of it.
    Refined {
        /// What it was before.
        of: DefId,
        /// What is known.
        by: Refinement,
    },
    /// Nobody knows.
    Unknown,
}

/// A condition that is true or false where an operation runs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Guard {
    /// The condition.
    pub condition: OpId,
    /// Whether it is true.
    pub truth: bool,
    pub(super) around: Option<u32>,
}

/// What the calls of a function pass to a lane of one of its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Passed<'m> {
    pub(super) module: &'m Module,
    pub(super) calls: &'m [OpId],
    pub(super) position: usize,
    /// The lane.
    pub lane: u32,
}

impl<'m> Passed<'m> {
    /// The arguments, one for each call.
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

/// All definitions of a shader.
#[derive(Debug)]
pub struct Defs {
    /// How values lie in lanes.
    pub layout: Layout,
    /// By variable: its first slot; at the end, how many slots there are.
    pub(super) slots: Vec<u32>,
    /// By slot: the number of the variable that it belongs to.
    pub(super) variables: Vec<u32>,
    /// By operation: its first lane; at the end, how many lanes there are.
    pub(super) lanes: Vec<u32>,
    /// By lane: the number of the operation that it belongs to.
    pub(super) owners: Vec<u32>,
    /// By lane of an operation that loads: what it sees.
    pub(super) seen: Vec<DefId>,
    pub(super) defs: Vec<Def>,
    /// By definition: the same without what conditions tell of it.
    pub(super) unrefined: Vec<DefId>,
    pub(super) lists: Vec<DefId>,
    /// By function: the calls of it.
    pub(super) calls: Lists<OpId>,
    /// By function: the values that it returns.
    pub(super) returns: Lists<OpId>,
    /// By function: the one value that it returns, if it just gives that and does nothing else that
    /// anybody sees.
    pub(super) values: Vec<Option<OpId>>,
    /// By function: whether the same arguments give the same again.
    pub(super) pure: Vec<bool>,
    /// By slot of a parameter that goes back to the caller: what it holds in the end.
    pub(super) exits: FxHashMap<Slot, DefId>,
    /// By slot: what is ever put there, if it is one of a global.
    pub(super) global_writes: Lists<DefId>,
    /// By loop: the definitions made in it; the heads stand together.
    pub(super) loop_defs: Vec<(DefId, DefId)>,
    pub(super) guards: Vec<Guard>,
    /// From which operation on which guard is the innermost.
    pub(super) guarded: Vec<(OpId, Option<u32>)>,
    /// Whether all of the shader was looked at; not where there is too much of it.
    pub is_complete: bool,
}

impl Defs {
    pub(super) const UNKNOWN: DefId = DefId(0);

    /// A definition.
    pub fn get(&self, id: DefId) -> Def {
        self.defs
            .get(id.0 as usize)
            .copied()
            .unwrap_or(Def::Unknown)
    }

    /// How many definitions there are.
    pub fn len(&self) -> u32 {
        self.defs.len() as u32
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.defs.is_empty()
    }

    /// The definitions of a list.
    pub fn list(&self, list: List) -> &[DefId] {
        let start = list.start as usize;
        self.lists
            .get(start..start + list.len as usize)
            .unwrap_or(&[])
    }

    /// How many lanes all operations have together.
    pub fn lane_count(&self) -> u32 {
        self.lanes.last().copied().unwrap_or(0)
    }

    /// The first lane of an operation among those of all.
    pub fn first_lane(&self, op: OpId) -> u32 {
        self.lanes.get(op.0 as usize).copied().unwrap_or(0)
    }

    /// How many lanes an operation's value has.
    pub fn lanes_of(&self, op: OpId) -> u32 {
        let end = self.lanes.get(op.0 as usize + 1).copied().unwrap_or(0);
        end.saturating_sub(self.first_lane(op))
    }

    /// The operation that a lane belongs to, and which of its lanes it is.
    pub fn op_at(&self, lane: u32) -> (OpId, u32) {
        let op = OpId(self.owners.get(lane as usize).copied().unwrap_or(0));
        (op, lane - self.first_lane(op))
    }

    /// What a load sees in one of its lanes.
    pub fn seen(&self, load: OpId, lane: u32) -> DefId {
        let at = self.first_lane(load) + lane;
        let seen = self.seen.get(at as usize).copied();
        seen.unwrap_or(Defs::UNKNOWN)
    }

    /// The variable that a slot belongs to, and which of its lanes it is.
    pub fn variable_at(&self, slot: Slot) -> (VariableId, u32) {
        let number = self.variables.get(slot.0 as usize).copied().unwrap_or(0);
        let first = self.slots.get(number as usize).copied().unwrap_or(0);
        (VariableId(number), slot.0.saturating_sub(first))
    }

    /// The slot of a lane of a variable.
    pub fn slot(&self, variable: VariableId, lane: u32) -> Slot {
        Slot(self.slots.get(variable.0 as usize).copied().unwrap_or(0) + lane)
    }

    /// The calls of a function.
    pub fn calls_of(&self, function: FunctionRef) -> &[OpId] {
        self.calls.get(function.0)
    }

    /// The values that a function returns.
    pub fn returns_of(&self, function: FunctionRef) -> &[OpId] {
        self.returns.get(function.0)
    }

    /// The value that a function is just another word for.
    pub fn value_of(&self, function: FunctionRef) -> Option<OpId> {
        self.values.get(function.0 as usize).copied().flatten()
    }

    /// Whether a function writes to nothing of others and gives the same for the same arguments.
    pub fn is_pure(&self, function: FunctionRef) -> bool {
        self.pure.get(function.0 as usize) == Some(&true)
    }

    /// What a call passes to a slot of a parameter.
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

    /// What a parameter that goes back to the caller holds in the end.
    pub fn exit(&self, slot: Slot) -> Option<DefId> {
        self.exits.get(&slot).copied()
    }

    /// What is ever put into a global.
    pub fn global_writes(&self, slot: Slot) -> &[DefId] {
        self.global_writes.get(slot.0)
    }

    /// What calls pass to a lane of a parameter; `None` where nobody calls its function, or it is no
    /// parameter that takes values.
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

    /// The definitions that were made inside a loop.
    pub fn made_in(&self, looped: LoopId) -> std::ops::Range<DefId> {
        let found = self.loop_defs.get(looped.0 as usize).copied();
        let (first, end) = found.unwrap_or((DefId(0), DefId(0)));
        first..end
    }

    /// The heads of a loop: what its turns carry on.
    pub fn heads(&self, looped: LoopId) -> impl Iterator<Item = DefId> + '_ {
        let made = self.made_in(looped);
        let all = (made.start.0..made.end.0).map(DefId);
        let is_head = move |d: &DefId| matches!(self.get(*d), Def::Head { of, .. } if of == looped);
        // What the loop is first to name has its entry before them.
        all.skip_while(move |d| !is_head(d)).take_while(is_head)
    }

    /// A definition without what conditions tell of it.
    pub fn unrefined(&self, id: DefId) -> DefId {
        self.unrefined.get(id.0 as usize).copied().unwrap_or(id)
    }

    /// Where a value was first made, copies taken back; a definition, for want of a value.
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

    /// The load that a lane of a value is a copy of: through swizzles and the like.
    pub fn through(&self, module: &Module, mut op: OpId, mut lane: u32) -> Option<(OpId, u32)> {
        for _ in 0..16 {
            if let OpKind::Load(_) = module.op(op).kind {
                return Some((op, lane));
            }
            (op, lane) = self.part_of(module, op, lane)?;
        }
        None
    }

    /// The lane of another value that a lane is, where it is just that.
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

    /// The conditions around an operation, innermost first, each with its number.
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

    /// How many conditions there are.
    pub fn guard_count(&self) -> usize {
        self.guards.len()
    }
}
