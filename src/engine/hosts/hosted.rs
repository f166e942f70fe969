//! Shaders of known hosts that WebGL cannot compile as they are: each is checked as composed for
//! its host, in the same way as the port does it.

use super::host::Hosts;
use crate::check_context::CheckContext;
use crate::options::{DialectChoice, Options};
use crate::repair::repair;
use crate::shader::input::SplitInput;
use crate::shader::reading::{Reading, Readings};
use crate::shader::shader_input::ShaderInput;
use shaderlint_diagnostic::{Applicability, Diagnostic, Facet, Severity, error};
use shaderlint_explain::Checked;
use shaderlint_host::Preset;
use shaderlint_project::{
    Clues, Hosted, Project, SiblingTexts, TextChange, asks_for_desktop, calls_entry, hosted,
    may_be_composed, read_siblings,
};
use shaderlint_semantic::snippet::is_body;
use shaderlint_semantic::{Dialect, Stage, guess};
use shaderlint_syntax::GlContext;
use shaderlint_text::{FileId, Role, Sources, Span};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// Size limit in bytes of texts that are tested for composing hosts without being asked to.
const MAX_COMPOSED: usize = 200_000;

/// Whether the user names a host for a text that looks like a ShaderToy pass.
pub fn is_pass_of_another(text: &str, options: &Options) -> bool {
    let host = options.host.preset;
    host.is_some_and(|host| calls_entry(host) && !host.composes) && guess(text).is_shadertoy()
}

/// Adds a shader of a known host, which is a file or starts at an offset in one, composed for its
/// host. Returns whether there is such a host.
pub fn part(
    input: &mut SplitInput,
    name: &str,
    (file, start): (FileId, usize),
    text: &str,
    context: CheckContext,
) -> Option<bool> {
    // A host that the user describes runs desktop GLSL only if it says so.
    let takes = |host: &&Preset| {
        let is_pass = is_pass_of_another(text, context.options);
        is_pass || !host.name.is_empty() || host.runs_desktop()
    };
    let given = context.options.host.preset.filter(takes);
    let Some(found) = hosted_with_siblings(name, text, given, context) else {
        return Some(false);
    };
    let sources = Arc::make_mut(&mut input.sources);
    let piece = sources.embed(file, start, text)?;
    let reading = reading(sources, &[piece], &found)?;
    input.parts.push(ShaderInput {
        host: Some(found.recognised.host),
        ..ShaderInput::new(Readings::of_complete(reading))
    });
    Some(true)
}

/// Reads a shader that lacks something as composed by its host, if the user names a composing host
/// or the text shows one. Returns the checked shader.
pub fn compose(
    sources: &mut Arc<Sources>,
    part: &mut ShaderInput,
    hosts: &Hosts,
    options: &Options,
) -> Option<Checked> {
    let given = given_composer(options);
    let is_open = options.dialect == DialectChoice::Auto && options.host.preset.is_none();
    let (text, pieces) = own_text(sources, part)?;
    // A text with a `#version` of WebGL needs none of them; an included one may be of desktop GLSL.
    let is_complete = part.readings.has_version() && !asks_for_desktop(&text);
    let is_candidate = is_open && !is_complete && text.len() <= MAX_COMPOSED;
    if given.is_none() && !(is_candidate && may_be_composed(&text)) {
        return None;
    }
    let found = hosted_with_siblings(hosts.name(), &text, given, hosts.context())?;
    let host = found.recognised.host;
    // What is missing is unknown, so that another host may declare it; a script that imports the file is a
    // program of its own.
    if !found.is_sure() && (part.readings.has_missing() || hosts.is_imported()) {
        return None;
    }
    let is_vertex = found.completion.stage == Stage::Vertex;
    let guessed = guess(&text);
    let has_entry = guessed.has_main || guessed.is_shadertoy() || is_body(&text);
    // Without an entry function, no `main` is appended that would call it.
    let after = &found.completion.after;
    let mut entries = host.entries.iter();
    let lacks_entry = entries.any(|entry| after.contains(entry.as_str()) && !text.contains(entry));
    let is_misread = !has_entry && !after.is_empty() || lacks_entry;
    if !host.composes || is_misread || part.readings.is_vertex() && !is_vertex {
        return None;
    }
    let reading = reading(Arc::make_mut(sources), &pieces, &found)?;
    let mut readings = Readings::of_complete(reading);
    let checked = readings.check(sources, false)?;
    let lacks_main = checked
        .diagnostics
        .iter()
        .any(|d| d.is(error::MISSING_MAIN));
    // The names may belong to an unknown host.
    if !found.is_sure() && checked.has_errors() {
        return None;
    }
    // Missing files may declare the unknown names.
    let is_open = part.readings.has_missing();
    let checked = match lacks_main || is_open {
        true => {
            readings.open(host, is_open);
            readings.check(sources, false)?
        }
        false => checked,
    };
    (part.readings, part.host) = (readings, Some(host));
    (part.infer_channels, part.mipmapped) = (false, [None; 4]);
    Some(checked)
}

/// The host that the user names, if it composes shaders.
pub fn given_composer(options: &Options) -> Option<&'static Preset> {
    options.host.preset.filter(|host| host.composes)
}

