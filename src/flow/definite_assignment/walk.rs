//! The walk over the regions of a function that computes definite assignment.
//!
//! `reaching_definitions` walks the same regions with the same visitor, but keeps one definition per component,
//! merged where paths join. This walk keeps the components that every path has written and the
//! conditions that hold on it, so that infeasible paths are excluded and correlated branches stay
//! distinct. The two states are independent.

use super::conditions::Conditions;
use super::operands::{chosen, handed};
use super::state::{ALL, AssignmentFindings, AssignmentState, PartMask, Path, UnassignedVariable};
use crate::ranges::Query;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::{
    Access, Case, CaseLabel, Loop, LoopId, Module, Op, OpId, OpKind, Place, PlaceId, Provenance,
    Region, Root, Run, Step, Switch, Visit,
};
use shaderlint_semantic::{FunctionRef, Mentions, Program, VariableId};
use shaderlint_syntax::ast::{Extent, StmtId};

/// Maximum nesting of regions; deeper functions have no findings.
const MAX_DEPTH: u32 = 200;

/// A loop or `switch` being walked.
struct ConstructFrame {
    /// The trail at its start.
    mark: usize,
    /// The first operation after its start.
    start: u32,
    /// The last operation of a loop: its writes may come from the previous iteration.
    last: Option<u32>,
    /// The join of the states at each `break`, relative to the start.
    exits: Option<Path>,
}

pub(super) struct AssignmentWalk<'x> {
    program: &'x Program,
    module: &'x Module,
    mentions: &'x Mentions,
    /// By operation: whether it is an operand of `?:`, `&&` or `||` whose value may not be used.
    chosen: Vec<bool>,
    /// By read in the findings: the number of branches around it, if nothing else guards it.
    pub(super) depths: Vec<usize>,
    state: AssignmentState,
    conditions: Conditions,
    /// By variable: the components written to so far on any path.
    ever: FxHashMap<VariableId, PartMask>,
    /// By variable: where it became unassigned.
    pub(super) since: FxHashMap<VariableId, u32>,
    /// Variables that must be assigned when the function returns.
    outputs: Vec<VariableId>,
    /// By load passed as an argument: the `inout` parameter that receives it; `None` for a
    /// parameter whose value is unused or unknown.
    handed: FxHashMap<OpId, Option<VariableId>>,
    /// Requested only if the first walk finds something.
    query: &'x dyn Fn() -> Query<'x>,
    /// Ranges to test the feasibility of paths, in the second walk.
    cases: Option<Query<'x>>,
    /// By variable and hash of a value: the parts written where that value equals one constant.
    gains: FxHashMap<(VariableId, u64), PartMask>,
    /// By `inout` parameter of the functions walked so far: the components whose incoming value is
    /// read.
    taken: FxHashMap<VariableId, PartMask>,
    /// By variable: the components that count as assigned only because a loop writes them on some path.
    kept: FxHashMap<VariableId, PartMask>,
    /// All writes in the function so far.
    writes: Vec<(VariableId, PartMask)>,
    frames: Vec<ConstructFrame>,
    /// The enclosing branches: the operation after the condition, and the last operation.
    pub(super) branches: Vec<(u32, u32)>,
    /// The hash of the value that the enclosing `else if` chain compares with constants.
    compared: Option<u64>,
    /// The last condition after which the function, a loop or a `switch` may have been left.
    exit: u32,
    next: u32,
    /// The current nesting of regions.
    depth: u32,
    too_deep: bool,
    pub(super) findings: AssignmentFindings,
}

