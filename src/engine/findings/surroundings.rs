//! Findings that depend on what is around a shader: a document, a script, a host.

use super::stage::{ShaderCheck, ask_first};
use crate::hosts::hosted;
use shaderlint_detect::embed::LeadingBlanks;
use shaderlint_diagnostic::{Certainty, Facet, Severity, Subject, error};
use shaderlint_semantic::Completeness;
use shaderlint_syntax::{Version, WordClass, classify};
use std::sync::Arc;

/// Keeps the errors of an excerpt that hold out of context, such as type errors, as warnings. An
/// excerpt may be cut anywhere, list prototypes, or repeat earlier declarations.
pub fn keep_of_excerpt(shader: &mut ShaderCheck) {
    let checked = &mut shader.checked;
    if !shader.part.readings.is_shown() || checked.completeness == Completeness::Complete {
        return;
    }
    checked.diagnostics.retain_mut(|d| {
        if d.severity != Severity::Error {
            return true;
        }
        let holds = d.certainty() == Certainty::Meaning && !d.has(Facet::Declares);
        d.severity = Severity::Warning;
        holds
    });
}

/// Lowers the error about white space before `#version`, if a script may trim it.
pub fn expect_trimmed(shader: &mut ShaderCheck) {
    let part = shader.part;
    if !part.readings.is_handed_over() || part.embedder.leading_blanks != LeadingBlanks::Unknown {
        return;
    }
    let misplaced = shader.checked.diagnostics.iter_mut();
    for d in misplaced.filter(|d| d.subject == Subject::BlankFront) {
        d.severity = Severity::Warning;
        d.notes
            .push("valid if the text is trimmed before it is compiled".to_string());
    }
}

/// Drops findings that depend on names of hosts that were only guessed.
pub fn keep_under_hosts(shader: &mut ShaderCheck) {
    let (sources, readings) = (shader.sources, &shader.part.readings);
    let diagnostics = &mut shader.checked.diagnostics;
    if readings.renames {
        diagnostics.retain(|d| !d.is(error::RESERVED_WORD));
    }
    if readings.is_guessed && !readings.needs_300() {
        // If a host is known only from packages, the text may be compiled as GLSL ES 1.00 by other
        // means.
        diagnostics.retain(|d| {
            let word = classify(sources.text(d.span), Version::Es100);
            let is_free = d.is(error::RESERVED_WORD) && word == WordClass::Plain;
            !d.is(error::BUILTIN_REDEFINITION) && !is_free
        });
    }
}

/// The program around a shader fragment depends on its names.
pub fn ask_before_renaming(shader: &mut ShaderCheck) {
    if shader.checked.completeness != Completeness::Complete {
        let names = shader.checked.diagnostics.iter_mut();
        ask_first(names.filter(|d| d.is(error::RESERVED_WORD)));
    }
}

/// Notes the hosts of a shader fragment in its findings.
pub fn name_hosts(shader: &mut ShaderCheck) {
    if shader.checked.completeness != Completeness::Complete {
        let hosts: Arc<[String]> = shader.part.readings.hosts.as_slice().into();
        let own = shader.checked.diagnostics.iter_mut();
        own.for_each(|d| d.part = Some(hosts.clone()));
    }
}

/// Drops findings about desktop GLSL that the port repairs silently.
pub fn drop_repaired(shader: &mut ShaderCheck) {
    let found = &mut shader.checked.diagnostics;
    hosted::leave_repaired(shader.sources, shader.part, found);
}
