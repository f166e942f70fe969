//! `shaderlint FILE`: checks a text and prints its findings.

use super::reading::{Recognition, reading};
use super::scope::scope_of;
use serde::{Deserialize, Serialize};
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_engine::config::Selection;
use shaderlint_engine::{DialectChoice, Offer, Options, Report, check_content};
use shaderlint_host::Preset;
use shaderlint_lint::{Infos, Settings};
use shaderlint_project::Files;
use shaderlint_report::{Format, Reporter, Scope};
use shaderlint_text::{Content, Encoding};
use std::collections::HashSet;
use std::io::{self, Write};

/// How texts are checked: the same for the command line, MCP and WebAssembly.
#[derive(Clone, Default, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::Args, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", command(next_help_heading = "Rules"))]
#[serde(default, rename_all = "camelCase")]
pub struct CheckRequest {
    /// Site or library that the shaders are written for, such as `three`, or a file that describes one;
    /// an unknown name lists all hosts
    #[cfg_attr(
        feature = "cli",
        arg(long, value_name = "NAME", help_heading = "Files")
    )]
    #[cfg_attr(feature = "cli", arg(conflicts_with = "dialect"))]
    pub host: Option<String>,
    /// Dialect of the shaders: auto, shadertoy, webgl2, webgl1
    #[cfg_attr(
        feature = "cli",
        arg(long, value_enum, default_value_t, value_name = "DIALECT")
    )]
    #[cfg_attr(
        feature = "cli",
        arg(hide_possible_values = true, help_heading = "Files")
    )]
    pub dialect: DialectChoice,
    /// Enable these rules or groups; `all` enables every rule
    #[cfg_attr(feature = "cli", arg(long, value_name = "RULE", value_delimiter = ','))]
    pub select: Vec<String>,
    /// Disable these rules or groups; the more specific of --select and --ignore wins
    #[cfg_attr(feature = "cli", arg(long, value_name = "RULE", value_delimiter = ','))]
    pub ignore: Vec<String>,
    /// Report only these rules, groups or compile errors
    #[cfg_attr(feature = "cli", arg(long, value_name = "RULE", value_delimiter = ','))]
    #[cfg_attr(feature = "cli", arg(conflicts_with_all = ["select", "ignore"]))]
    pub only: Vec<String>,
    /// Also report infos; by default they are only counted
    #[cfg_attr(feature = "cli", arg(long))]
    pub info: bool,
    /// Static analysis only: do not execute shaders
    #[cfg_attr(feature = "cli", arg(long))]
    pub no_run: bool,
    /// Sample N pixels of each shader, however long it takes, instead of up to 4096
    #[cfg_attr(
        feature = "cli",
        arg(long, value_name = "N", conflicts_with = "no_run")
    )]
    pub run_samples: Option<u32>,
}

impl CheckRequest {
    /// The options of a run with this output; `host` is the one that is named.
    pub fn selection(&self, host: Option<&'static Preset>, format: Format) -> Selection {
        Selection {
            dialect: self.dialect,
            host,
            select: self.select.clone(),
            ignore: self.ignore.clone(),
            only: self.only.clone(),
            run_samples: self.run_samples.or(self.no_run.then_some(0)),
            infos: match self.info || format.shows_infos() {
                true => Infos::Shown,
                false => Infos::Counted,
            },
        }
    }
}

/// A text that was checked.
pub struct CheckedText {
    /// The findings.
    pub report: Report,
    /// What was checked.
    pub scope: Scope,
    /// The fixes on offer.
    pub offer: Offer,
}

/// Checks a text. `left` has the findings whose fixes would change the image; with `recognition`, the
/// scope describes how the text was interpreted.
pub fn check(
    (name, content): (&str, &Content),
    (options, files): (&Options, &dyn Files),
    left: &[Diagnostic],
    recognition: Option<Recognition>,
) -> CheckedText {
    let mut report = check_content(name, content, options, files);
    report.leave_alone(left);
    report.retract_failing_fixes((name, &content.text), options, files);
    let is_written = content.encoding == Encoding::Utf8 && report.unread.is_none();
    let offer = match is_written {
        true => Offer::of(&report),
        false => Offer::default(),
    };
    let mut scope = scope_of(&report);
    scope.read_as = recognition.map(|how| reading(name, &report, (options, files), how));
    CheckedText {
        report,
        scope,
        offer,
    }
}

/// Identifies a finding: file, pass and offset, rule, message.
pub type FindingKey = ((String, Option<String>, u32), &'static str, String);

/// Prints the findings of a text that the settings report. Those in `printed` are left out, as several
/// files may include the same one. `known` removes findings of a baseline.
///
/// # Errors
/// If the output cannot be written.
pub fn print<W: Write>(
    reporter: &mut Reporter<W>,
    (name, checked): (&str, CheckedText),
    settings: Option<&Settings>,
    printed: &mut HashSet<FindingKey>,
    known: impl FnOnce(&mut Report),
) -> io::Result<()> {
    let CheckedText {
        mut report,
        mut scope,
        mut offer,
    } = checked;
    let found = &mut report.diagnostics;
    if let Some(settings) = settings {
        let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
        let before = found.iter().filter(is_error).count();
        found.retain(|d| settings.reports(d.rule));
        scope.hidden = before - found.iter().filter(is_error).count();
    }
    let sources = &report.sources;
    found.retain(|d| {
        let Some(file) = sources.file_at(d.span.start) else {
            return true;
        };
        let offset = d.span.start - file.base;
        let place = (file.path.clone(), file.part.clone(), offset);
        printed.insert((place, d.rule, d.message.clone()))
    });
    let before = found.len();
    known(&mut report);
    scope.known = before - report.diagnostics.len();
    if scope.known > 0 {
        // Fixes of findings in the baseline are not on offer.
        offer = Offer::of(&report);
    }
    reporter.add_offer(offer.safe, offer.others);
    if let Some(settings) = settings {
        let failing = report.diagnostics.iter();
        let failing = failing.filter(|d| settings.fails(d.rule));
        scope.failing = failing.map(|d| d.rule).collect();
    }
    // Services track each finding by its own fingerprint.
    if !reporter.has_fingerprints() {
        report.group();
    }
    reporter.input(name, &report.sources, &report.diagnostics, &scope)
}
