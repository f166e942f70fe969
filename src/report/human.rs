//! The format for people: the finding with a source excerpt, rendered by codespan-reporting.

use super::excerpt::Excerpt;
use super::others::others;
use super::place::clean;
use anstyle::{AnsiColor, Effects, Style};
use codespan_reporting::diagnostic as cs;
use codespan_reporting::term::{Config, WriteStyle, emit_to_io_write, emit_to_write_style};
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_text::Sources;
use std::io::{self, Write};

/// Writes one finding.
pub fn write(
    out: &mut impl Write,
    sources: &Sources,
    diagnostic: &Diagnostic,
    color: bool,
) -> io::Result<()> {
    let excerpt = Excerpt::new(sources, diagnostic);
    let mut shown = convert(diagnostic, &excerpt);
    shown.notes.extend(others(sources, diagnostic));
    let config = Config::default();
    let mut text = Vec::new();
    let result = if color {
        emit_to_write_style(&mut Colored(&mut text), &config, &excerpt, &shown)
    } else {
        emit_to_io_write(&mut text, &config, &excerpt, &shown)
    };
    result.map_err(io::Error::other)?;
    // codespan-reporting calls its lowest severity a note.
    if diagnostic.severity == Severity::Info
        && let Some(at) = text.windows(NOTE.len()).position(|part| part == NOTE)
    {
        text.splice(at..at + NOTE.len(), INFO.iter().copied());
    }
    out.write_all(&text)
}

/// How a finding of severity info starts in codespan-reporting.
const NOTE: &[u8] = b"note[";
/// How it starts here.
const INFO: &[u8] = b"info[";

fn convert(diagnostic: &Diagnostic, excerpt: &Excerpt) -> cs::Diagnostic<usize> {
    let severity = match diagnostic.severity {
        Severity::Error => cs::Severity::Error,
        Severity::Warning => cs::Severity::Warning,
        Severity::Info => cs::Severity::Note,
    };
    let mut shown = cs::Diagnostic::new(severity)
        .with_code(diagnostic.rule)
        .with_message(clean(&diagnostic.message));
    if let Some((file, range)) = excerpt.range(diagnostic.span) {
        shown
            .labels
            .push(cs::Label::primary(file, range).with_message(clean(&diagnostic.label)));
    }
    for label in &diagnostic.labels {
        if let Some((file, range)) = excerpt.range(label.span) {
            shown
                .labels
                .push(cs::Label::secondary(file, range).with_message(clean(&label.message)));
        }
    }
    shown.notes.extend(macro_note(diagnostic));
    shown
        .notes
        .extend(diagnostic.notes.iter().map(|n| clean(n)));
    shown.notes.extend(
        diagnostic
            .help
            .iter()
            .map(|h| format!("help: {}", clean(h))),
    );
    if let Some(fix) = &diagnostic.fix
        && !diagnostic.help.contains(&fix.title)
    {
        shown.notes.push(format!("help: {}", clean(&fix.title)));
    }
    shown
}

/// The macros that the code was expanded from, outermost first.
fn macro_note(diagnostic: &Diagnostic) -> Option<String> {
    const SHOWN: usize = 4;
    let names: Vec<String> = diagnostic
        .macros
        .iter()
        .rev()
        .map(|m| format!("`{}`", clean(&m.name)))
        .collect();
    match names.as_slice() {
        [] => None,
        [one] => Some(format!("expanded from macro {one}")),
        [first, rest @ ..] => {
            let mut through = rest
                .iter()
                .take(SHOWN)
                .cloned()
                .collect::<Vec<_>>()
                .join(", ");
            if rest.len() > SHOWN {
                through.push_str(&format!(" and {} more", rest.len() - SHOWN));
            }
            Some(format!("expanded from macro {first}, via {through}"))
        }
    }
}

/// Translates the styles of codespan-reporting to ANSI escape sequences.
struct Colored<W: Write>(W);

impl<W: Write> Colored<W> {
    fn set(&mut self, color: AnsiColor, effects: Effects) -> io::Result<()> {
        let style = Style::new().fg_color(Some(color.into())).effects(effects);
        write!(self.0, "{}", style.render())
    }
}

impl<W: Write> Write for Colored<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

fn color_of(severity: cs::Severity) -> AnsiColor {
    match severity {
        cs::Severity::Bug | cs::Severity::Error => AnsiColor::BrightRed,
        cs::Severity::Warning => AnsiColor::BrightYellow,
        cs::Severity::Note => AnsiColor::BrightCyan,
        cs::Severity::Help => AnsiColor::BrightGreen,
    }
}

impl<W: Write> WriteStyle for Colored<W> {
    fn set_header(&mut self, severity: cs::Severity) -> io::Result<()> {
        self.set(color_of(severity), Effects::BOLD)
    }

    fn set_header_message(&mut self) -> io::Result<()> {
        write!(self.0, "{}", Style::new().effects(Effects::BOLD).render())
    }

    fn set_line_number(&mut self) -> io::Result<()> {
        self.set(AnsiColor::Blue, Effects::new())
    }

    fn set_note_bullet(&mut self) -> io::Result<()> {
        self.set(AnsiColor::Blue, Effects::new())
    }

    fn set_source_border(&mut self) -> io::Result<()> {
        self.set(AnsiColor::Blue, Effects::new())
    }

    fn set_label(&mut self, severity: cs::Severity, style: cs::LabelStyle) -> io::Result<()> {
        match style {
            cs::LabelStyle::Primary => self.set(color_of(severity), Effects::new()),
            cs::LabelStyle::Secondary => self.set(AnsiColor::Blue, Effects::new()),
        }
    }

    fn reset(&mut self) -> io::Result<()> {
        write!(self.0, "{}", anstyle::Reset.render())
    }
}

/// Renders one finding without colour.
pub fn render(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let mut out = Vec::new();
    // Writing to memory cannot fail.
    let _ = write(&mut out, sources, diagnostic, false);
    String::from_utf8_lossy(&out).into_owned()
}
