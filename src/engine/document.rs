//! From the text of one file to what is said of it.

use super::analysis::Analysis;
use super::check::{PartFindings, ask_first, check_part};
use super::export::Written;
use super::host::Hosts;
use super::input::SplitInput;
use super::options::Desktop;
use super::part::{Part, Shader};
use super::shader::shader_part;
use super::world::{Keep, World};
use super::{embedded, foreign, hosted, partner};
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_lint::Judged;
use shaderlint_port::{Project, ProjectError, compose};
use shaderlint_rules::RULES;
use shaderlint_text::embed::{DocumentLanguage, Embedded, extract_named};
use shaderlint_text::kind::{Decision, FileKind, Tongue, decide};
use shaderlint_text::{Encoding, FileId, Role, Sources, Span};
use std::fmt;
use std::sync::Arc;

/// What is said of one text.
#[derive(Default)]
pub struct Report {
    /// The texts that they point into.
    pub sources: Arc<Sources>,
    /// The findings, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The file of the input itself; `None` for an export, whose passes are files of their own.
    pub file: Option<FileId>,
    /// What was read as shaders.
    pub shaders: Vec<Shader>,
    /// Findings of the rules that are not kept, since there are too many.
    pub left_out: usize,
    /// Why nothing was judged, where that is so.
    pub unread: Option<Unread>,
    /// What is known of the shaders, where [`analyze`](super::analyze) was asked.
    pub analyses: Vec<Analysis>,
    /// The shaders inside the file, where it is a page, a script or a text.
    pub(super) embedded: Vec<Embedded>,
    /// Whether the file holds shaders and is none itself.
    pub(super) holds_others: bool,
    /// Where the code of the passes is written, where it is an export.
    pub(super) export: Option<Written>,
    /// What was judged, where there are errors.
    pub(super) judged: Option<Judged>,
}

impl Report {
    /// Whether other files are read with this one.
    pub fn includes(&self) -> bool {
        let users = self.sources.files().iter().filter(|f| f.role == Role::User);
        self.file.is_some() && users.count() > 1
    }

    /// Whether the file holds shaders and is none itself.
    pub fn holds_shaders(&self) -> bool {
        self.holds_others
    }

    /// Whether a finding's fix can be written into the file.
    pub fn can_apply(&self, diagnostic: &Diagnostic) -> bool {
        let fix = diagnostic.fix.as_ref();
        fix.is_some_and(|fix| fix.edits.iter().all(|e| self.edit_of_input(e).is_some()))
    }
}

/// Why a text is not judged.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Unread {
    /// It is nothing that is read.
    Skipped(Decision),
    /// It should be a ShaderToy export, but something is wrong with it.
    Export(ProjectError),
    /// It is too large to be addressed.
    TooLarge,
}

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unread::Skipped(decision) => decision.fmt(f),
            Unread::Export(error) => error.fmt(f),
            Unread::TooLarge => f.write_str("the file is too large"),
        }
    }
}

/// Judges a text as its bytes were written.
pub(super) fn judge(name: &str, text: &str, encoding: Encoding, world: World) -> Report {
    let judged = try_judge(name, text, encoding, world);
    judged.unwrap_or_else(|unread| Report {
        unread: Some(unread),
        ..Report::default()
    })
}

fn try_judge(name: &str, text: &str, encoding: Encoding, world: World) -> Result<Report, Unread> {
    let options = world.options;
    let decision = decide(name, text, options.claim);
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
    let mut input = read(name, text, world, decision)?;
    let partner = partner::load(&mut input, name, world);
    let may_link = partner.is_some() || input.embedded.len() > 1;
    let keep = match kind {
        FileKind::Holds(DocumentLanguage::Markdown) => world.keep,
        // Shaders that may be linked are not checked again for it.
        _ if may_link => Keep::Programs,
        _ => world.keep,
    };
    let told = check_parts(&mut input, name, world, keep);
    let (mut diagnostics, shaders) = (told.found.diagnostics, told.shaders);
    diagnostics.extend(told.found.unresolved.report());
    partner::check(
        &input,
        partner.as_ref(),
        &options.settings,
        &mut diagnostics,
    );
    told.found
        .allows
        .report(RULES, &options.settings, &mut diagnostics);
    diagnostics.append(&mut input.problems);
    if let (Encoding::Damaged(at), true) = (encoding, kind != FileKind::Export) {
        report_damage(&input, at, &mut diagnostics);
    }
    diagnostics.retain(|d| input.hushed.admits(&input.sources, d));
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
    diagnostics.dedup_by(|a, b| (a.span, a.rule, &a.message) == (b.span, b.rule, &b.message));
    let mut report = Report {
        sources: input.sources,
        diagnostics: Vec::new(),
        file: input.file,
        left_out: shaders.iter().map(|s| s.left_out).sum(),
        shaders,
        embedded: input.embedded,
        holds_others: matches!(kind, FileKind::Holds(_)),
        export: input.export,
        judged: told.judged,
        unread: None,
        analyses: match world.keep {
            Keep::Programs => input.parts.into_iter().filter_map(|p| p.analysis).collect(),
            Keep::Findings => Vec::new(),
        },
    };
    if options.desktop == Desktop::Port && kind == FileKind::Foreign(Tongue::Desktop) {
        ask_first(&mut diagnostics);
    }
    if !report.embedded.is_empty() {
        for diagnostic in &mut diagnostics {
            if diagnostic.fix.is_some() && !report.can_apply(diagnostic) {
                embedded::tell_fix(diagnostic);
            }
        }
    }
    report.diagnostics = diagnostics;
    Ok(report)
}

