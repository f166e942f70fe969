//! Output formats: the only place with line numbers, colour and JSON.
//!
//! A [`Reporter`] is given the findings file by file and writes them as it goes; [`Reporter::finish`]
//! writes what comes last. One file per format.

mod checkstyle;
mod excerpt;
mod fingerprint;
mod github;
mod gitlab;
mod human;
mod json;
mod junit;
mod sarif;
mod short;
mod xml;

pub use fingerprint::fingerprints;

use crate::diagnostic::{Applicability, Diagnostic, Severity};
use crate::text::{Position, Sources, Span};
use std::collections::BTreeMap;
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
    /// SARIF 2.1.0.
    Sarif,
    /// Workflow commands of GitHub Actions.
    Github,
    /// GitLab's code quality report.
    Gitlab,
    /// JUnit XML.
    Junit,
    /// Checkstyle XML.
    Checkstyle,
    /// How often each rule found something.
    Statistics,
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
    /// Findings that `--unsafe-fixes` would mend besides.
    pub suggested: usize,
    /// Findings that have been mended.
    pub fixed: usize,
}

impl Summary {
    fn add(&mut self, input: &str, sources: &Sources, diagnostic: &Diagnostic) {
        // What stands in an export is not written back, nor a file that this one includes.
        let in_file = |span: Span| {
            let file = sources.file_at(span.start);
            file.is_some_and(|f| f.part.is_none() && f.path == input)
        };
        let fix = diagnostic.fix.as_ref();
        let fix = fix.filter(|f| f.edits.iter().all(|e| in_file(e.span)));
        match fix.map(|f| f.applicability) {
            Some(Applicability::Safe) => self.fixable += 1,
            Some(Applicability::Unsafe) => self.suggested += 1,
            None => {}
        }
        match diagnostic.severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Info => self.infos += 1,
        }
    }

    /// All findings.
    pub fn findings(&self) -> usize {
        self.errors + self.warnings + self.infos
    }
}

/// The page of a rule or a compile error, by its name.
pub type Pages = fn(&str) -> Option<&'static str>;

/// Writes findings in one format.
pub struct Reporter<W: Write> {
    format: Format,
    out: W,
    color: bool,
    pages: Pages,
    offers_fixes: bool,
    /// The folder that the paths of the formats for services count from; ends with a slash.
    root: String,
    summary: Summary,
    /// How often each name was reported, for the formats that sum up.
    names: BTreeMap<&'static str, usize>,
}

impl<W: Write> Reporter<W> {
    /// A reporter that writes to `out`, with terminal colours if `color` is set and the format has
    /// any.
    pub fn new(format: Format, out: W, color: bool) -> Reporter<W> {
        Reporter {
            format,
            out,
            color,
            pages: |_| None,
            offers_fixes: false,
            root: "/".to_string(),
            summary: Summary::default(),
            names: BTreeMap::new(),
        }
    }

    /// Lets the formats that explain rules do so.
    pub fn with_pages(mut self, pages: Pages) -> Reporter<W> {
        self.pages = pages;
        self
    }

    /// Says at the end how many findings `--fix` would mend.
    pub fn offering_fixes(mut self) -> Reporter<W> {
        self.offers_fixes = true;
        self
    }

    /// Names files from this folder in the formats that services read: they know no other.
    pub fn inside(mut self, folder: &str) -> Reporter<W> {
        self.root = format!("{}/", folder.trim_end_matches('/'));
        self
    }

    /// Counts findings that were mended before they could be reported.
    pub fn add_fixed(&mut self, count: usize) {
        self.summary.fixed += count;
    }

    /// Writes the findings of one input file, in the order given. `name` is its path.
    pub fn file(
        &mut self,
        name: &str,
        sources: &Sources,
        diagnostics: &[Diagnostic],
    ) -> io::Result<()> {
        if self.summary.files == 0 {
            self.begin()?;
        }
        self.summary.files += 1;
        match self.format {
            Format::Checkstyle => checkstyle::file(&mut self.out, name, sources, diagnostics)?,
            Format::Junit => junit::file(&mut self.out, name, sources, diagnostics)?,
            Format::Sarif | Format::Gitlab => self.with_fingerprints(sources, diagnostics)?,
            _ => {}
        }
        for diagnostic in diagnostics {
            let is_first = self.summary.findings() == 0;
            match self.format {
                Format::Human => human::write(&mut self.out, sources, diagnostic, self.color)?,
                Format::Short => short::write(&mut self.out, sources, diagnostic)?,
                Format::Json => json::write(&mut self.out, sources, diagnostic, is_first)?,
                Format::Jsonl => json::write_line(&mut self.out, sources, diagnostic)?,
                Format::Github => github::write(&mut self.out, sources, diagnostic, &self.root)?,
                _ => {}
            }
            self.summary.add(name, sources, diagnostic);
            *self.names.entry(diagnostic.rule).or_default() += 1;
        }
        Ok(())
    }

