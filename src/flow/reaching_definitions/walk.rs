//! The walk over the regions of each function that numbers definitions.

use super::condition::{each_comparison, each_load};
use super::def::{Def, DefId, Guard, ReachingDefinitions, Refinement, Slot};
use super::place::PlaceSlots;
use crate::calls::Calls;
use rustc_hash::FxHashMap;
use shaderlint_ir::{
    self as ir, Binary, Layout, LoopId, Module, OpId, OpKind, PlaceId, Provenance, Region, Root,
    Run, Visit, length_lane,
};
use shaderlint_semantic::lists::Lists;
use shaderlint_semantic::{FunctionRef, Program, VariableId};
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::SetAt;

/// Maximum number of definitions and list entries per component of a shader. Beyond it the analysis
/// stops and the remaining definitions are unknown.
const PER_LANE: usize = 24;
/// Minimum of that limit, for small shaders.
const AT_LEAST: usize = 1 << 14;

/// The slots changed since some point, with their current definitions.
pub(super) type Changes = Vec<(Slot, DefId)>;

/// Computes the reaching definitions of a shader.
pub(super) fn walk(program: &Program, module: &Module, calls: &Calls) -> ReachingDefinitions {
    let mut walker = Walker::of(program, module, calls);
    let globals = module.globals;
    walker.region(globals);
    walker.roll_back(0);
    for (number, function) in (0..).zip(&module.functions) {
        if let Some(body) = function.body {
            walker.function(FunctionRef(number), body);
        }
    }
    // Functions are not numbered in operation order.
    walker.defs.guarded.sort_by_key(|(first, _)| *first);
    let is_complete = !walker.is_full();
    let (functions, slots) = (module.functions.len(), walker.current.len());
    ReachingDefinitions {
        calls: Lists::of(functions, walker.calls.into_iter()),
        returns: Lists::of(functions, walker.returns.into_iter()),
        global_writes: Lists::of(slots, walker.global_writes.into_iter()),
        is_complete,
        ..walker.defs
    }
}

/// A loop or `switch` that `break` or `continue` can leave.
struct JumpFrame {
    is_loop: bool,
    /// The length of the trail at its start.
    mark: usize,
    breaks: Vec<Changes>,
    continues: Vec<Changes>,
}

pub(super) struct Walker<'m> {
    pub(super) module: &'m Module,
    pub(super) defs: ReachingDefinitions,
    /// By slot: its current definition, if it has one since the start of the function.
    pub(super) current: Vec<Option<DefId>>,
    /// By slot: its definition on function entry, created on demand.
    pub(super) entries: Vec<Option<DefId>>,
    /// Undo log: the previous definition of each changed slot since the start of the function.
    pub(super) trail: Vec<(Slot, Option<DefId>)>,
    frames: Vec<JumpFrame>,
    guard: Option<u32>,
    /// Whether the next step is reachable.
    is_alive: bool,
    function: Option<FunctionRef>,
    /// By function: the slots of globals that a call may write to.
    pub(super) writes: Vec<Vec<Slot>>,
    /// Pairs of callee and call.
    calls: Vec<(u32, OpId)>,
    /// Pairs of function and return value.
    returns: Vec<(u32, OpId)>,
    /// Pairs of slot and definition stored there.
    global_writes: Vec<(u32, DefId)>,
    /// Slots of `out` and `inout` parameters with their definitions at each function exit.
    open_exits: Vec<(Slot, DefId)>,
    /// By slot: the stamp of the query that visited it last.
    pub(super) stamps: Vec<u32>,
    pub(super) stamp: u32,
    pub(super) limit: usize,
    /// Scratch list: the loads, components and refinements of the current condition.
    refinements: Vec<(OpId, u32, Refinement)>,
}

/// Prefix sums of sizes, with the total at the end, and for each component the index of its value.
fn numbered(sizes: impl Iterator<Item = u32>) -> (Vec<u32>, Vec<u32>) {
    let mut firsts = Vec::with_capacity(sizes.size_hint().0 + 1);
    let mut owners = Vec::with_capacity(sizes.size_hint().0 * 2);
    for (number, size) in (0..).zip(sizes) {
        firsts.push(owners.len() as u32);
        owners.resize(owners.len() + size as usize, number);
    }
    firsts.push(owners.len() as u32);
    (firsts, owners)
}

