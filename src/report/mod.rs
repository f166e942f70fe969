//! Output formats: the only place with line numbers, colour and JSON.
//!
//! A [`Reporter`] is given the findings file by file and writes them as it goes; [`Reporter::finish`]
//! writes what comes last. One file per format.

mod excerpt;
mod human;
mod json;
mod short;

use crate::diagnostic::{Applicability, Diagnostic, Severity};
use crate::text::{Sources, Span};
use std::io::{self, Write};

/// The formats.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Format {
    /// With excerpts of the source, for people.
    Human,
    /// One line a finding.
    Short,
    /// One JSON object.
    Json,
    /// One JSON object a line, one line a finding.
    Jsonl,
}

/// How many findings there were.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Summary {
    /// Files looked at.
    pub files: usize,
    /// Errors.
    pub errors: usize,
    /// Warnings.
    pub warnings: usize,
    /// Infos.
    pub infos: usize,
    /// Findings that `--fix` would mend.
    pub fixable: usize,
}

impl Summary {
    fn add(&mut self, diagnostic: &Diagnostic) {
        match diagnostic.severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Info => self.infos += 1,
        }
        let is_safe = |f: &crate::diagnostic::Fix| f.applicability == Applicability::Safe;
        self.fixable += diagnostic.fix.as_ref().is_some_and(is_safe) as usize;
    }

    /// All findings.
    pub fn findings(&self) -> usize {
        self.errors + self.warnings + self.infos
    }
}

/// Writes findings in one format.
pub struct Reporter<W: Write> {
    format: Format,
    out: W,
    color: bool,
    summary: Summary,
}

impl<W: Write> Reporter<W> {
    /// A reporter that writes to `out`, with terminal colours if `color` is set and the format has
    /// any.
    pub fn new(format: Format, out: W, color: bool) -> Reporter<W> {
        Reporter {
            format,
            out,
            color,
            summary: Summary::default(),
        }
    }

    /// Writes the findings of one input file, in the order given.
    pub fn file(&mut self, sources: &Sources, diagnostics: &[Diagnostic]) -> io::Result<()> {
        if self.summary.files == 0 && self.format == Format::Json {
            json::begin(&mut self.out)?;
        }
        self.summary.files += 1;
        for diagnostic in diagnostics {
            let is_first = self.summary.findings() == 0;
            match self.format {
                Format::Human => human::write(&mut self.out, sources, diagnostic, self.color)?,
                Format::Short => short::write(&mut self.out, sources, diagnostic)?,
                Format::Json => json::write(&mut self.out, sources, diagnostic, is_first)?,
                Format::Jsonl => json::write_line(&mut self.out, sources, diagnostic)?,
            }
            self.summary.add(diagnostic);
        }
        Ok(())
    }

    /// Writes what comes behind the last file, and tells how much was found.
    pub fn finish(mut self) -> io::Result<Summary> {
        match self.format {
            Format::Json => {
                if self.summary.files == 0 {
                    json::begin(&mut self.out)?;
                }
                json::end(&mut self.out, &self.summary)?;
            }
            Format::Human => human::summary(&mut self.out, &self.summary)?,
            _ => {}
        }
        self.out.flush()?;
        Ok(self.summary)
    }
}

/// Renders one finding as people see it, without colour.
pub fn render(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let mut out = Vec::new();
    // Writing to memory cannot fail.
    let _ = human::write(&mut out, sources, diagnostic, false);
    String::from_utf8_lossy(&out).into_owned()
}

/// Path of the file that holds a span, with the pass where there are several.
fn location_name(sources: &Sources, span: Span) -> String {
    match sources.file_at(span.start) {
        Some(file) => match &file.part {
            Some(part) => format!("{} ({})", clean(&file.path), clean(part)),
            None => clean(&file.path),
        },
        None => String::new(),
    }
}

/// Text without control characters, those that nobody sees, and those that turn the direction of
/// writing, which could make a terminal show something else. Each is replaced by something of the same length.
fn clean(text: &str) -> String {
    text.chars().map(clean_char).collect()
}

fn clean_char(c: char) -> char {
    match c {
        '\t' => c,
        // Three bytes each in UTF-8, like U+FFFD.
        '\u{200b}'..='\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{2069}'
        | '\u{feff}' => '\u{fffd}',
        // Two bytes each, like U+00A4.
        '\u{ad}' => '\u{a4}',
        c if c.is_control() && c.len_utf8() == 1 => '?',
        c if c.is_control() => '\u{a4}',
        c => c,
    }
}
