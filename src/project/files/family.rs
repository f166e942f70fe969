//! ShaderToy passes in separate files: which files of a folder form a project.

use super::FileType;
use super::pass_name::role;
use crate::PassRole;
use crate::access::FileAccess;
use crate::dialect::has_directives;
use crate::input::parts::saver_roles;
use shaderlint_semantic::{GuessedKind, Pass, guess};
use std::path::{Path, PathBuf};

/// Size limit in bytes of files that are read to detect what they are.
const MAX_PASS: usize = 1024 * 1024;

/// The files of a project.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Family {
    /// The files with their passes, in the order of the roles.
    pub passes: Vec<(PassRole, PathBuf)>,
    /// Whether they are the programs of a screen saver of XScreenSaver.
    pub is_saver: bool,
}

impl Family {
    /// The file of a role.
    pub fn file(&self, role: PassRole) -> Option<&Path> {
        let found = self.passes.iter().find(|(own, _)| *own == role);
        found.map(|(_, path)| path.as_path())
    }

    /// The role of a file.
    pub fn role(&self, path: &Path) -> Option<PassRole> {
        let found = self.passes.iter().find(|(_, own)| own == path);
        found.map(|(role, _)| *role)
    }
}

/// The project that a shader file belongs to; `None` if it is alone.
pub fn family(name: &str, text: &str, access: FileAccess) -> Option<Family> {
    let path = Path::new(name);
    if !access.may_be_passes || text.contains("#version") || has_directives(text) {
        return None;
    }
    let is_own_pass = pass_of(text).is_some();
    if let Some(saver) = saver(path, is_own_pass, access) {
        return Some(saver);
    }
    let own = role(&path.file_name()?.to_string_lossy());
    let may_be_common = matches!(own, Some((PassRole::Common, _)));
    if !is_own_pass && !may_be_common {
        return None;
    }
    let passes = access.cache.passes(access.files, path.parent()?);
    let stem = path.file_stem()?.to_string_lossy().to_lowercase();
    let prefix = own.map_or(stem, |(_, prefix)| prefix);
    let is_image = |path: &Path| access.pass(path).is_some();
    let mut passes = passes.project(&prefix, is_image);
    passes.retain(|(role, path)| access.may_be(*role, path));
    let family = Family {
        passes,
        is_saver: false,
    };
    let own = family.role(path)?;
    let is_in_use = |(role, path): &(PassRole, PathBuf)| {
        *role != own && (own != PassRole::Common || is_image(path))
    };
    family.passes.iter().any(is_in_use).then_some(family)
}

/// The programs of a screen saver of XScreenSaver: `NAME-0.glsl` to `NAME-4.glsl`, or `NAME.glsl`,
/// with common code in `NAME-c.glsl`.
fn saver(path: &Path, is_own_pass: bool, access: FileAccess) -> Option<Family> {
    let stem = path.file_stem()?.to_str()?;
    let extension = path.extension()?.to_str()?;
    let saver = match stem.rsplit_once('-') {
        Some((saver, "c" | "0" | "1" | "2" | "3" | "4")) => saver,
        _ => stem,
    };
    let parts = ["0", "1", "2", "3", "4", "c"];
    let files = parts.map(|part| path.with_file_name(format!("{saver}-{part}.{extension}")));
    let common = files.last()?.clone();
    let exists = |path: &PathBuf| access.files.entry(path) == Some(FileType::File);
    let is_here = path == common && !is_own_pass || path != common && is_own_pass;
    if !is_here || !exists(&common) || access.pass(&common).is_some() {
        return None;
    }
    let mut files: Vec<PathBuf> = files.into_iter().filter(exists).collect();
    let stems = files.iter().filter_map(|path| path.file_stem()?.to_str());
    let roles = saver_roles(&stems.collect::<Vec<_>>());
    let roles = roles.filter(|_| files.iter().any(|file| file == path));
    let is_saver = roles.is_some();
    let roles = roles.unwrap_or_else(|| vec![PassRole::Image, PassRole::Common]);
    if !is_saver {
        let program = match path == common {
            true => path.with_file_name(format!("{saver}.{extension}")),
            false => path.to_path_buf(),
        };
        files = vec![program, common];
    }
    let mut passes: Vec<_> = roles.into_iter().zip(files).collect();
    passes.sort();
    let family = Family { passes, is_saver };
    let program = family.file(PassRole::Image)?;
    let has_program = is_own_pass || access.pass(program).is_some();
    (family.role(path).is_some() && has_program).then_some(family)
}

/// The Common file that is included before a pass, if there is one.
pub fn common_of(name: &str, text: &str, access: FileAccess) -> Option<PathBuf> {
    let family = family(name, text, access)?;
    let common = family.file(PassRole::Common)?;
    (common != Path::new(name)).then(|| common.to_path_buf())
}

/// Whether a file is the Common file of passes in its folder.
pub fn is_common(name: &str, text: &str, access: FileAccess) -> bool {
    let family = family(name, text, access);
    family.is_some_and(|family| family.role(Path::new(name)) == Some(PassRole::Common))
}

impl FileAccess<'_> {
    /// Whether a file may be a pass: a name alone does not make a cube map or a sound.
    pub fn may_be(&self, role: PassRole, path: &Path) -> bool {
        let needs_entry = matches!(role.kind(), Pass::Cubemap | Pass::Sound);
        !needs_entry || self.pass(path) == Some(role.kind())
    }

    /// The pass that a file has the entry point of.
    pub fn pass(&self, path: &Path) -> Option<Pass> {
        let text = self.files.load(path).ok();
        text.filter(|text| text.len() <= MAX_PASS)
            .and_then(|text| pass_of(&text))
    }
}

fn pass_of(text: &str) -> Option<Pass> {
    match guess(text).kind {
        Some(GuessedKind::ShaderToy(pass)) => Some(pass).filter(|pass| *pass != Pass::Common),
        _ => None,
    }
}
