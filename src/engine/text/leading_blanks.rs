//! White space before the `#version` of a shader: scripts may trim the text before they compile it.

use crate::check_context::CheckContext;
use shaderlint_detect::embed::{DocumentLanguage, Embedder, LeadingBlanks};
use shaderlint_project::imports;
use shaderlint_text::path::plain;
use std::path::Path;

/// Maximum number of scripts of a page that are read.
const MAX_SCRIPTS: usize = 16;

/// What a page or script does with white space before its shaders, according to itself or to a
/// script that it loads.
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
    let relative = own_scripts.filter(|path| !path.contains("://"));
    let found = relative.take(MAX_SCRIPTS).filter_map(|path| {
        let path = plain(&folder.join(path.trim_start_matches('/')));
        let script = context.files.load(&path).ok()?;
        Some(Embedder::of(DocumentLanguage::Script, &script).leading_blanks)
    });
    // Helper scripts read the shader, others compile it.
    let all: Vec<LeadingBlanks> = found.collect();
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
    attributes.filter(|path| path.ends_with("js")).collect()
}
