//! Checks the text of one file.

use super::check::{ShaderFindings, ask_first, check_shader};
use super::partner;
use crate::check_context::{CheckContext, Keep};
use crate::files::Files;
use crate::hosts::host::Hosts;
use crate::hosts::hosted;
use crate::options::{Desktop, Options};
use crate::shader::analysis::Analysis;
use crate::shader::export::ExportText;
use crate::shader::input::SplitInput;
use crate::shader::shader_input::{Shader, ShaderInput};
use crate::text::shader_file::shader_part;
use crate::text::{embedded, foreign};
use shaderlint_detect::embed::{DocumentLanguage, Embedded, extract_named};
use shaderlint_detect::kind::{Decision, Evidence, FileKind, ShaderLanguage, decide};
use shaderlint_diagnostic::{Diagnostic, Facet, Severity, error};
use shaderlint_lint::{CheckedSpans, Settings, SkippedRules};
use shaderlint_port::{Project, ProjectError, compose};
use shaderlint_rules::RULES;
use shaderlint_semantic::Completeness;
use shaderlint_text::{Content, Encoding, FileId, Role, Sources, Span};
use std::fmt;
use std::sync::Arc;

/// The result of checking a text.
#[derive(Default)]
pub struct Report {
    /// The source texts that findings refer to.
    pub sources: Arc<Sources>,
    /// The findings in source order.
    pub diagnostics: Vec<Diagnostic>,
    /// The input file; `None` for an export, whose passes are separate files.
    pub file: Option<FileId>,
    /// The shaders of the file.
    pub shaders: Vec<Shader>,
    /// Number of findings dropped because there are too many.
    pub left_out: usize,
    /// Number of infos that were counted instead of reported.
    pub counted_infos: usize,
    /// Why the file was not checked.
    pub unread: Option<Unread>,
    /// The language of a shader that was not checked because WebGL does not support it.
    pub language: Option<ShaderLanguage>,
    /// The analyses of the shaders, if [`analyze`] was called.
    pub analyses: Vec<Analysis>,
    /// The embedded shaders of a page, script or document.
    pub(crate) embedded: Vec<Embedded>,
    /// Whether the file contains embedded shaders.
    pub(crate) holds_others: bool,
    /// Positions of the code of passes in an export.
    pub(crate) export: Option<ExportText>,
    /// What was checked, if there are errors.
    pub(crate) checked_spans: Option<CheckedSpans>,
}

impl Report {
    /// Whether the file includes other files.
    pub fn includes(&self) -> bool {
        let users = self.sources.files().iter().filter(|f| f.role == Role::User);
        self.file.is_some() && users.count() > 1
    }

    /// Whether the file contains embedded shaders.
    pub fn holds_shaders(&self) -> bool {
        self.holds_others
    }

    /// The embedded shaders of a page, script or document.
    pub fn embedded(&self) -> &[Embedded] {
        &self.embedded
    }

    /// Whether the fix of a finding can be written to the file.
    pub fn can_apply(&self, diagnostic: &Diagnostic) -> bool {
        let fix = diagnostic.fix.as_ref();
        fix.is_some_and(|fix| fix.edits.iter().all(|e| self.edit_of_input(e).is_some()))
    }
}

/// Why a text was not checked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Unread {
    /// It is not a kind of file that is checked.
    Skipped(Decision),
    /// It is an invalid ShaderToy export.
    Export(ProjectError),
    /// Nothing in it is GLSL, though its name says so, and it cannot be parsed.
    NotGlsl,
    /// The text exceeds the address space of 4 GiB.
    TooLarge,
}

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unread::Skipped(decision) => decision.fmt(f),
            Unread::Export(error) => error.fmt(f),
            Unread::NotGlsl => f.write_str("the text is not GLSL"),
            Unread::TooLarge => f.write_str("the file is too large"),
        }
    }
}

