//! One shader of an input.

use super::include::{is_common, spread};
use super::{DialectChoice, HostUniform, Options, Read};
use crate::diagnostic::{Diagnostic, Severity, error};
use crate::lint::{Allows, Judged, Settings, Unrun, keep_comments, lint_within};
use crate::port::PassUnit;
use crate::rules::RULES;
use crate::semantic::snippet::is_certain;
use crate::semantic::{
    Analysis, Dialect, Kind, Pass, Stage, Unit, analyze, guess, shadertoy_header, three_header,
};
use crate::syntax::{Lexer, RawKind, Version};
use crate::text::embed::Host;
use crate::text::kind::ending;
use crate::text::{FileId, Role, Sources, Span};

/// How much of a shader is at hand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Extent {
    /// All of it.
    Whole,
    /// What it does not declare may be declared elsewhere.
    Open,
    /// It is an excerpt: rules, which look at whole shaders, have nothing to say.
    Excerpt,
}

/// One shader of an input.
pub struct Part {
    /// What is compiled, in order.
    pub files: Vec<FileId>,
    /// The stage.
    pub stage: Stage,
    /// Who runs it.
    pub dialect: Dialect,
    /// Whether its channels may be of any type.
    pub infer_channels: bool,
    /// How much of it is at hand.
    pub extent: Extent,
    /// The page or script around it.
    pub host: Host,
}

impl Part {
    /// A pass of an export.
    pub fn of_pass(unit: PassUnit) -> Part {
        Part {
            files: unit.files,
            stage: Stage::Fragment,
            dialect: Dialect::ShaderToy(unit.kind),
            infer_channels: false,
            extent: Extent::Whole,
            host: Host::default(),
        }
    }
}

/// Finds what is to be said of a shader, and says what was looked at; of one with errors also what
/// was judged at all.
pub fn check_part(
    sources: &Sources,
    part: &Part,
    settings: &Settings,
    allows: &mut Allows,
    diagnostics: &mut Vec<Diagnostic>,
) -> (Shader, Option<Judged>) {
    let known = diagnostics.len();
    let mut analysis = analyze(&Unit {
        sources,
        files: &part.files,
        stage: part.stage,
        dialect: part.dialect,
        infer_channels: part.infer_channels,
    });
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    let count = |found: &[Diagnostic]| found.iter().filter(is_error).count();
    let errors = count(&analysis.diagnostics);
    if part.extent != Extent::Whole {
        keep_certain(sources, part.extent, &mut analysis);
    }
    // What is uncertain shows that the shader is not all here.
    let is_known = errors == count(&analysis.diagnostics);
    let mut left_out = 0;
    let unrun = if is_known && part.extent != Extent::Excerpt {
        let mut found = Vec::new();
        let (program, errors) = (&analysis.program, &analysis.diagnostics);
        let unrun = lint_within(program, part.host, errors, RULES, settings, &mut found);
        if unrun != Unrun::Everywhere {
            allows.apply(&analysis.program, RULES, &mut found);
        }
        if let Unrun::Functions { broken, .. } = &unrun {
            allows.excuse(broken);
        }
        found.sort_by_key(|d| (d.span.start, d.span.end));
        left_out = found.len().saturating_sub(MAX_FINDINGS);
        found.truncate(MAX_FINDINGS);
        diagnostics.append(&mut found);
        unrun
    } else {
        Unrun::Everywhere
    };
    diagnostics.extend(analysis.diagnostics);
    let own = diagnostics.get_mut(known..).unwrap_or(&mut []);
    if own.iter().any(|d| d.fix.is_some()) {
        let mut comments = analysis.program.tokens.comments.clone();
        comments.sort();
        for diagnostic in own {
            keep_comments(sources, &comments, diagnostic);
        }
    }
    let judged = (errors > 0).then(|| Judged::of(&analysis.program));
    let shader = Shader {
        file: part.files.last().copied(),
        stage: part.stage,
        dialect: part.dialect,
        version: analysis.program.version,
        extent: part.extent,
        unrun,
        has_errors: errors > 0,
        left_out,
        size: analysis.program.size(),
    };
    (shader, judged)
}

