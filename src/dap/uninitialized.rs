//! Finds the statement that reads an uninitialised variable.
//!
//! The code is run twice: with zeros in uninitialised variables, as browsers have them, and with other
//! bits. The first statement that writes a component that differs, although it did not before, has read
//! such a variable; so has a condition after which the runs part.

use super::debuggee::{Debuggee, stepping};
use super::stepping::moment_of;
use rustc_hash::FxHashMap;
use shaderlint_commands::run::Variant;
use shaderlint_exec::{CompileOptions, Pause, Replay, Stop, lane_of};
use shaderlint_ir::{OpId, OpKind};
use shaderlint_semantic::VariableId;

/// The bits of uninitialised variables in the second run: NaN, and an unlikely integer.
const BITS: u32 = 0x7fc1_2345;
/// Maximum number of scalars of a variable that are compared.
const MOST: usize = 256;

/// The moment of the first statement of a pixel that reads an uninitialised variable.
///
/// # Errors
/// A message about code that cannot be run.
pub fn first(debuggee: &Debuggee, pixel: [u32; 2]) -> Result<Option<u32>, String> {
    let options = CompileOptions {
        undefined: BITS,
        ..stepping()
    };
    let other = debuggee.variant(None, &options);
    let other = other.map_err(super::debuggee::message)?;
    let found = compare(&debuggee.build, &other, pixel);
    found.map_err(|stop| stop.to_string())
}

fn compare(own: &Variant, other: &Variant, pixel: [u32; 2]) -> Result<Option<u32>, Stop> {
    let lane = lane_of(pixel);
    let (draw, other_draw) = (own.draw(), other.draw());
    let mut replay = Replay::new(&draw, pixel)?;
    let mut second = Replay::new(&other_draw, pixel)?;
    let mut differing: FxHashMap<VariableId, Vec<bool>> = FxHashMap::default();
    while let Some(pause) = advance(&mut replay, lane)? {
        let before = moment_of(&pause, lane).saturating_sub(1);
        let with = advance(&mut second, lane)?;
        if with.is_none_or(|with| with.site != pause.site) {
            return Ok((before > 0).then_some(before));
        }
        let writes: Vec<(VariableId, OpId)> = replay.writes().collect();
        replay.forget();
        second.forget();
        for (variable, op) in writes {
            let values = [&replay, &second].map(|replay| replay.scalars(variable, lane, MOST));
            let [Some(value), Some(with)] = values else {
                continue;
            };
            let now: Vec<bool> = value.iter().zip(&with).map(|(a, b)| a != b).collect();
            let known = differing.insert(variable, now.clone()).unwrap_or_default();
            let mut components = now.iter().enumerate();
            let is_new = components.any(|(at, differs)| *differs && known.get(at) != Some(&true));
            if is_new && !is_undefined(own, op) {
                return Ok((before > 0).then_some(before));
            }
        }
    }
    Ok(None)
}

/// Runs to the next stop of a lane.
fn advance(replay: &mut Replay<'_>, lane: usize) -> Result<Option<Pause>, Stop> {
    loop {
        let pause = replay.advance()?;
        if pause.is_none_or(|pause| pause.lanes >> lane & 1 == 1) {
            return Ok(pause);
        }
    }
}

/// Whether a store is that of a declaration without an initialiser.
fn is_undefined(build: &Variant, store: OpId) -> bool {
    let module = &build.module;
    match module.op(store).kind {
        OpKind::Store(_, value) => module.op(value).kind == OpKind::Undef,
        _ => false,
    }
}
