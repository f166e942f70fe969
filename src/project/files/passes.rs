//! The files of a folder that contain the passes of a ShaderToy project.

use super::Files;
use crate::PassRole;
use shaderlint_host::shadertoy;
use std::path::{Path, PathBuf};

/// Maximum number of files in a folder that are examined.
const MAX_FILES: usize = 10_000;

/// The files of a folder that are named like passes.
#[derive(Default, Debug)]
pub struct Passes(Vec<(PassRole, String, PathBuf)>);

impl Passes {
    /// Lists the passes in a folder.
    pub fn inside(files: &dyn Files, folder: &Path) -> Passes {
        let names = files.names(folder).into_iter().take(MAX_FILES);
        let mut found: Vec<_> = names
            .filter_map(|name| {
                let (role, prefix) = role(&name)?;
                Some((role, prefix, folder.join(name)))
            })
            .collect();
        found.sort();
        Passes(found)
    }

    /// The passes of the same project: all passes of the folder or, if it contains several
    /// projects, those with the same prefix. Empty if one of them exists twice.
    pub fn project(&self, prefix: &str) -> Vec<(PassRole, &Path)> {
        let is_one = |all: &[(PassRole, &Path)]| {
            let mut roles: Vec<PassRole> = all.iter().map(|(role, _)| *role).collect();
            roles.sort();
            roles
                .windows(2)
                .all(|pair| !matches!(pair, [a, b] if a == b))
        };
        let files = || self.0.iter();
        let mut prefixes: Vec<&str> = files().map(|(_, p, _)| p.as_str()).collect();
        prefixes.retain(|p| !p.is_empty());
        prefixes.sort_unstable();
        prefixes.dedup();
        let of = |is_in: &dyn Fn(&str) -> bool| {
            let inside = files().filter(|(_, p, _)| is_in(p));
            inside.map(|(r, _, path)| (*r, path.as_path())).collect()
        };
        let all: Vec<_> = of(&|_| true);
        if prefixes.len() < 2 && is_one(&all) {
            return all;
        }
        let alike: Vec<_> = of(&|p| p == prefix);
        if is_one(&alike) { alike } else { Vec::new() }
    }
}

/// The pass that a file name denotes, and the prefix before it.
pub fn role(name: &str) -> Option<(PassRole, String)> {
    let (stem, extension) = name.rsplit_once('.')?;
    let extension = extension.to_ascii_lowercase();
    shadertoy().filter(|host| host.has_extension(&extension))?;
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

    #[test]
    fn several_image_passes_are_not_a_project() {
        let passes = |names: &[&str]| {
            let mut found: Vec<_> = names
                .iter()
                .map(|n| {
                    let (role, prefix) = role(n).unwrap();
                    (role, prefix, PathBuf::from(n))
                })
                .collect();
            found.sort();
            Passes(found)
        };
        let count = |names: &[&str], prefix: &str| passes(names).project(prefix).len();
        assert_eq!(count(&["Image.glsl", "Common.glsl"], ""), 2);
        assert_eq!(
            count(&["a-image.glsl", "common.glsl", "a-buf_a.glsl"], "a"),
            3
        );
        let two = ["a-image.glsl", "b-image.glsl", "a-common.glsl"];
        assert_eq!(count(&two, "a"), 2);
        assert_eq!(count(&two, "b"), 1);
        assert_eq!(count(&["image.glsl", "image.frag", "common.glsl"], ""), 0);
    }
}