/// Checks a text. `name` is its path: the extension selects the kind of file, and includes are
/// resolved in its folder.
///
/// ```
/// use shaderlint_engine::{NoFiles, Options, check};
///
/// let text = "void mainImage(out vec4 color, in vec2 place) {\n    color = vec3(1.0);\n}\n";
/// let report = check("image.glsl", text, &Options::default(), &NoFiles);
/// let [finding] = &report.diagnostics[..] else {
///     panic!("one finding")
/// };
/// assert_eq!(finding.rule, "vector-size");
/// let file = report.sources.file_at(finding.span.start).unwrap();
/// assert_eq!(file.position(finding.span.start).line, 2);
/// ```
pub fn check(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let context = CheckContext::new(options, files);
    check_text(name, text, Encoding::Utf8, context)
}

/// Checks the decoded bytes of a file. The encoding may be a finding.
pub fn check_content(
    name: &str,
    content: &Content,
    options: &Options,
    files: &dyn Files,
) -> Report {
    let context = CheckContext::new(options, files);
    check_text(name, &content.text, content.encoding, context)
}

/// Checks a text and keeps the analyses of its shaders in [`Report::analyses`].
pub fn analyze(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let context = CheckContext {
        keep: Keep::Programs,
        ..CheckContext::new(options, files)
    };
    check_text(name, text, Encoding::Utf8, context)
}

/// Checks a text that was decoded from an encoding.
pub fn check_text(name: &str, text: &str, encoding: Encoding, context: CheckContext) -> Report {
    let report = try_check(name, text, encoding, context);
    report.unwrap_or_else(|unread| Report {
        unread: Some(unread),
        ..Report::default()
    })
}

fn try_check(
    name: &str,
    text: &str,
    encoding: Encoding,
    context: CheckContext,
) -> Result<Report, Unread> {
    let options = context.options;
    let decision = decide(name, text, options.claimed());
    let is_shader = matches!(decision.kind, FileKind::Shader | FileKind::Foreign(_));
    if let Some(diagnostic) = unreadable(text, encoding).filter(|_| is_shader) {
        let mut sources = Sources::new();
        let file = sources.add(name, None, Role::User, text);
        return Ok(Report {
            sources: Arc::new(sources),
            diagnostics: vec![diagnostic],
            file: Some(file.ok_or(Unread::TooLarge)?),
            ..Report::default()
        });
    }
    let kind = decision.kind;
    let language = match kind {
        FileKind::Foreign(language) => Some(language),
        _ => None,
    };
    let mut input = read(name, text, context, decision)?;
    let partner = partner::load(&mut input, name, context);
    let may_link = partner.is_some() || input.embedded.len() > 1;
    let keep = kept(kind, may_link, context);
    let all = check_shaders(&mut input, name, context, keep);
    let (mut diagnostics, shaders) = (all.found.diagnostics, all.shaders);
    if kind == FileKind::Shader && diagnostics.is_empty() {
        expect_glsl(name, text, &shaders, context)?;
    }
    diagnostics.extend(all.found.unresolved.report());
    partner::check(
        &input,
        partner
            .as_ref()
            .map(|p| (p, partner::linked_by(name, context))),
        &options.settings,
        &mut diagnostics,
    );
    all.found
        .allows
        .report(RULES, &options.settings, &mut diagnostics);
    diagnostics.append(&mut input.problems);
    if let (Encoding::Damaged(at), true) = (encoding, kind != FileKind::Export) {
        report_damage(&input, at, &mut diagnostics);
    }
    diagnostics.retain(|d| input.hushed.admits(&input.sources, d));
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
    diagnostics.dedup_by(|a, b| (a.span, a.rule, &a.message) == (b.span, b.rule, &b.message));
    let counted_infos = count_infos(&options.settings, &mut diagnostics);
    let mut report = Report {
        counted_infos,
        sources: input.sources,
        diagnostics: Vec::new(),
        file: input.file,
        left_out: shaders.iter().map(|s| s.left_out).sum(),
        shaders,
        embedded: input.embedded,
        holds_others: matches!(kind, FileKind::Holds(_)),
        export: input.export,
        checked_spans: all.checked_spans,
        unread: None,
        language: language.filter(|_| input.parts.is_empty()),
        analyses: match context.keep {
            Keep::Programs => input.parts.into_iter().filter_map(|p| p.analysis).collect(),
            Keep::Findings => Vec::new(),
        },
    };
    if options.desktop == Desktop::Port && kind == FileKind::Foreign(ShaderLanguage::Desktop) {
        ask_first(&mut diagnostics);
    }
    note_fixes(&report, &mut diagnostics);
    report.diagnostics = diagnostics;
    Ok(report)
}

