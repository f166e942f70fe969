//! Collects the statistics of a run.

use super::active::ActiveLanes;
use super::{Tile, Vm};
use crate::bytecode::{Bytecode, CallPath, FaultCheck, OperandCheck, Reg};
use crate::observations::{
    BranchObservation, ComparisonObservation, FaultKind, FunctionObservation, LoopObservation,
    NumberObservation, Observations, SiteObservation, StatementObservation, Witness,
};
use crate::row::{LANES, Row, floats, inlined, mask_by_parts, signed};
use fearless_simd::{f32x8, mask32x8, prelude::*, u32x8};
use shaderlint_ir::{LoopId, OpId, Provenance};
use shaderlint_math as math;
use shaderlint_semantic::{ComparedWith, Comparing, FunctionRef, OperandTest, Scalar, Undefined};

/// Maximum number of faults that are kept for a debugger.
const MOST_FAULTS: usize = 16;
/// The last bucket of iteration histograms.
const MAX_ITERATIONS: usize = 1024;

/// The statistics so far, and those of the current tile.
pub(crate) struct Watched {
    /// By lane: the cost in this tile, of operations that not all lanes executed.
    cost: [u32; LANES],
    /// The cost in this tile of operations that all lanes executed.
    shared_cost: u32,
    /// By lane: the iterations of all loops in this tile that not all lanes executed.
    iterations: [u32; LANES],
    /// The iterations of all loops in this tile that all lanes executed.
    shared_iterations: u32,
    /// The operations executed for this tile, counted once for all its pixels.
    pub ran: u32,
    /// By charge: the cost summed over pixels.
    paid: Vec<u64>,
    loops: Vec<LoopCount>,
    /// By check: how often pixels executed it.
    visits: Vec<u64>,
    compared: Vec<Ends>,
    /// By statement: the lanes that started it in this tile.
    started: Vec<u32>,
    /// The first faults, until a debugger forgets them.
    pub faults: Vec<Fault>,
    seen: Observations,
}

/// What a debugger can break on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// A numeric fault of an operation.
    Number(OpId, FaultKind),
    /// A loop ended because its condition was false.
    Exhausted(LoopId),
}

/// The minimum and maximum of the operands of a comparison, by lane.
struct Ends {
    held: u64,
    failed: u64,
    low: [[f32; LANES]; 2],
    high: [[f32; LANES]; 2],
}

/// The state of a loop in the current tile.
#[derive(Default)]
struct LoopCount {
    /// The lanes inside it.
    entered: u32,
    /// By lane: the iterations of this entry that not all lanes executed.
    iterations: [u32; LANES],
    /// The iterations of this entry that all lanes executed.
    shared: u32,
    /// By lane: the maximum iterations of an entry in this tile.
    most: [u32; LANES],
    /// The lanes that entered it in this tile, and those for which its condition became false.
    came: u32,
    exhausted: u32,
}

impl Watched {
    pub fn new(code: &Bytecode) -> Watched {
        let loops = code.loops.iter().map(|_| LoopCount::default());
        Watched {
            cost: [0; LANES],
            shared_cost: 0,
            iterations: [0; LANES],
            shared_iterations: 0,
            ran: 0,
            paid: vec![0; code.charges.len()],
            loops: loops.collect(),
            started: vec![0; code.statements().len()],
            faults: Vec::new(),
            visits: vec![0; code.checks.len()],
            compared: code.compared.iter().map(|_| Ends::default()).collect(),
            seen: Observations {
                loops: code
                    .loops
                    .iter()
                    .map(|id| LoopObservation::new(*id))
                    .collect(),
                branches: code
                    .branches
                    .iter()
                    .map(|at| BranchObservation::new(*at))
                    .collect(),
                statements: vec![StatementObservation::default(); code.statements().len()],
                ..Observations::default()
            },
        }
    }

    /// The statistics of all tiles.
    pub fn finish(mut self, code: &Bytecode) -> Observations {
        let seen = &mut self.seen;
        for (site, visits) in code.checks.iter().zip(self.visits) {
            let op = site.op;
            let kinds = site.checked.kinds().iter();
            seen.watched
                .extend(kinds.map(|&kind| SiteObservation { op, kind, visits }));
        }
        let compared = code.compared.iter().zip(&self.compared);
        seen.compared = compared.map(|(op, ends)| ends.seen(*op)).collect();
        seen.numbers.sort_by_key(|n| (n.op, n.kind));
        let mut paid = vec![0; code.calls.len()];
        for (charge, charged) in code.charges.iter().zip(&self.paid) {
            if let Some(paid) = paid.get_mut(charge.path as usize) {
                *paid += charged;
            }
        }
        seen.functions = functions_seen(&code.calls, &paid);
        seen.charged = self.paid;
        self.seen
    }

