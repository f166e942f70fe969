//! Hosts: sites, tools and libraries that run a shader, or complete it before the browser compiles
//! it. Each is a GLSL file with facts in its header. Presets in `presets/` and hosts written by
//! users have the same form. This is the only table of hosts: checking, running and porting use it.
//!
//! The header consists of line comments: the title in the first line, a description, and lines
//! `key: value`. The rest of the file is put before the shaders, with `VERTEX_SHADER` or
//! `FRAGMENT_SHADER` defined. A comment `// = time` after a declaration states the value that the
//! host sets ([`Meanings`]), comments `/// ...` before it are shown by editors. Names that the
//! shaders declare themselves are between `#ifdef SHADER_DECLARES` and `#endif`, which are not put
//! before any shader. Between `#ifdef SHADER_MAIN` and `#endif` is the `main` that the host appends, in
//! which `port_entry` is the entry function of the shader. Between `#ifdef SHADER_TEMPLATE` and `#endif` is what surrounds the code of a
//! shader that is written for the host ([`Template`]).

mod chunk;
mod derived;
mod head;
mod limit;
mod list;
mod meaning;
mod near;
mod preset;
mod template;

pub use chunk::{
    ChunkLibrary, HostChunk, chunk_libraries, chunk_names, chunk_prelude, is_chunk, predecessor,
    was_in_chunk,
};
pub use limit::Limit;
pub use meaning::{
    COMMON, Feed, FeedRow, Meanings, OWN, TextureFeed, TextureRow, USUAL, VaryingRow, is_named,
    is_one_name,
};
pub use near::none_of;
pub use preset::{
    HeadError, HostVersion, Preset, RequiredVersion, TextSign, declared_in, matches_any,
};
pub use template::Template;

use list::FILES;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The hosts of [`FILES`], each parsed on first use.
static PRESETS: [OnceLock<Preset>; FILES.len()] = [const { OnceLock::new() }; FILES.len()];

fn at(index: usize) -> Option<&'static Preset> {
    let ((name, text), cell) = (FILES.get(index)?, PRESETS.get(index)?);
    Some(cell.get_or_init(|| Preset {
        name,
        ..read(text).unwrap_or_default()
    }))
}

/// All presets in alphabetical order.
pub fn presets() -> impl Iterator<Item = &'static Preset> {
    (0..FILES.len()).filter_map(at)
}

/// The preset with a name or an alias.
pub fn preset(name: &str) -> Option<&'static Preset> {
    match FILES.iter().position(|(own, _)| *own == name) {
        Some(index) => at(index),
        None => presets().find(|p| p.aliases.iter().any(|alias| alias == name)),
    }
}

/// Whether a host provides a file of this name for includes.
pub fn is_provided(path: &str) -> bool {
    presets().any(|host| host.files.iter().any(|file| file == path))
}

/// Keeps a host written by a user until the program ends. Equal hosts are kept once.
pub fn kept(host: Preset) -> &'static Preset {
    static KEPT: Mutex<Vec<&'static Preset>> = Mutex::new(Vec::new());
    let mut all = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = all.iter().find(|own| ***own == host) {
        return known;
    }
    let own: &'static Preset = Box::leak(Box::new(host));
    all.push(own);
    own
}

/// The host for ShaderToy's player.
pub fn shadertoy() -> Option<&'static Preset> {
    preset("shadertoy")
}

/// The host for a page that compiles a shader unchanged.
pub fn page() -> Option<&'static Preset> {
    preset("webgl")
}

/// The names and aliases of all presets in alphabetical order.
pub fn names() -> Vec<&'static str> {
    let aliases = presets().flat_map(|p| &p.aliases).map(String::as_str);
    let mut all: Vec<&str> = FILES.iter().map(|(name, _)| *name).chain(aliases).collect();
    all.sort_unstable();
    all
}

/// The preset with a name given by the user.
///
/// # Errors
///
/// For an unknown name, with similar names.
pub fn host_named(name: &str) -> Result<&'static Preset, String> {
    preset(name).ok_or_else(|| {
        let all = names();
        let most = (name.len() / 3).clamp(1, 3);
        let is_near = |n: &&&str| {
            n.starts_with(name) && !name.is_empty() || strsim::damerau_levenshtein(n, name) <= most
        };
        let near: Vec<&str> = all.iter().filter(is_near).copied().collect();
        match near.is_empty() {
            true => format!(
                "unknown host `{name}`; expected one of `{}`",
                all.join("`, `")
            ),
            false => format!(
                "unknown host `{name}`; did you mean `{}`?",
                near.join("` or `")
            ),
        }
    })
}

/// Parses a host file.
///
/// # Errors
///
/// For the first header line with an unknown key or an invalid value, or the first invalid `// =`
/// comment.
pub fn read(text: &str) -> Result<Preset, HeadError> {
    head::read(text, host_named)
}

#[cfg(test)]
mod tests;
