//! Uniform blocks: their names, and the buffers that fill them; samplers that share a texture unit.

use super::replay::{GlReplay, argument, constant, place_of};
use crate::breach::{Breach, nearest};
use crate::shape::length;
use shaderlint_script::{EventKind, ForeignCall, ObjectId, ScriptPlace, ScriptValue, World};
use shaderlint_semantic::{Base, BlockLayout, Sampler};
use std::collections::HashMap;

/// The buffers of a program.
#[derive(Default)]
struct Buffers {
    /// The buffer that is bound for uniforms.
    bound: Option<ObjectId>,
    /// By buffer: its bytes, with the place where it is filled.
    sizes: HashMap<ObjectId, (f64, ScriptPlace)>,
    /// By binding: the buffer.
    bindings: HashMap<u32, ObjectId>,
    /// Whether several buffers use a binding in turns.
    is_shared: bool,
    /// Parts that are written: the buffer, the first byte and the place.
    parts: Vec<(ObjectId, f64, ScriptPlace)>,
}

/// Adds what is wrong with uniform blocks.
pub fn check(replay: &GlReplay, found: &mut Vec<Breach>) {
    let world = replay.world;
    let mut buffers = Buffers::default();
    // By result of `getUniformBlockIndex`: the program and the name.
    let mut indices: HashMap<ObjectId, (ObjectId, String)> = HashMap::new();
    let mut blocks: Vec<(ObjectId, String, u32)> = Vec::new();
    for event in &world.events {
        let EventKind::Call(call) = &event.kind else {
            continue;
        };
        match &*call.name {
            "getUniformBlockIndex" => {
                let program = argument(call, 0).and_then(ScriptValue::object);
                let name = argument(call, 1).and_then(ScriptValue::text);
                if let (Some(program), Some(name)) = (program, name) {
                    let place = place_of(call, 1).unwrap_or(event.place);
                    found.extend(unknown_block(replay, program, name, place));
                    indices.insert(call.result, (program, name.to_string()));
                }
            }
            "uniformBlockBinding" => {
                let index = argument(call, 1).and_then(ScriptValue::object);
                let binding = argument(call, 2).and_then(ScriptValue::number);
                if let (Some((program, name)), Some(binding)) =
                    (index.and_then(|id| indices.get(&id)), binding)
                {
                    blocks.push((*program, name.clone(), binding as u32));
                }
            }
            _ => buffers.follow(world, call, event.place),
        }
    }
    let blocks = if buffers.is_shared {
        &[][..]
    } else {
        blocks.as_slice()
    };
    for (program, name, binding) in blocks {
        let layout = replay
            .programs
            .get(program)
            .and_then(|p| p.stages.block(name));
        if let (Some((layout, declared)), Some(buffer)) = (layout, buffers.bindings.get(binding)) {
            buffers.check(*buffer, (name, layout, declared), found);
        }
    }
    check_units(replay, found);
}

/// A block that no shader declares.
fn unknown_block(
    replay: &GlReplay,
    program: ObjectId,
    name: &str,
    place: ScriptPlace,
) -> Option<Breach> {
    let program = replay.programs.get(&program).filter(|p| !p.is_open)?;
    let names: Vec<&str> = program.stages.all().flat_map(|s| s.block_names()).collect();
    if names.contains(&name) {
        return None;
    }
    let near = nearest(name, names.into_iter());
    let message = format!("no shader of this program declares the uniform block `{name}`");
    let breach = Breach::new("unknown-uniform", place, message)
        .note("the index is INVALID_INDEX, and its binding has no effect")
        .help(near.map(|near| format!("did you mean `{near}`?")));
    Some(breach)
}

impl Buffers {
    fn follow(&mut self, world: &World, call: &ForeignCall, place: ScriptPlace) {
        let is_uniform = constant(world, argument(call, 0)) == Some("UNIFORM_BUFFER");
        if !is_uniform {
            return;
        }
        match &*call.name {
            "bindBuffer" => self.bound = argument(call, 1).and_then(ScriptValue::object),
            "bindBufferBase" => {
                let binding = argument(call, 1).and_then(ScriptValue::number);
                let buffer = argument(call, 2).and_then(ScriptValue::object);
                if let (Some(binding), Some(buffer)) = (binding, buffer) {
                    // Another buffer may be for another program.
                    let old = self.bindings.insert(binding as u32, buffer);
                    self.is_shared |= old.is_some_and(|old| old != buffer);
                    self.bound = Some(buffer);
                }
            }
            "bufferData" => {
                let bytes = match argument(call, 1) {
                    Some(ScriptValue::Number(bytes)) => Some(*bytes),
                    value => value.and_then(|value| byte_length(world, value)),
                };
                if let (Some(buffer), Some(bytes)) = (self.bound, bytes) {
                    self.sizes
                        .insert(buffer, (bytes, place_of(call, 1).unwrap_or(place)));
                }
            }
            "bufferSubData" => {
                let offset = argument(call, 1).and_then(ScriptValue::number);
                if let (Some(buffer), Some(offset)) = (self.bound, offset) {
                    self.parts
                        .push((buffer, offset, place_of(call, 1).unwrap_or(place)));
                }
            }
            _ => {}
        }
    }