impl<'m> Visit<'m> for Walker<'m> {
    type Out = ();

    fn module(&self) -> &'m Module {
        self.module
    }

    /// Walks operations in order. The right side of `&&` and `||` and the sides of `?:` may be
    /// evaluated unconditionally if they are cheap, but their values are only used if the condition
    /// holds, so their loads get the refined definitions.
    fn run(&mut self, run: Run) {
        let module = self.module;
        self.enter_guard(run.first);
        let mut cover: Vec<(OpId, OpId, OpId, bool)> = Vec::new();
        for op in run.ops() {
            match module.op(op).kind {
                OpKind::Select {
                    condition,
                    then,
                    otherwise,
                } => {
                    cover.push((condition, then, condition, true));
                    cover.push((then, otherwise, condition, false));
                }
                OpKind::Binary(Binary::And, a, b) => cover.push((a, b, a, true)),
                OpKind::Binary(Binary::Or, a, b) => cover.push((a, b, a, false)),
                _ => {}
            }
        }
        cover.retain(|(after, last, ..)| run.contains(*after) && after < last);
        if cover.is_empty() {
            run.ops().for_each(|op| self.op(op));
            return;
        }
        // Outer ones first.
        cover.sort_unstable_by_key(|(after, last, ..)| (after.0, std::cmp::Reverse(last.0)));
        let mut next = cover.into_iter().peekable();
        let mut open: Vec<(OpId, usize, Option<u32>)> = Vec::new();
        for op in run.ops() {
            self.op(op);
            while let Some((_, mark, guard)) = open.pop_if(|(last, ..)| *last <= op) {
                self.roll_back(mark);
                self.guard = guard;
                self.enter_guard(OpId(op.0 + 1));
            }
            while let Some((_, last, condition, truth)) = next.next_if(|(at, ..)| *at <= op) {
                open.push((last, self.trail.len(), self.guard));
                self.refine(condition, truth);
                self.enter_guard(OpId(op.0 + 1));
            }
        }
        if let Some(&(_, mark, guard)) = open.first() {
            self.roll_back(mark);
            self.guard = guard;
        }
    }

    #[inline]
    fn op(&mut self, op: OpId) {
        match self.module.op(op).kind {
            OpKind::Load(place) => self.load(op, place),
            OpKind::Store(place, value) => self.store(place, value),
            OpKind::Call(function, _) => self.call(op, function),
            _ => {}
        }
    }

    fn branch(&mut self, condition: OpId, [then, otherwise]: [Region; 2], _: Provenance) {
        let (since, mark, guard, was_alive) =
            (self.next(), self.trail.len(), self.guard, self.is_alive);
        let side = |walker: &mut Self, region, truth| {
            walker.is_alive = was_alive;
            walker.refine(condition, truth);
            walker.region(region);
            let changes = match walker.is_alive {
                true => walker.changes(mark),
                false => Changes::new(),
            };
            walker.roll_back(mark);
            walker.guard = guard;
            (walker.is_alive, changes)
        };
        let (is_then, first) = side(self, then, true);
        let (is_otherwise, second) = side(self, otherwise, false);
        self.is_alive = is_then || is_otherwise;
        match (is_then, is_otherwise) {
            (true, true) => self.merge(&[first, second], since, Some(condition)),
            (true, false) => {
                self.apply(&first);
                self.push_guard(condition, true);
            }
            (false, true) => {
                self.apply(&second);
                self.push_guard(condition, false);
            }
            (false, false) => {}
        }
    }

    fn looped(&mut self, id: LoopId, found: &'m ir::Loop) {
        let first = self.next();
        let was_alive = self.is_alive;
        let heads = self.heads(id, found);
        let (mark, guard) = (self.trail.len(), self.guard);
        self.frames.push(JumpFrame {
            is_loop: true,
            mark,
            breaks: Vec::new(),
            continues: Vec::new(),
        });
        let mut exits = Vec::new();
        if found.tests_first {
            self.region(found.test);
            self.test(found.condition, mark, &mut exits);
        }
        self.region(found.body);
        self.go_on(mark, first);
        self.region(found.step);
        if !found.tests_first {
            self.region(found.test);
            self.test(found.condition, mark, &mut exits);
        }
        let is_back = self.is_alive && was_alive;
        self.defs.repeats.set_at(id.0 as usize, is_back);
        for (slot, head) in heads {
            let now = self.get(slot);
            if let Some(Def::Head { init, back, .. }) = self.defs.defs.get_mut(head.0 as usize) {
                *back = if is_back { now } else { *init };
            }
        }
        self.roll_back(mark);
        self.guard = guard;
        exits.extend(self.frames.pop().map_or(Vec::new(), |f| f.breaks));
        self.is_alive = was_alive && !exits.is_empty();
        match &exits[..] {
            [] => {}
            [only] => self.apply(only),
            _ => self.merge(&exits, first, None),
        }
        let end = self.next();
        self.defs.loop_defs.set_at(id.0 as usize, (first, end));
    }

    fn switch(&mut self, found: &'m ir::Switch) {
        let module = self.module;
        let (since, mark, guard, was_alive) =
            (self.next(), self.trail.len(), self.guard, self.is_alive);
        self.frames.push(JumpFrame {
            is_loop: false,
            mark,
            breaks: Vec::new(),
            continues: Vec::new(),
        });
        let mut has_default = false;
        self.is_alive = false;
        for case in module.cases(found) {
            let labels = module.labels(case);
            has_default |= labels.contains(&shaderlint_ir::CaseLabel::Default);
            let fallen = match self.is_alive {
                true => Some(self.changes(mark)),
                false => None,
            };
            self.roll_back(mark);
            if let Some(fallen) = fallen {
                self.merge(&[Changes::new(), fallen], since, None);
            }
            self.is_alive = was_alive;
            self.guard = guard;
            self.region(case.body);
        }
        let mut exits = Vec::new();
        if self.is_alive {
            exits.push(self.changes(mark));
        }
        self.roll_back(mark);
        self.guard = guard;
        exits.extend(self.frames.pop().map_or(Vec::new(), |f| f.breaks));
        if !has_default {
            exits.push(Changes::new());
        }
        self.is_alive = was_alive && !exits.is_empty();
        match &exits[..] {
            [] => {}
            [only] => self.apply(only),
            _ => self.merge(&exits, since, None),
        }
    }

    fn breaks(&mut self, _: StmtId) {
        self.leave(|frame| Some(&mut frame.breaks));
    }

    fn continues(&mut self, _: StmtId) {
        self.leave(|frame| frame.is_loop.then_some(&mut frame.continues));
    }

    fn returns(&mut self, value: Option<OpId>, _: StmtId) {
        if self.is_alive {
            self.leave_function(value);
        }
        self.is_alive = false;
    }

    fn discards(&mut self, _: StmtId) {
        self.is_alive = false;
    }
}

