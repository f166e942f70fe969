//! Messages, with the other places of a mistake in words.

use super::place::{clean, list, location_name};
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::{Sources, Span};

/// Maximum number of places in words.
const MAX_PLACES: usize = 8;
/// Longest code that stands for a place, in characters.
const MAX_CODE: usize = 24;

/// The message, with the other places of the mistake.
pub(super) fn full_message(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let message = clean(&diagnostic.message);
    match others(sources, diagnostic) {
        Some(others) => format!("{message} ({others})"),
        None => message,
    }
}

/// The full message, followed by the position in the pass if the file itself has no position for it.
pub(super) fn placed_message(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let message = full_message(sources, diagnostic);
    let file = sources.file_at(diagnostic.span.start);
    match file.and_then(|f| Some((f, f.part.as_ref()?))) {
        Some((file, part)) => {
            let at = file.shown_position(diagnostic.span.start);
            let part = clean(part);
            format!("{message} ({part}, line {}, column {})", at.line, at.column)
        }
        None => message,
    }
}

/// A message followed by the title of the fix or the first help, for formats without a field for it. The
/// general advice of the message itself gives way to the one for this place.
pub(super) fn with_advice(message: String, diagnostic: &Diagnostic) -> String {
    let fix = diagnostic.fix.as_ref().map(|f| &f.title);
    let Some(advice) = fix.or(diagnostic.help.first()) else {
        return message;
    };
    let (what, general) = message.split_once("; use `").unwrap_or((&message, ""));
    let places = general.find(" (also ").and_then(|at| general.get(at..));
    format!("{what}{}; {}", places.unwrap_or(""), clean(advice))
}

/// The other places of a finding: `also in lines 12, 14`, or ``also `b` (line 12), `c` (line 14)``
/// where they have messages of their own.
pub(super) fn others(sources: &Sources, diagnostic: &Diagnostic) -> Option<String> {
    let all = &diagnostic.others;
    if all.is_empty() {
        return None;
    }
    let line = |span: Span| line(sources, span, diagnostic.span);
    let is_same = all.iter().all(|l| l.message == diagnostic.message);
    if !is_same {
        let places = all.iter().map(|l| named(sources, l.span, line(l.span)));
        return Some(format!("also {}", list(places, MAX_PLACES)));
    }
    let own = line(diagnostic.span);
    let mut lines: Vec<String> = all.iter().map(|l| line(l.span)).collect();
    lines.dedup();
    lines.retain(|l| *l != own);
    let noun = match lines.len() {
        0 => return Some("also elsewhere in this line".to_string()),
        1 => "line",
        _ => "lines",
    };
    Some(format!(
        "also in {noun} {}",
        list(lines.into_iter(), MAX_PLACES)
    ))
}

/// The line of a span, with its pass or file if that differs from the one of `beside`.
fn line(sources: &Sources, span: Span, beside: Span) -> String {
    let Some(file) = sources.file_at(span.start) else {
        return String::new();
    };
    let line = file.shown_position(span.start).line;
    match (sources.file_at(beside.start), &file.part) {
        (Some(other), part) if other.path == file.path && other.part == *part => line.to_string(),
        (Some(other), Some(part)) if other.path == file.path => {
            format!("{line} of {}", clean(part))
        }
        _ => format!("{line} of {}", location_name(sources, span)),
    }
}

/// Short code with its line, or the line alone.
fn named(sources: &Sources, span: Span, line: String) -> String {
    let text = sources.text(span);
    match text.chars().count() <= MAX_CODE && !text.contains('\n') {
        true => format!("`{}` (line {line})", clean(text)),
        false => format!("line {line}"),
    }
}