/// The user's text of a shader fragment, and its files in order, with includes.
fn own_text(sources: &Sources, part: &ShaderInput) -> Option<(String, Vec<FileId>)> {
    let is_own = |id: &FileId| sources.code(*id).is_some_and(|c| c.role == Role::User);
    let pieces: Vec<FileId> = part
        .reading()?
        .files
        .iter()
        .copied()
        .filter(is_own)
        .collect();
    let codes = pieces.iter().filter_map(|id| sources.code(*id));
    Some((codes.map(|c| c.text).collect(), pieces))
}

/// The user's text of a shader fragment, before its host changed it.
fn text_before(sources: &Sources, part: &ShaderInput) -> Option<String> {
    // Changed text is between two pieces of the same file.
    let mut stretches: Vec<(FileId, Range<u32>)> = Vec::new();
    for id in &part.reading()?.files {
        let Some(code) = sources.code(*id).filter(|c| c.role == Role::User) else {
            continue;
        };
        let file = sources.file_id_at(code.base)?;
        let end = code.base + code.text.len() as u32;
        match stretches.last_mut() {
            Some((last, range)) if *last == file && range.end <= end => range.end = end,
            _ => stretches.push((file, code.base..end)),
        }
    }
    let texts = stretches.iter();
    Some(
        texts
            .map(|(_, r)| sources.text(Span::new(r.start, r.end)))
            .collect(),
    )
}

/// The text that a host composes, with other texts that it refers to.
fn hosted_with_siblings(
    name: &str,
    text: &str,
    given: Option<&'static Preset>,
    context: CheckContext,
) -> Option<Hosted> {
    let title = Path::new(name).file_stem().unwrap_or_default();
    let title = title.to_string_lossy();
    let mut texts = SiblingTexts::new();
    loop {
        let found = hosted(&Clues::with_siblings(text, &title, &texts), given)?;
        let read = read_siblings(name, &found.requested, &mut texts, context.file_access());
        if read != Ok(true) {
            return Some(found);
        }
    }
}

/// Drops findings about desktop GLSL that the port repairs silently: implicit conversions,
/// keywords, or everything if the repaired text has no errors.
pub fn leave_repaired(sources: &Sources, part: &ShaderInput, diagnostics: &mut Vec<Diagnostic>) {
    // A host that does not accept desktop GLSL rejects it, as WebGL does.
    let Some(host) = part.host.filter(|h| !h.composes || h.runs_desktop()) else {
        return;
    };
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    let is_safe = |d: &Diagnostic| {
        let fix = d.fix.as_ref();
        fix.is_some_and(|fix| fix.applicability == Applicability::Safe)
    };
    let is_desktop = |d: &Diagnostic| d.kind.is_some_and(|kind| kind.has(Facet::Desktop));
    diagnostics.retain(|d| !is_desktop(d) || !is_safe(d));
    let mut errors = diagnostics.iter().filter(|d| is_error(d)).peekable();
    let is_left = errors.peek().is_some() && errors.all(is_desktop);
    let text = || text_before(sources, part);
    if is_left && text().is_some_and(|text| is_repaired(host, &text).unwrap_or(false)) {
        diagnostics.retain(|d| !is_error(d));
    }
}

/// Whether the repairs of the port make a shader of a host compile.
fn is_repaired(host: &'static Preset, text: &str) -> Option<bool> {
    let mut project = Project::draft("", text, Some(host)).ok()?;
    let composed = project.resolve("").ok()?;
    repair(&mut project, &composed, "")?;
    Some(!project.resolve("").ok()?.has_errors())
}

/// The files of a text with the host's additions and changes. Changed text is replaced by comments
/// of the same length, so that positions stay valid.
fn reading(sources: &mut Sources, pieces: &[FileId], found: &Hosted) -> Option<Reading> {
    let completion = &found.completion;
    let mut files = Vec::new();
    if !completion.before.is_empty() {
        files.push(sources.add("", None, Role::Prelude, completion.before.clone())?);
    }
    for piece in pieces {
        let code = sources.code(*piece)?;
        let (base, text) = (code.base, code.text.to_string());
        let file = sources.file_id_at(base)?;
        let start = (base - sources.file(file)?.base) as usize;
        put(
            sources,
            (file, start),
            &text,
            &found.changes(&text),
            &mut files,
        )?;
    }
    if !completion.after.is_empty() {
        files.push(sources.add("", None, Role::Prelude, completion.after.clone())?);
    }
    Some(Reading {
        files,
        stage: completion.stage,
        dialect: Dialect::WebGl,
        context: GlContext::WEBGL2,
    })
}

/// Adds a file that starts at an offset, with the changes in it.
fn put(
    sources: &mut Sources,
    (file, start): (FileId, usize),
    text: &str,
    changes: &[TextChange],
    files: &mut Vec<FileId>,
) -> Option<()> {
    let mut code = text.as_bytes().to_vec();
    let hidden = changes.iter().filter(|c| c.is_hidden);
    for byte in hidden.flat_map(|c| c.range.clone()) {
        match code.get_mut(byte) {
            Some(b'\n' | b'\r') | None => {}
            Some(byte) => *byte = b' ',
        }
    }
    let code = String::from_utf8(code).ok()?;
    let mut from = 0;
    for change in changes.iter().filter(|c| !c.is_hidden) {
        files.push(sources.embed(file, start + from, code.get(from..change.range.start)?)?);
        files.push(sources.add("", None, Role::Prelude, change.put.clone())?);
        from = change.range.end;
    }
    files.push(sources.embed(file, start + from, code.get(from..)?)?);
    Some(())
}
