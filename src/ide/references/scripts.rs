//! The names of a shader in the scripts that use it.

use crate::document::Document;
use shaderlint_detect::embed::{DocumentLanguage, Mention, MentionKind, NameRole, mentions};
use shaderlint_detect::kind::file_extension;
use shaderlint_text::Span;

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

/// Whether a document names a file; in strings, without its extension too.
pub fn names_file(document: &Document, path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let imports = |quote: char| document.text.contains(&format!("/{stem}{quote}"));
    let text = &document.text;
    document.path != path && (text.contains(name) || ['\'', '"', '`'].into_iter().any(imports))
}
