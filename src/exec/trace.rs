//! Traces a pixel: everything that it writes, in order.

use super::bytecode::TraceSite;
use super::draw::{Draw, Stop};
use super::observations::Observations;
use super::render::{Sampled, tile_of};
use super::vm::{TraceLog, TraceStep, Vm};

/// What a pixel did.
#[derive(Clone, Debug)]
pub struct PixelTrace {
    /// The values that are traced.
    pub sites: Vec<TraceSite>,
    /// The steps in the order in which they were executed.
    pub steps: Vec<TraceStep>,
    /// Whether there were more steps than allowed.
    pub is_cut: bool,
    /// By output: the first four scalars, as bits.
    pub outputs: Vec<[u32; 4]>,
    /// Whether the pixel was not discarded.
    pub is_covered: bool,
    /// The number of operations.
    pub cost: u32,
    /// The statistics of this pixel alone.
    pub seen: Observations,
    /// Why the run was aborted, if it was.
    pub stop: Option<Stop>,
}

/// Runs the quad of a pixel and records up to `most` of its steps. The code has to be compiled with
/// [`CompileOptions::trace`](crate::CompileOptions::trace).
pub fn trace(draw: &Draw<'_>, pixel: [u32; 2], most: usize) -> PixelTrace {
    let mut vm = Vm::new(draw);
    let [x, y] = pixel;
    let lane = (y & 1) << 1 | x & 1;
    let mut tile = tile_of(draw.size, &[[x & !1, y & !1]]);
    tile.requested &= 1 << lane;
    vm.traced = Some(TraceLog {
        lane: lane as usize,
        most,
        steps: Vec::new(),
        is_cut: false,
    });
    let ended = vm.run(&tile);
    let (covered, stop) = match ended {
        Ok(covered) => (covered, None),
        Err(stop) => (0, Some(stop)),
    };
    let sampled = Sampled::of(&vm, draw.code, &tile, covered);
    let log = vm.traced.take();
    let (steps, is_cut) = log.map_or_else(Default::default, |log| (log.steps, log.is_cut));
    PixelTrace {
        sites: draw.code.traces.clone(),
        steps,
        is_cut,
        outputs: sampled
            .outputs
            .iter()
            .filter_map(|all| all.first().copied())
            .collect(),
        is_covered: sampled.covered.first().copied().unwrap_or(false),
        cost: sampled.cost.first().copied().unwrap_or(0),
        seen: vm.finish(),
        stop,
    }
}
