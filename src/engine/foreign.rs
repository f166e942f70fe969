//! Shaders in languages that WebGL does not compile: GLSL for OpenGL and Vulkan, HLSL, Metal, WGSL.
//! One thing is said of each, and nothing is mended unasked.

use super::input::SplitInput;
use super::options::{Desktop, Options};
use super::part::Part;
use super::reading::Reading;
use super::repair::repair;
use shaderlint_diagnostic::{Applicability, Diagnostic, Facet, Severity, error};
use shaderlint_host::{Preset, preset};
use shaderlint_port::{Completion, Project, calls_entry, hosted as ported_by_host};
use shaderlint_semantic::{Dialect, guess};
use shaderlint_text::embed::Embedded;
use shaderlint_text::kind::{Decision, Evidence, Tongue, reason};
use shaderlint_text::{FileId, Role, Sources, Span};
use std::sync::Arc;

/// Whether a shader is checked as what it is to become.
pub fn is_ported(tongue: Tongue, options: &Options) -> bool {
    tongue == Tongue::Desktop && options.desktop == Desktop::Port
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

/// Whether the user says that a host runs a text which is a pass of ShaderToy by what it holds.
pub(super) fn is_pass_of_another(text: &str, options: &Options) -> bool {
    let host = options.host.preset.as_deref();
    host.is_some_and(calls_entry) && guess(text).is_shadertoy()
}

/// Makes a part of a desktop shader that a known host runs, of what it becomes there. Gives whether
/// there is such a host.
pub(super) fn hosted(
    input: &mut SplitInput,
    file: FileId,
    text: &str,
    options: &Options,
) -> Option<bool> {
    let given = options.host.preset.as_deref();
    let given = given.and_then(|own| preset(own.name));
    let Some(found) = ported_by_host(text, given) else {
        return Some(false);
    };
    let sources = Arc::make_mut(&mut input.sources);
    let files = pieces(sources, file, text, &found.completion)?;
    input.parts.push(Part::hosted(Reading {
        files,
        stage: found.completion.stage,
        dialect: Dialect::WebGl,
    }));
    input.hosted = Some(found.recognised.host);
    Some(true)
}

/// Leaves out what GLSL of desktops takes and the port puts right unasked: conversions, words, and
/// all of it where nothing is wrong any more behind that.
pub(super) fn leave_repaired(host: &'static Preset, text: &str, diagnostics: &mut Vec<Diagnostic>) {
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    let is_safe = |d: &Diagnostic| {
        let fix = d.fix.as_ref();
        fix.is_some_and(|fix| fix.applicability == Applicability::Safe)
    };
    let is_desktop = |d: &Diagnostic| d.kind.is_some_and(|kind| kind.has(Facet::Desktop));
    diagnostics.retain(|d| !is_desktop(d) || !is_safe(d));
    let mut errors = diagnostics.iter().filter(|d| is_error(d)).peekable();
    let is_left = errors.peek().is_some() && errors.all(is_desktop);
    if is_left && is_repaired(host, text).unwrap_or(false) {
        diagnostics.retain(|d| !is_error(d));
    }
}

/// Whether the port's repairs make a shader of a host one that compiles.
fn is_repaired(host: &'static Preset, text: &str) -> Option<bool> {
    let mut project = Project::draft("", text, Some(host)).ok()?;
    let composed = project.resolve("").ok()?;
    repair(&mut project, &composed, "")?;
    Some(!project.resolve("").ok()?.has_errors())
}

/// The text of a file with what goes around it and the changes in it. What is a comment there has
/// the same length here, so that places stay.
fn pieces(
    sources: &mut Sources,
    file: FileId,
    text: &str,
    completion: &Completion,
) -> Option<Vec<FileId>> {
    let mut code = text.as_bytes().to_vec();
    let hidden = completion.changes.iter().filter(|c| c.is_hidden);
    for byte in hidden.flat_map(|c| c.range.clone()) {
        match code.get_mut(byte) {
            Some(b'\n' | b'\r') | None => {}
            Some(byte) => *byte = b' ',
        }
    }
    let code = String::from_utf8(code).ok()?;
    let mut files = Vec::new();
    let mut from = 0;
    if !completion.before.is_empty() {
        files.push(sources.add("", None, Role::Prelude, completion.before.clone())?);
    }
    for change in completion.changes.iter().filter(|c| !c.is_hidden) {
        files.push(sources.embed(file, from, code.get(from..change.range.start)?)?);
        files.push(sources.add("", None, Role::Prelude, change.put.clone())?);
        from = change.range.end;
    }
    files.push(sources.embed(file, from, code.get(from..)?)?);
    if !completion.behind.is_empty() {
        files.push(sources.add("", None, Role::Prelude, completion.behind.clone())?);
    }
    Some(files)
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