/// What was read as one shader, and how far rules looked at it.
#[derive(Clone, Debug)]
pub struct Shader {
    /// Its last file.
    pub file: Option<FileId>,
    /// The stage.
    pub stage: Stage,
    /// How many tokens and macro calls it has.
    pub size: usize,
    /// Who runs it.
    pub dialect: Dialect,
    /// The version of the language.
    pub version: Version,
    /// How much of it is at hand.
    pub extent: Extent,
    /// Where no rule looked.
    pub unrun: Unrun,
    /// Whether the browser would refuse it as it stands.
    pub has_errors: bool,
    /// Findings of the rules that are not kept, since there are too many.
    pub left_out: usize,
}

/// Most findings of the rules in one shader; whoever mends these sees the next.
const MAX_FINDINGS: usize = 500;

/// Keeps what is wrong whatever the rest of the shader is.
fn keep_certain(sources: &Sources, extent: Extent, analysis: &mut Analysis) {
    let program = &analysis.program;
    let is_own = |name: &str| {
        let functions = program.functions.iter();
        functions
            .into_iter()
            .any(|f| program.names.text(f.name) == name)
    };
    let is_user = |span: Span| {
        let file = sources.file_at(span.start);
        file.is_some_and(|f| f.role == Role::User && f.span().contains(span))
    };
    // An excerpt leaves bodies out, by `...` or a comment.
    let is_left_out = |d: &Diagnostic| extent == Extent::Excerpt && d.rule == error::MISSING_RETURN;
    analysis.diagnostics.retain(|d| {
        is_user(d.span) && !is_left_out(d) && is_certain(d, sources.text(d.span), is_own)
    });
    for diagnostic in &mut analysis.diagnostics {
        diagnostic.labels.retain(|l| is_user(l.span));
    }
}

/// Makes the one shader of a shader file. `None` where it is too large.
pub(super) fn shader_part(
    read: &mut Read,
    name: &str,
    file: FileId,
    text: &str,
    options: &Options,
) -> Option<()> {
    let told = guess(text);
    let extension = ending(name);
    let extension = extension.as_str();
    let is_stage_file = matches!(extension, "frag" | "vert" | "fs" | "vs" | "fsh" | "vsh");
    let kind = match options.dialect {
        DialectChoice::Shadertoy => match told.kind {
            Some(Kind::ShaderToy(pass)) => Kind::ShaderToy(pass),
            _ => Kind::ShaderToy(Pass::Common),
        },
        DialectChoice::Webgl1 => Kind::WebGl1,
        DialectChoice::Webgl2 if told.kind == Some(Kind::Versioned) => Kind::Versioned,
        DialectChoice::Webgl2 => Kind::WebGl2,
        DialectChoice::Auto => match told.kind {
            Some(Kind::ShaderToy(pass)) => Kind::ShaderToy(pass),
            _ if is_common(name, text, options) => Kind::ShaderToy(Pass::Common),
            // What a stage's file holds is compiled as it stands: without `#version` it is 1.00.
            _ if is_stage_file => Kind::Versioned,
            Some(kind) => kind,
            None => Kind::ShaderToy(Pass::Common),
        },
    };
    let stage = match (kind, extension) {
        (Kind::ShaderToy(_), _) => Stage::Fragment,
        (_, "vert" | "vs" | "vsh") => Stage::Vertex,
        (_, "frag" | "fs" | "fsh") => Stage::Fragment,
        _ => told.stage.unwrap_or(Stage::Fragment),
    };
    let is_three = options.host.is_three && told.kind != Some(Kind::Versioned);
    let header = match kind {
        Kind::ShaderToy(pass) => Some(shadertoy_header(pass, [None; 4])),
        _ if is_three => Some(three_header(stage)),
        Kind::WebGl2 => Some("#version 300 es\n".to_string()),
        Kind::Versioned | Kind::WebGl1 => None,
    };
    let own = spread(read, name, file, text, options)?;
    let extent = if own.is_open {
        Extent::Open
    } else {
        Extent::Whole
    };
    let files = with_host(&mut read.sources, header, own.files, options)?;
    let dialect = match kind {
        Kind::ShaderToy(pass) => Dialect::ShaderToy(pass),
        Kind::WebGl2 => Dialect::WebGl { whole: false },
        _ => Dialect::WebGl { whole: true },
    };
    read.parts.push(Part {
        files,
        stage,
        dialect,
        infer_channels: dialect.is_shadertoy(),
        extent,
        host: Host::default(),
    });
    Some(())
}

