//! Messages on standard error.

use crate::diagnostic::{Diagnostic, Severity};
use crate::port::Remark;
use crate::report::{Format, Reporter, Summary};
use crate::text::Sources;
use std::collections::HashSet;
use std::io::{self, IsTerminal, Write};

/// Prints a message to standard error.
pub(super) fn print_note(message: &str) {
    let _ = writeln!(io::stderr(), "shaderport: {message}");
}

pub(super) fn is_colored() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none()
}

/// Reports the errors of the passes, and the passes that could not be written as requested.
pub(super) fn report<'a>(
    sources: &Sources,
    problems: impl Iterator<Item = &'a Diagnostic>,
    remarks: &[Remark],
) -> io::Result<Summary> {
    // Several passes may share a text or its includes, so the same finding can occur more than
    // once.
    let mut printed = HashSet::new();
    let place = |d: &Diagnostic| {
        let file = sources.file_at(d.span.start);
        file.map(|f| (f.path.clone(), f.part.clone(), d.span.start - f.base))
    };
    let is_new = |d: &&Diagnostic| printed.insert((place(d), d.rule, d.message.clone()));
    let mut found: Vec<Diagnostic> = problems.filter(is_new).cloned().collect();
    let mut stderr = io::stderr().lock();
    let mut errors = 0;
    for remark in remarks {
        if sources.text(remark.span).is_empty() {
            let (severity, pass) = (remark.severity.name(), &remark.pass);
            writeln!(stderr, "{severity}: {pass}: {}", remark.message)?;
            errors += usize::from(remark.severity == Severity::Error);
        } else {
            found.push(remark.diagnostic());
        }
    }
    if found.is_empty() {
        return Ok(Summary {
            errors,
            ..Summary::default()
        });
    }
    let mut reporter = Reporter::new(Format::Human, stderr, is_colored());
    reporter.file("", sources, &found)?;
    let mut summary = reporter.finish()?;
    summary.errors += errors;
    Ok(summary)
}
