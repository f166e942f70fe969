//! ShaderToy passes in separate files: the Common file of a folder is included before the others.

use crate::PassRole;
use crate::access::FileAccess;
use crate::files::passes::{Passes, role};
use shaderlint_semantic::{GuessedKind, Pass, guess};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Size limit in bytes of passes that are read to detect what they are.
const MAX_PASS: usize = 1024 * 1024;
/// The Common file that is included before a pass, if there is one.
pub fn common_of(name: &str, text: &str, context: FileAccess) -> Option<PathBuf> {
    let Some((role, prefix)) = role(file_name(name)) else {
        return common_of_saver(name, text, context);
    };
    if role == PassRole::Common || !context.may_be_passes || !is_pass(text) {
        return None;
    }
    let passes = sibling_passes(name, context)?;
    let project = passes.project(&prefix);
    let is_here = project.iter().any(|(r, _)| *r == role);
    let mut common = project.iter().filter(|(r, _)| *r == PassRole::Common);
    let (_, path) = common.next().filter(|_| is_here)?;
    Some(path.to_path_buf())
}

/// The common code of a screen saver of XScreenSaver: `NAME-c.glsl` for `NAME.glsl`, `NAME-0.glsl`
/// and so on.
fn common_of_saver(name: &str, text: &str, context: FileAccess) -> Option<PathBuf> {
    let (path, extension) = name.rsplit_once('.')?;
    let saver = match path.rsplit_once('-') {
        Some((saver, "0" | "1" | "2" | "3" | "4")) => saver,
        _ => path,
    };
    let common = PathBuf::from(format!("{saver}-c.{extension}"));
    if !context.may_be_passes || !is_pass(text) {
        return None;
    }
    context.files.entry(&common)?;
    let code = context.files.load(&common).ok()?;
    (code.len() <= MAX_PASS && !is_pass(&code)).then_some(common)
}

/// Whether a file is the common code of a screen saver.
fn is_common_of_saver(name: &str, context: FileAccess) -> bool {
    let split = name.rsplit_once('.');
    let Some((saver, extension)) = split.and_then(|(p, e)| Some((p.strip_suffix("-c")?, e))) else {
        return false;
    };
    let mut programs = ["", "-0", "-1", "-2", "-3", "-4"].iter();
    programs.any(|end| {
        let program = format!("{saver}{end}.{extension}");
        let path = Path::new(&program);
        let text = context
            .files
            .entry(path)
            .and_then(|_| context.files.load(path).ok());
        text.is_some_and(|text| text.len() <= MAX_PASS && is_pass(&text))
    })
}

/// Whether a file is the Common file of the passes in its folder.
pub fn is_common(name: &str, text: &str, context: FileAccess) -> bool {
    if !context.may_be_passes || text.contains("#version") {
        return false;
    }
    let Some((PassRole::Common, prefix)) = role(file_name(name)) else {
        return is_common_of_saver(name, context) && !is_pass(text);
    };
    let Some(passes) = sibling_passes(name, context) else {
        return false;
    };
    let project = passes.project(&prefix);
    let mut others = project.iter().filter(|(r, _)| *r != PassRole::Common);
    others.any(|(_, path)| {
        let text = context.files.load(path);
        text.is_ok_and(|text| text.len() <= MAX_PASS && is_pass(&text))
    })
}

/// The ShaderToy passes in the folder of a file.
fn sibling_passes(name: &str, context: FileAccess) -> Option<Arc<Passes>> {
    let folder = Path::new(name).parent()?;
    Some(context.cache.passes(context.files, folder))
}

fn is_pass(text: &str) -> bool {
    let kind = guess(text).kind;
    matches!(kind, Some(GuessedKind::ShaderToy(pass)) if pass != Pass::Common)
}

fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}
