//! For programs that read as people do: one line a finding, with all that belongs to it.
//!
//! `path:line:column: severity rule: message; replace ... with ... at 5:3,9 6:1; 5:3: remark; note`
//!
//! Of places on one line the first names it. Remarks and notes stand where there is no fix; a note is
//! told with the first finding that has it.

use super::place::{clean, location_name};
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix};
use shaderlint_text::{Edit, Sources, Span};
use std::collections::HashSet;
use std::io::{self, Write};

/// Longest piece of code that is written out although the place tells which it is, in characters.
const MAX_OLD: usize = 24;
/// Longest text of a fix that is written out whenever it is put in, in characters.
const MAX_NEW: usize = 60;

/// What was told already. A note is told once: it is the same for all findings that have it.
#[derive(Default)]
pub struct Told(HashSet<String>);

impl Told {
    /// Whether a text is new.
    fn is_new(&mut self, text: &str) -> bool {
        self.0.insert(text.to_string())
    }
}

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    diagnostic: &Diagnostic,
    told: &mut Told,
) -> io::Result<()> {
    let span = diagnostic.span;
    write!(
        out,
        "{}:{}: {} {}: {}",
        location_name(sources, span),
        place(sources, span.start),
        diagnostic.severity.name(),
        diagnostic.rule,
        clean(&diagnostic.message)
    )?;
    if let Some(fix) = &diagnostic.fix {
        write!(out, "; {}", told_fix(sources, fix, span, told))?;
    }
    for used in &diagnostic.macros {
        write!(out, "; in macro `{}`", clean(&used.name))?;
    }
    // A fix says what to do and where; the page of the rule says why.
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
        if told.is_new(note) {
            write!(out, "; {}", clean(note))?;
        }
    }
    out.write_all(b"\n")
}

/// The other places of a finding, by what is said of them.
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
    let position = sources.file_at(at).map(|f| f.position(at));
    position.map_or("1:1".to_string(), |p| format!("{}:{}", p.line, p.column))
}

/// A place beside another: its file is named where it is another one.
fn other_place(sources: &Sources, at: u32, beside: Span) -> String {
    let here = location_name(sources, beside);
    let there = location_name(sources, Span::at(at));
    let place = place(sources, at);
    match here == there {
        true => place,
        false => format!("{there}:{place}"),
    }
}

/// Places in one text: of those on the same line, the line stands with the first only.
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

/// What to write: ``replace `1` with `1.0` at 5:3, 6:7``.
fn told_fix(sources: &Sources, fix: &Fix, at: Span, told: &mut Told) -> String {
    // The same edit in several places is told once.
    let mut all: Vec<(String, Vec<String>)> = Vec::new();
    for edit in &fix.edits {
        let what = told_edit(sources, edit, told);
        let from = other_place(sources, edit.span.start, at);
        let place = match is_short(sources, edit) {
            true => from,
            false => match whole_lines(sources, edit) {
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

/// The first and last line that an edit takes away, where it takes away whole lines of this text.
fn whole_lines(sources: &Sources, edit: &Edit) -> Option<(u32, u32)> {
    let file = sources.file_at(edit.span.start)?;
    let (start, end) = (file.position(edit.span.start), file.position(edit.span.end));
    let is_whole = start.column == 1 && end.column == 1 && end.line > start.line;
    (is_whole && edit.text.is_empty()).then_some((start.line, end.line - 1))
}

/// Whether what an edit takes away is written out.
fn is_short(sources: &Sources, edit: &Edit) -> bool {
    let old = sources.text(edit.span);
    old.chars().count() <= MAX_OLD && !old.contains('\n')
}

fn told_edit(sources: &Sources, edit: &Edit, told: &mut Told) -> String {
    let old = match is_short(sources, edit) {
        true => code(sources.text(edit.span)),
        false => String::new(),
    };
    let is_long = edit.text.chars().count() > MAX_NEW;
    let new = match is_long && !told.is_new(&edit.text) {
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

/// Code on one line.
fn code(text: &str) -> String {
    let text = text.replace('\r', "").replace('\n', "\\n");
    clean(&text)
}
