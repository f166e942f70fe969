//! From the text of one input to its findings. Nothing here touches the outside.

mod embedded;
pub mod include;
mod part;

use super::input::{Content, Encoding};
use crate::diagnostic::{Diagnostic, Origin, Severity, error};
use crate::lint::{Allow, Allows, Fixed, Look, Settings, fix};
use crate::port::{Project, ProjectError, compose};
use crate::rules::RULES;
use crate::text::embed::{Embedded, Language, extract};
use crate::text::{FileId, Role, Sources, Span};
use include::Includes;
use part::{Part, check_part, shader_part};
use std::sync::Arc;

/// What the user says a shader is written for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, clap::ValueEnum)]
pub enum DialectChoice {
    /// What the text tells.
    #[default]
    Auto,
    /// A pass of ShaderToy.
    Shadertoy,
    /// A shader of WebGL2, GLSL ES 3.00.
    Webgl2,
    /// A shader of WebGL1, GLSL ES 1.00.
    Webgl1,
}

/// What declares names for a shader, besides the shader itself.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct HostNames {
    /// Whether three.js puts its own declarations before it.
    pub is_three: bool,
    /// Further uniforms.
    pub uniforms: Vec<HostUniform>,
}

/// A uniform that the host declares, unless the shader does it itself.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HostUniform {
    /// Its name.
    pub name: String,
    /// Its type without an array's size, `vec4`.
    pub ty: String,
    /// How many there are, where it is an array.
    pub size: Option<u32>,
}

/// How an input is judged.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// What its shaders are written for.
    pub dialect: DialectChoice,
    /// Which rules run.
    pub settings: &'a Settings,
    /// What the host declares.
    pub host: &'a HostNames,
    /// Where `#include` finds its files.
    pub includes: &'a Includes,
}

/// The findings in one input.
pub struct Findings {
    /// The texts that they point into.
    pub sources: Sources,
    /// The findings, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The file of the input itself; `None` for an export, whose passes are files of their own.
    pub file: Option<FileId>,
    /// The shaders inside the file, where it is a page, a script or a text.
    embedded: Vec<Embedded>,
}

impl Findings {
    /// Whether a finding's fix can be written into the file.
    pub fn can_apply(&self, diagnostic: &Diagnostic) -> bool {
        let file = self.file.and_then(|id| self.sources.file(id));
        let (Some(file), Some(fix)) = (file, &diagnostic.fix) else {
            return false;
        };
        let is_page = Language::of_extension(extension(&file.path)).is_some();
        fix.edits.iter().all(|edit| {
            let mut inner = edit.clone();
            inner.span.start = edit.span.start.wrapping_sub(file.base);
            inner.span.end = edit.span.end.wrapping_sub(file.base);
            let is_inside = file.span().contains(edit.span);
            is_inside && (!is_page || self.embedded.iter().any(|e| e.admits(&file.text, &inner)))
        })
    }
}

/// Why an input cannot be judged.
pub enum DocumentError {
    /// It is JSON, but no ShaderToy export.
    NotAnExport,
    /// It should be a ShaderToy export, but something is wrong with it.
    Export(ProjectError),
    /// It is too large to be addressed.
    TooLarge,
}

/// The ending of a file's name.
fn extension(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or("")
}

/// Whether a file of this name is a ShaderToy export, by its ending.
pub fn is_export(name: &str) -> bool {
    matches!(extension(name), "json" | "shadertoy")
}

/// Finds what is to be said of the text of one input that stands alone.
pub fn check(
    name: &str,
    content: Content,
    choice: DialectChoice,
    settings: &Settings,
) -> Result<Findings, DocumentError> {
    let options = Options {
        dialect: choice,
        settings,
        host: &HostNames::default(),
        includes: &Includes::none(),
    };
    check_with(name, content, &options)
}

/// Finds what is to be said of the text of one input.
pub fn check_with(
    name: &str,
    content: Content,
    options: &Options,
) -> Result<Findings, DocumentError> {
    if let Some(diagnostic) = unreadable(&content, name) {
        let mut sources = Sources::new();
        let file = sources.add(name, None, Role::User, content.text);
        return Ok(Findings {
            sources,
            diagnostics: vec![diagnostic],
            file: Some(file.ok_or(DocumentError::TooLarge)?),
            embedded: Vec::new(),
        });
    }
    let Content { text, encoding } = content;
    let mut read = read(name, text, options)?;
    let mut diagnostics = Vec::new();
    let mut allows = Allows::default();
    for part in &read.parts {
        check_part(
            &read.sources,
            part,
            options.settings,
            &mut allows,
            &mut diagnostics,
        );
    }
    allows.report(RULES, options.settings, &mut diagnostics);
    diagnostics.append(&mut read.problems);
    if let (Encoding::Damaged(at), false) = (encoding, is_export(name)) {
        report_damage(&read, at, &mut diagnostics);
    }
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
    diagnostics.dedup_by(|a, b| (a.span, a.rule, &a.message) == (b.span, b.rule, &b.message));
    let mut findings = Findings {
        sources: read.sources,
        diagnostics: Vec::new(),
        file: read.file,
        embedded: read.embedded,
    };
    if !findings.embedded.is_empty() {
        for diagnostic in &mut diagnostics {
            if diagnostic.fix.is_some() && !findings.can_apply(diagnostic) {
                embedded::tell_fix(diagnostic);
            }
        }
    }
    findings.diagnostics = diagnostics;
    Ok(findings)
}

