//! Attributes that scripts feed with WebGL.

use super::replay::{GlLocation, GlProgram, GlReplay, argument, constant};
use crate::breach::{Breach, nearest};
use crate::interface::DeclaredInput;
use crate::shape::length;
use shaderlint_script::{
    EventCertainty, EventKind, ForeignCall, ObjectId, ScriptPlace, ScriptValue, World,
};
use shaderlint_semantic::Scalar;
use std::collections::{HashMap, HashSet};

/// By program and name of an attribute: the columns that are enabled.
type EnabledColumns = HashMap<(ObjectId, String), HashSet<i32>>;

/// A pointer to the data of an attribute.
struct Pointer<'w> {
    place: ScriptPlace,
    attribute: &'w DeclaredInput,
    column: i32,
    size: Option<f64>,
    /// Type of the data, as a constant of WebGL.
    data_type: Option<String>,
    is_integer: bool,
    is_normalized: bool,
    stride: Option<f64>,
    offset: Option<f64>,
    /// The data of the buffer that is bound.
    data: Option<Data>,
    certainty: EventCertainty,
    task: usize,
}

/// The data of a buffer.
#[derive(Clone, PartialEq)]
struct Data {
    /// The object.
    id: ObjectId,
    /// Name of the typed array.
    class: String,
    values: Option<Vec<f64>>,
}

/// Bytes of a value of a type of WebGL.
fn bytes(data_type: &str) -> Option<f64> {
    Some(match data_type {
        "BYTE" | "UNSIGNED_BYTE" => 1.0,
        "SHORT" | "UNSIGNED_SHORT" | "HALF_FLOAT" => 2.0,
        "FLOAT" | "INT" | "UNSIGNED_INT" => 4.0,
        _ => return None,
    })
}

/// The types of WebGL that read a typed array as it is.
fn types_of(class: &str) -> &'static [&'static str] {
    match class {
        "Float32Array" => &["FLOAT"],
        "Int8Array" => &["BYTE"],
        "Uint8Array" | "Uint8ClampedArray" => &["UNSIGNED_BYTE"],
        "Int16Array" => &["SHORT"],
        "Uint16Array" => &["UNSIGNED_SHORT", "HALF_FLOAT"],
        "Int32Array" => &["INT"],
        "Uint32Array" => &[
            "UNSIGNED_INT",
            "INT_2_10_10_10_REV",
            "UNSIGNED_INT_2_10_10_10_REV",
        ],
        _ => &[],
    }
}

fn data(world: &World, value: &ScriptValue) -> Option<Data> {
    let id = value.object()?;
    let call = world
        .call_of(id)
        .filter(|call| call.is_new && call.name.ends_with("Array"))?;
    let first = argument(call, 0);
    let values = first.and_then(|value| world.elements(value));
    let numbers = values.map(|all| {
        all.iter()
            .filter_map(ScriptValue::number)
            .collect::<Vec<_>>()
    });
    Some(Data {
        id,
        class: call.name.to_string(),
        values: numbers.filter(|n| Some(n.len()) == length(world, first)),
    })
}

/// Adds what is wrong with attributes.
pub fn check(replay: &GlReplay, found: &mut Vec<Breach>) {
    let world = replay.world;
    let mut pointers: Vec<Pointer> = Vec::new();
    let mut enabled = EnabledColumns::new();
    let mut is_unknown = false;
    let mut bound: Option<ObjectId> = None;
    let mut contents: HashMap<ObjectId, Option<Data>> = HashMap::new();
    for event in &world.events {
        let EventKind::Call(call) = &event.kind else {
            continue;
        };
        match &*call.name {
            "bindBuffer" if constant(world, argument(call, 0)) == Some("ARRAY_BUFFER") => {
                bound = argument(call, 1).and_then(ScriptValue::object);
            }
            "bufferData" => {
                if constant(world, argument(call, 0)) == Some("ARRAY_BUFFER")
                    && let Some(buffer) = bound
                {
                    let data = argument(call, 1).and_then(|value| data(world, value));
                    contents.insert(buffer, data);
                }
            }
            "enableVertexAttribArray"
            | "vertexAttrib4f"
            | "vertexAttrib3f"
            | "vertexAttrib2f"
            | "vertexAttrib1f"
            | "vertexAttrib4fv"
            | "vertexAttrib3fv" => match replay.location(argument(call, 0)) {
                Some((
                    GlLocation {
                        program,
                        name: Some(name),
                        ..
                    },
                    column,
                )) => {
                    enabled
                        .entry((*program, name.clone()))
                        .or_default()
                        .insert(column);
                }
                _ => is_unknown = true,
            },
            "vertexAttribPointer" | "vertexAttribIPointer" => {
                let data = bound.and_then(|id| contents.get(&id).cloned()).flatten();
                match pointer(
                    replay,
                    call,
                    (event.place, event.certainty, event.task),
                    data,
                ) {
                    Some(pointer) => pointers.push(pointer),
                    None => is_unknown = true,
                }
            }
            _ => {}
        }
    }
    for pointer in &pointers {
        if pointer.certainty != EventCertainty::Alternative {
            found.extend(pointer.wrong_type());
            found.extend(pointer.layout(&pointers));
        }
    }
    for (id, program) in &replay.programs {
        check_captured(program, found);
        if program.is_open || !program.is_used || is_unknown {
            continue;
        }
        check_fed(*id, program, (&pointers, &enabled), found);
    }
}