    /// By lane: the cost in this tile.
    pub fn cost(&self) -> [u32; LANES] {
        counts(self.cost, self.shared_cost)
    }

    /// By lane: the iterations of all loops in this tile.
    pub fn iterations(&self) -> [u32; LANES] {
        counts(self.iterations, self.shared_iterations)
    }

    /// Counts lanes that start a statement.
    pub fn statement(&mut self, index: u32, lanes: u32) {
        let seen = self.seen.statements.get_mut(index as usize);
        if let (Some(seen), Some(came)) = (seen, self.started.get_mut(index as usize)) {
            seen.times += lanes.count_ones() as u64;
            *came |= lanes;
        }
    }

    pub fn enter(&mut self, index: u32, active: u32) {
        if let Some(count) = self.loops.get_mut(index as usize) {
            count.entered = active;
            count.iterations = [0; LANES];
            count.shared = 0;
        }
    }

    pub fn iterate(&mut self, index: u32, active: &ActiveLanes) {
        let count = self.loops.get_mut(index as usize);
        if active.mask == u32::MAX {
            self.shared_iterations += 1;
            if let Some(count) = count {
                count.shared += 1;
            }
            return;
        }
        if let Some(count) = count {
            add_where(&mut count.iterations, &active.lanes, 1);
        }
        add_where(&mut self.iterations, &active.lanes, 1);
    }

    /// Records the lanes that leave a loop because its condition is false.
    pub fn exhaust(&mut self, index: u32, lanes: u32) {
        let count = self.loops.get_mut(index as usize);
        let seen = self.seen.loops.get_mut(index as usize);
        if let (Some(count), Some(seen)) = (count, seen) {
            count.exhausted |= lanes;
            seen.exhausted += lanes.count_ones() as u64;
            let fault = Fault::Exhausted(seen.id);
            if lanes != 0 {
                self.note(fault);
            }
        }
    }

    pub fn leave(&mut self, index: u32, requested: u32) {
        let count = self.loops.get_mut(index as usize);
        let seen = self.seen.loops.get_mut(index as usize);
        let (Some(count), Some(seen)) = (count, seen) else {
            return;
        };
        let lanes = count.entered & requested;
        count.came |= lanes;
        seen.entries += lanes.count_ones() as u64;
        let iterations = counts(count.iterations, count.shared);
        for ((lane, most), iterations) in count.most.iter_mut().enumerate().zip(iterations) {
            if lanes >> lane & 1 == 1 {
                *most = iterations.max(*most);
                seen.iterations += iterations as u64;
            }
        }
    }

    /// Records how many of the active lanes take each side of a branch.
    pub fn branch(&mut self, index: u32, active: &ActiveLanes, holds: u32) {
        if let Some(seen) = self.seen.branches.get_mut(index as usize) {
            let held = active.requested_where(holds);
            seen.taken += held as u64;
            seen.skipped += (active.pixels - held) as u64;
        }
    }

    /// Charges the active lanes for operations.
    #[inline(always)]
    pub fn spend(&mut self, [cost, by]: [u32; 2], active: &ActiveLanes) {
        if active.pixels > 0 {
            self.ran = self.ran.saturating_add(cost);
        }
        if let Some(paid) = self.paid.get_mut(by as usize) {
            *paid += cost as u64 * active.pixels as u64;
        }
        if active.mask == u32::MAX {
            self.shared_cost = self.shared_cost.wrapping_add(cost);
            return;
        }
        add_where(&mut self.cost, &active.lanes, cost);
    }

    /// Starts a tile.
    pub fn open(&mut self) {
        self.cost = [0; LANES];
        self.iterations = [0; LANES];
        (self.shared_cost, self.shared_iterations) = (0, 0);
        self.ran = 0;
        for count in &mut self.loops {
            (count.came, count.exhausted) = (0, 0);
            count.most = [0; LANES];
        }
    }

