//! Programs that scripts make with WebGL itself.

mod attributes;
mod bind;
mod blocks;
mod replay;
mod setters;
mod uniforms;

use crate::bindings::ProgramBindings;
use crate::breach::Breach;
use crate::link;
use replay::GlReplay;
pub use replay::constant;
use shaderlint_script::World;
pub use uniforms::{css_size, is_css_size};

/// Adds what is wrong with the programs that scripts make with WebGL, and their inputs.
pub fn check(world: &World, found: &mut Vec<Breach>, bindings: &mut Vec<ProgramBindings>) {
    let mut replay = GlReplay::new(world);
    if replay.programs.is_empty() {
        return;
    }
    for program in replay.programs.values() {
        link::check(&program.stages, program.place, found);
    }
    replay.run();
    let bound = replay.bind();
    replay.check_unset(&bound, found);
    attributes::check(&replay, found);
    blocks::check(&replay, found);
    bindings.extend(bound.into_values());
    found.extend(replay.verdicts.0.into_values().flatten());
}
