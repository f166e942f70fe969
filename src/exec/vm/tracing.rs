//! Records what one lane does.

use crate::row::Row;

/// A value that a pixel wrote, passed or returned.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TraceStep {
    /// Index of the site in [`PixelTrace::sites`](crate::PixelTrace::sites).
    pub site: u32,
    /// The scalars, as bits.
    pub bits: Vec<u32>,
}

/// The steps of a lane.
pub(crate) struct TraceLog {
    /// The lane.
    pub lane: usize,
    /// How many steps are recorded at most.
    pub most: usize,
    /// The steps so far.
    pub steps: Vec<TraceStep>,
    /// Whether there were more steps.
    pub is_cut: bool,
}

impl TraceLog {
    /// Adds a step with the values of some registers, if there is room.
    pub fn add<'r>(&mut self, site: u32, rows: impl Iterator<Item = &'r Row>) {
        if self.steps.len() >= self.most {
            self.is_cut = true;
            return;
        }
        let bits = rows.map(|row| row.0.get(self.lane).copied().unwrap_or(0));
        let bits = bits.collect();
        self.steps.push(TraceStep { site, bits });
    }
}