/// What is kept of the shaders of a file. Programs are kept for linking, so that they are not
/// checked again.
fn kept(kind: FileKind, may_link: bool, context: CheckContext) -> Keep {
    match kind {
        FileKind::Holds(DocumentLanguage::Markdown) => context.keep,
        _ if may_link => Keep::Programs,
        _ => context.keep,
    }
}

/// Rejects a text that could not be read as a part of a shader and shows no GLSL at all: nothing
/// that only GLSL has, and no statements of a function.
fn expect_glsl(
    name: &str,
    text: &str,
    shaders: &[Shader],
    context: CheckContext,
) -> Result<(), Unread> {
    let is_lost = |shader: &Shader| {
        let is_everywhere = matches!(shader.skipped, SkippedRules::Everywhere);
        is_everywhere && shader.completeness != Completeness::Complete
    };
    if shaders.is_empty()
        || !shaders.iter().all(is_lost)
        || text.contains('#')
        || Evidence::of(text).has_glsl()
    {
        return Ok(());
    }
    let body = format!("void statements() {{\n{text}\n}}\n");
    let report = try_check(name, &body, Encoding::Utf8, context)?;
    let is_broken = report.diagnostics.iter().any(|d| d.has(Facet::Grammar));
    match is_broken || report.shaders.iter().all(is_lost) {
        true => Err(Unread::NotGlsl),
        false => Ok(()),
    }
}

/// Notes which fixes of embedded shaders cannot be written.
fn note_fixes(report: &Report, diagnostics: &mut [Diagnostic]) {
    if report.embedded.is_empty() {
        return;
    }
    for diagnostic in diagnostics {
        if diagnostic.fix.is_some() && !report.can_apply(diagnostic) {
            embedded::note_fix(diagnostic);
        }
    }
}

/// Drops the infos that are only counted, and counts them.
fn count_infos(settings: &Settings, diagnostics: &mut Vec<Diagnostic>) -> usize {
    let mut counted = 0;
    diagnostics.retain(|d| {
        let is_shown = settings.shows(d.rule, d.severity);
        counted += usize::from(!is_shown && settings.reports(d.rule));
        is_shown
    });
    counted
}

/// The findings about the shaders of a file.
#[derive(Default)]
struct CheckedShaders {
    found: ShaderFindings,
    shaders: Vec<Shader>,
    checked_spans: Option<CheckedSpans>,
}

fn check_shaders(
    input: &mut SplitInput,
    name: &str,
    context: CheckContext,
    keep: Keep,
) -> CheckedShaders {
    let mut all = CheckedShaders::default();
    let script = input.file.and_then(|id| input.sources.file(id));
    let script = script
        .filter(|_| !input.embedded.is_empty())
        .map(|f| f.text.clone());
    let hosts = Hosts::new(name, script, context);
    for part in &mut input.parts {
        let checked = check_shader(
            &mut input.sources,
            part,
            &hosts,
            context.options,
            keep,
            &mut all.found,
        );
        let Some((shader, seen)) = checked else {
            continue;
        };
        all.shaders.push(shader);
        if let Some(seen) = seen {
            all.checked_spans.get_or_insert_default().join(seen);
        }
    }
    all
}