    fn with_fingerprints(&mut self, sources: &Sources, found: &[Diagnostic]) -> io::Result<()> {
        let prints = fingerprints(sources, found);
        for (i, (diagnostic, print)) in found.iter().zip(prints).enumerate() {
            let is_first = self.summary.findings() + i == 0;
            let separator: &[u8] = if is_first { b"\n" } else { b",\n" };
            self.out.write_all(separator)?;
            match self.format {
                Format::Sarif => {
                    sarif::write(&mut self.out, sources, diagnostic, &print, &self.root)?
                }
                _ => gitlab::write(&mut self.out, sources, diagnostic, &print, &self.root)?,
            }
        }
        Ok(())
    }

    /// The summary as people see it.
    fn told_summary(&self) -> Summary {
        if self.offers_fixes {
            return self.summary;
        }
        Summary {
            fixable: 0,
            suggested: 0,
            ..self.summary
        }
    }

    fn begin(&mut self) -> io::Result<()> {
        match self.format {
            Format::Json => json::begin(&mut self.out),
            Format::Sarif => sarif::begin(&mut self.out),
            Format::Gitlab => self.out.write_all(b"["),
            Format::Junit => junit::begin(&mut self.out),
            Format::Checkstyle => checkstyle::begin(&mut self.out),
            _ => Ok(()),
        }
    }

    /// Writes what comes behind the last file, and tells how much was found.
    pub fn finish(mut self) -> io::Result<Summary> {
        if self.summary.files == 0 {
            self.begin()?;
        }
        let summary = self.told_summary();
        match self.format {
            Format::Json => json::end(&mut self.out, &self.summary)?,
            Format::Human => human::summary(&mut self.out, &summary)?,
            Format::Sarif => {
                let names: Vec<&'static str> = self.names.keys().copied().collect();
                sarif::end(&mut self.out, &names, self.pages)?;
            }
            Format::Gitlab => self.out.write_all(b"\n]\n")?,
            Format::Junit => junit::end(&mut self.out)?,
            Format::Checkstyle => checkstyle::end(&mut self.out)?,
            Format::Statistics => {
                let mut counts: Vec<_> = self.names.into_iter().collect();
                counts.sort_by_key(|(name, count)| (std::cmp::Reverse(*count), *name));
                for (name, count) in counts {
                    writeln!(self.out, "{count:>7}  {name}")?;
                }
                human::summary(&mut self.out, &summary)?;
            }
            _ => {}
        }
        self.out.flush()?;
        Ok(self.summary)
    }
}

/// Where a finding starts and ends in its file; `None` for a pass of an export, whose code does not
/// stand in the file as such.
fn region(sources: &Sources, span: Span) -> Option<(Position, Position)> {
    let file = sources.file_at(span.start).filter(|f| f.part.is_none())?;
    Some((file.position(span.start), file.position(span.end)))
}

/// The path of the file that holds a span, from the folder `root` where it lies in there.
fn path<'a>(sources: &'a Sources, span: Span, root: &str) -> &'a str {
    let path = sources.file_at(span.start).map_or("", |f| &f.path);
    path.strip_prefix(root).unwrap_or(path)
}

/// The message, with the place in its pass where the file has no place for it.
fn placed_message(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let message = clean(&diagnostic.message);
    let file = sources.file_at(diagnostic.span.start);
    match file.and_then(|f| Some((f, f.part.as_ref()?))) {
        Some((file, part)) => {
            let at = file.position(diagnostic.span.start);
            let part = clean(part);
            format!("{message} ({part}, line {}, column {})", at.line, at.column)
        }
        None => message,
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
