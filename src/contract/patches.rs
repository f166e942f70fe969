//! Changes of the shaders of built-in materials: `onBeforeCompile`.

use crate::breach::{Breach, nearest};
use crate::library::is_given_to_patches;
use shaderlint_host::{chunk_names, is_chunk, presets};
use shaderlint_script::{
    EventKind, ForeignCall, KnownText, ObjectId, ObjectKind, ScriptPlace, ScriptValue, Source,
    World,
};
use std::rc::Rc;

/// The texts that a patch changes.
const STAGES: &[&str] = &["vertexShader", "fragmentShader"];

/// The release of a program that uses the newest one.
pub const NEWEST: u32 = u32::MAX;

/// A change of the shader of a built-in material.
struct Patch<'w> {
    /// The object that `onBeforeCompile` gets.
    shader: ObjectId,
    call: &'w ForeignCall,
    place: ScriptPlace,
    /// What is searched.
    pattern: &'w Rc<KnownText>,
    /// What replaces it.
    new: Option<&'w Rc<KnownText>>,
}

/// Adds what is wrong with changes of built-in materials.
pub fn check(world: &World, release: Option<u32>, found: &mut Vec<Breach>) {
    let all = patches(world);
    for patch in &all {
        let others = all.iter().filter(|p| p.shader == patch.shader);
        let inserted: Vec<&str> = others
            .filter(|p| !std::ptr::eq(p.call, patch.call))
            .filter_map(|p| Some(p.new?.content.as_str()))
            .collect();
        found.extend(unmatched(patch, &inserted, release));
    }
    check_uniforms(world, &all, found);
}

/// The stage whose text a value is, through calls of `replace`.
fn base(world: &World, id: ObjectId) -> Option<(ObjectId, &'static str)> {
    let mut id = id;
    for _ in 0..64 {
        match &world.object(id)?.kind {
            ObjectKind::Foreign(Source::Member(shader, name)) => {
                let stage = STAGES.iter().find(|stage| **stage == &**name)?;
                return Some((*shader, stage));
            }
            ObjectKind::Foreign(Source::Event(_)) => id = world.call_of(id)?.this?,
            _ => return None,
        }
    }
    None
}

fn patches<'w>(world: &'w World) -> Vec<Patch<'w>> {
    let calls = world.events.iter().filter_map(|event| match &event.kind {
        EventKind::Call(call) if &*call.name == "replace" => Some((call, event.place)),
        _ => None,
    });
    let patches = calls.filter_map(|(call, place)| {
        let (shader, _) = base(world, call.this?)?;
        // The shader of a program of its own is another text.
        let is_parameter = matches!(
            world.object(shader)?.kind,
            ObjectKind::Foreign(Source::Unknown)
        );
        let ScriptValue::Text(pattern) = &call.arguments.first()?.0 else {
            return None;
        };
        let new = call.arguments.get(1).and_then(|(value, _)| match value {
            ScriptValue::Text(text) => Some(text),
            _ => None,
        });
        is_parameter.then_some(Patch {
            shader,
            call,
            place: call.arguments.first().map_or(place, |(_, place)| *place),
            pattern,
            new,
        })
    });
    patches.collect()
}

/// A pattern that includes a chunk that three.js does not have.
fn unmatched(patch: &Patch, inserted: &[&str], release: Option<u32>) -> Option<Breach> {
    if patch.pattern.is_open {
        return None;
    }
    let pattern = patch.pattern.content.trim();
    let name = pattern
        .strip_prefix("#include")?
        .trim()
        .strip_prefix('<')?
        .strip_suffix('>')?;
    let own = presets().find_map(|preset| preset.chunk(name));
    let has = own.is_some_and(|chunk| release.is_none_or(|r| chunk.releases.contains(&r)));
    if has || inserted.iter().any(|text| text.contains(pattern)) {
        return None;
    }
    let stem = name.split('.').next().unwrap_or(name);
    let near = match is_chunk(stem) {
        true => Some(stem),
        false => nearest(name, chunk_names()),
    };
    // Another name may be one that a program inserts itself.
    let near = match own {
        Some(chunk) => chunk.successor,
        None => Some(near?),
    };
    let message = match (own, release) {
        (Some(_), Some(release)) if release != NEWEST => {
            format!("no shader of three.js r{release} contains `{pattern}`")
        }
        (Some(chunk), _) => {
            let last = chunk.releases.end();
            format!(
                "no shader of three.js contains `{pattern}` since r{}",
                last + 1
            )
        }
        (None, _) => format!("no shader of three.js contains `{pattern}`"),
    };
    let breach = Breach::new("unmatched-patch", patch.place, message)
        .note("`replace` finds nothing, so the shader is not changed")
        .help(near.map(|near| format!("did you mean `#include <{near}>`?")));
    Some(breach)
}