impl<'x> Visit<'x> for AssignmentWalk<'x> {
    type Out = ();

    fn module(&self) -> &'x Module {
        self.module
    }

    fn region(&mut self, region: Region) {
        self.too_deep |= self.depth > MAX_DEPTH;
        if self.too_deep {
            return;
        }
        let held = self.conditions.mark();
        self.depth += 1;
        for step in self.module.steps(region) {
            self.step(step);
        }
        self.depth -= 1;
        self.conditions.undo(held);
    }

    fn run(&mut self, run: Run) {
        self.next = run.first.0 + run.len;
        if self.state.dead {
            return;
        }
        let module = self.module;
        for id in run.ops() {
            match module.op(id).kind {
                OpKind::Load(place) if self.is_open() => {
                    let variable = module.place(place).variable;
                    self.conditions.loaded(module, id, variable);
                    self.read(id, place);
                }
                OpKind::Store(place, value) => self.store(id, place, module.op(value)),
                OpKind::Call(..) => self.conditions.called(),
                _ => {}
            }
        }
    }

    fn branch(&mut self, condition: OpId, [then, otherwise]: [Region; 2], _: Provenance) {
        let known = self.known(condition);
        let start = self.next;
        let mark = self.state.mark();
        let was_dead = self.state.dead;
        let compared = self.compared(condition);
        let is_next = compared.is_some() && compared == self.compared;
        let outer = self.compared.take();
        self.state.dead |= known == Some(false);
        let reads = self.findings.reads.len();
        self.side(condition, true, then);
        let middle = self.findings.reads.len();
        let first = self.state.path(mark);
        self.state.undo(mark);
        self.state.dead = was_dead || known == Some(true);
        self.compared = compared;
        self.side(condition, false, otherwise);
        self.compared = outer;
        self.join_reads(reads, middle);
        let second = self.state.path(mark);
        // An `if`/`else if` chain that compares one value with two or more constants and has no
        // `else` is taken to be exhaustive.
        let is_empty = self.module.steps(otherwise).is_empty();
        let second = second.filter(|_| !(is_next && is_empty && first.is_some()));
        let paths: Vec<Path> = first.iter().chain(&second).cloned().collect();
        self.state.join(mark, &paths);
        if was_dead || !self.is_open() {
            return;
        }
        match (first, second) {
            (Some(first), Some(second)) => self.compare(condition, &first, &second),
            (None, None) => {}
            (first, _) => {
                self.exit = self.exit.max(if is_next && is_empty { 0 } else { start });
                if !(is_next && is_empty) {
                    self.conditions
                        .learn(self.module, condition, first.is_some());
                }
            }
        }
    }

    fn looped(&mut self, _: LoopId, found: &'x Loop) {
        let (start, last) = (self.next, last_op(found));
        self.begin_iteration(start, last);
        let is_endless = found.condition.is_none_or(|c| self.known(c) == Some(true));
        let before = self.writes.len();
        if found.tests_first {
            self.region(found.test);
        }
        let mark = self.begin(start, last);
        let was_dead = self.state.dead;
        self.region(found.body);
        self.region(found.step);
        if !found.tests_first {
            self.region(found.test);
        }
        let path = match self.state.path(mark) {
            // No iteration reaches the end of the body, but the loop may run zero times.
            None if !was_dead && found.tests_first => Some(Path::default()),
            path => path,
        };
        self.end(mark, path.filter(|_| !is_endless));
        self.keep(before);
    }

    fn switch(&mut self, found: &'x Switch) {
        let module = self.module;
        let start = self.next;
        let mark = self.begin(start, None);
        let was_dead = self.state.dead;
        let cases = module.cases(found);
        let mut has_default = false;
        for case in cases {
            has_default |= module.labels(case).contains(&CaseLabel::Default);
            // A label is also reached directly from the `switch`, where less is assigned.
            self.state.undo(mark);
            self.state.dead = was_dead;
            self.guarded_region(case.body, start);
        }
        let path = self.state.path(mark);
        let has_left = self.frames.last().is_some_and(|f| f.exits.is_some());
        // A `switch` with several labels on a value computed by the shader is taken to be
        // exhaustive.
        let is_known =
            cases.len() > 1 && !self.is_outside(found.selector) && (path.is_some() || has_left);
        let has_default = has_default || self.has_all(found.selector, cases);
        let path = match path {
            _ if !has_default && !was_dead && !is_known => Some(Path::default()),
            path => path,
        };
        self.end(mark, path);
    }

    fn breaks(&mut self, _: StmtId) {
        self.leave_frame();
    }

    fn continues(&mut self, _: StmtId) {
        self.state.dead = true;
    }

    fn returns(&mut self, _: Option<OpId>, stmt: StmtId) {
        self.leave(self.program.tree.stmt(stmt).extent);
        self.state.dead = true;
    }

    fn discards(&mut self, _: StmtId) {
        self.state.dead = true;
    }
}

