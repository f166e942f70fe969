//! What a run says of a finding that was made by reading.

use super::{Trial, percent};
use crate::facts::Facts;
use shaderlint_exec::{Kind, LoopSeen, NumberSeen, Seen};
use shaderlint_ir::OpId;
use shaderlint_syntax::ast::StmtId;

/// What a run says of a finding.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Verdict {
    /// Whether it was seen; else it never was, although pixels came there.
    pub is_confirmed: bool,
    /// What was seen.
    pub words: String,
}

/// How often pixels have to come somewhere before it means something that nothing was seen.
const LEAST_VISITS: u64 = 1000;

impl Facts<'_> {
    /// What a run says of numbers that go wrong at an operation; nothing where hardly any pixel came
    /// there, or what happens there hangs on what nobody knows.
    pub(crate) fn verdict(&self, op: OpId, kinds: &[Kind]) -> Option<Verdict> {
        let trial = self.trial().filter(|_| self.is_known(op))?;
        let is_one = |kind: Kind, other: OpId| other == op && kinds.contains(&kind);
        let watched = trial.seen.watched.iter();
        let visits = watched
            .filter(|w| is_one(w.kind, w.op))
            .map(|w| w.visits)
            .max()?;
        let times = |trial: &Trial| {
            let numbers = trial.seen.numbers.iter();
            numbers
                .filter(|n| is_one(n.kind, n.op))
                .map(|n| n.times)
                .sum::<u64>()
        };
        let seen = times(trial);
        if seen > 0 {
            let number = trial.seen.numbers.iter().find(|n| is_one(n.kind, n.op))?;
            let place = place(trial, number);
            return Some(Verdict {
                is_confirmed: true,
                words: format!("a run met this {seen} of {visits} times, first {place}"),
            });
        }
        (visits >= LEAST_VISITS && self.is_seen(|trial| times(trial) == 0)).then(|| Verdict {
            is_confirmed: false,
            words: format!("a run came here {visits} times and never met this"),
        })
    }
}

impl Facts<'_> {
    /// What was seen of a loop.
    pub fn loop_seen<'s>(&self, seen: &'s Seen, stmt: StmtId) -> Option<&'s LoopSeen> {
        let is_this = |id| self.module().looped(id).is_some_and(|l| l.stmt == stmt);
        seen.loops.iter().find(|l| is_this(l.id))
    }

    /// How often a loop was seen to turn, as a note; nothing where that hangs on what nobody knows.
    pub fn turns_seen(&self, stmt: StmtId) -> Option<String> {
        let trial = self.trial()?;
        let seen = self.loop_seen(&trial.seen, stmt)?;
        let mut ops = self.module().looped(seen.id)?.ops.ops();
        if seen.entries == 0 || !ops.all(|op| self.is_known(op)) {
            return None;
        }
        let (pixels, most) = (trial.pixels, seen.most);
        let mean = seen.turns as f64 / seen.entries as f64;
        let out = match seen.exhausted_pixels {
            0 => "none of them ran out".to_string(),
            n => format!(
                "{} of them ran out",
                percent(n as f64 / seen.pixels.max(1) as f64)
            ),
        };
        Some(format!(
            "a run of {pixels} pixels took {most} at most, {mean:.1} in the mean; {out}"
        ))
    }
}

/// A number that went wrong and of which no rule has told.
#[derive(Clone, PartialEq, Debug)]
pub struct Untold {
    /// What was seen.
    pub number: NumberSeen,
    /// How often pixels came there.
    pub visits: u64,
    /// How often it happened and where first, as a note.
    pub words: String,
}

impl Facts<'_> {
    /// The numbers that go wrong in this way on every GPU, whatever nobody knows, and of which no rule
    /// has told.
    pub fn untold(&self, kind: Kind) -> Vec<Untold> {
        let Some(trial) = self.trial() else {
            return Vec::new();
        };
        let numbers = trial.seen.numbers.iter().filter(|n| n.kind == kind);
        let is_one = |number: &&NumberSeen| {
            let is_same = |n: &NumberSeen| n.op == number.op && n.kind == kind;
            let is_new = !self.is_told(number.op) && self.is_known(number.op);
            is_new && self.is_seen(|trial| trial.seen.numbers.iter().any(is_same))
        };
        let told = numbers.filter(is_one).map(|number| {
            let watched = trial.seen.watched.iter();
            let same = watched.filter(|w| w.op == number.op && w.kind == kind);
            let visits = same.map(|w| w.visits).max().unwrap_or(0);
            let (times, place) = (number.times, place(trial, number));
            Untold {
                number: number.clone(),
                visits,
                words: format!("{times} of {visits} times, first {place}"),
            }
        });
        told.collect()
    }
}

/// Where and when a number first went wrong: at the pixel (3, 4), at 2.3 s.
fn place(trial: &Trial, number: &NumberSeen) -> String {
    let is_same = |n: &NumberSeen| n.op == number.op && n.kind == number.kind;
    let mut shots = trial.shots.iter();
    let first = shots.find_map(|shot| {
        let mut numbers = shot.sampled.seen.numbers.iter();
        Some((
            shot.instant.time,
            numbers.find(|n| is_same(n))?.witness.pixel,
        ))
    });
    let (time, [x, y]) = first.unwrap_or((0.0, number.witness.pixel));
    format!("at the pixel ({x}, {y}) at {time} s")
}
