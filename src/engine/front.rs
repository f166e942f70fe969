//! White space before the `#version` of a shader: scripts may trim the text before they compile it.

use super::host::imports;
use super::path::plain;
use super::world::World;
use shaderlint_text::embed::{Embedder, Front};
use std::path::Path;

/// Maximum number of scripts of a page that are read.
const MAX_SCRIPTS: usize = 16;

/// What a page or script does with white space before its shaders, according to itself or to a
/// script that it loads.
pub fn front(name: &str, text: &str, own: Embedder, world: World) -> Front {
    if own.front != Front::Unknown {
        return own.front;
    }
    let file = plain(&world.files.here().join(name));
    let folder = file.parent().unwrap_or(Path::new(""));
    let own_scripts = sources(text).into_iter().chain(imports(text));
    let relative = own_scripts.filter(|path| !path.contains("://"));
    let told = relative.take(MAX_SCRIPTS).filter_map(|path| {
        let path = plain(&folder.join(path.trim_start_matches('/')));
        let script = world.files.load(&path).ok()?;
        Some(Embedder::of(&script).front)
    });
    // Helper scripts read the shader, others compile it.
    let all: Vec<Front> = told.collect();
    match (all.contains(&Front::Trimmed), all.contains(&Front::Kept)) {
        (true, _) => Front::Trimmed,
        (false, true) => Front::Kept,
        (false, false) => Front::Unknown,
    }
}

/// The scripts that a page loads.
fn sources(page: &str) -> Vec<&str> {
    let attributes = page.match_indices("src=").filter_map(|(at, word)| {
        let value = page.get(at + word.len()..)?;
        let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''))?;
        value.get(1..)?.split(quote).next()
    });
    attributes.filter(|path| path.ends_with("js")).collect()
}
