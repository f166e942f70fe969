//! Ray loops: loops that provably move a point along a ray.
//!
//! Three forms are recognised. A *distance loop* adds a step to a ray parameter (`t += k * d`) or to a
//! point (`p += direction * d`), where `d` is evaluated at a point that depends on that parameter or
//! point, and the direction is loop-invariant. A *grid loop* moves an integer cell by at most one per
//! component and asks a function about it. A *fixed-step loop* adds a step that does not depend on the
//! scene; nothing is known of its hits. Loops over bounces, fractal iterations and loops in two
//! dimensions have none of these forms.

mod dependence;
mod exits;
mod form;
mod motion;
mod start;
mod step;
#[cfg(test)]
mod tests;

use super::calls::{Bodies, Calls};
use super::ranges::Query;
use dependence::LoopSlice;
use exits::exits;
pub use form::{HitTest, RayKind, RayLoop, RayMotion, RayStep, SceneCall};
use shaderlint_ir::LoopId;
use shaderlint_semantic::FunctionRef;
use start::Starts;
use step::Stepped;

/// Most ray loops of which the starts are compared with the results of the others.
const MAX_LOOPS: usize = 32;

/// The ray loops of a shader, in the order of [`shaderlint_ir::Module::loops`].
pub fn ray_loops(query: Query, calls: &Calls) -> Vec<RayLoop> {
    let module = query.module;
    let bodies = Bodies::of(module);
    let loops = (0..).map(LoopId).zip(&module.loops);
    let all =
        loops.filter_map(|(id, looped)| ray_loop(query, id, bodies.around(looped.ops.first)?));
    let all: Vec<(RayLoop, Stepped)> = all.collect();
    let ids: Vec<LoopId> = all.iter().map(|(ray, _)| ray.looped).collect();
    let holds = |function| all.iter().any(|(ray, _)| ray.function == function);
    let marching = calls.graph.reaching(holds);
    let starts = Starts::new(query, &ids, &marching);
    let found = all.into_iter().map(|(mut ray, stepped)| {
        if ids.len() <= MAX_LOOPS {
            ray.start = starts.of(&stepped);
        }
        ray
    });
    found.collect()
}

fn ray_loop(query: Query, id: LoopId, function: FunctionRef) -> Option<(RayLoop, Stepped)> {
    let looped = query.module.looped(id)?;
    let slice = LoopSlice::new(query, id, looped);
    let stepped = step::find(&slice)?;
    let (hit, ends_far) = exits(&slice, &stepped, looped);
    let hit = hit.filter(|_| stepped.kind != RayKind::Fixed);
    let asked = hit.filter(|_| stepped.kind == RayKind::Grid);
    let asked = asked.map(|hit| vec![(hit.condition, 0)]);
    let ray = RayLoop {
        looped: id,
        stmt: looped.stmt,
        function,
        kind: stepped.kind,
        scene: slice.called(asked.as_ref().unwrap_or(&stepped.distance), &stepped.heads),
        hit,
        ends_far,
        accumulates: step::accumulates(&slice, &stepped),
        start: None,
        motion: motion::motion(&slice, &stepped, hit.as_ref()),
    };
    Some((ray, stepped))
}
