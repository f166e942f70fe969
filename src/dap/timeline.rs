//! The moments of a pixel, forwards and backwards.
//!
//! A moment is the number of stops of the pixel's lane so far, so the first stop is moment 1. Going back
//! restores the nearest checkpoint and runs from there.

use shaderlint_exec::{Draw, Pause, Replay, ReplayCheckpoint, Stop, lane_of};

/// The number of moments between checkpoints, until there are too many.
const EVERY: u32 = 1024;
/// Maximum number of checkpoints. A checkpoint has 16 bytes per register.
const MOST: usize = 64;

/// The moments of one pixel of a draw call.
pub struct Timeline {
    /// The pixel, from the lower left corner.
    pub pixel: [u32; 2],
    /// In order of moments.
    checkpoints: Vec<(u32, ReplayCheckpoint)>,
    /// The number of moments between checkpoints.
    every: u32,
}

impl Timeline {
    /// The moments of a pixel.
    pub const fn of(pixel: [u32; 2]) -> Timeline {
        Timeline {
            pixel,
            checkpoints: Vec::new(),
            every: EVERY,
        }
    }

    /// The lane of the pixel.
    pub const fn lane(&self) -> usize {
        lane_of(self.pixel)
    }

    /// A replay at a moment, with its stop; `None` beyond the last moment.
    ///
    /// # Errors
    /// The pixel ran out of fuel before.
    pub fn at<'d>(
        &mut self,
        draw: &'d Draw<'d>,
        moment: u32,
    ) -> Result<Option<(Replay<'d>, Pause)>, Stop> {
        let mut found = None;
        let mut replay = self.scan(draw, moment.saturating_sub(1), &mut |_, pause| {
            found = pause;
            true
        })?;
        // What earlier statements did is not what this one does.
        replay.forget();
        Ok(found.map(|pause| (replay, pause)))
    }

    /// Runs on from a moment. `visit` gets each later stop of the lane and then the end; it returns
    /// whether to stop there.
    ///
    /// # Errors
    /// The pixel ran out of fuel.
    pub fn scan<'d>(
        &mut self,
        draw: &'d Draw<'d>,
        from: u32,
        visit: &mut dyn FnMut(&mut Replay<'d>, Option<Pause>) -> bool,
    ) -> Result<Replay<'d>, Stop> {
        let lane = self.lane();
        let mut replay = Replay::new(draw, self.pixel)?;
        let known = self.checkpoints.partition_point(|(at, _)| *at <= from);
        let nearest = known.checked_sub(1).and_then(|at| self.checkpoints.get(at));
        let mut moment = 0;
        if let Some((at, checkpoint)) = nearest {
            replay.restore(checkpoint);
            moment = *at;
        }
        loop {
            let pause = replay.advance()?;
            if pause.is_some_and(|pause| pause.lanes >> lane & 1 == 0) {
                continue;
            }
            let is_seen = moment >= from || pause.is_none();
            if is_seen && visit(&mut replay, pause) || pause.is_none() {
                return Ok(replay);
            }
            replay.forget();
            moment += 1;
            self.keep(moment, &replay);
        }
    }

    /// The last stop before a moment for which `choose` has a value.
    ///
    /// # Errors
    /// The pixel ran out of fuel.
    pub fn scan_back<'d, T>(
        &mut self,
        draw: &'d Draw<'d>,
        before: u32,
        choose: &mut dyn FnMut(&mut Replay<'d>, Pause) -> Option<T>,
    ) -> Result<Option<T>, Stop> {
        let mut end = before;
        loop {
            let starts = self.checkpoints.iter().map(|(at, _)| *at);
            let start = starts.rev().find(|at| *at + 2 < end).unwrap_or(0);
            let lane = self.lane();
            let mut found = None;
            self.scan(draw, start, &mut |replay, pause| {
                let Some(pause) = pause else {
                    return true;
                };
                let moment = pause.moments.get(lane).copied().unwrap_or(0);
                if moment >= end {
                    return true;
                }
                if let Some(chosen) = choose(replay, pause) {
                    found = Some(chosen);
                }
                false
            })?;
            if found.is_some() || start == 0 {
                return Ok(found);
            }
            // The first stop after a checkpoint is seen again, after the one before it.
            end = start + 2;
        }
    }

    /// Keeps a checkpoint if one is due.
    fn keep(&mut self, moment: u32, replay: &Replay<'_>) {
        let last = self.checkpoints.last().map_or(0, |(at, _)| *at);
        if moment < last.saturating_add(self.every) {
            return;
        }
        self.checkpoints.push((moment, replay.checkpoint()));
        if self.checkpoints.len() > MOST {
            let mut number = 0;
            self.checkpoints.retain(|_| {
                number += 1;
                number % 2 == 0
            });
            self.every = self.every.saturating_mul(2);
        }
    }
}
