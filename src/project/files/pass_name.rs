//! Which passes of ShaderToy the names of files denote.

use crate::PassRole;
use shaderlint_host::shadertoy;

/// Whether a file has an extension of passes.
pub fn is_shader(name: &str) -> bool {
    shader_stem(name).is_some()
}

/// The name of a shader file without its extension.
pub fn shader_stem(name: &str) -> Option<&str> {
    let (stem, extension) = name.rsplit_once('.')?;
    let extension = extension.to_ascii_lowercase();
    shadertoy().filter(|host| host.has_extension(&extension))?;
    Some(stem)
}

/// The pass that a file name denotes, and the prefix before it.
pub fn role(name: &str) -> Option<(PassRole, String)> {
    let stem = shader_stem(name)?;
    let role = PassRole::of_name(stem)?;
    let mut starts = stem.char_indices().map(|(at, _)| at).rev();
    let after = |at: &usize| PassRole::of_name(stem.get(*at..).unwrap_or("")) == Some(role);
    let prefix = stem.get(..starts.find(after)?)?;
    let prefix = prefix.trim_end_matches(|c: char| !c.is_alphanumeric());
    Some((role, prefix.to_lowercase()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_names_identify_passes_and_projects() {
        let shown = |name: &str| role(name).map(|(r, p)| (r.name(), p));
        let some = |role, prefix: &str| Some((role, prefix.to_string()));
        assert_eq!(shown("Common.glsl"), some("common", ""));
        assert_eq!(shown("BufferA.frag"), some("buffer_a", ""));
        assert_eq!(shown("Ocean-Image.GLSL"), some("image", "ocean"));
        assert_eq!(shown("ocean.buf_b.glsl"), some("buffer_b", "ocean"));
        assert_eq!(shown("noise.glsl"), None);
        assert_eq!(shown("image.png"), None);
    }
}
