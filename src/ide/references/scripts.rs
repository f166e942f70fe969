//! The names of a shader in the scripts that use it.

use crate::document::Document;
use shaderlint_detect::embed::{DocumentLanguage, Mention, MentionKind, NameRole, mentions};
use shaderlint_detect::kind::file_extension;
use shaderlint_text::Span;
use shaderlint_text::path::{slashed, tidy};
use std::path::Path;

/// The places where the scripts of a document refer to a name.
pub fn in_scripts(document: &Document, name: &str, role: NameRole) -> Vec<(Span, MentionKind)> {
    let extension = file_extension(&document.path);
    let Some(language) = DocumentLanguage::of_extension(&extension) else {
        return Vec::new();
    };
    let all = mentions(language, &document.text, name, role).into_iter();
    // The shaders of the document are read as shaders.
    let is_script = |m: &Mention| document.spot(m.range.start as u32).is_none();
    let spans = all.filter(is_script).map(|mention| {
        let span = Span::new(mention.range.start as u32, mention.range.end as u32);
        (span, mention.kind)
    });
    spans.collect()
}

/// Whether a document names a file; in strings, without its extension too. A path that starts with a dot is
/// relative to the document.
pub fn names_file(document: &Document, path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let (text, quotes) = (&*document.text, ['\'', '"', '`']);
    let folder = Path::new(&document.path).parent().unwrap_or(Path::new(""));
    let is_it = |(at, found): (usize, &str)| {
        let before = text.get(..at).unwrap_or("");
        let start = before.rfind(|c| c == '\n' || quotes.contains(&c));
        let before = before
            .get(start.map_or(0, |start| start + 1)..)
            .unwrap_or("");
        let after = text.get(at + found.len()..).unwrap_or("");
        let ends = after.starts_with(quotes) || after.starts_with('?');
        if !before.starts_with('.') || !ends {
            return found == name || before.ends_with('/') && after.starts_with(quotes);
        }
        let meant = slashed(tidy(&folder.join(format!("{before}{found}"))));
        path.strip_prefix(&meant)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    document.path != path
        && (text.match_indices(name).any(is_it) || text.match_indices(stem).any(is_it))
}