/// Checks that uniforms which a patch declares are given to the shader, and the reverse.
fn check_uniforms(world: &World, all: &[Patch], found: &mut Vec<Breach>) {
    let mut shaders: Vec<ObjectId> = all.iter().map(|patch| patch.shader).collect();
    shaders.sort_unstable();
    shaders.dedup();
    for shader in shaders {
        let own = || all.iter().filter(|patch| patch.shader == shader);
        if own().any(|patch| patch.new.is_none_or(|text| text.is_open)) {
            continue;
        }
        let uniforms = uniforms_of(world, shader);
        // Where a script sets none, another function may.
        let Some(uniforms) = uniforms.filter(|all| !all.is_empty()) else {
            continue;
        };
        let texts = || own().filter_map(|patch| patch.new);
        let mut declared: Vec<(String, Option<ScriptPlace>)> = Vec::new();
        for text in texts() {
            declared.extend(declarations(text));
        }
        let strays: Vec<&(String, ScriptPlace)> = uniforms
            .iter()
            .filter(|(name, _)| !texts().any(|text| has_word(&text.content, name)))
            .collect();
        for (name, place) in &declared {
            if uniforms.iter().any(|(set, _)| set == name) || is_given_to_patches(name) {
                continue;
            }
            let near = nearest(name, strays.iter().map(|(name, _)| name.as_str()));
            let stray = near.and_then(|near| strays.iter().find(|(name, _)| name == near));
            let message = format!("uniform `{name}` is never set");
            let at = stray.map(|(_, place)| *place).or(*place);
            let Some(at) = at else { continue };
            let breach = Breach::new("unset-uniform", at, message)
                .label(place.filter(|_| stray.is_some()), "declared here")
                .note("it is 0 in the shader")
                .help(Some(format!("set `shader.uniforms.{name}`")));
            found.push(breach);
        }
        let own: Vec<&Patch> = own().collect();
        check_used(&own, &uniforms, &declared, found);
    }
}

/// Checks that a uniform which a patch uses and the script sets is declared.
fn check_used(
    own: &[&Patch],
    uniforms: &[(String, ScriptPlace)],
    declared: &[(String, Option<ScriptPlace>)],
    found: &mut Vec<Breach>,
) {
    for (name, place) in uniforms {
        if declared.iter().any(|(known, _)| known == name) || is_given_to_patches(name) {
            continue;
        }
        let using = own.iter().filter_map(|patch| patch.new).find_map(|text| {
            let at = word_at(&text.content, name)?;
            text.place(at..at + name.len())
        });
        if let Some(using) = using {
            let message = format!("the patch uses `{name}` and does not declare it");
            let breach = Breach::new("unset-uniform", using, message)
                .label(Some(*place), "set here")
                .note("the shader does not compile")
                .help(Some(format!(
                    "add `uniform ... {name};` after `#include <common>`"
                )));
            found.push(breach);
        }
    }
}

/// The uniforms that a script sets on a shader; `None` if others may be set.
fn uniforms_of(world: &World, shader: ObjectId) -> Option<Vec<(String, ScriptPlace)>> {
    let mut found = Vec::new();
    for event in &world.events {
        match &event.kind {
            EventKind::Write { object, key, .. } if is_uniforms(world, *object, shader) => {
                found.push((key.as_ref()?.to_string(), event.place));
            }
            EventKind::Write {
                object,
                key: Some(key),
                ..
            } if *object == shader && &**key == "uniforms" => {
                return None;
            }
            EventKind::Call(call) => {
                let gets = call.arguments.iter().any(|(value, _)| {
                    value
                        .object()
                        .is_some_and(|id| id == shader || is_uniforms(world, id, shader))
                });
                if gets {
                    return None;
                }
            }
            _ => {}
        }
    }
    // `Object.assign(shader.uniforms, ...)` opens the object.
    let is_open = world
        .objects
        .iter()
        .enumerate()
        .any(|(id, object)| object.is_open && is_uniforms(world, id, shader));
    (!is_open).then_some(found)
}

/// Whether an object is `shader.uniforms`.
fn is_uniforms(world: &World, id: ObjectId, shader: ObjectId) -> bool {
    world.member_of(id) == Some((shader, "uniforms"))
}

/// The uniforms that a text declares, with the places of their names.
fn declarations(text: &KnownText) -> Vec<(String, Option<ScriptPlace>)> {
    let content = text.content.as_str();
    let mut found = Vec::new();
    for (at, _) in content.match_indices("uniform ") {
        let is_word = content
            .get(..at)
            .is_some_and(|before| !before.ends_with(is_part));
        let rest = content.get(at..).unwrap_or("");
        let Some(end) = rest.find(';').filter(|_| is_word) else {
            continue;
        };
        let declaration = rest.get(..end).unwrap_or("");
        let name = declaration.split('[').next().unwrap_or("").trim_end();
        let start = name
            .rfind(|c: char| !is_part(c))
            .map_or(0, |space| space + 1);
        let word = name.get(start..).unwrap_or("");
        let place = text.place(at + start..at + start + word.len());
        found.push((word.to_string(), place));
    }
    found
}

fn is_part(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

fn word_at(text: &str, word: &str) -> Option<usize> {
    let found = text.match_indices(word).find(|(at, _)| {
        let before = text.get(..*at).unwrap_or("");
        let after = text.get(at + word.len()..).unwrap_or("");
        !before.ends_with(is_part) && !after.starts_with(is_part)
    });
    found.map(|(at, _)| at)
}

fn has_word(text: &str, word: &str) -> bool {
    word_at(text, word).is_some()
}
