//! Names that the library of a host no longer declares for its shaders.

use crate::hosts::host::Hosts;
use crate::shader::shader_input::ShaderInput;
use shaderlint_diagnostic::{Diagnostic, Severity};
use shaderlint_host::was_in_chunk;
use shaderlint_text::Sources;

/// Takes such names out of the undeclared ones, and returns the findings about them. Those that the release in
/// use still declares are left out.
pub fn take(
    unknown: &mut Vec<Diagnostic>,
    (sources, part): (&Sources, &ShaderInput),
    hosts: &Hosts,
    count: impl Fn(&str) -> usize,
) -> Vec<Diagnostic> {
    let readings = &part.readings;
    let mut found = Vec::new();
    let Some(host) = readings.presets().find(|p| !p.removed.is_empty()) else {
        return found;
    };
    unknown.retain(|d| {
        let word = sources.text(d.span);
        let Some(removed) = host.removed.iter().find(|r| r.name == word) else {
            return true;
        };
        let release = hosts.release(host, readings);
        let asked = host.chunk_library().map(|library| library.asked);
        let is_asked = asked.is_some_and(|name| hosts.is_in_script(name, 0));
        if is_asked || release.is_some_and(|now| now < removed.release) {
            return false;
        }
        // Shaders that include chunks are written for the release that has them.
        let is_of_chunk = release.is_none() && was_in_chunk(word);
        if is_of_chunk || hosts.may_be_declared_outside(word, count(word)) {
            return true;
        }
        let (title, since) = (&host.title, removed.release);
        found.push(Diagnostic {
            severity: match release.is_some() && readings.are_hosts_complete {
                true => Severity::Error,
                false => Severity::Warning,
            },
            message: format!("{title} removed `{word}` in r{since}"),
            fix: None,
            help: vec![removed.advice.clone()],
            ..d.clone()
        });
        false
    });
    found
}
