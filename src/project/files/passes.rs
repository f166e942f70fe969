//! The files of a folder that contain the passes of a ShaderToy project.

use super::Files;
use super::manifest::Manifest;
use super::pass_name::{role, shader_stem};
use crate::PassRole;
use std::path::{Path, PathBuf};

/// Maximum number of files in a folder that are examined.
const MAX_FILES: usize = 10_000;

/// Maximum number of files without the name of a pass, of which one may be the Image.
const MAX_OTHERS: usize = 8;

/// The files of a folder that may be passes.
#[derive(Default, Debug)]
pub struct Passes {
    /// Those that are named like passes, with the prefix of their names.
    named: Vec<(PassRole, String, PathBuf)>,
    /// Other shaders, with their names in lower case and without the extension.
    others: Vec<(String, PathBuf)>,
    /// The files of other tools that may name passes.
    pub manifests: Vec<PathBuf>,
}

impl Passes {
    /// Lists the passes in a folder.
    pub fn inside(files: &dyn Files, folder: &Path) -> Passes {
        let mut names = files.names(folder);
        names.truncate(MAX_FILES);
        names.sort();
        let mut found = Passes::default();
        for name in &names {
            let path = folder.join(name);
            match (role(name), shader_stem(name)) {
                (Some((role, prefix)), _) => found.named.push((role, prefix, path)),
                (None, Some(stem)) => found.others.push((stem.to_lowercase(), path)),
                (None, None) => {}
            }
        }
        if !found.others.is_empty() {
            found.follow(Manifest::among(&names, folder, files));
        }
        found.named.sort();
        found
    }

    /// Takes the passes without the name of one from the first file of another tool that connects
    /// passes, where no file has the name.
    fn follow(&mut self, manifests: Vec<Manifest>) {
        self.manifests = manifests.iter().map(|m| m.path.clone()).collect();
        let first = manifests.into_iter().find(|m| !m.channels.is_empty());
        for (role, path) in first.into_iter().flat_map(|m| m.passes) {
            let mut named = self.named.iter();
            if !named.any(|(known, _, own)| *known == role || *own == path) {
                self.others.retain(|(_, own)| *own != path);
                self.named.push((role, String::new(), path));
            }
        }
    }

    /// The passes of the same project: all passes of the folder or, if it contains several
    /// projects, those with the same prefix. Empty if one of them exists twice. An Image without
    /// the name of a pass has the prefix as its name, or is the only other file of which
    /// `is_image` says that it has an entry point.
    pub fn project(
        &self,
        prefix: &str,
        is_image: impl Fn(&Path) -> bool,
    ) -> Vec<(PassRole, PathBuf)> {
        let mut prefixes: Vec<&str> = self.named.iter().map(|(_, p, _)| p.as_str()).collect();
        prefixes.retain(|p| !p.is_empty());
        prefixes.sort_unstable();
        prefixes.dedup();
        let of = |is_in: &dyn Fn(&str) -> bool| -> Vec<(PassRole, PathBuf)> {
            let inside = self.named.iter().filter(|(_, p, _)| is_in(p));
            inside.map(|(r, _, path)| (*r, path.clone())).collect()
        };
        let is_once = |all: &[(PassRole, PathBuf)]| {
            all.windows(2)
                .all(|pair| !matches!(pair, [a, b] if a.0 == b.0))
        };
        let mut found = of(&|_| prefixes.len() < 2);
        if found.is_empty() || !is_once(&found) {
            found = of(&|p| p == prefix);
        }
        if found.is_empty() || !is_once(&found) {
            return Vec::new();
        }
        if found.iter().all(|(role, _)| *role != PassRole::Image) {
            let prefix = prefixes.first().filter(|_| prefixes.len() == 1);
            let image = self.unnamed_image(prefix.copied().unwrap_or(""), is_image);
            found.extend(image.map(|path| (PassRole::Image, path.to_path_buf())));
            found.sort();
        }
        found
    }

    /// All passes of the folder, even if several have the same role.
    pub fn all(&self, is_image: impl Fn(&Path) -> bool) -> Vec<(PassRole, PathBuf)> {
        let named = self.named.iter();
        let mut found: Vec<_> = named.map(|(r, _, path)| (*r, path.clone())).collect();
        let has_image = found.iter().any(|(role, _)| *role == PassRole::Image);
        if let (false, Some((_, prefix, _))) = (has_image, self.named.first()) {
            let image = self.unnamed_image(prefix, is_image);
            found.extend(image.map(|path| (PassRole::Image, path.to_path_buf())));
        }
        found.sort();
        found
    }

    /// The Image of a project whose file does not have the name of a pass.
    fn unnamed_image(&self, prefix: &str, is_image: impl Fn(&Path) -> bool) -> Option<&Path> {
        let named = self.others.iter().find(|(stem, _)| stem == prefix);
        if let Some((_, path)) = named {
            return Some(path);
        }
        let others = || self.others.iter().map(|(_, path)| path.as_path());
        let mut images = others().filter(|path| is_image(path));
        let first = images.next().filter(|_| self.others.len() <= MAX_OTHERS)?;
        images.next().is_none().then_some(first)
    }

    /// The shaders that are not named like passes.
    pub fn others(&self) -> impl Iterator<Item = &Path> {
        self.others.iter().map(|(_, path)| path.as_path())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::sync::Arc;

    #[test]
    fn several_image_passes_are_not_a_project() {
        let count = |names: &[&str], prefix: &str| {
            let files = names
                .iter()
                .map(|name| (PathBuf::from(format!("/{name}")), "".into()));
            let files: BTreeMap<PathBuf, Arc<str>> = files.collect();
            let passes = Passes::inside(&files, Path::new("/"));
            passes
                .project(prefix, |path| path.ends_with("main.glsl"))
                .len()
        };
        assert_eq!(count(&["Image.glsl", "Common.glsl"], ""), 2);
        assert_eq!(
            count(&["a-image.glsl", "common.glsl", "a-buf_a.glsl"], "a"),
            3
        );
        let two = ["a-image.glsl", "b-image.glsl", "a-common.glsl"];
        assert_eq!(count(&two, "a"), 2);
        assert_eq!(count(&two, "b"), 1);
        assert_eq!(count(&["image.glsl", "image.frag", "common.glsl"], ""), 0);
        assert_eq!(
            count(&["sea.frag", "sea_bufferA.frag", "lake.frag"], "sea"),
            2
        );
        assert_eq!(count(&["main.glsl", "bufA.glsl", "lib.glsl"], ""), 2);
        assert_eq!(count(&["bufA.glsl", "lib.glsl"], ""), 1);
    }
}
