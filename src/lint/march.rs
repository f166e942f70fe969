//! Loops that march along a ray, and the functions that they ask for the scene.

use crate::flow::{Calls, LoopFacts, Loops};
use crate::semantic::{FunctionRef, Program};

/// A loop that asks the scene at each step along a ray.
#[derive(Clone, Copy, Debug)]
pub struct March {
    /// The loop.
    pub looped: LoopFacts,
    /// What it looks for.
    pub goal: MarchGoal,
    /// The call of the scene in it that does most, by its place in the text the first.
    pub scene: FunctionRef,
}

/// What a marching loop looks for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MarchGoal {
    /// What a pixel shows.
    Picture,
    /// What stands before a light.
    Shadow,
}

impl MarchGoal {
    /// In a message: the ... takes too long.
    pub const fn name(self) -> &'static str {
        match self {
            MarchGoal::Picture => "marching loop",
            MarchGoal::Shadow => "shadow loop",
        }
    }
}

/// The marching loops that are reached from the entry: `for`, `while` and `do` loops that call a
/// function of the shader with a place in the plane or in space.
pub fn marches(
    program: &Program,
    loops: &Loops,
    calls: &Calls,
    entry: Option<FunctionRef>,
) -> Vec<March> {
    let Some(entry) = entry else {
        return Vec::new();
    };
    let reached = calls.graph().reached_from(entry);
    let is_reached = |f: FunctionRef| reached.get(f.0 as usize).copied().unwrap_or(false);
    let all = loops.all.iter().filter(|l| is_reached(l.function));
    all.filter_map(|l| {
        Some(March {
            looped: *l,
            goal: role(program, l)?,
            scene: scene(program, calls, l)?,
        })
    })
    .collect()
}

fn role(program: &Program, looped: &LoopFacts) -> Option<MarchGoal> {
    let name = program.names.text(program.function(looped.function)?.name);
    let is_shadow = name.to_lowercase().contains("shadow");
    Some(if is_shadow {
        MarchGoal::Shadow
    } else {
        MarchGoal::Picture
    })
}

/// The function of the shader that a loop's body calls with a place.
fn scene(program: &Program, calls: &Calls, looped: &LoopFacts) -> Option<FunctionRef> {
    let extent = program.tree.stmt(looped.stmt).extent;
    let called = calls.calls_by(looped.function).find(|call| {
        let expr = program.tree.expr(call.expr);
        let is_inside = extent.first <= expr.extent.first && expr.extent.last <= extent.last;
        is_inside && takes_place(program, call.callee)
    });
    called.map(|c| c.callee)
}

/// Whether a function takes a vector.
fn takes_place(program: &Program, function: FunctionRef) -> bool {
    let callee = program.function(function);
    callee.is_some_and(|f| f.params.iter().any(|p| p.ty.components() >= 2))
}

/// `mainImage`, `render`, `castRay`: the way from the entry to a function, where it is more than
/// the two.
pub fn way(
    program: &Program,
    calls: &Calls,
    entry: FunctionRef,
    to: FunctionRef,
) -> Option<String> {
    let chain = calls.graph().chain(entry, to)?;
    let names: Vec<String> = chain
        .iter()
        .filter_map(|f| program.function(*f))
        .map(|f| format!("`{}`", program.names.text(f.name)))
        .collect();
    (names.len() > 2).then(|| names.join(", "))
}
