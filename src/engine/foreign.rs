//! Shaders in languages that WebGL cannot compile: desktop GLSL, HLSL, Metal, WGSL. Each gets one
//! finding.

use super::input::SplitInput;
use super::options::{Desktop, Options};
use super::version;
use shaderlint_detect::embed::Embedded;
use shaderlint_detect::kind::{Decision, Evidence, ShaderLanguage, reason};
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_text::{FileId, Span};

/// Whether desktop GLSL is checked as GLSL ES 3.00.
pub fn is_ported(language: ShaderLanguage, options: &Options) -> bool {
    language == ShaderLanguage::Desktop && options.desktop == Desktop::Port
}

/// Whether a text is desktop GLSL that is reported, unless a known host runs it.
pub(super) fn is_reported(text: &str, options: &Options) -> bool {
    options.desktop == Desktop::Report
        && Evidence::of(text).foreign() == Some(ShaderLanguage::Desktop)
}

/// Reports a file in another language.
pub(super) fn report_file(
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
pub(super) fn inside(
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
            .fix(version::as_webgl2(text, base, span))
            .help("set `desktop = \"port\"` in shaderlint.toml to check it as GLSL ES 3.00, or `desktop = \"skip\"` to skip it");
    }
    let sign = evidence.first_sign(language).unwrap_or(0..0);
    let span = Span::new(base + sign.start as u32, base + sign.end as u32);
    let message = format!("WebGL does not support {language}");
    Diagnostic::of(kind, Severity::Info, span, message)
        .note(format!("{why}; it is not checked further"))
        .help("set `desktop = \"skip\"` in shaderlint.toml to skip it")
}
