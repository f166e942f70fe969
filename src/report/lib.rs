//! Output formats. Only this crate deals with line numbers, colour and JSON.
//!
//! A [`Reporter`] receives the findings file by file and writes them at once; [`Reporter::finish`]
//! writes what follows the last file. Each format has its own module.

mod agent;
mod checkstyle;
mod excerpt;
mod fingerprint;
mod github;
mod gitlab;
mod human;
mod json;
pub mod junit;
mod others;
mod place;
mod sarif;
mod short;
mod summary;
pub mod xml;

pub use fingerprint::fingerprints;
pub use human::render;
pub use sarif::{Pages, RulePage};
pub use summary::{OptionNames, ReadAs, Scope, Summary};

use place::clean;
use shaderlint_diagnostic::{Diagnostic, Origin, Severity, count};
use shaderlint_text::{Sources, Span};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// The formats.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug, serde::Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// With excerpts of the source, for people.
    #[default]
    Human,
    /// One line per finding.
    Short,
    /// One line per finding, with its fix, labels and notes.
    Agent,
    /// The same for the answers of tools, which have parameters instead of options.
    #[cfg_attr(feature = "cli", value(hide = true))]
    Tool,
    /// One JSON object.
    Json,
    /// One JSON object per line, one line per finding.
    Jsonl,
    /// SARIF 2.1.0.
    Sarif,
    /// Workflow commands of GitHub Actions.
    Github,
    /// GitLab code quality report.
    Gitlab,
    /// JUnit XML.
    Junit,
    /// Checkstyle XML.
    Checkstyle,
    /// The number of findings of each rule.
    #[cfg_attr(feature = "cli", value(skip))]
    Statistics,
}

impl Format {
    /// Whether infos are shown that nobody asked for: programs choose for themselves what they show.
    pub fn shows_infos(self) -> bool {
        matches!(self, Format::Json | Format::Jsonl | Format::Statistics)
    }
}

/// Maximum number of findings printed for one input.
const MAX_PRINTED: usize = 200;

/// What the formats for people print at the end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ReportEnd {
    /// No summary.
    None,
    /// The number of findings, if there are any.
    Counts,
    /// What was checked and found.
    All,
    /// Also where rules did not run.
    Details,
}