fn pointer<'w>(
    replay: &'w GlReplay,
    call: &ForeignCall,
    (place, certainty, task): (ScriptPlace, EventCertainty, usize),
    data: Option<Data>,
) -> Option<Pointer<'w>> {
    let (location, column) = replay.location(argument(call, 0))?;
    let name = location.name.as_deref()?;
    let program = replay
        .programs
        .get(&location.program)
        .filter(|p| !p.is_open)?;
    let vertex = program.stages.vertex.as_ref()?;
    let attribute = vertex.inputs.iter().find(|a| a.name == name)?;
    let is_integer = &*call.name == "vertexAttribIPointer";
    let rest = if is_integer { 3 } else { 4 };
    Some(Pointer {
        place,
        attribute,
        column,
        size: argument(call, 1).and_then(ScriptValue::number),
        data_type: constant(replay.world, argument(call, 2)).map(str::to_string),
        is_integer,
        is_normalized: !is_integer && !matches!(argument(call, 3), Some(ScriptValue::Bool(false))),
        stride: argument(call, rest).and_then(ScriptValue::number),
        offset: argument(call, rest + 1).and_then(ScriptValue::number),
        data,
        certainty,
        task,
    })
}

impl Pointer<'_> {
    /// A pointer of the wrong kind for the type of its attribute.
    fn wrong_type(&self) -> Option<Breach> {
        let scalar = self.attribute.scalar()?;
        let (name, type_name) = (&self.attribute.name, &self.attribute.type_name);
        let expects_integer = matches!(scalar, Scalar::Int | Scalar::Uint);
        let data_type = self.data_type.as_deref().unwrap_or("");
        let breach = |message: String| {
            let declared = format!("declared as `{type_name}`");
            Breach::new("attribute-data", self.place, message).label(self.attribute.place, declared)
        };
        if expects_integer != self.is_integer {
            let needed = match expects_integer {
                true => "vertexAttribIPointer",
                false => "vertexAttribPointer",
            };
            let message = format!("attribute `{name}` is a `{type_name}`: it needs `{needed}`");
            return Some(
                breach(message).note("drawing reports INVALID_OPERATION, and nothing is drawn"),
            );
        }
        let is_signed = matches!(data_type, "BYTE" | "SHORT" | "INT");
        if expects_integer && bytes(data_type).is_some() && is_signed != (scalar == Scalar::Int) {
            let message =
                format!("attribute `{name}` is a `{type_name}`, but its data is `{data_type}`");
            return Some(
                breach(message).note("drawing reports INVALID_OPERATION, and nothing is drawn"),
            );
        }
        let data = self.data.as_ref()?;
        let fitting = types_of(&data.class);
        if !fitting.is_empty()
            && !data_type.is_empty()
            && !fitting.contains(&data_type)
            && self.stride.unwrap_or(1.0) == 0.0
        {
            let message = format!(
                "attribute `{name}` reads a `{}` as `{data_type}`",
                data.class
            );
            return Some(breach(message).help(fitting.first().map(|t| format!("use `gl.{t}`"))));
        }
        let is_full = data.values.as_ref().is_some_and(|v| v.contains(&255.0));
        if !self.is_integer
            && !self.is_normalized
            && data_type == "UNSIGNED_BYTE"
            && self.size.is_some_and(|size| size >= 3.0)
            && is_full
        {
            let message = format!("attribute `{name}` gets values up to 255.0");
            return Some(
                breach(message)
                    .note("bytes are converted to 0.0 to 255.0 unless they are normalised")
                    .help(Some("pass `true` as the fourth argument".to_string())),
            );
        }
        None
    }

    /// A layout of interleaved data in which attributes overlap or leave gaps.
    fn layout(&self, all: &[Pointer]) -> Option<Breach> {
        let (stride, offset) = (self.stride?, self.offset?);
        let size = self.size? * bytes(self.data_type.as_deref()?)?;
        if stride <= 0.0 {
            return None;
        }
        let declared = self.attribute.place;
        let name = &self.attribute.name;
        if offset + size > stride {
            let message = format!(
                "attribute `{name}` ends at byte {}, past the stride of {stride} bytes",
                offset + size
            );
            let breach = Breach::new("attribute-data", self.place, message)
                .label(declared, "this attribute");
            return Some(breach.note("it reads data of the next vertex"));
        }
        let data = self.data.as_ref()?;
        let fits = types_of(&data.class).contains(&self.data_type.as_deref()?);
        if !fits && data.class != "Uint8Array" && !types_of(&data.class).is_empty() {
            let message = format!(
                "attribute `{name}` reads a `{}` as `{}`",
                data.class,
                self.data_type.as_deref()?
            );
            return Some(
                Breach::new("attribute-data", self.place, message)
                    .label(declared, "this attribute"),
            );
        }
        // The attribute that follows in the same data.
        let same = all.iter().filter(|p| {
            p.data.as_ref().is_some_and(|d| d.id == data.id)
                && p.stride == self.stride
                && p.task == self.task
        });
        let next = same
            .filter_map(|p| p.offset)
            .filter(|o| *o > offset)
            .fold(stride, f64::min);
        let needed = f64::from(self.attribute.components()?) * 4.0;
        let gap = next - offset;
        (gap >= needed && size < needed && gap == needed && data.class == "Float32Array").then(
            || {
                let message = format!(
                    "attribute `{name}` is a `{}`, but reads {} of its {} numbers",
                    self.attribute.type_name,
                    self.size.unwrap_or(0.0),
                    needed / 4.0
                );
                Breach::new("attribute-data", self.place, message)
                    .label(
                        declared,
                        format!("declared as `{}`", self.attribute.type_name),
                    )
                    .note("the missing components are 0")
            },
        )
    }
}

