//! Chunks that a text includes and its host does not have.

use super::stage::ShaderCheck;
use super::typo::is_typo;
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_host::{ChunkLibrary, HostChunk, Preset, chunk_names, is_chunk, predecessor};
use shaderlint_project::chunks_in;
use shaderlint_text::{Edit, FileId, Role, Sources, Span};

/// Reports the chunks that a shader includes and does not get.
pub fn report(shader: &mut ShaderCheck) {
    let mut found = of_other_releases(shader).unwrap_or_default();
    shader.checked.diagnostics.append(&mut found);
    report_unknown(shader);
    let key = |d: &Diagnostic| (d.span.start, d.span.end);
    shader.checked.diagnostics.sort_by_key(key);
}

/// The chunks that the release of the library does not have.
fn of_other_releases(shader: &ShaderCheck) -> Option<Vec<Diagnostic>> {
    let (host, library) = library(shader)?;
    let hosts = shader.hosts;
    let release = hosts.release(host, &shader.part.readings);
    let files = shader.part.reading()?.files.iter();
    let found = files.clone().zip(files.skip(1));
    let found = found.filter_map(|(before, inserted)| {
        let (name, span) = inserted_after(shader.sources, *before, *inserted)?;
        let (mut d, other) = missing(name, host.chunk(name)?, (library, release), span)?;
        // A script that knows both names, or asks for the release, has a text for each.
        let is_known = |word: &str| hosts.is_in_script(word, 0);
        let is_open = other.is_some_and(is_known) || is_known(library.asked);
        // An info is not worth reading the repository.
        let is_anywhere = d.severity != Severity::Info;
        if is_open || hosts.adds_chunk(library, name, is_anywhere) {
            return None;
        }
        if hosts.adds_chunk(library, "*", is_anywhere) {
            d.severity = d.severity.min(Severity::Warning);
        }
        Some(d)
    });
    Some(found.collect())
}

/// The host that inserts the chunks of a shader, and its library.
pub fn library(shader: &ShaderCheck) -> Option<(&'static Preset, &'static ChunkLibrary)> {
    let readings = &shader.part.readings;
    if readings.chunks().is_empty() {
        return None;
    }
    readings
        .presets()
        .find_map(|host| Some((host, host.chunk_library()?)))
}

/// The name of a chunk, and where the directive is that it was inserted for: at the end of the text before it.
fn inserted_after(sources: &Sources, before: FileId, inserted: FileId) -> Option<(&str, Span)> {
    let chunk = sources.file(inserted).filter(|f| f.role == Role::Prelude)?;
    let name = chunk.path.strip_prefix('<')?.strip_suffix('>')?;
    let before = sources.code(before)?;
    let end = before.base + before.text.len() as u32;
    let file = sources.file_at(end)?;
    let rest = file.text.get((end - file.base) as usize..)?;
    // A name that the script puts in is not there.
    let at = rest.find('<')? + 1;
    let is_there = rest.get(at..)?.strip_prefix(name)?.starts_with('>');
    let start = end + at as u32;
    is_there.then(|| (name, Span::new(start, start + name.len() as u32)))
}

/// The finding about a chunk that a release of its library does not have, and the chunk to use instead.
fn missing(
    name: &str,
    chunk: &HostChunk,
    (library, release): (&ChunkLibrary, Option<u32>),
    span: Span,
) -> Option<(Diagnostic, Option<&'static str>)> {
    let (first, last) = (*chunk.releases.start(), *chunk.releases.end());
    if release.map_or(last == u32::MAX, |now| chunk.releases.contains(&now)) {
        return None;
    }
    let (title, accepted) = (library.title, chunk.accepted.max(last));
    let why = match chunk.successor {
        Some(new) => format!("it became `{new}` in r{}", last.saturating_add(1)),
        None => format!("r{last} was the last release with it"),
    };
    let early = release.filter(|now| *now < first);
    let which = match (release, early) {
        (_, Some(now)) => format!("exists from r{first} on; {title} is r{now} here"),
        (Some(now), _) if now <= accepted => {
            format!("is an old name, which {title} accepts until r{accepted}; {why}")
        }
        (Some(now), _) => format!("does not exist in {title} r{now}; {why}"),
        (None, _) => format!("does not exist in {title} after r{accepted}; {why}"),
    };
    let severity = match release {
        Some(now) if early.is_none() && now <= accepted => Severity::Warning,
        Some(_) => Severity::Error,
        None => Severity::Info,
    };
    let other = early.map_or(chunk.successor, |now| predecessor(name, now));
    let fix = other.map(|other| {
        let (title, edits) = (format!("use `{other}`"), vec![Edit::replace(span, other)]);
        match release {
            Some(_) => Fix::safe(title, edits),
            None => Fix::suggestion(title, edits),
        }
    });
    let message = format!("`{name}` {which}");
    let found = Diagnostic::of(error::BAD_DIRECTIVE, severity, span, message);
    Some((found.fix(fix), other))
}

/// Reports misspelled names of chunks. Other unknown names may be chunks of the program.
fn report_unknown(shader: &mut ShaderCheck) {
    let readings = &shader.part.readings;
    if readings.hosts.is_empty() || !readings.has_gaps() {
        return;
    }
    let has_chunks = |p: &&Preset| !p.chunks.is_empty() && p.base.is_none();
    let Some(host) = readings.presets().find(has_chunks) else {
        return;
    };
    let files = shader
        .part
        .reading()
        .map_or(&[][..], |r| r.files.as_slice());
    for id in files {
        let Some(code) = shader.sources.code(*id).filter(|c| c.role == Role::User) else {
            continue;
        };
        for chunk in chunks_in(code.text)
            .iter()
            .filter(|chunk| !is_chunk(&chunk.name))
        {
            let name = chunk.name.as_str();
            let Some(near) = chunk_names().filter(|known| is_typo(name, known)).min() else {
                continue;
            };
            let is_own = shader.hosts.is_used_outside(name, 1);
            let directive = code.text.get(chunk.range.clone()).unwrap_or("");
            let Some(at) = directive.find(name).filter(|_| !is_own) else {
                continue;
            };
            let start = code.base + (chunk.range.start + at) as u32;
            let span = Span::new(start, start + name.len() as u32);
            let severity = match readings.are_hosts_complete {
                true => Severity::Error,
                false => Severity::Warning,
            };
            let message = format!("{} has no chunk `{name}`", host.title);
            let found = Diagnostic::of(error::BAD_DIRECTIVE, severity, span, message);
            let edits = vec![Edit::replace(span, near)];
            let fix = Fix::suggestion(format!("did you mean `{near}`?"), edits);
            shader.checked.diagnostics.push(found.fix(Some(fix)));
        }
    }
}