/// Writes findings in one format.
pub struct Reporter<W: Write> {
    format: Format,
    out: W,
    color: bool,
    pages: Pages,
    end: ReportEnd,
    /// Base folder of paths in the formats that services read; ends with a slash.
    root: String,
    summary: Summary,
    /// Number of findings printed.
    printed: usize,
    /// The texts that the agent format printed already.
    notes: agent::SeenNotes,
    /// Number of findings by rule, for the statistics and SARIF.
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
            end: ReportEnd::Counts,
            root: "/".to_string(),
            summary: Summary::default(),
            printed: 0,
            notes: agent::SeenNotes::default(),
            names: BTreeMap::new(),
        }
    }

    /// Sets the function that returns the documentation of a rule, for SARIF.
    pub fn with_pages(mut self, pages: Pages) -> Reporter<W> {
        self.pages = pages;
        self
    }

    /// Prints at the end what was checked and how many findings can be fixed, with `details` also where rules
    /// did not run.
    pub fn summing_up(mut self, details: bool) -> Reporter<W> {
        self.end = match details {
            true => ReportEnd::Details,
            false => ReportEnd::All,
        };
        self
    }

    /// Prints no summary, except in the formats that always have one.
    pub fn without_summary(mut self) -> Reporter<W> {
        self.end = ReportEnd::None;
        self
    }

    /// Sets the folder that paths are relative to in the formats that services read.
    pub fn inside(mut self, folder: &str) -> Reporter<W> {
        self.root = format!("{}/", folder.trim_end_matches('/'));
        self
    }

    /// Whether the format prints how each input was interpreted.
    pub fn shows_readings(&self) -> bool {
        matches!(self.format, Format::Json | Format::Jsonl)
    }

    /// Whether the format identifies each finding for a service that tracks it.
    pub fn has_fingerprints(&self) -> bool {
        matches!(self.format, Format::Sarif | Format::Gitlab)
    }

    /// Counts findings that were fixed before they could be reported.
    pub fn add_fixed(&mut self, count: usize) {
        self.summary.fixed += count;
    }

    /// Counts findings that `--fix` would fix, and others with a fix.
    pub fn add_offer(&mut self, safe: usize, others: usize) {
        self.summary.fixable += safe;
        self.summary.suggested += others;
    }

    /// Flushes the output.
    pub fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }

    /// Writes the findings of one input file, in the order given. `name` is its path.
    pub fn file(
        &mut self,
        name: &str,
        sources: &Sources,
        diagnostics: &[Diagnostic],
    ) -> io::Result<()> {
        self.input(name, sources, diagnostics, &Scope::default())
    }

    /// Writes the findings of one input file, and adds its scope to the summary.
    pub fn input(
        &mut self,
        name: &str,
        sources: &Sources,
        diagnostics: &[Diagnostic],
        scope: &Scope,
    ) -> io::Result<()> {
        if self.summary.files == 0 {
            self.begin()?;
        }
        self.summary.files += 1;
        self.summary.enter(name, scope);
        for diagnostic in diagnostics {
            self.summary.add(diagnostic);
            *self.names.entry(diagnostic.rule).or_default() += 1;
        }
        let left_out = diagnostics.len().saturating_sub(MAX_PRINTED);
        self.summary.left_out += left_out;
        let missing = scope.left_out + left_out;
        if missing == 0 {
            return self.print((name, scope), sources, diagnostics);
        }
        let more = format!("and {}", count(missing, "more finding"));
        let mut printed = worst(diagnostics);
        match self.format {
            Format::Human | Format::Short | Format::Agent | Format::Tool => {
                self.print((name, scope), sources, &printed)?;
                writeln!(self.out, "{}: {more}", clean(name))
            }
            _ => {
                let at = printed
                    .last()
                    .map_or(Span::at(0), |d| Span::at(d.span.start));
                let (rule, origin) = ("more-findings", Origin::Report);
                printed.push(Diagnostic::new(rule, origin, Severity::Info, at, more));
                self.print((name, scope), sources, &printed)
            }
        }
    }

    fn print(
        &mut self,
        (name, scope): (&str, &Scope),
        sources: &Sources,
        found: &[Diagnostic],
    ) -> io::Result<()> {
        let read_as = scope.read_as.as_ref();
        match self.format {
            Format::Checkstyle => self
                .out
                .write_all(checkstyle::file(name, sources, found).as_bytes())?,
            Format::Junit => self
                .out
                .write_all(junit::file(name, sources, found).as_bytes())?,
            Format::Sarif | Format::Gitlab => self.with_fingerprints(sources, found)?,
            _ => {}
        }
        for diagnostic in found {
            let out = &mut self.out;
            match self.format {
                Format::Human => human::write(out, sources, diagnostic, self.color)?,
                Format::Short => short::write(out, sources, diagnostic)?,
                Format::Agent | Format::Tool => {
                    agent::write(out, sources, diagnostic, &mut self.notes)?;
                }
                Format::Json => json::write(out, sources, diagnostic, self.printed == 0)?,
                Format::Jsonl => json::write_line(out, sources, diagnostic, read_as)?,
                Format::Github => github::write(out, sources, diagnostic, &self.root)?,
                _ => {}
            }
            self.printed += 1;
        }
        Ok(())
    }

    fn with_fingerprints(&mut self, sources: &Sources, found: &[Diagnostic]) -> io::Result<()> {
        let prints = fingerprints(sources, found);
        for (i, (diagnostic, print)) in found.iter().zip(prints).enumerate() {
            let is_first = self.printed + i == 0;
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

    fn sum_up(&mut self) -> io::Result<()> {
        let summary = &self.summary;
        let lines = match self.end {
            ReportEnd::None => Vec::new(),
            ReportEnd::Counts if summary.findings() == 0 => Vec::new(),
            ReportEnd::Counts => {
                let files = count(summary.files, "file");
                vec![format!("Found {} in {files}", summary.counts())]
            }
            end => {
                let options = match self.format {
                    Format::Tool => &OptionNames::TOOL,
                    _ => &OptionNames::COMMAND,
                };
                let mut lines = summary.lines(options);
                match end {
                    ReportEnd::Details => lines.extend(summary.skipped()),
                    _ => lines.extend(summary.unchecked()),
                }
                lines
            }
        };
        for line in lines {
            writeln!(self.out, "{}", clean(&line))?;
        }
        Ok(())
    }

    fn begin(&mut self) -> io::Result<()> {
        match self.format {
            Format::Json => json::begin(&mut self.out),
            Format::Sarif => sarif::begin(&mut self.out),
            Format::Gitlab => self.out.write_all(b"["),
            Format::Junit => self.out.write_all(junit::begin("shaderlint").as_bytes()),
            Format::Checkstyle => self.out.write_all(checkstyle::BEGIN.as_bytes()),
            _ => Ok(()),
        }
    }

    /// Writes what follows the last file, and returns the totals.
    pub fn finish(mut self) -> io::Result<Summary> {
        if self.summary.files == 0 {
            self.begin()?;
        }
        match self.format {
            Format::Json => json::end(&mut self.out, &self.summary)?,
            Format::Human => self.sum_up()?,
            Format::Agent | Format::Tool => {
                self.end = match self.end {
                    ReportEnd::Details => ReportEnd::Details,
                    _ if self.format == Format::Tool => ReportEnd::Details,
                    _ => ReportEnd::All,
                };
                self.sum_up()?;
            }
            Format::Sarif => {
                let names: Vec<&'static str> = self.names.keys().copied().collect();
                sarif::end(&mut self.out, &names, self.pages)?;
            }
            Format::Gitlab => self.out.write_all(b"\n]\n")?,
            Format::Junit => self.out.write_all(junit::END.as_bytes())?,
            Format::Checkstyle => self.out.write_all(checkstyle::END.as_bytes())?,
            Format::Statistics => {
                let mut counts: Vec<_> = std::mem::take(&mut self.names).into_iter().collect();
                counts.sort_by_key(|(name, count)| (std::cmp::Reverse(*count), *name));
                for (name, count) in counts {
                    writeln!(self.out, "{count:>7}  {name}")?;
                }
                self.sum_up()?;
            }
            _ => {}
        }
        self.out.flush()?;
        Ok(self.summary)
    }
}

/// The findings to print if there are too many: the most severe, in source order.
fn worst(found: &[Diagnostic]) -> Vec<Diagnostic> {
    let mut order: Vec<usize> = (0..found.len()).collect();
    order.sort_by_key(|i| std::cmp::Reverse(found.get(*i).map(|d| d.severity)));
    order.truncate(MAX_PRINTED);
    order.sort_unstable();
    let picked = order.iter().filter_map(|i| found.get(*i));
    picked.cloned().collect()
}
