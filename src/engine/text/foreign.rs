//! Shaders in languages that WebGL cannot compile: desktop GLSL, HLSL, Metal, WGSL. Each gets one
//! finding.

use crate::options::{Desktop, Options};
use crate::shader::input::SplitInput;
use shaderlint_detect::embed::Embedded;
use shaderlint_detect::kind::{Decision, Evidence, ShaderLanguage, reason};
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_explain::analyze;
use shaderlint_semantic::{Completeness, Dialect, Stage, Unit};
use shaderlint_syntax::GlContext;
use shaderlint_text::{Edit, FileId, Role, Sources, Span, apply_edits};
use std::sync::Arc;

const DIRECTIVE: &str = "#version 300 es";

/// Whether desktop GLSL is checked as GLSL ES 3.00.
pub fn is_ported(language: ShaderLanguage, options: &Options) -> bool {
    language == ShaderLanguage::Desktop && options.desktop == Desktop::Port
}

/// Whether a text is desktop GLSL that is reported, unless a known host runs it.
pub fn is_reported(text: &str, options: &Options) -> bool {
    options.desktop == Desktop::Report
        && Evidence::of(text).foreign() == Some(ShaderLanguage::Desktop)
}

/// Reports a file in another language.
pub fn report_file(
    input: &mut SplitInput,
    file: FileId,
    text: &str,
    language: ShaderLanguage,
    decision: &Decision,
) -> Option<()> {
    let base = input.sources.file(file)?.base;
    let evidence = Evidence::of(text);
    let diagnostic = report(&evidence, text, base, language, &decision.to_string());
    input.problems.push(diagnostic);
    Some(())
}

/// Reports an embedded shader in another language. Returns whether it is one, so that it is not
/// checked further.
pub fn inside(
    input: &mut SplitInput,
    file: FileId,
    embedded: &Embedded,
    options: &Options,
) -> Option<bool> {
    let code = embedded.code.as_str();
    let evidence = Evidence::of(code);
    let Some(language) = evidence.foreign().filter(|t| !is_ported(*t, options)) else {
        return Some(false);
    };
    if options.desktop != Desktop::Skip {
        let base = input.sources.file(file)?.base + embedded.start as u32;
        let why = reason(&evidence, language);
        let diagnostic = report(&evidence, code, base, language, &why);
        input.problems.push(diagnostic);
    }
    Some(true)
}

fn report(
    evidence: &Evidence,
    text: &str,
    base: u32,
    language: ShaderLanguage,
    why: &str,
) -> Diagnostic {
    let kind = error::UNSUPPORTED_VERSION;
    if let Some(version) = evidence.version.filter(|v| v.is_desktop()) {
        let start = version.at;
        let line = text.get(start..).unwrap_or("");
        let line = line.split(['\n', '\r']).next().unwrap_or("");
        let line = line.split("//").next().unwrap_or("");
        let line = line.split("/*").next().unwrap_or("").trim_end();
        let start = base + start as u32;
        let span = Span::new(start, start + line.len() as u32);
        let message = format!("`#version {}` is not supported by WebGL2", version.number);
        return Diagnostic::error(kind, span, message)
            .note("desktop GLSL for OpenGL or Vulkan is not checked further")
            .fix(as_webgl2(text, base, span))
            .help("set `desktop = \"port\"` in shaderlint.toml to check it as GLSL ES 3.00, or `desktop = \"skip\"` to skip it");
    }
    let sign = evidence.first_sign(language).unwrap_or(0..0);
    let span = Span::new(base + sign.start as u32, base + sign.end as u32);
    let message = format!("WebGL does not support {language}");
    Diagnostic::of(kind, Severity::Info, span, message)
        .note(format!("{why}; it is not checked further"))
        .help("set `desktop = \"skip\"` in shaderlint.toml to skip it")
}

/// Declares what desktop GLSL has by default.
const PRECISION: &str = "precision highp float;";

/// Replaces the `#version` of desktop GLSL, if the text then compiles: alone, with a default
/// precision, or with the fixes of all errors that this reveals.
fn as_webgl2(text: &str, base: u32, directive: Span) -> Option<Fix> {
    let plain = DIRECTIVE.to_string();
    let precise = format!("{plain}\n{PRECISION}");
    let variants = [
        (Stage::Fragment, &plain),
        (Stage::Fragment, &precise),
        (Stage::Vertex, &plain),
    ];
    let first = Edit::replace(directive, "");
    variants.into_iter().find_map(|(stage, head)| {
        let mut edits = vec![Edit {
            text: head.clone(),
            ..first.clone()
        }];
        let fixed = apply_edits(text, base, &edits).ok()?;
        let errors = errors_of(fixed, stage)?;
        let shift = (head.len() as u32).checked_sub(directive.len());
        let original = |at: u32| match shift {
            Some(longer) => at.checked_sub(longer),
            None => Some(at + (directive.len() - head.len() as u32)),
        };
        for error in &errors {
            let fix = error.fix.as_ref()?;
            for edit in &fix.edits {
                let start = original(edit.span.start)? + base;
                let end = original(edit.span.end)? + base;
                if start < directive.end {
                    return None;
                }
                edits.push(Edit::replace(Span::new(start, end), edit.text.clone()));
            }
        }
        edits.sort_by_key(|e| e.span);
        edits.dedup();
        let fixed = apply_edits(text, base, &edits).ok()?;
        errors_of(fixed, stage)?.is_empty().then_some(())?;
        let title = match errors.len() {
            0 if *head == plain => format!("use `{DIRECTIVE}`"),
            0 => format!("use `{DIRECTIVE}` and `{PRECISION}`"),
            _ => format!("use `{DIRECTIVE}` and fix the errors that this reveals"),
        };
        Some(Fix::suggestion(title, edits))
    })
}

/// The errors of a complete shader, with positions in its text.
fn errors_of(text: String, stage: Stage) -> Option<Vec<Diagnostic>> {
    let mut sources = Sources::new();
    let file = sources.add("", None, Role::User, text)?;
    let checked = analyze(&Unit {
        sources: &Arc::new(sources),
        files: &[file],
        stage,
        dialect: Dialect::WebGl,
        context: GlContext::WEBGL2,
        infer_channels: false,
        completeness: Completeness::Complete,
    });
    let mut errors = checked.diagnostics;
    errors.retain(|d| d.severity == Severity::Error);
    Some(errors)
}
