//! Positions of findings, and text that is safe to show in a terminal.

use shaderlint_text::markup::escape;
use shaderlint_text::{Position, Sources, Span};

/// The start and end of a span in its file; `None` for a pass of an export, because its code is
/// escaped in the file.
pub(super) fn region(sources: &Sources, span: Span) -> Option<(Position, Position)> {
    let file = sources.file_at(span.start).filter(|f| f.part.is_none())?;
    Some((
        file.shown_position(span.start),
        file.shown_position(span.end),
    ))
}

/// The path of the file that contains a span, relative to `root` if it is inside of it.
pub(super) fn path<'a>(sources: &'a Sources, span: Span, root: &str) -> &'a str {
    let path = sources
        .file_at(span.start)
        .map_or("", |f| f.shown_path(span.start));
    path.strip_prefix(root).unwrap_or(path)
}

/// The path of the file that contains a span, with the pass if the file has several.
pub(super) fn location_name(sources: &Sources, span: Span) -> String {
    match sources.file_at(span.start) {
        Some(file) => match &file.part {
            Some(part) => format!("{} ({})", clean(&file.path), clean(part)),
            None => clean(file.shown_path(span.start)),
        },
        None => String::new(),
    }
}

/// `a, b, 3 more`: at most `max` of some names or places.
pub(super) fn list(names: impl ExactSizeIterator<Item = String>, max: usize) -> String {
    let more = names.len().saturating_sub(max);
    let mut listed: Vec<String> = names.take(max).collect();
    if more > 0 {
        listed.push(format!("{more} more"));
    }
    listed.join(", ")
}

/// Replaces control characters, invisible characters and bidirectional overrides, with which a
/// terminal could show other text. Replacements keep the length in bytes.
pub(super) fn clean(text: &str) -> String {
    text.chars().map(clean_char).collect()
}

/// A text for an element or an attribute of XML, in which line breaks must be spelled out.
pub(super) fn xml(text: &str) -> String {
    let lines: Vec<String> = text.split('\n').map(clean).collect();
    escape(&lines.join("\n")).replace('\n', "&#10;")
}

pub(super) fn clean_char(c: char) -> char {
    match c {
        '\t' => c,
        // Three bytes each in UTF-8, as U+FFFD.
        '\u{200b}'..='\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{2069}'
        | '\u{feff}' => '\u{fffd}',
        // Two bytes each, as U+00A4.
        '\u{ad}' => '\u{a4}',
        c if c.is_control() && c.len_utf8() == 1 => '?',
        c if c.is_control() => '\u{a4}',
        c => c,
    }
}
