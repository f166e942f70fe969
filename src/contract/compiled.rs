//! What only the program around a shader shows about its compilation: macros with their values, and chunks that
//! the program adds to its library.

use crate::breach::{Breach, nearest};
use crate::interface::{ShaderInterface, unit};
use crate::materials::Material;
use shaderlint_diagnostic::Severity;
use shaderlint_explain::analyze;
use shaderlint_host::is_chunk;
use shaderlint_script::{EventKind, ObjectKind, ScriptPlace, Source, World};
use shaderlint_semantic::Stage;
use shaderlint_text::{Role, Sources};
use std::sync::Arc;

/// Adds what is wrong with the texts of programs of libraries.
pub fn check(world: &World, materials: &[Material], found: &mut Vec<Breach>) {
    let added = added_chunks(world);
    for material in materials {
        let stages = [
            (&material.stages.vertex, Stage::Vertex),
            (&material.stages.fragment, Stage::Fragment),
        ];
        for (shader, stage) in stages {
            let Some(shader) = shader else { continue };
            check_macros(material, shader, stage, found);
            if let Some(added) = added.as_ref().filter(|added| !added.is_empty()) {
                check_chunks(shader, added, found);
            }
        }
    }
}

/// Reports errors that the values of macros cause.
fn check_macros(
    material: &Material,
    shader: &ShaderInterface,
    stage: Stage,
    found: &mut Vec<Breach>,
) {
    if material.macros.is_empty() || shader.text.is_open {
        return;
    }
    let mut sources = Sources::new();
    let Some(files) = shader.add_after(Role::User, &mut sources) else {
        return;
    };
    let sources = Arc::new(sources);
    let checked = analyze(&unit(&sources, &files, stage));
    let base = files
        .last()
        .and_then(|id| sources.file(*id))
        .map_or(0, |f| f.base);
    let is_own = |name: &str| material.macros.iter().any(|(own, _, _)| own == name);
    let errors = checked
        .diagnostics
        .iter()
        .filter(|d| d.severity == Severity::Error);
    for d in errors {
        let mut uses = d.macros.iter().map(|used| used.name.as_str());
        let mut words = words_of(sources.text(d.span));
        let named = d.labels.iter().map(|label| sources.text(label.span));
        let name = uses
            .find(|name| is_own(name))
            .or_else(|| words.find(|word| is_own(word)));
        let name = name.or_else(|| named.flat_map(words_of).find(|word| is_own(word)));
        let given = material
            .macros
            .iter()
            .find(|(own, _, _)| Some(own.as_str()) == name);
        let mut spans = std::iter::once(d.span).chain(d.labels.iter().map(|label| label.span));
        let at = spans.find_map(|span| shader.written(base, span));
        let (Some((name, value, place)), Some(at)) = (given, at) else {
            continue;
        };
        let breach = Breach::new(d.rule, at, d.message.clone())
            .label(Some(*place), format!("`{name}` is `{value}`"))
            .help(d.help.first().cloned());
        found.push(breach);
    }
}

/// The words of a text.
fn words_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}

/// The chunks that a program adds to its library; `None` if there may be others.
fn added_chunks(world: &World) -> Option<Vec<String>> {
    let mut found = Vec::new();
    for event in &world.events {
        let EventKind::Write { object, key, .. } = &event.kind else {
            continue;
        };
        let registry = world.object(*object);
        let is_registry = match registry.map(|o| &o.kind) {
            Some(ObjectKind::Foreign(Source::Member(_, name) | Source::Package(_, name))) => {
                &**name == "ShaderChunk"
            }
            _ => false,
        };
        if is_registry {
            found.push(key.as_ref()?.to_string());
        }
        if is_registry && registry.is_some_and(|o| o.is_open) {
            return None;
        }
    }
    Some(found)
}

/// Reports included chunks that neither the library nor the program has, if one of the program looks like them.
fn check_chunks(shader: &ShaderInterface, added: &[String], found: &mut Vec<Breach>) {
    let text = shader.text.content.as_str();
    for (at, include) in text.match_indices("#include <") {
        let start = at + include.len();
        let rest = text.get(start..).unwrap_or("");
        let name = rest.split('>').next().unwrap_or("");
        if is_chunk(name) || added.iter().any(|own| own == name) {
            continue;
        }
        let near = nearest(name, added.iter().map(String::as_str));
        let place: Option<ScriptPlace> = shader.text.place(start..start + name.len());
        if let (Some(near), Some(place)) = (near, place) {
            let message = format!("there is no chunk `{name}`");
            let breach = Breach::new("bad-directive", place, message)
                .note("the library throws an exception for a chunk that it does not have")
                .help(Some(format!("did you mean `{near}`?")));
            found.push(breach);
        }
    }
}