    /// Ends a tile.
    pub fn close(&mut self, requested: u32) {
        self.seen.pixels += requested.count_ones() as u64;
        for (lane, cost) in self.cost().into_iter().enumerate() {
            if requested >> lane & 1 == 1 {
                self.seen.operations += cost as u64;
            }
        }
        for (came, seen) in self.started.iter_mut().zip(&mut self.seen.statements) {
            seen.pixels += std::mem::take(came).count_ones() as u64;
        }
        for (count, seen) in self.loops.iter().zip(&mut self.seen.loops) {
            seen.pixels += count.came.count_ones() as u64;
            seen.exhausted_pixels += (count.exhausted & count.came).count_ones() as u64;
            for (lane, most) in count.most.into_iter().enumerate() {
                if count.came >> lane & 1 == 1 {
                    seen.count(most);
                }
            }
        }
    }

    /// Keeps a fault for a debugger.
    fn note(&mut self, fault: Fault) {
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(fault);
        }
    }

    fn number(&mut self, op: OpId, kind: FaultKind, times: u64, witness: impl FnOnce() -> Witness) {
        self.note(Fault::Number(op, kind));
        let same = |n: &&mut NumberObservation| n.op == op && n.kind == kind;
        if let Some(known) = self.seen.numbers.iter_mut().find(same) {
            known.times += times;
            return;
        }
        self.seen.numbers.push(NumberObservation {
            kind,
            op,
            times,
            witness: witness(),
        });
    }
}

/// Adds to the counts of active lanes.
#[inline(always)]
fn add_where(counts: &mut [u32; LANES], lanes: &Row, number: u32) {
    for (count, lane) in counts.iter_mut().zip(lanes.0) {
        *count = count.wrapping_add(lane & number);
    }
}

/// By lane: a count, of which a part is shared by all lanes.
fn counts(own: [u32; LANES], shared: u32) -> [u32; LANES] {
    own.map(|own| own.wrapping_add(shared))
}

/// The cost of each function, from the costs of all call paths that contain it.
fn functions_seen(calls: &[CallPath], paid: &[u64]) -> Vec<FunctionObservation> {
    let mut seen: Vec<FunctionObservation> = Vec::new();
    let mut add = |function: Option<FunctionRef>, own: u64, inclusive: u64| {
        let at = seen.iter().position(|f| f.function == function);
        let at = at.unwrap_or_else(|| {
            let (own, inclusive) = (0, 0);
            seen.push(FunctionObservation {
                function,
                own,
                inclusive,
            });
            seen.len() - 1
        });
        if let Some(known) = seen.get_mut(at) {
            (known.own, known.inclusive) = (known.own + own, known.inclusive + inclusive);
        }
    };
    for (path, &paid) in calls.iter().zip(paid) {
        add(path.function, paid, paid);
        // There is no recursion, so a function occurs once per path.
        let next = |path: &CallPath| calls.get(path.caller? as usize).copied();
        for caller in std::iter::successors(next(path), next) {
            add(caller.function, 0, paid);
        }
    }
    seen
}

impl LoopObservation {
    fn new(id: LoopId) -> LoopObservation {
        LoopObservation {
            id,
            pixels: 0,
            entries: 0,
            iterations: 0,
            most: 0,
            exhausted: 0,
            exhausted_pixels: 0,
            histogram: Vec::new(),
        }
    }

    /// Adds a pixel with this maximum number of iterations.
    fn count(&mut self, most: u32) {
        self.most = self.most.max(most);
        let at = (most as usize).min(MAX_ITERATIONS);
        if self.histogram.len() <= at {
            self.histogram.resize(at + 1, 0);
        }
        if let Some(slot) = self.histogram.get_mut(at) {
            *slot += 1;
        }
    }
}

impl BranchObservation {
    const fn new(at: Provenance) -> BranchObservation {
        BranchObservation {
            at,
            taken: 0,
            skipped: 0,
        }
    }
}

impl Default for Ends {
    fn default() -> Ends {
        Ends {
            held: 0,
            failed: 0,
            low: [[f32::INFINITY; LANES]; 2],
            high: [[f32::NEG_INFINITY; LANES]; 2],
        }
    }
}

