//! Evidence from a sample run for findings of the static analysis.

use super::{Round, SampleRun};
use crate::facts::Facts;
use shaderlint_exec::{FaultKind, LoopObservation, NumberObservation, Observations};
use shaderlint_ir::OpId;
use shaderlint_syntax::ast::StmtId;
use shaderlint_text::number::{grouped, rounded_percent};

/// Evidence from a sample run for a finding.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Verdict {
    /// Whether the fault occurred; if not, the operation ran often without it.
    pub is_confirmed: bool,
    /// The evidence, as a note.
    pub words: String,
}

/// Fewest evaluations without a fault that count as evidence.
const LEAST_VISITS: u64 = 256;

impl Facts<'_> {
    /// Evidence from a sample run for faults of an operation; `None` if it ran rarely, or depends on
    /// unknown inputs.
    pub(crate) fn verdict(&self, op: OpId, kinds: &[FaultKind]) -> Option<Verdict> {
        if !self.is_known(op) {
            return None;
        }
        let is_one = |kind: FaultKind, other: OpId| other == op && kinds.contains(&kind);
        let occurs = |sample_run: &&SampleRun| {
            let mut numbers = sample_run.seen.numbers.iter();
            numbers.any(|n| is_one(n.kind, n.op))
        };
        // One occurrence is enough; that there is none needs all pixels.
        let few = self.round(Round::Second).filter(occurs);
        let sample_run = few.or_else(|| self.sample_run())?;
        let watched = sample_run.seen.watched.iter();
        let visits = watched
            .filter(|w| is_one(w.kind, w.op))
            .map(|w| w.visits)
            .max()?;
        let times = |sample_run: &SampleRun| {
            let numbers = sample_run.seen.numbers.iter();
            numbers
                .filter(|n| is_one(n.kind, n.op))
                .map(|n| n.times)
                .sum::<u64>()
        };
        let seen = times(sample_run);
        if seen > 0 {
            let number = sample_run
                .seen
                .numbers
                .iter()
                .find(|n| is_one(n.kind, n.op))?;
            let place = place(sample_run, number);
            return Some(Verdict {
                is_confirmed: true,
                words: format!(
                    "occurred in {} of {} sampled evaluations, first {place}",
                    grouped(seen),
                    grouped(visits)
                ),
            });
        }
        (visits >= LEAST_VISITS && self.is_seen(|sample_run| times(sample_run) == 0)).then(|| {
            Verdict {
                is_confirmed: false,
                words: format!("did not occur in {} sampled evaluations", grouped(visits)),
            }
        })
    }
}

impl Facts<'_> {
    /// The sampled iteration counts of a loop.
    pub fn loop_observation<'s>(
        &self,
        seen: &'s Observations,
        stmt: StmtId,
    ) -> Option<&'s LoopObservation> {
        let is_this = |id| self.module().looped(id).is_some_and(|l| l.stmt == stmt);
        seen.loops.iter().find(|l| is_this(l.id))
    }

    /// The sampled iteration counts of a loop, as a note; `None` if they depend on unknown inputs.
    pub fn iterations_note(&self, stmt: StmtId) -> Option<String> {
        let sample_run = self.round(Round::Second)?;
        let seen = self.loop_observation(&sample_run.seen, stmt)?;
        let mut ops = self.module().looped(seen.id)?.ops.ops();
        if seen.entries == 0 || !ops.all(|op| self.is_known(op)) {
            return None;
        }
        let (pixels, most) = (sample_run.pixels, seen.most);
        let mean = seen.iterations as f64 / seen.entries as f64;
        let out = match seen.exhausted_pixels {
            0 => "no pixel reached the limit".to_string(),
            n => format!(
                "{} of the pixels in the loop reached the limit",
                rounded_percent(n as f64 / seen.pixels.max(1) as f64)
            ),
        };
        Some(format!(
            "sampled {} pixels: at most {most} iterations, {mean:.1} on average; {out}",
            grouped(pixels)
        ))
    }
}

/// A sampled fault that no other rule has reported.
#[derive(Clone, PartialEq, Debug)]
pub struct UnreportedFault {
    /// The operation, and the first sample of the fault.
    pub number: NumberObservation,
    /// How often the fault occurred and where first, as a note.
    pub words: String,
    /// What was sampled, as a note.
    pub sampled: String,
}

/// Least share of the evaluations of a fault that affects more than a line or a point of the image, which
/// the code may account for.
pub const OFTEN: f64 = 0.01;

/// By how much the share in a few pixels may be too small by chance.
const CHANCE: f64 = 3.0;

/// How often an operation was evaluated.
fn visits(sample_run: &SampleRun, number: &NumberObservation) -> u64 {
    let watched = sample_run.seen.watched.iter();
    let same = watched.filter(|w| w.op == number.op && w.kind == number.kind);
    same.map(|w| w.visits).max().unwrap_or(0)
}

/// The share of the evaluations of an operation in which a fault occurred.
fn share_of(sample_run: &SampleRun, number: &NumberObservation) -> f64 {
    number.times as f64 / visits(sample_run, number).max(1) as f64
}

impl Facts<'_> {
    /// The faults of this kind that occur on every GPU, do not depend on unknown inputs, and have not been
    /// reported by another rule. `concerns` selects among them, by their share of the evaluations too,
    /// before other GPUs are tried.
    pub fn unreported_faults(
        &self,
        kind: FaultKind,
        concerns: impl Fn(&NumberObservation, f64) -> bool,
    ) -> Vec<UnreportedFault> {
        let is_same =
            |a: &NumberObservation, b: &NumberObservation| a.op == b.op && a.kind == b.kind;
        let may_be = |number: &NumberObservation, share: f64| {
            number.kind == kind && concerns(number, share) && self.is_open(number.op, kind)
        };
        if !self.has_open(kind) {
            return Vec::new();
        }
        let few = self.round(Round::Second);
        let is_open = few.is_some_and(|few| {
            let mut numbers = few.seen.numbers.iter();
            numbers.any(|number| may_be(number, CHANCE * share_of(few, number)))
        });
        let Some(sample_run) = few.filter(|_| is_open).and_then(|_| self.sample_run()) else {
            return Vec::new();
        };
        let numbers = sample_run.seen.numbers.iter();
        let is_one = |number: &&NumberObservation| {
            let occurs = |run: &SampleRun| run.seen.numbers.iter().any(|n| is_same(n, number));
            may_be(number, share_of(sample_run, number)) && self.is_seen(occurs)
        };
        let unreported = numbers.filter(is_one).map(|number| {
            let visits = visits(sample_run, number);
            let (times, place) = (number.times, place(sample_run, number));
            UnreportedFault {
                number: number.clone(),
                words: format!(
                    "occurred in {} of {} sampled evaluations, first {place}",
                    grouped(times),
                    grouped(visits)
                ),
                sampled: sample_run.sampled_note(),
            }
        });
        unreported.collect()
    }
}

/// Where a fault first occurred: `at pixel (3, 4) at 2.3 s`.
fn place(sample_run: &SampleRun, number: &NumberObservation) -> String {
    let is_same = |n: &NumberObservation| n.op == number.op && n.kind == number.kind;
    let mut frames = sample_run.frames.iter();
    let first = frames.find_map(|frame| {
        let mut numbers = frame.sampled.seen.numbers.iter();
        Some((
            frame.instant.time,
            numbers.find(|n| is_same(n))?.witness.pixel,
        ))
    });
    let (time, [x, y]) = first.unwrap_or((0.0, number.witness.pixel));
    format!("at pixel ({x}, {y}) at {time} s")
}
