//! White space before the `#version` of a shader: scripts may trim the text before they compile it.

use crate::check_context::CheckContext;
use shaderlint_detect::embed::{DocumentLanguage, Embedder, LeadingBlanks};
use shaderlint_project::{FileType, imports, module_files};
use shaderlint_text::path::plain;
use std::collections::{BTreeSet, VecDeque};
use std::path::{Path, PathBuf};

/// Maximum number of scripts of a page that are read.
const MAX_SCRIPTS: usize = 16;

/// What a page or script does with white space before its shaders, according to itself or to
/// scripts that it loads, which may import others.
pub fn leading_blanks(
    name: &str,
    text: &str,
    own: Embedder,
    context: CheckContext,
) -> LeadingBlanks {
    if own.leading_blanks != LeadingBlanks::Unknown {
        return own.leading_blanks;
    }
    let file = plain(&context.files.here().join(name));
    let folder = file.parent().unwrap_or(Path::new(""));
    let own_scripts = sources(text).into_iter().chain(imports(text));
    let inside = |path: &&str| !path.contains("://");
    let own_scripts = own_scripts.filter(inside);
    let mut open: VecDeque<PathBuf> = own_scripts
        .map(|path| plain(&folder.join(path.trim_start_matches('/'))))
        .collect();
    let is_file = |path: &PathBuf| context.files.entry(path) == Some(FileType::File);
    let mut seen = BTreeSet::new();
    let mut all = Vec::new();
    while let Some(path) = open.pop_front().filter(|_| seen.len() < MAX_SCRIPTS) {
        let path = module_files(&path).into_iter().find(is_file);
        let Some(path) = path.filter(|path| seen.insert(path.clone())) else {
            continue;
        };
        let Ok(script) = context.files.load(&path) else {
            continue;
        };
        all.push(Embedder::of(DocumentLanguage::Script, &script).leading_blanks);
        let beside = imports(&script).into_iter().filter(|p| p.starts_with('.'));
        let folder = path.parent().unwrap_or(Path::new(""));
        open.extend(beside.map(|import| plain(&folder.join(import))));
    }
    // Helper scripts read the shader, others compile it.
    match (
        all.contains(&LeadingBlanks::Trimmed),
        all.contains(&LeadingBlanks::Kept),
    ) {
        (true, _) => LeadingBlanks::Trimmed,
        (false, true) => LeadingBlanks::Kept,
        (false, false) => LeadingBlanks::Unknown,
    }
}

/// The scripts that a page loads.
fn sources(page: &str) -> Vec<&str> {
    let attributes = page.match_indices("src=").filter_map(|(at, word)| {
        let value = page.get(at + word.len()..)?;
        let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''))?;
        value.get(1..)?.split(quote).next()
    });
    attributes
        .filter(|path| path.ends_with("js") || path.ends_with("ts"))
        .collect()
}