impl Ends {
    fn seen(&self, op: OpId) -> ComparisonObservation {
        let ends = |side: usize| {
            let lanes = |rows: &[[f32; LANES]; 2]| {
                let row = rows.get(side).copied().unwrap_or_default();
                row.into_iter().map(f64::from)
            };
            [
                lanes(&self.low).fold(f64::INFINITY, f64::min),
                lanes(&self.high).fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        ComparisonObservation {
            op,
            held: self.held,
            failed: self.failed,
            left: ends(0),
            right: ends(1),
        }
    }
}

impl FaultCheck {
    /// The kinds of faults that a check may report.
    pub const fn kinds(self) -> &'static [FaultKind] {
        match self {
            FaultCheck::Float => &[FaultKind::Nan, FaultKind::Infinite],
            FaultCheck::Quotient => &[
                FaultKind::DivisionByZero,
                FaultKind::Nan,
                FaultKind::Infinite,
            ],
            FaultCheck::Divisor(_) => &[FaultKind::DivisionByZero],
            FaultCheck::Index => &[FaultKind::OutOfRange],
            FaultCheck::Operands(..) | FaultCheck::Neighbours => &[FaultKind::Undefined],
        }
    }
}

impl ComparisonObservation {
    /// Merges the statistics of another thread.
    fn add(&mut self, other: &ComparisonObservation) {
        self.held += other.held;
        self.failed += other.failed;
        self.left = [
            self.left[0].min(other.left[0]),
            self.left[1].max(other.left[1]),
        ];
        self.right = [
            self.right[0].min(other.right[0]),
            self.right[1].max(other.right[1]),
        ];
    }
}

/// Converts eight lanes to floats. Integers beyond 2^24 are rounded, so that different ones may
/// become equal.
#[inline(always)]
fn numbers<S: Simd>(part: u32x8<S>, scalar: Scalar) -> f32x8<S> {
    match scalar {
        Scalar::Int => math::float_of_int(signed(part)),
        Scalar::Uint => math::float_of_uint(part),
        Scalar::Float | Scalar::Bool => floats(part),
    }
}

/// Where a comparison of two numbers holds.
#[inline(always)]
fn compared<S: Simd>(relation: Comparing, a: f32x8<S>, b: f32x8<S>) -> mask32x8<S> {
    match relation {
        Comparing::Less => a.simd_lt(b),
        Comparing::LessEqual => a.simd_le(b),
        Comparing::Equal => a.simd_eq(b),
        Comparing::Greater => a.simd_gt(b),
        Comparing::GreaterEqual => a.simd_ge(b),
    }
}

/// The lanes of a mask whose quad is completely in it.
const fn full_quads(lanes: u32) -> u32 {
    let first = lanes & lanes >> 1 & lanes >> 2 & lanes >> 3 & 0x1111_1111;
    first | first << 1 | first << 2 | first << 3
}

/// The lanes with an infinite or NaN float: all exponent bits are set.
#[inline(always)]
fn unusual<S: Simd>(simd: S, bits: &Row) -> u32 {
    let exponent = u32x8::splat(simd, 0x7f80_0000);
    bits.mask_where(simd, inlined!(|part| (part & exponent).simd_eq(exponent)))
}

/// The lanes whose float satisfies a predicate.
fn lanes_where(row: &Row, is: impl Fn(f32) -> bool) -> u32 {
    let lanes = row.floats().into_iter().enumerate();
    lanes.fold(0, |mask, (lane, v)| mask | (is(v) as u32) << lane)
}

impl Vm<'_> {
    /// Checks a result for faults.
    #[inline(never)]
    pub(super) fn check_operands<S: Simd>(&mut self, simd: S, index: u32) {
        simd.vectorize(
            #[inline(always)]
            || self.check_at(simd, index),
        );
    }

    #[inline(always)]
    fn check_at<S: Simd>(&mut self, simd: S, check_operands: u32) {
        let code = self.code;
        let Some(check_operands) = code.looks.get(check_operands as usize) else {
            return;
        };
        let Some(&what) = code.checks.get(check_operands.site as usize) else {
            return;
        };
        let came = self.active & self.requested;
        if let Some(visits) = self.watched.visits.get_mut(check_operands.site as usize) {
            *visits += came.count_ones() as u64;
        }
        let suspects = match what.checked {
            FaultCheck::Float | FaultCheck::Quotient => {
                unusual(simd, self.row(check_operands.result))
            }
            FaultCheck::Divisor(scalar) => self.zeros(simd, check_operands, scalar),
            FaultCheck::Index | FaultCheck::Operands(..) | FaultCheck::Neighbours => u32::MAX,
        };
        if came & suspects == 0 {
            return;
        }
        for &kind in what.checked.kinds() {
            let wrong = self.wrong(simd, kind, what.checked, check_operands) & came;
            if wrong != 0 {
                let lane = wrong.trailing_zeros() as usize;
                let witness = self.witness(what.checked.scalar(), check_operands, lane);
                let times = wrong.count_ones() as u64;
                self.watched.number(what.op, kind, times, || witness);
            }
        }
    }