/// An input, split into shaders.
struct Read {
    sources: Sources,
    parts: Vec<Part>,
    file: Option<FileId>,
    embedded: Vec<Embedded>,
    /// What is wrong before any shader is read.
    problems: Vec<Diagnostic>,
}

fn read(name: &str, text: String, options: &Options) -> Result<Read, DocumentError> {
    let mut read = Read {
        sources: Sources::new(),
        parts: Vec::new(),
        file: None,
        embedded: Vec::new(),
        problems: Vec::new(),
    };
    if is_export(name) {
        let project = Project::from_json(&text).map_err(|e| match e {
            ProjectError::NotAnExport => DocumentError::NotAnExport,
            e => DocumentError::Export(e),
        })?;
        let composed = compose(&project, name).ok_or(DocumentError::TooLarge)?;
        read.sources = composed.sources;
        read.parts = composed.units.into_iter().map(Part::of_pass).collect();
        return Ok(read);
    }
    let text: Arc<str> = text.into();
    let file = read.sources.add(name, None, Role::User, text.clone());
    let file = file.ok_or(DocumentError::TooLarge)?;
    read.file = Some(file);
    match Language::of_extension(extension(name)) {
        Some(language) => {
            read.embedded = extract(language, &text);
            embedded::parts(&mut read, language, file, &text, options)
        }
        None => shader_part(&mut read, name, file, &text, options),
    }
    .ok_or(DocumentError::TooLarge)?;
    Ok(read)
}

/// What is wrong with a file that holds no text to be judged.
fn unreadable(content: &Content, name: &str) -> Option<Diagnostic> {
    let error = |rule, message| Some(Diagnostic::error(rule, Span::at(0), message));
    match content.encoding {
        Encoding::Utf16 => error(
            error::INVALID_ENCODING,
            "the file is UTF-16; save it as UTF-8",
        ),
        Encoding::Binary => error(error::INVALID_ENCODING, "the file is no text"),
        _ if holds_others(name) || !content.text.trim().is_empty() => None,
        _ => error(error::MISSING_MAIN, "the file is empty"),
    }
}

/// Whether files of this name are no shaders themselves, but may hold some.
fn holds_others(name: &str) -> bool {
    is_export(name) || Language::of_extension(extension(name)).is_some()
}

/// Reports bytes that are no UTF-8, at this offset of the file, where nothing else is said of
/// them: a comment may hold them.
fn report_damage(read: &Read, offset: u32, diagnostics: &mut Vec<Diagnostic>) {
    let Some(file) = read.file.and_then(|id| read.sources.file(id)) else {
        return;
    };
    let start = file.base + offset;
    if diagnostics.iter().any(|d| d.span.start == start) {
        return;
    }
    let span = Span::new(start, start + '\u{fffd}'.len_utf8() as u32);
    let rule = error::INVALID_ENCODING;
    let message = "the file is not UTF-8 from here on";
    diagnostics.push(
        Diagnostic::new(rule, Origin::Compiler, Severity::Warning, span, message)
            .note("a browser reads U+FFFD in the place of such bytes"),
    );
}

/// Mends what can be mended in the text of one shader file, judging it anew after each round.
pub fn fix_text(
    name: &str,
    text: &str,
    choice: DialectChoice,
    settings: &Settings,
    allow: Allow,
) -> Fixed {
    let options = Options {
        dialect: choice,
        settings,
        host: &HostNames::default(),
        includes: &Includes::none(),
    };
    fix_with(name, text, &options, allow)
}

/// Mends what can be mended in the text of one input, judging it anew after each round.
pub fn fix_with(name: &str, text: &str, options: &Options, allow: Allow) -> Fixed {
    fix(text, allow, |text| {
        let findings = check_with(name, Content::utf8(text), options).ok()?;
        let span = findings.sources.file(findings.file?)?.span();
        let diagnostics = findings.diagnostics;
        Some(Look { span, diagnostics })
    })
}
