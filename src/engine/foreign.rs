//! Shaders in languages that WebGL does not compile: GLSL for OpenGL and Vulkan, HLSL, Metal, WGSL.
//! One thing is said of each, and nothing is mended unasked.

use super::input::SplitInput;
use super::options::{Desktop, Options};
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_text::embed::Embedded;
use shaderlint_text::kind::{Decision, Evidence, Tongue, reason};
use shaderlint_text::{FileId, Span};

/// Whether a shader is checked as what it is to become.
pub fn is_ported(tongue: Tongue, options: &Options) -> bool {
    tongue == Tongue::Desktop && options.desktop == Desktop::Port
}

/// Whether a text is a shader for desktops of which it is said that WebGL does not compile it, unless
/// a known host runs it.
pub(super) fn is_reported(text: &str, options: &Options) -> bool {
    options.desktop == Desktop::Report && Evidence::of(text).foreign() == Some(Tongue::Desktop)
}

/// Says what is to be said of a file.
pub(super) fn whole(
    input: &mut SplitInput,
    file: FileId,
    text: &str,
    tongue: Tongue,
    decision: &Decision,
) -> Option<()> {
    let base = input.sources.file(file)?.base;
    let evidence = Evidence::of(text);
    let told = tell(&evidence, text, base, tongue, &decision.to_string());
    input.problems.push(told);
    Some(())
}

/// Says what is to be said of a shader inside a file, if it is such a one. Gives whether it is, so
/// that nothing else is said.
pub(super) fn inside(
    input: &mut SplitInput,
    file: FileId,
    embedded: &Embedded,
    options: &Options,
) -> Option<bool> {
    let code = embedded.code.as_str();
    let evidence = Evidence::of(code);
    let Some(tongue) = evidence.foreign().filter(|t| !is_ported(*t, options)) else {
        return Some(false);
    };
    if options.desktop != Desktop::Skip {
        let base = input.sources.file(file)?.base + embedded.start as u32;
        let why = reason(&evidence, tongue);
        let told = tell(&evidence, code, base, tongue, &why);
        input.problems.push(told);
    }
    Some(true)
}

fn tell(evidence: &Evidence, text: &str, base: u32, tongue: Tongue, why: &str) -> Diagnostic {
    let kind = error::UNSUPPORTED_VERSION;
    if let Some(version) = evidence.version.filter(|v| v.is_desktop()) {
        let start = version.at;
        let line = text.get(start..).unwrap_or("");
        let line = line.split(['\n', '\r']).next().unwrap_or("");
        let line = line.split("//").next().unwrap_or("");
        let line = line.split("/*").next().unwrap_or("").trim_end();
        let start = base + start as u32;
        let span = Span::new(start, start + line.len() as u32);
        let message = format!("WebGL2 has no GLSL version {}", version.number);
        return Diagnostic::error(kind, span, message)
            .note("this is GLSL for OpenGL or Vulkan; nothing else is said of it")
            .help("`desktop = \"port\"` in shaderlint.toml checks it as GLSL ES 3.00, `desktop = \"skip\"` passes it over");
    }
    let sign = evidence.first_sign(tongue).unwrap_or(0..0);
    let span = Span::new(base + sign.start as u32, base + sign.end as u32);
    let message = format!("this shader is {tongue}, which WebGL does not compile");
    Diagnostic::of(kind, Severity::Info, span, message)
        .note(format!("{why}; nothing else is said of it"))
        .help("`desktop = \"skip\"` in shaderlint.toml passes it over")
}