    /// The lanes whose last operand, the divisor, is zero (of either sign).
    #[inline(always)]
    fn zeros<S: Simd>(&self, simd: S, check_operands: &OperandCheck, scalar: Scalar) -> u32 {
        let Some(divisor) = check_operands.operands.last() else {
            return 0;
        };
        let sign = u32::from(scalar == Scalar::Float);
        let zero = u32x8::splat(simd, 0);
        let divisor = self.row(*divisor);
        divisor.mask_where(simd, inlined!(|part| (part << sign).simd_eq(zero)))
    }

    /// The pixel of a lane, with the operands of the operation.
    fn witness(&self, scalar: Scalar, check_operands: &OperandCheck, lane: usize) -> Witness {
        let bits = |reg: &Reg| self.row(*reg).0.get(lane).copied().unwrap_or(0);
        let number = |bits: u32| match scalar {
            Scalar::Int => bits as i32 as f64,
            Scalar::Uint => bits as f64,
            Scalar::Bool => (bits != 0) as u8 as f64,
            Scalar::Float => f32::from_bits(bits) as f64,
        };
        Witness {
            pixel: self.tile.pixels.get(lane).copied().unwrap_or_default(),
            operands: check_operands
                .operands
                .iter()
                .map(|reg| number(bits(reg)))
                .collect(),
        }
    }

    /// Records the operands of a comparison.
    #[inline(never)]
    pub(super) fn compare<S: Simd>(&mut self, simd: S, index: u32) {
        simd.vectorize(
            #[inline(always)]
            || self.compare_at(simd, index),
        );
    }

    #[inline(always)]
    fn compare_at<S: Simd>(&mut self, simd: S, index: u32) {
        let code = self.code;
        let Some(&comparison) = code.comparisons.get(index as usize) else {
            return;
        };
        let came = self.active & self.requested;
        let lanes = super::active::spread(came);
        let holds = self.mask(simd, comparison.result);
        let sides = [comparison.left, comparison.right].map(|reg| *self.row(reg));
        let Some(ends) = self.watched.compared.get_mut(comparison.site as usize) else {
            return;
        };
        ends.held += (came & holds).count_ones() as u64;
        ends.failed += (came & !holds).count_ones() as u64;
        let rows = ends.low.iter_mut().zip(&mut ends.high).zip(sides);
        for ((lows, highs), side) in rows {
            let (lows, _) = lows.as_chunks_mut::<8>();
            let (highs, _) = highs.as_chunks_mut::<8>();
            for (part, (lows, highs)) in lows.iter_mut().zip(highs).enumerate() {
                let values = numbers(side.part(simd, part), comparison.scalar);
                let counts = signed(lanes.part(simd, part)).simd_lt(0);
                let [low, high]: [f32x8<S>; 2] = [*lows, *highs].map(|ends| ends.simd_into(simd));
                // Comparisons with NaN are false, so NaN changes neither bound.
                *lows = (values.simd_lt(low) & counts).select(values, low).into();
                *highs = (values.simd_gt(high) & counts).select(values, high).into();
            }
        }
    }

    /// The lanes in which an operand test holds; none if the operand is missing.
    #[inline(always)]
    fn holds<S: Simd>(
        &self,
        simd: S,
        test: &OperandTest,
        (scalar, check_operands): (Scalar, &OperandCheck),
    ) -> u32 {
        let operand = |at: usize| {
            let reg = check_operands.operands.get(at)?;
            Some(self.row(*reg))
        };
        let Some(left) = operand(test.operand) else {
            return 0;
        };
        let of = |row: &Row, part: usize| numbers(row.part(simd, part), scalar);
        let relation = test.relation;
        match test.with {
            ComparedWith::Number(number) => {
                let right = f32x8::splat(simd, number as f32);
                mask_by_parts(inlined!(|part| compared(relation, of(left, part), right)))
            }
            ComparedWith::Operand(at) => operand(at).map_or(0, |right| {
                mask_by_parts(inlined!(|part| compared(
                    relation,
                    of(left, part),
                    of(right, part)
                )))
            }),
        }
    }

