//! Replays the quad of a pixel, stop by stop.
//!
//! Nothing is recorded: a run is deterministic, so the state at an earlier stop is found by running
//! again, from the start or from a checkpoint.

use super::bytecode::{Location, StopSite, TracedValue};
use super::draw::{Draw, Stop};
use super::render::tile_of;
use super::row::QUAD;
use super::vm::state::VmState;
use super::vm::{Fault, Vm};
use shaderlint_ir::OpId;
use shaderlint_semantic::VariableId;

/// A quad that stops before each statement that one of its pixels executes. The code has to be
/// compiled with [`CompileOptions::steps`](crate::CompileOptions::steps).
pub struct Replay<'d> {
    vm: Vm<'d>,
    draw: &'d Draw<'d>,
    /// By lane: the number of stops so far.
    moments: [u32; QUAD],
}

/// A stop of some pixels of a quad. Lanes are numbered in rows: lower left, lower right, upper left,
/// upper right.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Pause {
    /// The index in [`Bytecode::stops`](crate::Bytecode::stops).
    pub site: u32,
    /// The lanes that stop, one bit each.
    pub lanes: u32,
    /// By lane: the number of its stops so far, with this one.
    pub moments: [u32; QUAD],
}

/// The state of a replay between two stops.
pub struct ReplayCheckpoint {
    state: VmState,
    moments: [u32; QUAD],
}

/// The lane of a pixel in its quad.
pub const fn lane_of([x, y]: [u32; 2]) -> usize {
    ((y & 1) << 1 | x & 1) as usize
}

impl<'d> Replay<'d> {
    /// The quad of a pixel, before its first statement. Faults of this pixel alone are reported.
    ///
    /// # Errors
    /// There is not enough fuel.
    pub fn new(draw: &'d Draw<'d>, pixel: [u32; 2]) -> Result<Replay<'d>, Stop> {
        let mut vm = Vm::new(draw);
        let [x, y] = pixel;
        let mut tile = tile_of(draw.size, &[[x & !1, y & !1]]);
        tile.requested = 1 << lane_of(pixel);
        vm.pauses = (1 << QUAD) - 1;
        vm.begin(&tile)?;
        Ok(Replay {
            vm,
            draw,
            moments: [0; QUAD],
        })
    }

    /// Runs to the next stop of any pixel of the quad; `None` at the end.
    ///
    /// # Errors
    /// The quad ran out of fuel.
    pub fn advance(&mut self) -> Result<Option<Pause>, Stop> {
        let Some(site) = self.vm.proceed()? else {
            return Ok(None);
        };
        let lanes = self.vm.active() & ((1 << QUAD) - 1);
        for (lane, moment) in self.moments.iter_mut().enumerate() {
            *moment += lanes >> lane & 1;
        }
        Ok(Some(Pause {
            site,
            lanes,
            moments: self.moments,
        }))
    }

    /// The first faults of the pixel since they were forgotten.
    pub fn faults(&self) -> &[Fault] {
        &self.vm.watched.faults
    }

    /// The variables that the pixel wrote since they were forgotten, with the stores, in order. The code has to be compiled
    /// with [`CompileOptions::trace`](crate::CompileOptions::trace), too.
    pub fn writes(&self) -> impl Iterator<Item = (VariableId, OpId)> {
        let sites = self.vm.written.iter();
        let sites = sites.filter_map(|site| self.draw.code.traces.get(*site as usize));
        sites.filter_map(|site| match site.value {
            TracedValue::Written(variable, op) => Some((variable, op)),
            _ => None,
        })
    }

    /// Forgets the writes and faults so far.
    pub fn forget(&mut self) {
        self.vm.written.clear();
        self.vm.watched.faults.clear();
    }

    /// The site with this index.
    pub fn site(&self, site: u32) -> Option<&'d StopSite> {
        self.draw.code.stops().get(site as usize)
    }

    /// The scalars of a variable in a lane, as bits, at most `most`; `None` if it is not in scope, or
    /// a sampler. They are meaningful while the lane stops.
    pub fn scalars(&self, variable: VariableId, lane: usize, most: usize) -> Option<Vec<u32>> {
        self.scalars_at(self.location(variable), lane, most)
    }

    /// Where a variable is at the current stop.
    pub fn location(&self, variable: VariableId) -> Location {
        let own = self.draw.code.debug.locations.get(variable.0 as usize);
        let own = own.map_or(&[][..], |own| own);
        // The instruction of the stop was executed.
        let here = self.vm.next_instruction();
        let after = own.partition_point(|(from, _)| (*from as usize) < here);
        let found = after.checked_sub(1).and_then(|at| own.get(at));
        found.map_or(Location::None, |(_, location)| *location)
    }

    /// The scalars at a location in a lane, as [`Replay::scalars`].
    pub fn scalars_at(&self, location: Location, lane: usize, most: usize) -> Option<Vec<u32>> {
        match location {
            Location::None | Location::Sampler(_) => None,
            Location::Registers { start, len } => {
                let start = start as usize;
                let regs = self
                    .draw
                    .code
                    .debug
                    .lists
                    .get(start..start + len as usize)?;
                let regs = regs.iter().take(most);
                let bits = regs.map(|reg| self.vm.row(*reg).0.get(lane).copied().unwrap_or(0));
                Some(bits.collect())
            }
            Location::Memory { at, len } => {
                let at = at as usize;
                let words = self.draw.memory.get(at..at + len as usize)?;
                Some(words.iter().take(most).copied().collect())
            }
        }
    }

    /// By output of the code: the scalars of a lane, as bits.
    pub fn outputs(&self, lane: usize) -> Vec<Vec<u32>> {
        let bits = |reg: &u16| self.vm.row(*reg).0.get(lane).copied().unwrap_or(0);
        let outputs = self.draw.code.outputs.iter();
        outputs
            .map(|slot| slot.regs.iter().map(bits).collect())
            .collect()
    }

    /// Whether a lane was not discarded so far.
    pub const fn is_covered(&self, lane: usize) -> bool {
        self.vm.live() >> lane & 1 == 1
    }

    /// The state, to go back to.
    pub fn checkpoint(&self) -> ReplayCheckpoint {
        ReplayCheckpoint {
            state: self.vm.state(),
            moments: self.moments,
        }
    }

    /// Goes to a state of a replay of the same draw and quad.
    pub fn restore(&mut self, checkpoint: &ReplayCheckpoint) {
        self.vm.restore(&checkpoint.state);
        self.moments = checkpoint.moments;
    }
}