impl<'m> Walker<'m> {
    fn of(program: &Program, module: &'m Module, calls: &Calls) -> Walker<'m> {
        let layout = Layout::of(program);
        let (slots, variables) = numbered(module.variables.iter().map(|v| layout.lanes(v.ty)));
        let (lanes, owners) = numbered(module.ops.iter().map(|o| layout.lanes(o.ty)));
        let (slot_count, lane_count) = (variables.len(), owners.len());
        let mut walker = Walker {
            module,
            defs: ReachingDefinitions {
                layout,
                slots,
                variables,
                lanes,
                owners,
                seen: vec![ReachingDefinitions::UNKNOWN; lane_count],
                defs: Vec::with_capacity(lane_count),
                unrefined: Vec::with_capacity(lane_count),
                lists: Vec::new(),
                calls: Lists::default(),
                returns: Lists::default(),
                values: vec![None; module.functions.len()],
                pure: Vec::new(),
                exits: FxHashMap::default(),
                global_writes: Lists::default(),
                loop_defs: vec![(DefId(0), DefId(0)); module.loops.len()],
                repeats: vec![false; module.loops.len()],
                guards: Vec::new(),
                guarded: Vec::new(),
                is_complete: true,
            },
            current: vec![None; slot_count],
            entries: vec![None; slot_count],
            trail: Vec::new(),
            frames: Vec::new(),
            guard: None,
            is_alive: true,
            function: None,
            writes: Vec::new(),
            calls: Vec::new(),
            returns: Vec::new(),
            global_writes: Vec::new(),
            open_exits: Vec::new(),
            stamps: vec![0; slot_count],
            stamp: 0,
            limit: AT_LEAST.max(PER_LANE * (lane_count + slot_count)),
            refinements: Vec::new(),
        };
        walker.define(Def::Unknown);
        walker.writes = walker.written_globals(calls);
        walker.defs.pure = walker.pure_functions(calls);
        walker
    }

    fn function(&mut self, function: FunctionRef, body: Region) {
        self.function = Some(function);
        self.is_alive = true;
        self.guard = None;
        if let Some(found) = self.module.function(function) {
            self.defs.guarded.push((found.ops.first, None));
        }
        self.region(body);
        if self.is_alive {
            self.leave_function(None);
        }
        self.roll_back(0);
        self.function = None;
        let mut returned = self.returns.iter().rev();
        let last = returned.next().filter(|(f, _)| *f == function.0);
        let is_alone = returned.next().is_none_or(|(f, _)| *f != function.0);
        let is_pure = self.defs.is_pure(function);
        self.defs.values.set_at(
            function.0 as usize,
            last.filter(|_| is_alone && is_pure).map(|(_, op)| *op),
        );
        let mut exits = std::mem::take(&mut self.open_exits);
        exits.sort_by_key(|(slot, _)| *slot);
        for ways in exits.chunk_by(|a, b| a.0 == b.0) {
            let (slot, exit) = match *ways {
                [one] => one,
                [(slot, _), ..] => {
                    let sides: Vec<DefId> = ways.iter().map(|(_, def)| *def).collect();
                    let sides = self.list(&sides);
                    let merge = self.define(Def::Merge {
                        sides,
                        condition: None,
                        is_choice: false,
                    });
                    (slot, merge)
                }
                [] => continue,
            };
            self.defs.exits.insert(slot, exit);
        }
    }

    /// Records the return value and the `out` parameters at a function exit.
    fn leave_function(&mut self, value: Option<OpId>) {
        let Some(function) = self.function else {
            return;
        };
        self.returns.extend(value.map(|value| (function.0, value)));
        let module = self.module;
        let Some(found) = module.function(function) else {
            return;
        };
        for id in module.parameters(found) {
            let root = module.variable(*id).map(|variable| variable.root);
            if let Some(Root::ParameterOut | Root::ParameterInout) = root {
                self.record_exit(*id);
            }
        }
        // Only the entry function, of which there is one, leaves with the outputs of the shader.
        if module.entry == Some(function) {
            let outputs = module.variables.iter().zip(0..);
            let outputs = outputs.filter(|(variable, _)| variable.root == Root::Output);
            outputs.for_each(|(_, number)| self.record_exit(VariableId(number)));
        }
    }

    /// Records the value of a variable at a function exit.
    fn record_exit(&mut self, id: VariableId) {
        let ty = self.module.variable(id).map(|variable| variable.ty);
        for lane in 0..ty.map_or(0, |ty| self.defs.layout.lanes(ty)) {
            let slot = self.defs.slot(id, lane);
            let def = self.get(slot);
            self.open_exits.push((slot, def));
        }
    }

    /// Records the current guard for the operations from `from` on.
    fn enter_guard(&mut self, from: OpId) {
        match self.defs.guarded.last_mut() {
            Some((first, guard)) if *first == from => *guard = self.guard,
            Some((first, guard)) if *first < from && *guard == self.guard => {}
            _ => self.defs.guarded.push((from, self.guard)),
        }
    }

    /// Ends the current path by jumping out of the innermost frame that accepts the jump.
    fn leave(&mut self, way: impl Fn(&mut JumpFrame) -> Option<&mut Vec<Changes>>) {
        if !self.is_alive {
            return;
        }
        self.is_alive = false;
        for number in (0..self.frames.len()).rev() {
            let Some(frame) = self.frames.get_mut(number) else {
                return;
            };
            let mark = frame.mark;
            if way(frame).is_none() {
                continue;
            }
            let changes = self.changes(mark);
            if let Some(list) = self.frames.get_mut(number).and_then(&way) {
                list.push(changes);
            }
            return;
        }
    }

    /// The id of the next definition.
    fn next(&self) -> DefId {
        DefId(self.defs.defs.len() as u32)
    }

    fn push_guard(&mut self, condition: OpId, truth: bool) {
        self.defs.guards.push(Guard {
            condition,
            truth,
            around: self.guard,
        });
        self.guard = Some(self.defs.guards.len() as u32 - 1);
    }

    /// Pushes a guard, and refines the definitions that the condition constrains.
    fn refine(&mut self, condition: OpId, truth: bool) {
        self.push_guard(condition, truth);
        let mut refinements = std::mem::take(&mut self.refinements);
        let (module, defs) = (self.module, &self.defs);
        each_comparison(module, defs, condition, truth, |comparison| {
            each_load(module, defs, comparison, |load, lane, by| {
                refinements.push((load, lane, by));
            });
        });
        for &(load, lane, by) in &refinements {
            let OpKind::Load(place) = self.module.op(load).kind else {
                continue;
            };
            let variable = self.module.variable(self.module.place(place).variable);
            if variable.is_some_and(|v| v.function.is_some() && v.function != self.function) {
                continue;
            }
            let Some(slot) = self.slot_of(place, lane) else {
                continue;
            };
            let of = self.get(slot);
            let before = self.defs.unrefined(of);
            // The variable was not written to since the condition was computed.
            if before == self.defs.unrefined(self.defs.seen(load, lane))
                && before != ReachingDefinitions::UNKNOWN
            {
                let refined = self.define(Def::Refined { of, by });
                self.set(slot, refined);
            }
        }
        refinements.clear();
        self.refinements = refinements;
    }

    /// The slot of a component of a place, if it is the only one.
    fn slot_of(&self, place: PlaceId, lane: u32) -> Option<Slot> {
        let spot = self.spot(place)?;
        if spot.is_element || spot.is_picked() {
            return None;
        }
        if lane >= spot.width(&self.defs.layout) {
            return spot.length();
        }
        spot.slot(lane)
    }

    fn spot(&self, place: PlaceId) -> Option<PlaceSlots> {
        PlaceSlots::of(self.module, &self.defs.layout, &self.defs.slots, place)
    }

    /// Creates the head definitions of a loop, one for each slot that it writes to.
    fn heads(&mut self, id: LoopId, looped: &ir::Loop) -> Vec<(Slot, DefId)> {
        let written = self.written(looped);
        let mut heads = Vec::with_capacity(written.len());
        let mut inits = Vec::with_capacity(written.len());
        for slot in written {
            let is_known = self.current.get(slot.0 as usize).copied().flatten();
            if is_known.is_none() && matches!(self.root(slot), Some(Root::Local | Root::Temporary))
            {
                continue;
            }
            inits.push((slot, self.get(slot)));
        }
        let first = self.next();
        for (slot, init) in inits {
            let head = self.define(Def::Head {
                of: id,
                slot,
                init,
                back: init,
            });
            heads.push((slot, head));
            self.set(slot, head);
        }
        self.defs.loop_defs.set_at(id.0 as usize, (first, first));
        heads
    }

    /// The slots that are written to in a loop, sorted, without duplicates.
    fn written(&mut self, looped: &ir::Loop) -> Vec<Slot> {
        let module = self.module;
        self.stamp += 1;
        let mut written = Vec::new();
        for op in looped.ops.ops() {
            match module.op(op).kind {
                OpKind::Store(place, _) => {
                    let Some(spot) = self.spot(place) else {
                        continue;
                    };
                    let width = spot.width(&self.defs.layout);
                    for slot in (0..width).flat_map(|lane| spot.slots(lane)) {
                        self.note(slot, &mut written);
                    }
                    for (first, rows) in spot.vectors() {
                        self.note(Slot(first.0 + rows as u32), &mut written);
                    }
                }
                OpKind::Call(function, _) => {
                    let writes = std::mem::take(&mut self.writes);
                    for &slot in writes.get(function.0 as usize).into_iter().flatten() {
                        self.note(slot, &mut written);
                    }
                    self.writes = writes;
                }
                _ => {}
            }
        }
        written.sort_unstable();
        written
    }

    fn note(&mut self, slot: Slot, all: &mut Vec<Slot>) {
        if let Some(stamp) = self.stamps.get_mut(slot.0 as usize)
            && *stamp != self.stamp
        {
            *stamp = self.stamp;
            all.push(slot);
        }
    }

    /// The condition of a loop: the loop exits where it is false.
    fn test(&mut self, condition: Option<OpId>, mark: usize, exits: &mut Vec<Changes>) {
        let Some(condition) = condition else {
            return;
        };
        if self.is_alive {
            let (inner, guard) = (self.trail.len(), self.guard);
            self.refine(condition, false);
            exits.push(self.changes(mark));
            self.roll_back(inner);
            self.guard = guard;
        }
        self.refine(condition, true);
        self.enter_guard(OpId(condition.0 + 1));
    }

    /// Joins the `continue` paths with the end of the body.
    fn go_on(&mut self, mark: usize, since: DefId) {
        let Some(frame) = self.frames.last_mut() else {
            return;
        };
        let mut ways = std::mem::take(&mut frame.continues);
        if ways.is_empty() {
            return;
        }
        if self.is_alive {
            ways.push(self.changes(mark));
        }
        self.roll_back(mark);
        self.is_alive = true;
        match &ways[..] {
            [only] => self.apply(only),
            _ => self.merge(&ways, since, None),
        }
    }

    fn call(&mut self, op: OpId, function: FunctionRef) {
        self.calls.push((function.0, op));
        let writes = std::mem::take(&mut self.writes);
        for &slot in writes.get(function.0 as usize).into_iter().flatten() {
            let entry = self.define(Def::Entry(slot));
            self.set(slot, entry);
        }
        self.writes = writes;
    }

    #[inline(never)]
    fn load(&mut self, op: OpId, place: PlaceId) {
        let Some(spot) = self.spot(place) else {
            return;
        };
        let first = self.defs.first_lane(op);
        let width = spot.width(&self.defs.layout).min(self.defs.lanes_of(op));
        for lane in 0..width {
            let def = self.lane_of(spot, lane);
            self.defs.seen.set_at((first + lane) as usize, def);
        }
        // The length of a swizzle.
        if spot.lanes.is_some()
            && let Some(lane) = length_lane(self.module.ty(op))
        {
            let def = match spot.length() {
                Some(slot) => self.get(slot),
                None => {
                    let parts = first as usize..(first + width) as usize;
                    let parts = self.defs.seen.get(parts).map(<[DefId]>::to_vec);
                    self.measured(&parts.unwrap_or_default())
                }
            };
            self.defs.seen.set_at((first + lane) as usize, def);
        }
    }

    fn lane_of(&mut self, spot: PlaceSlots, lane: u32) -> DefId {
        if !spot.is_picked() {
            let slot = spot.slot(lane);
            return slot.map_or(ReachingDefinitions::UNKNOWN, |slot| self.get(slot));
        }
        let sides: Vec<DefId> = spot.slots(lane).map(|slot| self.get(slot)).collect();
        let sides = self.list(&sides);
        self.define(Def::Merge {
            sides,
            condition: None,
            is_choice: false,
        })
    }

    fn measured(&mut self, parts: &[DefId]) -> DefId {
        let parts = self.list(parts);
        self.define(Def::Measured(parts))
    }

    #[inline(never)]
    fn store(&mut self, place: PlaceId, value: OpId) {
        let Some(spot) = self.spot(place) else {
            return;
        };
        let width = spot.width(&self.defs.layout);
        let is_weak = spot.is_element || spot.is_picked();
        let root = self.module.variable(self.module.place(place).variable);
        let is_global = root.is_some_and(|v| matches!(v.root, Root::Global | Root::Output));
        for lane in 0..width {
            if !is_weak {
                if let Some(slot) = spot.slot(lane) {
                    let def = self.define(Def::Stored { value, lane });
                    self.put(slot, def, is_global);
                }
                continue;
            }
            for slot in spot.slots(lane) {
                let def = self.define(Def::Stored { value, lane });
                let before = self.get(slot);
                let sides = self.list(&[before, def]);
                let def = self.define(Def::Merge {
                    sides,
                    condition: None,
                    is_choice: false,
                });
                self.put(slot, def, is_global);
            }
        }
        for (first, rows) in spot.vectors() {
            let mut parts = [ReachingDefinitions::UNKNOWN; 4];
            let parts = parts.get_mut(..rows as usize).unwrap_or(&mut []);
            for (part, row) in parts.iter_mut().zip(0..) {
                *part = self.get(Slot(first.0 + row));
            }
            let length = self.measured(parts);
            self.put(Slot(first.0 + rows as u32), length, is_global);
        }
    }

    /// Sets the definition of a slot, and records it if the variable is global.
    fn put(&mut self, slot: Slot, def: DefId, is_global: bool) {
        self.set(slot, def);
        if is_global {
            self.global_writes.push((slot.0, def));
        }
    }
}