fn read(
    name: &str,
    text: &str,
    context: CheckContext,
    decision: Decision,
) -> Result<SplitInput, Unread> {
    let options = context.options;
    let mut input = SplitInput::default();
    match decision.kind {
        FileKind::Other => return Err(Unread::Skipped(decision)),
        FileKind::Foreign(_) if options.desktop == Desktop::Skip => {
            return Err(Unread::Skipped(decision));
        }
        FileKind::Export => {
            let project = Project::from_json(text).map_err(|e| no_project(e, text))?;
            let composed = compose(&project, name).ok_or(Unread::TooLarge)?;
            input.export = Some(ExportText::of(text, &project, &composed));
            input.sources = composed.sources;
            input.parts = composed
                .units
                .into_iter()
                .map(ShaderInput::of_pass)
                .collect();
            return Ok(input);
        }
        FileKind::Shader | FileKind::Foreign(_) | FileKind::Holds(_) => {}
    }
    let file = Arc::make_mut(&mut input.sources).add(name, None, Role::User, text);
    let file = file.ok_or(Unread::TooLarge)?;
    input.file = Some(file);
    match decision.kind {
        FileKind::Holds(language) => {
            input.embedded = extract_named(name, language, text);
            embedded::parts(&mut input, name, language, file, text, context)
        }
        FileKind::Shader
            if hosted::is_pass_of_another(text, options)
                && hosted::part(&mut input, name, (file, 0), text, context)
                    .ok_or(Unread::TooLarge)? =>
        {
            Some(())
        }
        FileKind::Foreign(ShaderLanguage::Desktop)
            if options.desktop == Desktop::Report
                && hosted::part(&mut input, name, (file, 0), text, context)
                    .ok_or(Unread::TooLarge)? =>
        {
            Some(())
        }
        FileKind::Foreign(language) if !foreign::is_ported(language, options) => {
            foreign::report_file(&mut input, file, text, language, &decision)
        }
        _ => shader_part(&mut input, name, file, text, context),
    }
    .ok_or(Unread::TooLarge)?;
    Ok(input)
}

/// JSON that is not an export is skipped, unless it mentions render passes.
fn no_project(error: ProjectError, text: &str) -> Unread {
    let is_meant = text.contains("\"renderpass\"");
    match error {
        ProjectError::NotAnExport => Unread::Skipped(Decision::no_export()),
        ProjectError::Json { .. } if !is_meant => Unread::Skipped(Decision::no_export()),
        error => Unread::Export(error),
    }
}

/// The finding about a shader file that has no readable text.
fn unreadable(text: &str, encoding: Encoding) -> Option<Diagnostic> {
    let error = |kind, message| Some(Diagnostic::error(kind, Span::at(0), message));
    match encoding {
        Encoding::Utf16 => error(
            error::INVALID_ENCODING,
            "the file is UTF-16; save it as UTF-8",
        ),
        Encoding::Binary => error(error::INVALID_ENCODING, "the file is not a text file"),
        _ if !text.trim().is_empty() => None,
        // Other files may include an empty file as a placeholder.
        _ => error(error::MISSING_MAIN, "the file is empty").map(|d| Diagnostic {
            severity: Severity::Warning,
            ..d
        }),
    }
}

/// Reports invalid UTF-8 at an offset of the file, unless another finding is at the same position.
/// Comments may contain invalid bytes.
fn report_damage(input: &SplitInput, offset: u32, diagnostics: &mut Vec<Diagnostic>) {
    let Some(file) = input.file.and_then(|id| input.sources.file(id)) else {
        return;
    };
    let start = file.base + offset;
    if diagnostics.iter().any(|d| d.span.start == start) {
        return;
    }
    let span = Span::new(start, start + '\u{fffd}'.len_utf8() as u32);
    let kind = error::INVALID_ENCODING;
    let message = "invalid UTF-8";
    diagnostics.push(
        Diagnostic::of(kind, Severity::Warning, span, message)
            .note("browsers replace invalid bytes with U+FFFD"),
    );
}