impl<'x> AssignmentWalk<'x> {
    pub fn new(
        program: &'x Program,
        module: &'x Module,
        mentions: &'x Mentions,
        ignored: &FxHashSet<VariableId>,
        query: &'x dyn Fn() -> Query<'x>,
    ) -> AssignmentWalk<'x> {
        AssignmentWalk {
            program,
            module,
            mentions,
            chosen: chosen(module),
            depths: Vec::new(),
            state: AssignmentState::new(module.variables.len()),
            conditions: Conditions::default(),
            ever: FxHashMap::default(),
            since: FxHashMap::default(),
            outputs: Vec::new(),
            handed: handed(program, module, ignored),
            query,
            cases: None,
            gains: FxHashMap::default(),
            taken: FxHashMap::default(),
            kept: FxHashMap::default(),
            writes: Vec::new(),
            frames: Vec::new(),
            branches: Vec::new(),
            compared: None,
            exit: 0,
            next: 0,
            depth: 0,
            too_deep: false,
            findings: AssignmentFindings::default(),
        }
    }

    /// Analyses a function that must assign some globals. Its callees must have been analysed
    /// before.
    pub fn function(
        &mut self,
        id: FunctionRef,
        globals: &[VariableId],
    ) -> Option<AssignmentFindings> {
        let found = self.follow(id, globals)?;
        let function = self.program.function(id)?;
        let is_clean = found.reads.is_empty() && found.outputs.is_empty();
        if is_clean && (function.returns.is_void() || !found.reaches_end) {
            return Some(found);
        }
        // The feasibility of paths is tested only if there is something to report.
        self.cases = Some((self.query)());
        let found = self.follow(id, globals);
        self.cases = None;
        found
    }

    fn follow(&mut self, id: FunctionRef, globals: &[VariableId]) -> Option<AssignmentFindings> {
        let module = self.module;
        let function = module.function(id)?;
        let body = function.body?;
        self.conditions.clear();
        self.ever.clear();
        self.since.clear();
        self.gains.clear();
        self.writes.clear();
        self.kept.clear();
        self.exit = 0;
        self.next = function.ops.first.0;
        self.too_deep = false;
        self.state.dead = false;
        let is_out = |v: &&VariableId| {
            module
                .variable(**v)
                .is_some_and(|v| v.root == Root::ParameterOut)
        };
        let out = module.parameters(function).iter().filter(is_out);
        self.outputs = globals.iter().chain(out).copied().collect();
        for variable in self.outputs.clone() {
            self.lose(variable, self.next);
        }
        for &variable in module.parameters(function) {
            if is_inout(module, variable) {
                self.lose(variable, self.next);
                self.taken.insert(variable, 0);
            }
        }
        self.depth = 0;
        self.region(body);
        self.findings.reaches_end = !self.state.dead;
        let definition = self.program.function(id).and_then(|f| f.definition);
        let end = definition.and_then(|d| self.program.tree.function(d));
        self.leave(Extent::token(end.map_or(0, |d| d.extent.last)));
        self.state.undo(0);
        let mut findings = std::mem::take(&mut self.findings);
        self.depths.clear();
        for unset in &mut findings.outputs {
            unset.always = self.written(unset.variable) & unset.missing == 0;
        }
        (!self.too_deep).then_some(findings)
    }

    /// Marks a variable as unassigned from here on.
    fn lose(&mut self, variable: VariableId, at: u32) {
        self.state.put(variable, 0);
        self.since.insert(variable, at);
        self.gains.retain(|(v, _), _| *v != variable);
        self.kept.remove(&variable);
        self.conditions.reset(variable);
    }

    /// Whether conditions must be tracked: a variable was unassigned, or this is the second walk.
    fn is_open(&self) -> bool {
        !self.since.is_empty() || self.cases.is_some()
    }

    pub(super) fn written(&self, variable: VariableId) -> PartMask {
        self.ever.get(&variable).copied().unwrap_or(0)
    }

    fn store(&mut self, id: OpId, place: PlaceId, value: &Op) {
        let module = self.module;
        let place = module.place(place);
        let variable = place.variable;
        let root = module.variable(variable).map(|v| v.root);
        if value.kind == OpKind::Undef && root == Some(Root::Local) {
            return self.lose(variable, id.0);
        }
        let mask = lanes(module, place).unwrap_or(ALL);
        *self.ever.entry(variable).or_insert(0) |= mask;
        if self.is_open() {
            self.conditions.written(variable);
            self.writes.push((variable, mask));
            if let Some(kept) = self.kept.get_mut(&variable) {
                *kept &= !mask;
            }
            self.state.put(variable, self.state.get(variable) | mask);
        }
    }

    /// The value of a condition on this path, if only one is possible.
    fn known(&self, condition: OpId) -> Option<bool> {
        let constant = self.module.constant(condition).first();
        constant.map(|v| v.as_bool()).or_else(|| {
            let query = self.cases.filter(|_| !self.state.dead)?;
            let may_be = |truth| self.conditions.may_be(query, condition, truth);
            match (may_be(true), may_be(false)) {
                (true, false) => Some(true),
                (false, true) => Some(false),
                _ => None,
            }
        })
    }

    /// Walks one side of a branch.
    fn side(&mut self, condition: OpId, truth: bool, region: Region) {
        let held = self.conditions.mark();
        let start = condition.0 + 1;
        if self.is_open() {
            self.conditions.learn(self.module, condition, truth);
        }
        self.guarded_region(region, start);
        self.conditions.undo(held);
    }

    /// Walks a region guarded by the condition before `start`.
    fn guarded_region(&mut self, region: Region, start: u32) {
        let last = last_in(self.module, region).unwrap_or(start);
        self.branches.push((start, last));
        self.region(region);
        self.branches.pop();
    }

    /// The hash of the value that a condition compares with a constant for equality.
    fn compared(&self, condition: OpId) -> Option<u64> {
        let OpKind::Same {
            negated: false,
            left,
            right,
        } = self.module.op(condition).kind
        else {
            return None;
        };
        let is_constant = |op: OpId| matches!(self.module.op(op).kind, OpKind::Const(_));
        let value = match (is_constant(left), is_constant(right)) {
            (false, true) => left,
            (true, false) => right,
            _ => return None,
        };
        let is_bounded = !self.is_outside(value);
        is_bounded.then(|| self.conditions.number(self.module, value))?
    }

    /// Whether a value is loaded directly from a uniform or input, so that it may be anything.
    fn is_outside(&self, value: OpId) -> bool {
        let OpKind::Load(place) = self.module.op(value).kind else {
            return false;
        };
        let variable = self.module.variable(self.module.place(place).variable);
        matches!(variable.map(|v| v.root), Some(Root::Uniform | Root::Input))
    }

    /// Records the correlation between a condition and the variables assigned on only one of its
    /// sides: they are assigned wherever the condition has the same value again.
    fn compare(&mut self, condition: OpId, first: &Path, second: &Path) {
        let Some(fact) = self.conditions.fact(self.module, condition, true) else {
            return;
        };
        let mut all: Vec<u32> = first.keys().chain(second.keys()).copied().collect();
        all.sort_unstable();
        all.dedup();
        for variable in all {
            let id = VariableId(variable);
            // After the join, it is the state common to both sides.
            let start = self.state.get(id);
            let of = |path: &Path| path.get(&variable).copied().unwrap_or(start);
            let (then, otherwise) = (of(first), of(second));
            let met = fact;
            for (gained, fact) in [
                (then & !otherwise, fact),
                (otherwise & !then, fact.negated()),
            ] {
                if gained != 0 {
                    let both = self.conditions.follows(fact, id, gained);
                    self.state.put(id, self.state.get(id) | both);
                }
                if gained != 0 && fact == met {
                    let again = self.count_gain(id, condition, gained);
                    self.state.put(id, self.state.get(id) | again);
                }
            }
        }
    }

    /// Records that parts of a variable are assigned where a value equals one constant. Returns
    /// those that were also assigned for another constant: such comparisons are taken to be
    /// exhaustive.
    fn count_gain(&mut self, variable: VariableId, condition: OpId, gained: PartMask) -> PartMask {
        let Some(value) = self.compared(condition) else {
            return 0;
        };
        let known = self.gains.entry((variable, value)).or_insert(0);
        let again = *known & gained;
        *known |= gained;
        again
    }

    fn begin(&mut self, start: u32, last: Option<u32>) -> usize {
        let mark = self.state.mark();
        self.frames.push(ConstructFrame {
            mark,
            start,
            last,
            exits: None,
        });
        mark
    }

    /// Ends a loop or `switch`: joins the paths of all `break` statements with `path`.
    fn end(&mut self, mark: usize, path: Option<Path>) {
        let exits = self.frames.pop().and_then(|f| f.exits);
        let paths: Vec<Path> = path.into_iter().chain(exits).collect();
        self.state.join(mark, &paths);
    }

    /// Everything that a loop writes on some path counts as assigned after it.
    fn keep(&mut self, before: usize) {
        for i in before..self.writes.len() {
            if let Some(&(variable, mask)) = self.writes.get(i) {
                let missing = self.needed(variable) & mask & !self.state.get(variable);
                if missing != 0 && !self.state.dead {
                    *self.kept.entry(variable).or_insert(0) |= missing;
                }
                self.state.put(variable, self.state.get(variable) | mask);
            }
        }
    }

    /// Invalidates the facts about variables that a loop writes to, as they differ in each
    /// iteration.
    fn begin_iteration(&mut self, start: u32, last: Option<u32>) {
        if !self.is_open() {
            return;
        }
        for op in start..last.map_or(start, |l| l + 1) {
            match self.module.op(OpId(op)).kind {
                OpKind::Store(place, _) => {
                    let variable = self.module.place(place).variable;
                    self.conditions.written(variable);
                }
                OpKind::Call(..) => self.conditions.called(),
                _ => {}
            }
        }
    }

    /// Whether the cases cover every value in the range of the selector.
    fn has_all(&self, selector: OpId, cases: &[Case]) -> bool {
        const MOST: f64 = 64.0;
        let Some(range) = self.cases.map(|query| query.lane(selector, 0)) else {
            return false;
        };
        let (lo, hi) = (range.lo.value, range.hi.value);
        if !range.is_finite() || hi - lo > MOST {
            return false;
        }
        let labels = cases.iter().flat_map(|c| self.module.labels(c));
        let values: FxHashSet<i64> = labels
            .filter_map(|label| match label {
                CaseLabel::Value(bits) => Some(*bits as i32 as i64),
                CaseLabel::Default => None,
            })
            .collect();
        (lo as i64..=hi as i64).all(|value| values.contains(&value))
    }

    /// Handles a `break`.
    fn leave_frame(&mut self) {
        let Some(frame) = self.frames.last_mut() else {
            return;
        };
        let Some(path) = self.state.path(frame.mark) else {
            return;
        };
        self.state.dead = true;
        let Some(exits) = &mut frame.exits else {
            frame.exits = Some(path);
            return;
        };
        let start = |v: u32| self.state.before(frame.mark, v);
        for (&variable, value) in exits.iter_mut() {
            *value &= path
                .get(&variable)
                .copied()
                .unwrap_or_else(|| start(variable));
        }
        for (&variable, &value) in &path {
            exits
                .entry(variable)
                .or_insert_with(|| start(variable) & value);
        }
    }

    /// Handles a function exit: outputs must be assigned.
    fn leave(&mut self, at: Extent) {
        if self.state.dead {
            return;
        }
        for i in 0..self.outputs.len() {
            let Some(&variable) = self.outputs.get(i) else {
                continue;
            };
            let has = self.state.get(variable) | self.conditions.known(variable);
            let missing = self.needed(variable) & !has;
            let is_known = self.findings.outputs.iter().any(|u| u.variable == variable);
            if missing != 0 && !is_known {
                self.findings.outputs.push(UnassignedVariable {
                    variable,
                    at,
                    missing,
                    always: false,
                    guarded: false,
                });
            }
        }
    }

    /// All parts of a variable; one bit for types without parts.
    fn needed(&self, variable: VariableId) -> PartMask {
        match self.module.variable(variable).map(|v| v.ty) {
            Some(ty) if ty.is_vector() => (1 << ty.components()) - 1,
            Some(ty) if ty.array == 0 => {
                let fields = self.program.struct_of(ty).map_or(1, |s| s.fields.len());
                let all = 1u64.checked_shl(fields as u32).map_or(0, |end| end - 1);
                if all == 0 || all > PartMask::MAX as u64 {
                    ALL
                } else {
                    all as PartMask
                }
            }
            _ => 1,
        }
    }

    /// Checks a load.
    fn read(&mut self, op: OpId, place: PlaceId) {
        let place = self.module.place(place);
        let variable = place.variable;
        let has = self.state.get(variable);
        self.read_kept(op, place);
        if has == ALL {
            return;
        }
        let needed = match self.module.path(place).first() {
            // The accessed component is not known statically.
            Some(Access::Computed(_) | Access::Element(_)) if has != 0 => 0,
            // A struct that is copied need not be assigned completely.
            None if has != 0 && self.has_members(variable) => 0,
            _ => lanes(self.module, place).unwrap_or_else(|| self.needed(variable)),
        };
        // It is not known what a function without a body does with its argument.
        let taken = |parameter| self.taken.get(&parameter).copied();
        let handed = self.handed.get(&op);
        let needed = match handed.map(|p| p.and_then(taken).unwrap_or(0)) {
            Some(0) => 0,
            Some(taken) if self.module.path(place).is_empty() => needed & taken,
            _ => needed,
        };
        let missing = needed & !(has | self.conditions.known(variable));
        if missing == 0 {
            return;
        }
        let since = self.since.get(&variable).copied().unwrap_or(0);
        let is_later = self.is_written_later(variable, missing, op, since);
        let always = self.written(variable) & missing == 0 && !is_later;
        let guarded = self.is_guarded(op, since);
        if let Some(taken) = self.taken.get_mut(&variable) {
            if always || !guarded {
                *taken |= missing;
            }
            return self.state.put(variable, has | missing);
        }
        let is_direct = self.exit <= since && self.chosen.get(op.0 as usize) != Some(&true);
        let depth = if is_direct {
            self.branches.len()
        } else {
            usize::MAX
        };
        self.depths.push(depth);
        self.findings.reads.push(UnassignedVariable {
            variable,
            at: self.named(variable, op),
            missing,
            always,
            guarded,
        });
        // Report each variable once.
        self.state.put(variable, ALL);
    }

    /// Checks a load of what a loop may have assigned.
    fn read_kept(&mut self, op: OpId, place: &Place) {
        let variable = place.variable;
        let Some(&kept) = self.kept.get(&variable) else {
            return;
        };
        let needed = lanes(self.module, place).unwrap_or_else(|| self.needed(variable));
        let missing = needed & kept & !self.conditions.known(variable);
        if missing == 0 || self.handed.contains_key(&op) {
            return;
        }
        self.kept.remove(&variable);
        let since = self.since.get(&variable).copied().unwrap_or(0);
        self.findings.loop_reads.push(UnassignedVariable {
            variable,
            at: self.named(variable, op),
            missing,
            always: false,
            guarded: self.is_guarded(op, since),
        });
    }

    fn has_members(&self, variable: VariableId) -> bool {
        let ty = self.module.variable(variable).map(|v| v.ty);
        ty.is_some_and(|ty| ty.array == 0 && self.program.struct_of(ty).is_some())
    }

    /// Whether a condition is between a point and this operation.
    fn is_guarded(&self, op: OpId, since: u32) -> bool {
        let is_chosen = self.chosen.get(op.0 as usize).copied().unwrap_or(false);
        is_chosen || self.exit > since || self.branches.iter().any(|b| b.0 > since)
    }

    /// Whether the previous iteration may have written what is read here. That needs a guarded
    /// read, since the condition may distinguish the first iteration from the others.
    fn is_written_later(
        &self,
        variable: VariableId,
        missing: PartMask,
        op: OpId,
        since: u32,
    ) -> bool {
        let loops = self.frames.iter().filter(|f| f.start >= since);
        let mut loops = loops.filter_map(|f| Some((f.start, f.last?)));
        loops.any(|(start, last)| {
            let around = self.branches.last().filter(|b| b.0 > start);
            let is_chosen = self.chosen.get(op.0 as usize) == Some(&true);
            let after = around.map(|b| b.1).or(is_chosen.then_some(op.0));
            after.is_some_and(|after| {
                (after + 1..=last).any(|later| {
                    let OpKind::Store(place, _) = self.module.op(OpId(later)).kind else {
                        return false;
                    };
                    let place = self.module.place(place);
                    let mask = lanes(self.module, place).unwrap_or(ALL);
                    place.variable == variable && mask & missing != 0
                })
            })
        })
    }

    /// Where the variable is mentioned in the expression that reads it.
    fn named(&self, variable: VariableId, op: OpId) -> Extent {
        let tree = &self.program.tree;
        let extent = self.module.provenance(op).extent(tree).unwrap_or_default();
        let name = self.mentions.first_in(self.program, variable, extent);
        name.map_or(extent, |e| tree.expr(e).extent)
    }
}