/// What is said of the shaders of a file.
#[derive(Default)]
struct ToldFindings {
    found: PartFindings,
    shaders: Vec<Shader>,
    judged: Option<Judged>,
}

fn check_parts(input: &mut SplitInput, name: &str, world: World, keep: Keep) -> ToldFindings {
    let mut told = ToldFindings::default();
    let script = input.file.and_then(|id| input.sources.file(id));
    let script = script
        .filter(|_| !input.embedded.is_empty())
        .map(|f| f.text.clone());
    let hosts = Hosts::new(name, script, world);
    for part in &mut input.parts {
        let checked = check_part(
            &mut input.sources,
            part,
            &hosts,
            world.options,
            keep,
            &mut told.found,
        );
        let Some((shader, seen)) = checked else {
            continue;
        };
        told.shaders.push(shader);
        if let Some(seen) = seen {
            told.judged.get_or_insert_default().join(seen);
        }
    }
    told
}

fn read(name: &str, text: &str, world: World, decision: Decision) -> Result<SplitInput, Unread> {
    let options = world.options;
    let mut input = SplitInput::default();
    match decision.kind {
        FileKind::Other => return Err(Unread::Skipped(decision)),
        FileKind::Foreign(_) if options.desktop == Desktop::Skip => {
            return Err(Unread::Skipped(decision));
        }
        FileKind::Export => {
            let project = Project::from_json(text).map_err(|e| no_project(e, text))?;
            let composed = compose(&project, name).ok_or(Unread::TooLarge)?;
            input.export = Some(Written::of(text, &project, &composed));
            input.sources = composed.sources;
            input.parts = composed.units.into_iter().map(Part::of_pass).collect();
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
            embedded::parts(&mut input, name, language, file, text, world)
        }
        FileKind::Shader
            if hosted::is_pass_of_another(text, options)
                && hosted::part(&mut input, name, (file, 0), text, world)
                    .ok_or(Unread::TooLarge)? =>
        {
            Some(())
        }
        FileKind::Foreign(Tongue::Desktop)
            if options.desktop == Desktop::Report
                && hosted::part(&mut input, name, (file, 0), text, world)
                    .ok_or(Unread::TooLarge)? =>
        {
            Some(())
        }
        FileKind::Foreign(tongue) if !foreign::is_ported(tongue, options) => {
            foreign::whole(&mut input, file, text, tongue, &decision)
        }
        _ => shader_part(&mut input, name, file, text, world),
    }
    .ok_or(Unread::TooLarge)?;
    Ok(input)
}

/// What becomes of JSON that is no project: any that does not speak of passes is passed over.
fn no_project(error: ProjectError, text: &str) -> Unread {
    let is_meant = text.contains("\"renderpass\"");
    match error {
        ProjectError::NotAnExport => Unread::Skipped(Decision::no_export()),
        ProjectError::Json { .. } if !is_meant => Unread::Skipped(Decision::no_export()),
        error => Unread::Export(error),
    }
}

/// What is wrong with a shader file that holds no text to be judged.
fn unreadable(text: &str, encoding: Encoding) -> Option<Diagnostic> {
    let error = |kind, message| Some(Diagnostic::error(kind, Span::at(0), message));
    match encoding {
        Encoding::Utf16 => error(
            error::INVALID_ENCODING,
            "the file is UTF-16; save it as UTF-8",
        ),
        Encoding::Binary => error(error::INVALID_ENCODING, "the file is no text"),
        _ if !text.trim().is_empty() => None,
        // Others may include it, as a place for something.
        _ => error(error::MISSING_MAIN, "the file is empty").map(|d| Diagnostic {
            severity: Severity::Warning,
            ..d
        }),
    }
}

/// Reports bytes that are no UTF-8, at this offset of the file, where nothing else is said of
/// them: a comment may hold them.
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
    let message = "the file is not UTF-8 from here on";
    diagnostics.push(
        Diagnostic::of(kind, Severity::Warning, span, message)
            .note("a browser reads U+FFFD in the place of such bytes"),
    );
}
