//! Opens passes in separate files: those of a folder, those beside a pass, those that are named.

use super::accept::{reject_other_languages, title};
use super::manifest::{ManifestOrders, manifest_orders};
use super::opened::OpenedProject;
use crate::access::FileAccess;
use crate::dialect::has_directives;
use crate::files::FileType;
use crate::files::family::Family;
use crate::include::gathered::{GatheredText, gather};
use crate::input::parts::saver_roles;
use crate::{ChannelSource, PassFile, PassRole, Project};
use shaderlint_text::path::slashed;
use std::path::{Path, PathBuf};

/// Opens the passes of a project that a file belongs to.
pub(super) fn open_family(
    name: &str,
    text: &str,
    family: &Family,
    access: FileAccess,
) -> Result<OpenedProject, String> {
    let own = Path::new(name);
    let role = family.role(own).unwrap_or(PassRole::Image);
    let has_image = family.file(PassRole::Image).is_some();
    let mut passes = family.passes.clone();
    if !has_image {
        // Common code and the pass that was opened, which is shown.
        passes.retain(|(role, path)| *role == PassRole::Common || path == own);
        for (role, _) in passes.iter_mut().filter(|(_, path)| path == own) {
            *role = PassRole::Image;
        }
    }
    let read = |path: &Path| match path == own {
        true => Ok(text.to_string()),
        false => loaded(path, access),
    };
    let folder = own.parent().unwrap_or(Path::new(""));
    let mut draft = opened(&folder_title(folder, access), &passes, read, access)?;
    match family.is_saver {
        true => draft.project.link_programs(),
        false => draft.follow(manifest_orders(folder, access.files), &passes),
    }
    let others = passes.iter().filter(|(_, path)| path != own);
    let others: Vec<String> = others.map(|(_, path)| file_name(path)).collect();
    if !others.is_empty() {
        draft.project.opened = has_image.then_some(role);
        let (pass, others) = (role.name(), others.join(", "));
        let note = format!("read as the pass `{pass}` with {others} beside it");
        draft.project.notes.push(note);
    }
    draft.read.retain(|path| path != own);
    draft.placed(folder, access)
}

/// Files that are passes.
#[derive(Default)]
pub(super) struct FoundPasses {
    /// The files with their passes.
    pub files: Vec<(PassRole, PathBuf)>,
    /// The name of the folder that they are in.
    pub title: String,
    manifest: ManifestOrders,
    is_saver: bool,
}

/// Finds the passes in files and folders by their names. `named` are files with given passes.
pub(super) fn found_passes(
    paths: &[PathBuf],
    named: &[(PassRole, PathBuf)],
    access: FileAccess,
) -> Result<FoundPasses, String> {
    let is_folder = |path: &Path| access.files.entry(path) == Some(FileType::Folder);
    let mut found = FoundPasses {
        files: named.to_vec(),
        title: match paths {
            [folder] if is_folder(folder) => folder_title(folder, access),
            _ => String::new(),
        },
        ..FoundPasses::default()
    };
    if let Some(programs) = programs(paths, access).filter(|_| named.is_empty()) {
        (found.files, found.is_saver) = (programs, true);
        return Ok(found);
    }
    for path in paths {
        if is_folder(path) {
            found.manifest = manifest_orders(path, access.files);
            found.files.extend(folder_passes(path, access)?);
            continue;
        }
        let role = PassRole::of_name(&title(path)).ok_or_else(|| {
            format!(
                "{}: the file name does not match a pass; rename it, for example to \
                 `image.glsl` or `buffer_a.glsl`, or use `--pass image=FILE`",
                slashed(path)
            )
        })?;
        found.files.push((role, path.clone()));
    }
    Ok(found)
}

/// Opens the passes that were found.
pub(super) fn open_found(found: FoundPasses, access: FileAccess) -> Result<OpenedProject, String> {
    let read = |path: &Path| loaded(path, access);
    let mut draft = opened(&found.title, &found.files, read, access)?;
    match found.is_saver {
        true => draft.project.link_programs(),
        false => draft.follow(found.manifest, &found.files),
    }
    Ok(draft)
}

impl OpenedProject {
    /// Follows what the file of another tool says about these passes.
    fn follow(&mut self, found: ManifestOrders, passes: &[(PassRole, PathBuf)]) {
        let has = |role: PassRole| passes.iter().any(|(own, _)| *own == role);
        self.orders.extend(found.orders.into_iter().filter(|given| {
            let source = match given.order.source {
                ChannelSource::Pass(role) => has(role),
                _ => true,
            };
            source && given.order.pass.is_some_and(has)
        }));
        self.project.notes.extend(found.notes);
        self.read.extend(found.read);
    }
}

