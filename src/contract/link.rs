//! Both stages of a program that a script puts together.

use crate::breach::Breach;
use crate::interface::{Stages, unit};
use shaderlint_explain::{analyze, link::link};
use shaderlint_script::ScriptPlace;
use shaderlint_semantic::Stage;
use shaderlint_text::{Sources, Span};
use std::sync::Arc;

/// Adds the errors of linking both stages.
pub fn check(stages: &Stages, place: ScriptPlace, found: &mut Vec<Breach>) {
    let (Some(vertex), Some(fragment)) = (&stages.vertex, &stages.fragment) else {
        return;
    };
    // Other texts may declare what is missing.
    if vertex.is_open || fragment.is_open && !fragment.includes_chunks_only {
        return;
    }
    let mut sources = Sources::new();
    let (Some(of_vertex), Some(of_fragment)) =
        (vertex.add(&mut sources), fragment.add(&mut sources))
    else {
        return;
    };
    let sources = Arc::new(sources);
    let (one, other) = (
        analyze(&unit(&sources, &of_vertex, Stage::Vertex)),
        analyze(&unit(&sources, &of_fragment, Stage::Fragment)),
    );
    // A shader with errors does not get that far.
    if one.has_errors() || other.has_errors() || one.program.version != other.program.version {
        return;
    }
    let at = |span: Span| {
        let sides = [(vertex, &of_vertex), (fragment, &of_fragment)];
        sides.into_iter().find_map(|(shader, files)| {
            let base = sources.file(*files.last()?)?.base;
            shader.written(base, span)
        })
    };
    for d in link(&one.program, &other.program) {
        let label = d
            .labels
            .first()
            .and_then(|l| Some((at(l.span)?, l.message.to_string())));
        let mut breach = Breach::new(d.rule, at(d.span).unwrap_or(place), d.message);
        breach.label = label;
        breach.note = d.notes.into_iter().next();
        breach.help = d.help.into_iter().next();
        found.push(breach);
    }
}