/// The last bit of the mask, shared by all further members.
const LAST_MEMBER: u32 = PartMask::BITS - 1;

/// The components of a place, or the member that contains it; `None` if that is not known
/// statically.
fn lanes(module: &Module, place: &Place) -> Option<PartMask> {
    match module.path(place) {
        [Access::Lanes(lanes)] => Some(lanes.numbers().iter().fold(0, |mask, n| mask | 1 << n)),
        [Access::Member(number), ..] => Some(1 << number.min(&LAST_MEMBER)),
        _ => None,
    }
}

/// Whether a variable is an `inout` parameter.
fn is_inout(module: &Module, variable: VariableId) -> bool {
    let root = module.variable(variable).map(|v| v.root);
    root == Some(Root::ParameterInout)
}

fn last_op(looped: &Loop) -> Option<u32> {
    looped.ops.ops().next_back().map(|op| op.0)
}

fn last_in(module: &Module, region: Region) -> Option<u32> {
    let mut steps = module.steps(region).iter().rev();
    steps.find_map(|step| match *step {
        Step::Run(run) => (run.first.0 + run.len).checked_sub(1),
        Step::Loop(id) => last_op(module.looped(id)?),
        _ => {
            let mut inside = module.inside(step).into_iter().rev();
            inside.find_map(|region| last_in(module, region))
        }
    })
}
