//! Opens a file: a shader, an export, or a script or page that holds one shader.

use super::accept::{held, reject_other_languages, title};
use super::opened::{OpenedProject, SingleShader};
use super::passes::open_family;
use crate::access::FileAccess;
use crate::dialect::{imported_hosts, installed_hosts, is_player};
use crate::files::family::family;
use crate::include::gathered::{GatheredText, gather};
use crate::{Project, ShaderError, SiblingTexts};
use shaderlint_host::Preset;
use shaderlint_semantic::{GuessedKind, guess};
use shaderlint_text::path::tidy;
use std::cell::OnceCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The largest number of companion files.
const MAX_TEXTS: usize = 256;

/// Opens a file with this name and text. `host` is the one that the user gives.
///
/// # Errors
/// A message if it is not a shader that can be run.
pub fn open_file(
    name: &str,
    text: &str,
    host: Option<&'static Preset>,
    access: FileAccess,
) -> Result<OpenedProject, String> {
    let wrong = |e: String| format!("{name}: {e}");
    if host.is_none() {
        reject_other_languages(name, text)?;
    }
    let start = text.trim_start();
    if start.starts_with(['{', '[']) {
        let project = Project::from_json(text).map_err(|e| wrong(e.to_string()))?;
        return OpenedProject::of(project).placed(Path::new(name), access);
    }
    let held = held(name, text).map_err(wrong)?;
    let is_description = held.is_none() && start.starts_with('<');
    if is_description && !text.contains("<klxml") {
        return Err(wrong("expected a shader, found HTML or XML".to_string()));
    }
    let script = held.as_ref().map_or("", |_| text);
    let own = held.as_ref().map_or(text, |held| &held.code);
    let unversioned = without_version(own);
    let own = unversioned.as_deref().unwrap_or(own);
    let text = match is_description {
        true => GatheredText::of(own),
        false => gather(name, own, None, access)
            .ok_or_else(|| wrong(ShaderError::TooLarge.to_string()))?,
    };
    // What it includes may bring a `main` for another host.
    let host = host.or(access.host);
    if unversioned.is_none()
        && host.is_none_or(is_player)
        && let Some(family) = family(name, &text.text, access)
    {
        return open_family(name, own, &family, access);
    }
    let text = match &held {
        Some(held) => text.from_line(held.line),
        None => text,
    };
    let mut single = SingleShader {
        text,
        title: match name {
            "-" => String::new(),
            name => title(Path::new(name)),
        },
        host,
        around: Vec::new(),
        siblings: SiblingTexts::new(),
    };
    let known = OnceCell::new();
    let around = || {
        let found = known.get_or_init(|| hosts_around(name, script, access));
        found.clone()
    };
    loop {
        let drafted = Project::draft_with_siblings(
            &single.title,
            &single.text,
            (single.host, &around),
            &single.siblings,
        );
        let project = drafted.map_err(|e| wrong(e.to_string()))?;
        if !read_siblings(name, &project.requested, &mut single.siblings, access).map_err(wrong)? {
            single.around = known.into_inner().unwrap_or_default();
            let mut draft = drafted_alone(name, project, single, access)?;
            draft.project.notes.extend(held.and_then(|held| held.note));
            return Ok(draft);
        }
    }
}

/// The hosts of the program around a text: those that the script imports, then those of the project.
fn hosts_around(name: &str, script: &str, access: FileAccess) -> Vec<&'static Preset> {
    let imported = imported_hosts(script);
    let is_new = |host: &&Preset| !imported.iter().any(|known| known.name == host.name);
    let installed = installed_hosts(name, access).into_iter().filter(is_new);
    let installed: Vec<_> = installed.collect();
    [imported, installed].concat()
}

fn drafted_alone(
    name: &str,
    project: Project,
    single: SingleShader,
    access: FileAccess,
) -> Result<OpenedProject, String> {
    let mut draft = OpenedProject::of(project);
    draft.gathered(&single.text);
    for text in single.siblings.values().flatten() {
        draft.gathered(text);
    }
    draft.single = Some(single);
    match name {
        "-" => Ok(draft),
        name => draft.placed(Path::new(name), access),
    }
}

/// A pass of ShaderToy that starts with a `#version`, without it: the player writes its own.
fn without_version(text: &str) -> Option<String> {
    let without = text.replacen("#version", "//#version", 1);
    let is_pass = |text: &str| matches!(guess(text).kind, Some(GuessedKind::ShaderToy(_)));
    (without != text && !is_pass(text) && is_pass(&without)).then_some(without)
}

/// Reads the companion files that a text asks for and that have not been read. Paths are relative
/// to the text or, if there is no such file, to the project. Returns whether there were any.
///
/// # Errors
/// If there are too many, or one is outside of the project.
pub fn read_siblings(
    name: &str,
    requested: &[String],
    texts: &mut SiblingTexts,
    access: FileAccess,
) -> Result<bool, String> {
    let known = texts.len();
    let folder = Path::new(name).parent().unwrap_or(Path::new(""));
    for asked in requested {
        if texts.contains_key(asked) {
            continue;
        }
        if texts.len() >= MAX_TEXTS {
            return Err(format!("the shader includes more than {MAX_TEXTS} files"));
        }
        let beside = tidy(&folder.join(asked));
        let tops = access
            .includes
            .tops
            .iter()
            .map(|top| access.relative(&top.join(asked)));
        let mut paths = std::iter::once(beside).chain(tops);
        let path = paths.find(|path| access.files.entry(path).is_some());
        let text = match path.map(|path| access.load(&path)) {
            Some(Ok(found)) => gather(&found.name, &found.file.text, None, access)
                .map(|text| Arc::new(of_file(text, &found.name))),
            Some(Err(crate::Absence::Outside)) => {
                return Err(format!("`{asked}` is outside of the project"));
            }
            _ => None,
        };
        texts.insert(asked.clone(), text);
    }
    Ok(texts.len() > known)
}

/// A text of another file than the shader's own.
fn of_file(text: GatheredText, name: &str) -> GatheredText {
    let mut text = text.from_line(1);
    for piece in text.pieces.iter_mut().filter(|piece| piece.file.is_empty()) {
        piece.file = name.to_string();
    }
    text.read.push(PathBuf::from(name));
    text
}
