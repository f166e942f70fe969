//! Programs that scripts make with WebGL itself.

mod attributes;
mod blocks;
mod replay;
mod setters;
mod uniforms;

use crate::breach::Breach;
use crate::link;
use replay::GlReplay;
pub use replay::constant;
use shaderlint_script::World;
pub use uniforms::{css_size, is_css_size};

/// Adds what is wrong with the programs that scripts make with WebGL.
pub fn check(world: &World, found: &mut Vec<Breach>) {
    let mut replay = GlReplay::new(world);
    if replay.programs.is_empty() {
        return;
    }
    for program in replay.programs.values() {
        link::check(&program.stages, program.place, found);
    }
    replay.run();
    replay.check_unset(found);
    attributes::check(&replay, found);
    blocks::check(&replay, found);
    found.extend(replay.verdicts.0.into_values().flatten());
}
