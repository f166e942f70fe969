//! From the text of one input to its findings. Nothing here touches the outside.

use super::input::{Content, Encoding};
use crate::diagnostic::{Diagnostic, Origin, Severity, error};
use crate::lint::{Allow, Fixed, Look, Settings, fix, lint};
use crate::port::{PassUnit, Project, ProjectError, compose};
use crate::rules::RULES;
use crate::semantic::{Dialect, Kind, Pass, Stage, Unit, analyze, guess, shadertoy_header};
use crate::text::{FileId, Role, Sources, Span};

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

/// One shader of a document.
struct Part {
    files: Vec<FileId>,
    stage: Stage,
    dialect: Dialect,
    infer_channels: bool,
}

impl Part {
    fn of_pass(unit: PassUnit) -> Part {
        Part {
            files: unit.files,
            stage: Stage::Fragment,
            dialect: Dialect::ShaderToy(unit.kind),
            infer_channels: false,
        }
    }
}

/// The findings in one input.
pub struct Findings {
    /// The texts that they point into.
    pub sources: Sources,
    /// The findings, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
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

/// Finds what is to be said of the text of one input.
pub fn check(
    name: &str,
    content: Content,
    choice: DialectChoice,
    settings: &Settings,
) -> Result<Findings, DocumentError> {
    let mut sources = Sources::new();
    let extension = name.rsplit('.').next().unwrap_or("");
    let is_export = matches!(extension, "json" | "shadertoy");
    if let Some(diagnostic) = unreadable(&content, is_export) {
        sources
            .add(name, None, Role::User, content.text)
            .ok_or(DocumentError::TooLarge)?;
        return Ok(Findings {
            sources,
            diagnostics: vec![diagnostic],
        });
    }
    let Content { text, encoding } = content;
    let parts = if is_export {
        let project = Project::from_json(&text).map_err(|e| match e {
            ProjectError::NotAnExport => DocumentError::NotAnExport,
            e => DocumentError::Export(e),
        })?;
        let composed = compose(&project, name).ok_or(DocumentError::TooLarge)?;
        sources = composed.sources;
        composed.units.into_iter().map(Part::of_pass).collect()
    } else {
        let part = shader_part(&mut sources, name, text, extension, choice);
        vec![part.ok_or(DocumentError::TooLarge)?]
    };
    let mut diagnostics = Vec::new();
    for part in &parts {
        check_part(&sources, part, settings, &mut diagnostics);
    }
    if let (Encoding::Damaged(at), false) = (encoding, is_export) {
        report_damage(&sources, at, &mut diagnostics);
    }
    diagnostics.sort_by_key(|d| (d.span.start, d.span.end));
    diagnostics.dedup_by(|a, b| (a.span, a.rule, &a.message) == (b.span, b.rule, &b.message));
    Ok(Findings {
        sources,
        diagnostics,
    })
}

/// What is wrong with a file that holds no text to be judged.
fn unreadable(content: &Content, is_export: bool) -> Option<Diagnostic> {
    let error = |rule, message| Some(Diagnostic::error(rule, Span::at(0), message));
    match content.encoding {
        Encoding::Utf16 => error(
            error::INVALID_ENCODING,
            "the file is UTF-16; save it as UTF-8",
        ),
        Encoding::Binary => error(error::INVALID_ENCODING, "the file is no text"),
        _ if is_export || !content.text.trim().is_empty() => None,
        _ => error(error::MISSING_MAIN, "the file is empty"),
    }
}

/// Reports bytes that are no UTF-8, at this offset of the last file, where nothing else is said of
/// them: a comment may hold them.
fn report_damage(sources: &Sources, offset: u32, diagnostics: &mut Vec<Diagnostic>) {
    let Some(file) = sources.files().last() else {
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
    fix(text, allow, |text| {
        let findings = check(name, Content::utf8(text), choice, settings).ok()?;
        let file = findings.sources.files().last()?;
        Some(Look {
            span: file.span(),
            diagnostics: findings.diagnostics,
        })
    })
}

fn check_part(
    sources: &Sources,
    part: &Part,
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let analysis = analyze(&Unit {
        sources,
        files: &part.files,
        stage: part.stage,
        dialect: part.dialect,
        infer_channels: part.infer_channels,
    });
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    if !analysis.diagnostics.iter().any(is_error) {
        lint(&analysis.program, RULES, settings, diagnostics);
    }
    diagnostics.extend(analysis.diagnostics);
}

fn shader_part(
    sources: &mut Sources,
    name: &str,
    text: String,
    extension: &str,
    choice: DialectChoice,
) -> Option<Part> {
    let told = guess(&text);
    let is_stage_file = matches!(extension, "frag" | "vert" | "fs" | "vs" | "fsh" | "vsh");
    let kind = match choice {
        DialectChoice::Shadertoy => match told.kind {
            Some(Kind::ShaderToy(pass)) => Kind::ShaderToy(pass),
            _ => Kind::ShaderToy(Pass::Common),
        },
        DialectChoice::Webgl1 => Kind::WebGl1,
        DialectChoice::Webgl2 if told.kind == Some(Kind::Versioned) => Kind::Versioned,
        DialectChoice::Webgl2 => Kind::WebGl2,
        DialectChoice::Auto => match told.kind {
            Some(Kind::ShaderToy(pass)) => Kind::ShaderToy(pass),
            // What a stage's file holds is compiled as it stands: without `#version` it is 1.00.
            _ if is_stage_file => Kind::Versioned,
            Some(kind) => kind,
            None => Kind::ShaderToy(Pass::Common),
        },
    };
    let header = match kind {
        Kind::ShaderToy(pass) => Some(shadertoy_header(pass, [None; 4])),
        Kind::WebGl2 => Some("#version 300 es\n".to_string()),
        Kind::Versioned | Kind::WebGl1 => None,
    };
    let mut files = Vec::new();
    if let Some(header) = header {
        files.push(sources.add("", None, Role::Prelude, header)?);
    }
    files.push(sources.add(name, None, Role::User, text)?);
    let stage = match extension {
        "vert" | "vs" | "vsh" => Stage::Vertex,
        "frag" | "fs" | "fsh" => Stage::Fragment,
        _ => told.stage.unwrap_or(Stage::Fragment),
    };
    let dialect = match kind {
        Kind::ShaderToy(pass) => Dialect::ShaderToy(pass),
        Kind::WebGl2 => Dialect::WebGl { whole: false },
        _ => Dialect::WebGl { whole: true },
    };
    Some(Part {
        files,
        stage,
        dialect,
        infer_channels: dialect.is_shadertoy(),
    })
}