    fn check(
        &self,
        buffer: ObjectId,
        (name, layout, declared): (&str, &BlockLayout, Option<ScriptPlace>),
        found: &mut Vec<Breach>,
    ) {
        if let Some((bytes, place)) = self.sizes.get(&buffer)
            && *bytes < f64::from(layout.size)
        {
            let message = format!(
                "block `{name}` has {} bytes, its buffer {bytes}",
                layout.size
            );
            let breach = Breach::new("uniform-type", *place, message)
                .label(declared, "declared here")
                .note("drawing reports INVALID_OPERATION; std140 aligns vectors of three, arrays and structs to 16 bytes")
                .help(Some(offsets(layout)));
            found.push(breach);
        }
        let all = self.parts.iter().filter(|(of, _, _)| *of == buffer);
        for (_, offset, place) in all {
            let is_member = layout.members.iter().any(|member| {
                let start = f64::from(member.offset);
                let inside = *offset - start;
                let is_element = member.stride > 0 && inside % f64::from(member.stride) == 0.0;
                let is_row = member
                    .ty
                    .numeric()
                    .is_some_and(|(_, columns, _)| columns > 1);
                let is_part = is_element || is_row && inside % 16.0 == 0.0;
                inside == 0.0 || is_part && inside > 0.0 && inside < f64::from(member.size)
            });
            if !is_member && *offset < f64::from(layout.size) {
                let message = format!("no member of block `{name}` starts at byte {offset}");
                let breach = Breach::new("uniform-type", *place, message)
                    .label(declared, "declared here")
                    .help(Some(offsets(layout)));
                found.push(breach);
            }
        }
    }
}

/// The bytes of a typed array.
fn byte_length(world: &World, value: &ScriptValue) -> Option<f64> {
    let call = world.call_of(value.object()?).filter(|call| call.is_new)?;
    let first = argument(call, 0);
    let bytes = match &*call.name {
        "Float32Array" | "Int32Array" | "Uint32Array" => 4.0,
        "Uint8Array" | "ArrayBuffer" => 1.0,
        _ => return None,
    };
    Some(length(world, first)? as f64 * bytes)
}

/// The first members of a block with their offsets.
fn offsets(layout: &BlockLayout) -> String {
    /// Maximum number of members that are listed.
    const MAX_LISTED: usize = 8;
    let all = layout.members.iter().take(MAX_LISTED);
    let all: Vec<String> = all
        .map(|m| format!("`{}` at {}", m.name, m.offset))
        .collect();
    format!("the members start at: {}", all.join(", "))
}

/// Reports samplers of different types that read the same texture unit.
fn check_units(replay: &GlReplay, found: &mut Vec<Breach>) {
    let mut units: HashMap<(ObjectId, u32), (Sampler, String, ScriptPlace)> = HashMap::new();
    for event in &replay.world.events {
        let EventKind::Call(call) = &event.kind else {
            continue;
        };
        if &*call.name != "uniform1i" {
            continue;
        }
        let Some((id, Some(name), _)) = replay.uniform_location(argument(call, 0)) else {
            continue;
        };
        let unit = argument(call, 1).and_then(ScriptValue::number);
        let program = replay.programs.get(&id).filter(|p| !p.is_open);
        let uniform = program
            .and_then(|p| p.stages.uniform(&name))
            .filter(|u| u.is_active);
        let (Some(unit), Some(uniform)) = (unit, uniform) else {
            continue;
        };
        let Base::Sampler(sampler) = uniform.ty.base else {
            continue;
        };
        let key = (id, unit as u32);
        match units.get(&key) {
            Some((other, other_name, other_place)) if *other != sampler && *other_name != name => {
                let message = format!(
                    "`{name}` and `{other_name}` read texture unit {unit} with different types"
                );
                let breach = Breach::new("uniform-type", event.place, message)
                    .label(Some(*other_place), format!("a `{}`", other.name()))
                    .note(format!(
                        "`{name}` is a `{}`; drawing reports INVALID_OPERATION",
                        sampler.name()
                    ));
                found.push(breach);
            }
            _ => {
                units.insert(key, (sampler, name, event.place));
            }
        }
    }
}
