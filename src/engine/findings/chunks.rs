//! Chunks that a text includes and its host does not have.

use super::stage::ShaderCheck;
use super::typo::is_typo;
use shaderlint_diagnostic::{Diagnostic, Fix, Severity, error};
use shaderlint_host::{chunk_names, is_chunk, presets};
use shaderlint_project::chunks_in;
use shaderlint_text::{Edit, Role, Span};

/// Reports misspelled names of chunks. Other unknown names may be chunks of the program.
pub fn report_unknown(shader: &mut ShaderCheck) {
    let readings = &shader.part.readings;
    if readings.hosts.is_empty() || !readings.has_gaps() {
        return;
    }
    let mut hosts = presets().filter(|p| !p.chunks.is_empty() && p.base.is_none());
    let Some(host) = hosts.find(|p| readings.hosts.contains(&p.title)) else {
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
    let key = |d: &Diagnostic| (d.span.start, d.span.end);
    shader.checked.diagnostics.sort_by_key(key);
}