fn opened(
    title: &str,
    files: &[(PassRole, PathBuf)],
    read: impl Fn(&Path) -> Result<String, String>,
    access: FileAccess,
) -> Result<OpenedProject, String> {
    let mut parts = Vec::new();
    let common = files.iter().find(|(role, _)| *role == PassRole::Common);
    let common = common.map(|(_, path)| path);
    for (role, path) in files {
        let (file, text) = (slashed(path), read(path)?);
        reject_other_languages(&file, &text)?;
        let common = common.filter(|common| *common != path);
        let text = gather(&file, &text, common.map(PathBuf::as_path), access)
            .ok_or_else(|| format!("{file}: the shader is too large"))?;
        parts.push(PassFile {
            role: *role,
            file,
            text,
        });
    }
    let texts: Vec<GatheredText> = parts.iter().map(|part| part.text.clone()).collect();
    let project = Project::from_parts(title, parts).map_err(|e| e.to_string())?;
    let mut draft = OpenedProject::of(project);
    draft.read = files.iter().map(|(_, path)| path.clone()).collect();
    for text in &texts {
        draft.gathered(text);
    }
    Ok(draft)
}

pub(super) fn loaded(path: &Path, access: FileAccess) -> Result<String, String> {
    let text = access.files.load(path);
    text.map(|text| text.trim_start_matches('\u{feff}').to_string())
        .map_err(|e| format!("{}: {e}", slashed(path)))
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The name of a folder.
fn folder_title(folder: &Path, access: FileAccess) -> String {
    let real = access.files.real(folder);
    file_name(real.as_deref().unwrap_or(folder))
}

/// The passes in a folder.
///
/// # Errors
/// If there are none, or if a symbolic link leaves the folder: the user may not have created a
/// downloaded folder.
pub fn folder_passes(
    folder: &Path,
    access: FileAccess,
) -> Result<Vec<(PassRole, PathBuf)>, String> {
    let passes = access.cache.passes(access.files, folder);
    let mut found = passes.all(|path| access.pass(path).is_some());
    if found.is_empty() {
        let programs = programs(&[folder.to_path_buf()], access);
        return programs.ok_or_else(|| no_pass(folder, passes.others().next(), access));
    }
    let named_there = |path: &Path| loaded(path, access).is_ok_and(|text| has_directives(&text));
    let mut images = found.iter().filter(|(role, _)| *role == PassRole::Image);
    if let Some(image) = images.find(|(_, path)| named_there(path)) {
        return Ok(vec![image.clone()]);
    }
    found.retain(|(role, path)| access.may_be(*role, path));
    let root = access.files.real(folder).unwrap_or_default();
    for (role, path) in &found {
        let real = access.files.real(path);
        if real.is_some_and(|real| !real.starts_with(&root)) {
            let (file, folder, pass) = (slashed(path), slashed(folder), role.name());
            let help = format!("pass it with `--pass {pass}=FILE`");
            return Err(format!("{file} is outside of {folder}; {help}"));
        }
    }
    Ok(found)
}

fn no_pass(folder: &Path, other: Option<&Path>, access: FileAccess) -> String {
    let mut names = access.files.names(folder);
    names.retain(|name| name.ends_with(".json"));
    names.sort();
    let other = other
        .map(Path::to_path_buf)
        .or_else(|| Some(folder.join(names.first()?)));
    let help = other.map_or(String::new(), |path| {
        format!(", or pass a single file, such as {}", slashed(path))
    });
    format!(
        "{}: no pass found; name the files `image.glsl`, `buffer_a.glsl`, `common.glsl`{help}",
        slashed(folder)
    )
}

/// A note about the shaders in a folder that are no passes by their names.
pub(super) fn left_out(folder: &Path, read: &[PathBuf], access: FileAccess) -> Option<String> {
    if access.files.entry(folder) != Some(FileType::Folder) {
        return None;
    }
    let passes = access.cache.passes(access.files, folder);
    let is_left = |path: &&Path| !read.iter().any(|known| known == path);
    let others = passes.others().filter(is_left);
    let others = others.filter(|path| access.pass(path).is_some());
    let others: Vec<String> = others.map(file_name).collect();
    let others = Some(others.join(", ")).filter(|others| !others.is_empty())?;
    Some(format!(
        "not used, since the name matches no pass: {others}"
    ))
}

/// The programs of a screen saver of XScreenSaver: the files themselves, or those of a folder.
fn programs(paths: &[PathBuf], access: FileAccess) -> Option<Vec<(PassRole, PathBuf)>> {
    let mut files = match paths {
        [folder] if access.files.entry(folder) == Some(FileType::Folder) => {
            let passes = access.cache.passes(access.files, folder);
            passes.others().map(Path::to_path_buf).collect()
        }
        files => files.to_vec(),
    };
    files.sort();
    let names: Vec<String> = files.iter().map(|path| title(path)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    Some(saver_roles(&names)?.into_iter().zip(files).collect())
}