/// Checks the outputs that transform feedback captures.
fn check_captured(program: &GlProgram, found: &mut Vec<Breach>) {
    let Some(vertex) = program.stages.vertex.as_ref().filter(|s| !s.is_open) else {
        return;
    };
    for (name, place) in &program.captured {
        if vertex.mentions(name) || name.starts_with("gl_") || name.contains(['[', '.']) {
            continue;
        }
        let near = nearest(name, vertex.outputs.iter().map(|o| o.name.as_str()));
        let message = format!("the vertex shader has no output `{name}`");
        let breach = Breach::new("attribute-data", *place, message)
            .note("the program does not link")
            .help(near.map(|near| format!("did you mean `{near}`?")));
        found.push(breach);
    }
}

/// Checks that each attribute gets data.
fn check_fed(
    id: ObjectId,
    program: &GlProgram,
    (pointers, enabled): (&[Pointer], &EnabledColumns),
    found: &mut Vec<Breach>,
) {
    let inputs = program.stages.vertex.iter().flat_map(|s| &s.inputs);
    for attribute in inputs.filter(|a| a.is_active && a.location.is_none()) {
        // A fixed location is fed by its number.
        if program
            .bound
            .iter()
            .any(|(_, name, _)| name.as_ref().is_none_or(|n| *n == attribute.name))
        {
            continue;
        }
        let own = pointers
            .iter()
            .filter(|p| std::ptr::eq(p.attribute, attribute));
        let columns: HashSet<i32> = own.clone().map(|p| p.column).collect();
        let Some(first) = own.clone().next() else {
            continue;
        };
        let known = enabled.get(&(id, attribute.name.clone()));
        let is_enabled = known.is_some_and(|columns| !columns.is_empty());
        if !is_enabled {
            let message = format!("the data of attribute `{}` is not enabled", attribute.name);
            let breach = Breach::new("attribute-data", first.place, message)
                .label(attribute.place, "declared here")
                .note("it is (0, 0, 0, 1) for all vertices")
                .help(Some(
                    "call `enableVertexAttribArray` with its location".to_string(),
                ));
            found.push(breach);
        } else if let Some((needed, _)) = attribute.matrix()
            && columns.len() < usize::from(needed)
        {
            let message = format!(
                "attribute `{}` is a `{}`, but {} of its {needed} columns get data",
                attribute.name,
                attribute.type_name,
                columns.len()
            );
            let breach = Breach::new("attribute-data", first.place, message)
                .label(
                    attribute.place,
                    format!("declared as `{}`", attribute.type_name),
                )
                .note("each column of a matrix has a location of its own");
            found.push(breach);
        }
    }
}
