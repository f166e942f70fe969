//! The source lines shown with a finding, cut to a readable width and cleaned for terminals.

use super::place::{clean_char, location_name};
use codespan_reporting::files::{Error, Files};
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::{FileId, SourceFile, Sources, Span};
use std::collections::BTreeMap;
use std::ops::Range;

/// Widest line that is shown completely, in characters.
const MAX_WIDTH: usize = 160;
/// Number of characters shown before the position of interest in a wider line.
const LEAD: usize = 60;

/// One source line as shown.
struct ExcerptLine {
    /// Line number in the file, from 1.
    number: u32,
    /// Address of the first byte shown.
    from: u32,
    /// Address after the last byte shown.
    to: u32,
    start: usize,
    /// Length in bytes of the mark that replaces the removed beginning.
    prefix: usize,
    /// Number of characters removed at the beginning.
    cut: usize,
}

/// The shown lines of one file.
struct ExcerptPart {
    name: String,
    text: String,
    lines: Vec<ExcerptLine>,
}

/// All source lines shown with one finding.
pub struct Excerpt {
    parts: Vec<(u32, ExcerptPart)>,
}

impl Excerpt {
    /// Collects the lines of the labels of `diagnostic`. Of a span over several lines only the
    /// first is shown.
    pub fn new(sources: &Sources, diagnostic: &Diagnostic) -> Excerpt {
        let mut by_file: BTreeMap<(FileId, &str), Vec<Span>> = BTreeMap::new();
        let labels = diagnostic.labels.iter().map(|l| l.span);
        for span in std::iter::once(diagnostic.span).chain(labels) {
            let id = sources.file_id_at(span.start);
            if let Some((id, file)) = id.and_then(|id| Some((id, sources.file(id)?))) {
                let path = file.shown_path(span.start);
                by_file.entry((id, path)).or_default().push(span);
            }
        }
        let part = |((id, _), inside): ((FileId, &str), Vec<Span>)| {
            let file = sources.file(id)?;
            let name = location_name(sources, *inside.first()?);
            Some((file.base, ExcerptPart::new(file, name, &inside)))
        };
        Excerpt {
            parts: by_file.into_iter().filter_map(part).collect(),
        }
    }

    /// The part that contains a span, and its range there. A span over several lines is cut at the
    /// end of the first.
    pub fn range(&self, span: Span) -> Option<(usize, Range<usize>)> {
        self.parts.iter().enumerate().find_map(|(i, (_, part))| {
            let line = part
                .lines
                .iter()
                .find(|l| l.from <= span.start && span.start <= l.to)?;
            let place = |address: u32| {
                let inside = address.clamp(line.from, line.to) - line.from;
                line.start + line.prefix + inside as usize
            };
            Some((i, place(span.start)..place(span.end)))
        })
    }
}

impl ExcerptPart {
    fn new(file: &SourceFile, name: String, spans: &[Span]) -> ExcerptPart {
        let mut numbered: Vec<(u32, Span)> = spans
            .iter()
            .map(|s| (file.lines().line(s.start - file.base), *s))
            .collect();
        numbered.sort_unstable_by_key(|(number, span)| (*number, span.start));
        let mut part = ExcerptPart {
            name,
            text: String::new(),
            lines: Vec::new(),
        };
        for (number, span) in numbered {
            let last = part
                .lines
                .last()
                .map(|l| file.lines().line(l.from - file.base));
            if last == Some(number) {
                continue;
            }
            // The renderer fills a gap of one line itself.
            if last.is_some_and(|l| l + 2 == number) {
                part.push_line(file, number - 1, Span::at(file.base));
            }
            part.push_line(file, number, span);
        }
        part
    }

    fn push_line(&mut self, file: &SourceFile, number: u32, focus: Span) {
        let start = file.lines().start(number).unwrap_or(0) as usize;
        let end = file
            .lines()
            .start(number + 1)
            .map_or(file.text.len(), |e| e as usize);
        let line = file
            .text
            .get(start..end)
            .unwrap_or("")
            .trim_end_matches(['\n', '\r']);
        let focus = ((focus.start - file.base) as usize).saturating_sub(start);
        let (cut, shown) = cut(line, focus);
        let prefix = if cut > 0 { "... " } else { "" };
        let from = file.base + (start + cut) as u32;
        self.lines.push(ExcerptLine {
            number: file.origin(number).1,
            from,
            to: from + shown.len() as u32,
            start: self.text.len(),
            prefix: prefix.len(),
            cut: file.position(from).column as usize - 1,
        });
        self.text.push_str(prefix);
        self.text.extend(shown.chars().map(clean_char));
        if cut + shown.len() < line.len() {
            self.text.push_str(" ...");
        }
        self.text.push('\n');
    }
}

/// The shown part of a line, and the number of bytes removed before it.
fn cut(line: &str, focus: usize) -> (usize, &str) {
    if line.len() <= MAX_WIDTH {
        return (0, line);
    }
    let boundary = |mut at: usize| {
        while !line.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let from = boundary(focus.saturating_sub(LEAD).min(line.len()));
    let to = boundary((from + MAX_WIDTH).min(line.len()));
    (from, line.get(from..to).unwrap_or(""))
}

impl<'a> Files<'a> for Excerpt {
    type FileId = usize;
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, id: usize) -> Result<&'a str, Error> {
        self.parts
            .get(id)
            .map(|(_, p)| p.name.as_str())
            .ok_or(Error::FileMissing)
    }

    fn source(&'a self, id: usize) -> Result<&'a str, Error> {
        self.parts
            .get(id)
            .map(|(_, p)| p.text.as_str())
            .ok_or(Error::FileMissing)
    }

    fn line_index(&'a self, id: usize, byte: usize) -> Result<usize, Error> {
        let (_, part) = self.parts.get(id).ok_or(Error::FileMissing)?;
        let after = part.lines.partition_point(|l| l.start <= byte);
        let line = after
            .checked_sub(1)
            .and_then(|i| part.lines.get(i))
            .ok_or(Error::FileMissing)?;
        // The renderer treats lines with consecutive indices as adjacent.
        Ok(line.number as usize - 1)
    }

    fn line_range(&'a self, id: usize, index: usize) -> Result<Range<usize>, Error> {
        let (_, part) = self.parts.get(id).ok_or(Error::FileMissing)?;
        let at = part
            .lines
            .iter()
            .position(|l| l.number as usize == index + 1);
        let Some(at) = at else {
            return Ok(part.text.len()..part.text.len());
        };
        let start = part.lines.get(at).map_or(0, |l| l.start);
        let end = part.lines.get(at + 1).map_or(part.text.len(), |l| l.start);
        Ok(start..end)
    }

    fn column_number(&'a self, id: usize, index: usize, byte: usize) -> Result<usize, Error> {
        let (_, part) = self.parts.get(id).ok_or(Error::FileMissing)?;
        let line = part
            .lines
            .iter()
            .find(|l| l.number as usize == index + 1)
            .ok_or(Error::FileMissing)?;
        let inside = part.text.get(line.start + line.prefix..byte).unwrap_or("");
        Ok(inside.chars().count() + line.cut + 1)
    }
}
