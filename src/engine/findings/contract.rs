//! What the program around the shaders of a script sets, compared with what they declare.

use super::stage::FileCheck;
use crate::contracts::contract;
use shaderlint_contract::Breach;
use shaderlint_diagnostic::{Diagnostic, Origin, Severity};
use shaderlint_lint::Settings;
use shaderlint_rules::rule;
use shaderlint_script::ScriptPlace;
use shaderlint_text::{FileId, Role, Span};
use std::sync::Arc;

/// Adds what is wrong between the program and its shaders.
pub fn report(file: &mut FileCheck) {
    let text = file.report.file.and_then(|id| file.report.sources.file(id));
    let Some(text) = text.map(|f| f.text.clone()) else {
        return;
    };
    let (options, files) = (file.context.options, file.context.files);
    let Some(contract) = contract(file.name, &text, options, files) else {
        return;
    };
    let mut ids: Vec<Option<FileId>> = vec![None; contract.files.len()];
    if let Some(first) = ids.first_mut() {
        *first = file.report.file;
    }
    for breach in contract.breaches.iter().cloned() {
        let mut span = |place: ScriptPlace| {
            let id = ids.get_mut(place.file)?;
            if id.is_none() {
                let (path, text) = contract.files.get(place.file)?;
                let path = path.to_string_lossy();
                let sources = Arc::make_mut(&mut file.report.sources);
                *id = sources.add(path, None, Role::User, text.clone());
            }
            let base = file.report.sources.file((*id)?)?.base;
            Some(Span::new(base + place.start, base + place.end))
        };
        let place = span(breach.place);
        let label = breach
            .label
            .as_ref()
            .and_then(|(place, text)| Some((span(*place)?, text.clone())));
        let settings = &file.context.options.settings;
        let others = &file.report.diagnostics;
        let is_known = |d: &Diagnostic| {
            let spans = || std::iter::once(d.span).chain(d.labels.iter().map(|l| l.span));
            let own = place.iter().chain(label.iter().map(|(span, _)| span));
            d.severity == Severity::Error && own.clone().any(|own| spans().any(|span| span == *own))
        };
        if others.iter().any(is_known) {
            continue;
        }
        let found = place.and_then(|place| diagnostic(breach, place, label, settings));
        file.report.diagnostics.extend(found);
    }
}

fn diagnostic(
    breach: Breach,
    place: Span,
    label: Option<(Span, String)>,
    settings: &Settings,
) -> Option<Diagnostic> {
    let mut d = match rule(breach.rule) {
        Some(rule) => {
            let severity = settings.level(rule)?;
            Diagnostic::new(rule.name, Origin::Rule, severity, place, breach.message)
        }
        None => {
            let (origin, severity) = (Origin::Compiler, Severity::Error);
            Diagnostic::new(breach.rule, origin, severity, place, breach.message)
        }
    };
    if let Some((span, text)) = label {
        d = d.label(span, text);
    }
    if let Some(note) = breach.note {
        d = d.note(note);
    }
    if let Some(help) = breach.help {
        d = d.help(help);
    }
    Some(d)
}
