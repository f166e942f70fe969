//! One shader from files to findings.

use super::blame::{attribute, gather};
use super::builtins::Stage;
use super::channels::needed_channels;
use super::checker::{MAX_ERRORS, Parsed, Problems, check};
use super::dialect::Dialect;
use super::explain::explain;
use super::part::{Open, Wholeness, keep_certain};
use super::program::Program;
use super::settle::{Corrected, Recheck};
use super::types::Sampler;
use shaderlint_diagnostic::{Diagnostic, Facet, Severity, error};
use shaderlint_syntax::{ParseOptions, Preprocessed, parse, preprocess};
use shaderlint_text::{FileId, Role, Sources, Span};
use std::sync::Arc;

/// What makes up one shader.
pub struct Unit<'a> {
    /// All files.
    pub sources: &'a Arc<Sources>,
    /// Those of the shader, in the order in which they are compiled.
    pub files: &'a [FileId],
    /// The stage it is written for.
    pub stage: Stage,
    /// Who runs it.
    pub dialect: Dialect,
    /// Whether the types of its channels are not known, and are to be what its uses need.
    pub infer_channels: bool,
    /// How much of the shader that is.
    pub wholeness: Wholeness,
}

/// A shader, checked.
pub struct Checked {
    /// What is known of it.
    pub program: Program,
    /// What the browser's compiler would refuse, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// What a part leaves open.
    pub open: Open,
    /// How much of a shader that is.
    pub wholeness: Wholeness,
}

impl Checked {
    /// Whether the browser would refuse it.
    pub fn has_errors(&self) -> bool {
        let mut all = self.diagnostics.iter();
        all.any(|d| d.severity == Severity::Error)
    }
}

/// Checks a complete fragment shader without a host: the short way in, which the tests of all layers
/// above take. `None` where it is too large.
pub fn analyze_alone(code: String, role: Role) -> Option<Checked> {
    let mut sources = Sources::new();
    let file = sources.add("", None, role, code)?;
    Some(analyze(&Unit {
        sources: &Arc::new(sources),
        files: &[file],
        stage: Stage::Fragment,
        dialect: Dialect::WebGl,
        infer_channels: false,
        wholeness: Wholeness::Whole,
    }))
}

/// Reads and checks a part of a shader in each way in which a host may take it, the likeliest first:
/// what is wrong in all of them is wrong.
pub fn analyze_part(readings: &[Unit]) -> Option<Checked> {
    /// Most tokens that are read for it.
    const MAX_READ: usize = 2_000_000;
    let (first, others) = readings.split_first()?;
    let mut analysis = analyze(first);
    let mut read = 0;
    for other in others {
        if !analysis.has_errors() {
            break;
        }
        read += analysis.program.size();
        if read > MAX_READ {
            // What the others would say is not known.
            analysis.open.is_any = true;
            analysis.open.unknown.clear();
            analysis
                .diagnostics
                .retain(|d| d.severity != Severity::Error);
            break;
        }
        let Checked {
            diagnostics: found,
            open,
            ..
        } = analyze(other);
        let is_told = |d: &Diagnostic| found.iter().any(|o| o.span.touches(d.span));
        analysis
            .diagnostics
            .retain(|d| d.severity != Severity::Error || is_told(d));
        keep_common(&mut analysis.open.unknown, &open.unknown);
    }
    Some(analysis)
}

/// Keeps the names that are unknown in each way in which a host may take a part: what only one stage
/// or version has is known in that.
pub fn confirm_unknown(readings: &[Unit], unknown: &mut Vec<Diagnostic>) {
    for reading in readings {
        if unknown.is_empty() {
            return;
        }
        keep_common(unknown, &analyze(reading).open.unknown);
    }
}

fn keep_common(unknown: &mut Vec<Diagnostic>, others: &[Diagnostic]) {
    unknown.retain(|d| others.iter().any(|o| o.span == d.span));
}

/// Reads and checks one shader, and finds whose fault its errors are.
pub fn analyze(unit: &Unit) -> Checked {
    let Checked {
        program,
        diagnostics,
        open,
        wholeness,
    } = analyze_once(unit);
    let mut diagnostics = attribute(unit, &program, diagnostics);
    // An entry that stands behind an `#if` without its end is there, only not read.
    if diagnostics
        .iter()
        .any(|d| d.is(error::UNBALANCED_CONDITIONAL))
    {
        diagnostics.retain(|d| !d.is(error::MISSING_MAIN));
    }
    if unit.wholeness != Wholeness::Whole {
        keep_own(unit.sources, &mut diagnostics);
    }
    limit(&mut diagnostics);
    Checked {
        program,
        diagnostics,
        open,
        wholeness,
    }
}

/// Checks a complete fragment shader without a host: the short way in, which the tests of all layers
/// above take.
pub fn analyze_fragment(code: &str) -> Checked {
    let mut sources = Sources::new();
    let files: Vec<FileId> = sources
        .add("test", None, Role::User, code)
        .into_iter()
        .collect();
    analyze(&Unit {
        sources: &Arc::new(sources),
        files: &files,
        stage: Stage::Fragment,
        dialect: Dialect::WebGl,
        infer_channels: false,
        wholeness: Wholeness::Whole,
    })
}

/// Keeps what is said of the user's text, without what it says of a host's.
fn keep_own(sources: &Sources, diagnostics: &mut Vec<Diagnostic>) {
    let is_user = |span: Span| {
        let file = sources.file_at(span.start);
        file.is_some_and(|f| f.role == Role::User && f.span().contains(span))
    };
    diagnostics.retain(|d| is_user(d.span));
    for diagnostic in diagnostics {
        diagnostic.labels.retain(|l| is_user(l.span));
    }
}

