//! Steps of a pixel, forwards and backwards, as moments of its timeline.

use super::debuggee::Debuggee;
use super::places::StopPlace;
use super::timeline::Timeline;
use shaderlint_exec::{Draw, Pause, Stop};
use shaderlint_semantic::VariableId;
use shaderlint_syntax::ast::{Extent, StmtKind};

/// A step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StepKind {
    /// To the next statement of the function, or after its call.
    Over,
    /// To the next statement of any function.
    In,
    /// After the call of the function.
    Out,
    /// To the statement of the function before this one, or to its call.
    Back,
    /// To the statement that ran before this one, in any function.
    BackIn,
    /// To the call of the function.
    BackOut,
    /// To the condition, or the first statement, of the next iteration of the innermost loop; after the
    /// loop if there is none.
    NextIteration,
}

/// The state that a step starts from.
#[derive(Clone, Copy)]
pub struct StepStart {
    pub moment: u32,
    pub place: StopPlace,
}

/// The moment that a step leads to; `None` at the end or the beginning.
///
/// # Errors
/// The pixel ran out of fuel.
pub fn step(
    debuggee: &Debuggee,
    timeline: &mut Timeline,
    draw: &Draw<'_>,
    (kind, start): (StepKind, StepStart),
) -> Result<Option<u32>, Stop> {
    let depth = start.place.depth;
    let is_statement = |place: &StopPlace| place.returned.is_none();
    let is_target = |place: &StopPlace| match kind {
        StepKind::Over => place.depth < depth || place.depth == depth && is_statement(place),
        StepKind::In => is_statement(place) || place.depth < depth,
        StepKind::Out => place.depth < depth,
        StepKind::Back => place.depth <= depth && is_statement(place),
        StepKind::BackIn => is_statement(place),
        StepKind::BackOut => place.depth < depth && is_statement(place),
        StepKind::NextIteration => false,
    };
    match kind {
        StepKind::Back | StepKind::BackIn | StepKind::BackOut => {
            last(debuggee, timeline, draw, start.moment, &mut |_, place| {
                is_target(place)
            })
        }
        StepKind::NextIteration => {
            let looped = looped(debuggee, start.place.extent);
            next(
                debuggee,
                timeline,
                draw,
                start.moment,
                &mut |place| match &looped {
                    Some(looped) if place.depth == depth => {
                        place.extent == looped.first || !looped.extent.contains(place.extent)
                    }
                    Some(_) => place.depth < depth,
                    None => place.depth < depth || place.depth == depth && is_statement(place),
                },
            )
        }
        _ => next(
            debuggee,
            timeline,
            draw,
            start.moment,
            &mut is_target.clone(),
        ),
    }
}

/// The first moment after `from` at a place of the user that is chosen.
pub fn next(
    debuggee: &Debuggee,
    timeline: &mut Timeline,
    draw: &Draw<'_>,
    from: u32,
    is_chosen: &mut dyn FnMut(&StopPlace) -> bool,
) -> Result<Option<u32>, Stop> {
    let lane = timeline.lane();
    let mut found = None;
    timeline.scan(draw, from, &mut |_, pause| {
        found = pause.and_then(|pause| {
            let place = debuggee.places.at(pause.site)?;
            let is_found = place.is_user && is_chosen(place);
            is_found.then(|| moment_of(&pause, lane))
        });
        found.is_some()
    })?;
    Ok(found)
}

/// The last moment before `before` at a place of the user that is chosen.
pub fn last(
    debuggee: &Debuggee,
    timeline: &mut Timeline,
    draw: &Draw<'_>,
    before: u32,
    is_chosen: &mut dyn FnMut(u32, &StopPlace) -> bool,
) -> Result<Option<u32>, Stop> {
    let lane = timeline.lane();
    timeline.scan_back(draw, before, &mut |_, pause| {
        let place = debuggee.places.at(pause.site)?;
        let moment = moment_of(&pause, lane);
        (place.is_user && is_chosen(moment, place)).then_some(moment)
    })
}

/// The moment of a statement before `before` that wrote a variable, the last one; if `part` is given,
/// one that changed these scalars.
///
/// # Errors
/// The pixel ran out of fuel.
pub fn written(
    timeline: &mut Timeline,
    draw: &Draw<'_>,
    before: u32,
    (variable, part): (VariableId, Option<std::ops::Range<usize>>),
) -> Result<Option<u32>, Stop> {
    let lane = timeline.lane();
    // Unknown at the first stop after a checkpoint.
    let mut old: Option<Option<Vec<u32>>> = None;
    // The statement that writes is the one before the stop that sees the write.
    timeline.scan_back(draw, before.saturating_add(1), &mut |replay, pause| {
        let has_written = replay.writes().any(|(written, _)| written == variable);
        let is_changed = part.clone().is_none_or(|part| {
            let new = replay.scalars(variable, lane, part.end);
            let new = new.and_then(|bits| bits.get(part).map(<[u32]>::to_vec));
            let is_changed = old.as_ref().is_some_and(|old| *old != new);
            old = Some(new);
            is_changed
        });
        let moment = moment_of(&pause, lane).checked_sub(1)?;
        (has_written && is_changed && moment > 0).then_some(moment)
    })
}

/// The moment of a lane at a stop.
pub fn moment_of(pause: &Pause, lane: usize) -> u32 {
    pause.moments.get(lane).copied().unwrap_or(0)
}

/// A loop.
struct LoopPlace {
    extent: Extent,
    /// What starts an iteration: the condition, or the first statement.
    first: Extent,
}

/// The innermost loop around a statement, whose iterations start at a place that the code stops at.
fn looped(debuggee: &Debuggee, at: Extent) -> Option<LoopPlace> {
    let program = debuggee.program()?;
    let tree = &program.tree;
    let loops = tree
        .stmts
        .iter()
        .filter(|s| s.kind.is_loop() && s.extent.contains(at));
    let innermost = loops.min_by_key(|s| s.extent.last - s.extent.first)?;
    let head = match innermost.kind {
        StmtKind::For {
            condition: Some(condition),
            ..
        }
        | StmtKind::While { condition, .. } => tree.stmt(condition).extent,
        StmtKind::For { body, .. } | StmtKind::Do { body, .. } => tree.stmt(body).extent,
        _ => return None,
    };
    let stops = debuggee.places.iter().map(|place| place.extent);
    let first = stops
        .filter(|extent| head.contains(*extent))
        .min_by_key(|e| e.first)?;
    Some(LoopPlace {
        extent: innermost.extent,
        first,
    })
}