/// Puts what the host declares where it belongs: before the text, but behind `#version`.
pub fn with_host(
    sources: &mut Sources,
    header: Option<String>,
    own: Vec<FileId>,
    options: &Options,
) -> Option<Vec<FileId>> {
    let declared = declarations(sources, &own, &options.host.uniforms);
    let Some(header) = header else {
        if declared.is_empty() {
            return Some(own);
        }
        let prelude = sources.add("", None, Role::Prelude, declared)?;
        return behind_version(sources, own, prelude);
    };
    let mut files = vec![sources.add("", None, Role::Prelude, header + &declared)?];
    files.extend(own);
    Some(files)
}

/// Declares the host's uniforms, without those that the shader declares itself.
fn declarations(sources: &Sources, own: &[FileId], uniforms: &[HostUniform]) -> String {
    let texts = || own.iter().filter_map(|id| Some(sources.code(*id)?.text));
    let mut text = String::new();
    for uniform in uniforms {
        let HostUniform { name, ty, size } = uniform;
        if texts().any(|code| declares(code, name)) {
            continue;
        }
        let precision = if ty.starts_with('b') { "" } else { "highp " };
        let size = size.map_or(String::new(), |s| format!("[{s}]"));
        text.push_str(&format!("uniform {precision}{ty} {name}{size};\n"));
    }
    text
}

/// Whether a text declares a uniform of this name.
fn declares(code: &str, name: &str) -> bool {
    if !code.contains(name) {
        return false;
    }
    let mut lexer = Lexer::new(code, 0);
    let mut in_uniform = false;
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        match (token.kind, code.get(range).unwrap_or("")) {
            (RawKind::End, _) => return false,
            (RawKind::Word, "uniform") => in_uniform = true,
            (RawKind::Word, word) if in_uniform && word == name => return true,
            (_, ";") => in_uniform = false,
            _ => {}
        }
    }
}

/// Puts a prelude behind the line with `#version`, or in front where there is none.
fn behind_version(sources: &mut Sources, own: Vec<FileId>, prelude: FileId) -> Option<Vec<FileId>> {
    let mut own = own.into_iter();
    let first = own.next()?;
    let code = sources.code(first)?;
    let (text, base) = (code.text.to_string(), code.base);
    let mut files = Vec::new();
    match version_end(&text) {
        None => files.extend([prelude, first]),
        Some(behind) => {
            let file = sources.file_id_at(base)?;
            let offset = (base - sources.file(file)?.base) as usize;
            files.push(sources.embed(file, offset, text.get(..behind)?)?);
            files.push(prelude);
            files.push(sources.embed(file, offset + behind, text.get(behind..)?)?);
        }
    }
    files.extend(own);
    Some(files)
}

/// Where the line behind `#version` starts.
fn version_end(text: &str) -> Option<usize> {
    let mut lexer = Lexer::new(text, 0);
    let mut after_hash = false;
    let mut seen = false;
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        match token.kind {
            RawKind::End => return None,
            RawKind::Newline if seen => return Some(range.end),
            RawKind::Hash => after_hash = true,
            RawKind::Word => {
                seen |= after_hash && text.get(range) == Some("version");
                after_hash = false;
            }
            _ => {}
        }
    }
}