/// Reads and checks one shader: every error stands where the compiler stumbles.
pub(super) fn analyze_once(unit: &Unit) -> Checked {
    let is_fragment = unit.stage == Stage::Fragment;
    let Preprocessed {
        mut tokens,
        names,
        version,
        mut diagnostics,
        gave_up,
    } = preprocess(unit.sources, unit.files, is_fragment);
    if gave_up {
        tokens.tokens.drain(..tokens.tokens.len().saturating_sub(1));
    }
    let language = ParseOptions {
        version,
        is_fragment,
    };
    let parse = parse(unit.sources, &mut tokens, &names, language);
    let translated = parse.translated;
    let has_errors = !diagnostics.is_empty()
        || !parse.diagnostics.is_empty()
        || !translated.diagnostics.is_empty();
    let parsed = Parsed {
        sources: Arc::clone(unit.sources),
        tokens,
        names,
        tree: parse.tree,
        version,
        has_errors,
        enough: MAX_ERRORS,
    };
    let corrected = Corrected {
        options: language,
        choices: parse.choices,
        original: parse.original,
        lost: translated.lost,
    };
    let looked = match gave_up {
        true => {
            let (program, problems) = check(parsed, unit.stage, unit.dialect, [None; 4]);
            Recheck::new(program, Vec::new(), problems)
        }
        false => corrected.settle(parsed, parse.diagnostics, unit),
    };
    let program = looked.program;
    // Of half a shader only what the preprocessor says is certain.
    if !gave_up {
        // What the lexer says of a piece of a foreign form is no second mistake.
        let is_told = |d: &Diagnostic| {
            let mut forms = translated.diagnostics.iter().map(|form| form.span);
            d.is(error::INVALID_NUMBER) && forms.any(|form| form != d.span && form.contains(d.span))
        };
        diagnostics.retain(|d| !is_told(d));
        diagnostics.extend(looked.syntax);
        diagnostics.extend(explain(&program, &looked.problems));
        diagnostics.extend(translated.diagnostics);
    }
    if let Some(cut) = program.tokens.cut {
        judge_cut(unit.sources, cut, &mut diagnostics);
    }
    let open = match unit.wholeness {
        Wholeness::Whole => Open::default(),
        wholeness => keep_certain(&program, wholeness, &mut diagnostics),
    };
    let mut diagnostics = gather(&program, diagnostics);
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
    diagnostics.truncate(MAX_ERRORS);
    Checked {
        program,
        diagnostics,
        open,
        wholeness: unit.wholeness,
    }
}

/// A NUL ends the shader. What is then missing is that one mistake; where nothing is missing, the
/// rest of the text is only not used.
fn judge_cut(sources: &Sources, cut: Span, diagnostics: &mut Vec<Diagnostic>) {
    let count = diagnostics.len();
    diagnostics.retain(|d| d.span.end < cut.start && !d.has(Facet::EndsEarly));
    let severity = if diagnostics.len() < count {
        Severity::Error
    } else {
        Severity::Warning
    };
    let rest = sources.file_at(cut.start).and_then(|file| {
        let from = (cut.end - file.base) as usize;
        file.text.get(from..)
    });
    if severity == Severity::Error || rest.is_some_and(|r| !r.trim_matches(['\0', '\n']).is_empty())
    {
        let message = "a NUL character ends the shader here";
        let kind = error::INVALID_CHARACTER;
        diagnostics.push(
            Diagnostic::of(kind, severity, cut, message)
                .note("the browser reads nothing of what stands behind it"),
        );
    }
}

fn limit(diagnostics: &mut Vec<Diagnostic>) {
    if diagnostics.len() >= MAX_ERRORS {
        diagnostics.truncate(MAX_ERRORS);
        if let Some(last) = diagnostics.last_mut() {
            last.notes.push(format!(
                "there may be more: only the first {MAX_ERRORS} errors are told"
            ));
        }
    }
}

/// Checks a shader, with the types of its channels found out where they are not known.
pub(super) fn judge(parsed: Parsed, unit: &Unit) -> (Program, Problems) {
    match unit.infer_channels {
        true => check_with_any_channels(parsed, unit),
        false => check(parsed, unit.stage, unit.dialect, [None; 4]),
    }
}

/// Checks a shader whose channels may be of any type. Only where something is wrong with channels of
/// two dimensions, its lookups are asked for others.
///
/// A count that ends early chooses well enough. Where it ended by lookups that do not fit two
/// dimensions, either they are more than those that do, and the other channels are taken; or at least
/// as many do, which would all be errors with the others.
fn check_with_any_channels(parsed: Parsed, unit: &Unit) -> (Program, Problems) {
    let enough = parsed.enough;
    let checked = check(parsed, unit.stage, unit.dialect, [None; 4]);
    if checked.1.is_empty() {
        return checked;
    }
    let channels = needed_channels(&checked.0);
    if channels.iter().flatten().all(|c| *c == Sampler::Sampler2D) {
        return checked;
    }
    let parsed = Parsed {
        enough,
        ..checked.0.into_parsed()
    };
    check(parsed, unit.stage, unit.dialect, channels)
}

impl Program {
    /// The shader as it was before it was checked.
    pub(super) fn into_parsed(self) -> Parsed {
        Parsed {
            sources: self.sources,
            tokens: self.tokens,
            names: self.names,
            tree: self.tree,
            version: self.version,
            has_errors: self.had_errors,
            enough: MAX_ERRORS,
        }
    }
}
