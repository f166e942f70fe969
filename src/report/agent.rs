//! A compact format for programs that read text: one line per finding, including its fix, labels
//! and notes.
//!
//! `path:line:column: severity rule: message; replace ... with ... at 5:3,9 6:1; 5:3: label; note`
//!
//! Places on the same line share its number. Labels and notes are printed for findings without a
//! fix only, and each note once per run.

use super::others::full_message;
use super::place::{clean, location_name};
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix};
use shaderlint_text::{Edit, Sources, Span};
use std::collections::HashSet;
use std::io::{self, Write};

/// Longest replaced code that is quoted next to its position, in characters.
const MAX_OLD: usize = 24;
/// Longest replacement that is quoted in full each time, in characters.
const MAX_NEW: usize = 60;

/// The texts printed so far. A note that many findings share is printed once.
#[derive(Default)]
pub struct SeenNotes(HashSet<String>);

impl SeenNotes {
    /// Whether a text was not printed before.
    fn is_new(&mut self, text: &str) -> bool {
        self.0.insert(text.to_string())
    }
}

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    diagnostic: &Diagnostic,
    notes: &mut SeenNotes,
) -> io::Result<()> {
    let span = diagnostic.span;
    write!(
        out,
        "{}:{}: {} {}: {}",
        location_name(sources, span),
        place(sources, span.start),
        diagnostic.severity.name(),
        diagnostic.rule,
        full_message(sources, diagnostic)
    )?;
    if let Some(fix) = &diagnostic.fix {
        write!(out, "; {}", fix_in_words(sources, fix, span, notes))?;
    }
    for used in &diagnostic.macros {
        write!(out, "; in macro `{}`", clean(&used.name))?;
    }
    // A fix says what to do and where; the documentation of the rule says why.
    if diagnostic.fix.is_some() {
        return out.write_all(b"\n");
    }
    if !diagnostic.message.contains(&diagnostic.label) {
        write!(out, "; {}", clean(&diagnostic.label))?;
    }
    for (message, places) in labels(sources, diagnostic) {
        write!(out, "; {}: {message}", joined(&places))?;
    }
    for note in diagnostic.notes.iter().chain(&diagnostic.help) {
        if notes.is_new(note) {
            write!(out, "; {}", clean(note))?;
        }
    }
    out.write_all(b"\n")
}

/// The secondary labels of a finding, grouped by message.
fn labels(sources: &Sources, diagnostic: &Diagnostic) -> Vec<(String, Vec<String>)> {
    let mut all: Vec<(String, Vec<String>)> = Vec::new();
    for label in &diagnostic.labels {
        let message = clean(&label.message);
        let at = other_place(sources, label.span.start, diagnostic.span);
        match all.last_mut().filter(|(last, _)| *last == message) {
            Some((_, places)) => places.push(at),
            None => all.push((message, vec![at])),
        }
    }
    all
}

/// `line:column`
fn place(sources: &Sources, at: u32) -> String {
    let position = sources.file_at(at).map(|f| f.shown_position(at));
    position.map_or("1:1".to_string(), |p| format!("{}:{}", p.line, p.column))
}

/// A position, with its file if that differs from the file of `beside`.
fn other_place(sources: &Sources, at: u32, beside: Span) -> String {
    let here = location_name(sources, beside);
    let there = location_name(sources, Span::at(at));
    let place = place(sources, at);
    match here == there {
        true => place,
        false => format!("{there}:{place}"),
    }
}

/// Positions in one text; positions on the same line share its number.
fn joined(places: &[String]) -> String {
    let mut text = String::new();
    let mut last = "";
    for place in places {
        let (line, column) = place.rsplit_once(':').unwrap_or(("", place));
        match text.is_empty() {
            true => text.push_str(place),
            false if line == last => text.push_str(&format!(",{column}")),
            false => text.push_str(&format!(" {place}")),
        }
        last = line;
    }
    text
}

/// The edits of a fix: ``replace `1` with `1.0` at 5:3, 6:7``.
fn fix_in_words(sources: &Sources, fix: &Fix, at: Span, notes: &mut SeenNotes) -> String {
    // The same edit in several places is printed once.
    let mut all: Vec<(String, Vec<String>)> = Vec::new();
    for edit in &fix.edits {
        let what = edit_in_words(sources, edit, notes);
        let from = other_place(sources, edit.span.start, at);
        let place = match is_short(sources, edit) {
            true => from,
            false => match complete_lines(sources, edit) {
                Some((first, last)) if first == last => format!("line {first}"),
                Some((first, last)) => format!("lines {first}-{last}"),
                None => format!("{from}-{}", place(sources, edit.span.end)),
            },
        };
        match all.iter_mut().find(|(known, _)| *known == what) {
            Some((_, places)) => places.push(place),
            None => all.push((what, vec![place])),
        }
    }
    let own = other_place(sources, at.start, at);
    let all: Vec<String> = all
        .into_iter()
        .map(|(what, places)| match places.as_slice() {
            [one] if *one == own => what,
            places if what == "delete" => format!("{what} {}", joined(places)),
            places => format!("{what} at {}", joined(places)),
        })
        .collect();
    let grade = match fix.applicability {
        Applicability::Safe => "",
        Applicability::Unsafe => "unsafe ",
    };
    format!("{grade}{}", all.join(", "))
}

/// The first and last line that an edit deletes, if it deletes whole lines and nothing else.
fn complete_lines(sources: &Sources, edit: &Edit) -> Option<(u32, u32)> {
    let file = sources.file_at(edit.span.start)?;
    let (start, end) = (
        file.shown_position(edit.span.start),
        file.shown_position(edit.span.end),
    );
    let is_complete = start.column == 1 && end.column == 1 && end.line > start.line;
    (is_complete && edit.text.is_empty()).then_some((start.line, end.line - 1))
}

/// Whether the replaced code is short enough to be quoted.
fn is_short(sources: &Sources, edit: &Edit) -> bool {
    let old = sources.text(edit.span);
    old.chars().count() <= MAX_OLD && !old.contains('\n')
}

fn edit_in_words(sources: &Sources, edit: &Edit, notes: &mut SeenNotes) -> String {
    let old = match is_short(sources, edit) {
        true => code(sources.text(edit.span)),
        false => String::new(),
    };
    let is_long = edit.text.chars().count() > MAX_NEW;
    let new = match is_long && !notes.is_new(&edit.text) {
        true => {
            let head: String = edit.text.chars().take(MAX_OLD).collect();
            format!("{}...` (as before)", code(&head))
        }
        false => format!("{}`", code(&edit.text)),
    };
    match (edit.span.is_empty(), edit.text.is_empty(), old.is_empty()) {
        (true, ..) => format!("insert `{new}"),
        (_, true, true) => "delete".to_string(),
        (_, true, false) => format!("delete `{old}`"),
        (_, false, true) => format!("replace with `{new}"),
        (_, false, false) => format!("replace `{old}` with `{new}"),
    }
}

/// Code, with line breaks escaped.
fn code(text: &str) -> String {
    let text = text.replace('\r', "").replace('\n', "\\n");
    clean(&text)
}