    /// The lanes whose operands make the result undefined.
    #[inline(always)]
    fn undefined<S: Simd>(
        &self,
        simd: S,
        Undefined(cases): Undefined,
        (scalar, check_operands): (Scalar, &OperandCheck),
    ) -> u32 {
        let mut any = 0;
        for case in cases {
            let mut all = u32::MAX;
            for test in *case {
                all &= self.holds(simd, test, (scalar, check_operands));
            }
            any |= all;
        }
        any
    }

    /// The lanes with a fault of this kind.
    #[inline(always)]
    fn wrong<S: Simd>(
        &self,
        simd: S,
        kind: FaultKind,
        checked: FaultCheck,
        check_operands: &OperandCheck,
    ) -> u32 {
        let result = self.row(check_operands.result);
        let operands = || check_operands.operands.iter().map(|reg| self.row(*reg));
        match kind {
            FaultKind::Nan => {
                let made = lanes_where(result, f32::is_nan);
                match made {
                    0 => 0,
                    _ => operands().fold(made, |m, row| m & !lanes_where(row, f32::is_nan)),
                }
            }
            FaultKind::Infinite => {
                let made = lanes_where(result, f32::is_infinite);
                match made {
                    0 => 0,
                    _ => operands().fold(made, |m, row| m & lanes_where(row, f32::is_finite)),
                }
            }
            FaultKind::DivisionByZero => self.zeros(simd, check_operands, checked.scalar()),
            FaultKind::OutOfRange => {
                let limit = check_operands
                    .operands
                    .last()
                    .map_or(&Row::ZERO, |r| self.row(*r));
                let lanes = result.0.into_iter().zip(limit.0).enumerate();
                lanes.fold(0, |m, (lane, (at, limit))| {
                    m | ((at >= limit) as u32) << lane
                })
            }
            FaultKind::Undefined => match checked {
                FaultCheck::Operands(undefined, scalar) => {
                    self.undefined(simd, undefined, (scalar, check_operands))
                }
                FaultCheck::Neighbours => !full_quads(self.active),
                _ => 0,
            },
        }
    }

    pub(super) fn open(&mut self, tile: &Tile) {
        self.tile = *tile;
        self.requested = tile.requested;
        self.expanded = ActiveLanes::of(u32::MAX, tile.requested);
        self.watched.open();
    }
}

impl Observations {
    /// Merges the statistics of another thread of the same draw.
    pub fn add(&mut self, other: Observations) {
        if self.pixels == 0 {
            *self = other;
            return;
        }
        self.pixels += other.pixels;
        self.operations += other.operations;
        for (own, other) in self.loops.iter_mut().zip(other.loops) {
            own.pixels += other.pixels;
            own.entries += other.entries;
            own.iterations += other.iterations;
            own.most = own.most.max(other.most);
            own.exhausted += other.exhausted;
            own.exhausted_pixels += other.exhausted_pixels;
            if own.histogram.len() < other.histogram.len() {
                own.histogram.resize(other.histogram.len(), 0);
            }
            for (own, other) in own.histogram.iter_mut().zip(other.histogram) {
                *own += other;
            }
        }
        for (own, other) in self.branches.iter_mut().zip(other.branches) {
            own.taken += other.taken;
            own.skipped += other.skipped;
        }
        for (own, other) in self.statements.iter_mut().zip(other.statements) {
            (own.times, own.pixels) = (own.times + other.times, own.pixels + other.pixels);
        }
        for (own, other) in self.functions.iter_mut().zip(other.functions) {
            (own.own, own.inclusive) = (own.own + other.own, own.inclusive + other.inclusive);
        }
        for (own, other) in self.charged.iter_mut().zip(other.charged) {
            *own += other;
        }
        for (own, other) in self.watched.iter_mut().zip(other.watched) {
            own.visits += other.visits;
        }
        for (own, other) in self.compared.iter_mut().zip(&other.compared) {
            own.add(other);
        }
        for index in other.numbers {
            let same = |n: &&mut NumberObservation| n.op == index.op && n.kind == index.kind;
            match self.numbers.iter_mut().find(same) {
                Some(known) => {
                    known.times += index.times;
                    let place = |w: &Witness| (w.pixel[1], w.pixel[0]);
                    if place(&index.witness) < place(&known.witness) {
                        known.witness = index.witness;
                    }
                }
                None => self.numbers.push(index),
            }
        }
        self.numbers.sort_by_key(|n| (n.op, n.kind));
    }
}
