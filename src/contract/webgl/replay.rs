//! The calls of WebGL, replayed in their order.

use crate::breach::Breach;
use crate::interface::{ShaderInterface, Stages};
use crate::library::maker_of;
use shaderlint_script::{
    EventCertainty, EventKind, ForeignCall, KnownText, ObjectId, ObjectKind, ScriptEvent,
    ScriptPlace, ScriptValue, Source, World,
};
use shaderlint_semantic::Stage;
use std::collections::HashMap;
use std::rc::Rc;

/// A program.
#[derive(Default)]
pub struct GlProgram {
    /// The shaders that are attached.
    pub shaders: Vec<ObjectId>,
    pub stages: Stages,
    /// Whether a shader is not known.
    pub is_open: bool,
    pub place: ScriptPlace,
    /// Whether it is put in use.
    pub is_used: bool,
    /// Whether something is drawn with it.
    pub is_drawn: bool,
    /// The names of attributes by location.
    pub bound: Vec<(Option<f64>, Option<String>, ScriptPlace)>,
    /// What transform feedback captures.
    pub captured: Vec<(String, ScriptPlace)>,
}

/// A location that a script looks up.
pub struct GlLocation {
    pub program: ObjectId,
    /// The name; `None` if it is not known.
    pub name: Option<String>,
    pub is_attribute: bool,
    pub place: ScriptPlace,
    /// Whether the name comes from a list, which may be for several programs, or from WebGL.
    pub is_listed: bool,
}

/// Places at which something is wrong each time that they are evaluated.
#[derive(Default)]
pub struct Verdicts(pub HashMap<ScriptPlace, Option<Breach>>);

impl Verdicts {
    /// Something is wrong at a place.
    pub fn bad(&mut self, breach: Breach) {
        self.0.entry(breach.place).or_insert(Some(breach));
    }

    /// Nothing is wrong at a place, at least once.
    pub fn good(&mut self, place: ScriptPlace) {
        self.0.insert(place, None);
    }
}

/// The state of WebGL while the calls are replayed.
pub struct GlReplay<'w> {
    pub world: &'w World<'w>,
    pub sources: HashMap<ObjectId, Option<Rc<KnownText>>>,
    pub stages: HashMap<ObjectId, Option<Stage>>,
    pub programs: HashMap<ObjectId, GlProgram>,
    pub locations: HashMap<ObjectId, GlLocation>,
    /// Objects whose members are locations by the name of the member.
    pub tables: HashMap<ObjectId, ObjectId>,
    /// The program in use; `Err` if it is not known.
    pub current: Result<Option<ObjectId>, ()>,
    pub task: usize,
    pub verdicts: Verdicts,
}

/// An argument of a call.
pub fn argument(call: &ForeignCall, index: usize) -> Option<&ScriptValue> {
    call.arguments.get(index).map(|(value, _)| value)
}

/// The place of an argument of a call.
pub fn place_of(call: &ForeignCall, index: usize) -> Option<ScriptPlace> {
    call.arguments.get(index).map(|(_, place)| *place)
}

/// The place of the contents of a quoted text.
fn inside(place: ScriptPlace) -> ScriptPlace {
    ScriptPlace {
        start: place.start + 1,
        end: place.end.saturating_sub(1),
        ..place
    }
}

/// The name of a constant of WebGL.
pub fn constant<'w>(world: &'w World, value: Option<&ScriptValue>) -> Option<&'w str> {
    let (_, name) = world.member_of(value?.object()?)?;
    Some(name)
}

/// A program that a function makes of the texts of its shaders: `createProgramFromSources(gl, [vertex, fragment])`.
fn made_of_texts(world: &World, id: ObjectId) -> Option<GlProgram> {
    let object = world.object(id)?;
    let holder = match world.member_of(id) {
        Some((of, "program")) => of,
        _ => id,
    };
    let call = world.call_of(holder);
    // Who gets what holds the program may set its uniforms.
    let is_handed_on = holder != id
        && world.events.iter().any(|event| match &event.kind {
            EventKind::Call(call) => {
                let mut all = call.arguments.iter();
                all.any(|(value, _)| value.object() == Some(holder))
            }
            _ => false,
        });
    // What a library sets with its own functions is not followed here.
    let call = call.filter(|call| maker_of(world, call).is_none())?;
    let given = call
        .arguments
        .iter()
        .flat_map(|(value, _)| match world.elements(value) {
            Some(all) => all.to_vec(),
            None => vec![value.clone()],
        });
    let texts = given.filter_map(|value| match value {
        ScriptValue::Text(text) if text.content.contains("main") => Some(text),
        _ => None,
    });
    let texts: Vec<Rc<KnownText>> = texts.collect();
    let [one, other] = texts.as_slice() else {
        return None;
    };
    let is_vertex = |text: &KnownText| text.content.contains("gl_Position");
    let (vertex, fragment) = match is_vertex(other) && !is_vertex(one) {
        true => (other, one),
        false => (one, other),
    };
    let read = |text, stage| Some(Rc::new(ShaderInterface::of(text, stage, (&[], ""))));
    Some(GlProgram {
        stages: Stages {
            vertex: read(vertex, Stage::Vertex),
            fragment: read(fragment, Stage::Fragment),
        },
        place: object.place,
        is_open: is_handed_on,
        ..GlProgram::default()
    })
}

/// What a script looks up.
fn location_of(
    world: &World,
    call: &ForeignCall,
    program: ObjectId,
    place: ScriptPlace,
) -> GlLocation {
    let name = argument(call, 1);
    // `gl.getActiveUniform(program, index).name`
    let info = name.and_then(|name| world.member_of(name.object()?));
    let info = info.and_then(|(info, _)| world.call_of(info));
    let is_active = info.is_some_and(|call| call.name.starts_with("getActive"));
    let written = match name {
        Some(ScriptValue::Text(text)) => text.place(0..text.content.len()),
        _ => None,
    };
    let given = place_of(call, 1);
    GlLocation {
        program,
        name: name.and_then(ScriptValue::text).map(str::to_string),
        is_attribute: &*call.name == "getAttribLocation",
        place: written.or(given).unwrap_or(place),
        is_listed: is_active || written.is_some() && written != given.map(inside),
    }
}

/// The stage that a type of shader names.
fn stage_of(world: &World, value: Option<&ScriptValue>) -> Option<Stage> {
    match (constant(world, value), value?.number()) {
        (Some("VERTEX_SHADER"), _) | (_, Some(35633.0)) => Some(Stage::Vertex),
        (Some("FRAGMENT_SHADER"), _) | (_, Some(35632.0)) => Some(Stage::Fragment),
        _ => None,
    }
}

impl<'w> GlReplay<'w> {
    /// Reads the calls that make programs and look up locations.
    pub fn new(world: &'w World<'w>) -> GlReplay<'w> {
        let mut replay = GlReplay {
            world,
            sources: HashMap::new(),
            stages: HashMap::new(),
            programs: HashMap::new(),
            locations: HashMap::new(),
            tables: HashMap::new(),
            current: Ok(None),
            task: 0,
            verdicts: Verdicts::default(),
        };
        for event in &world.events {
            if let EventKind::Call(call) = &event.kind {
                replay.adopt(call);
            }
        }
        for event in &world.events {
            if let EventKind::Call(call) = &event.kind {
                replay.prepare(call, event);
            }
        }
        replay.read_shaders();
        replay
    }

    /// Follows all calls in their order.
    pub fn run(&mut self) {
        for event in &self.world.events {
            self.follow(event);
        }
    }

    /// Reads the calls that make programs and look up locations.
    fn prepare(&mut self, call: &ForeignCall, event: &ScriptEvent) {
        let first = argument(call, 0).and_then(ScriptValue::object);
        let second = argument(call, 1);
        match (&*call.name, first) {
            ("createProgram", None) if call.arguments.is_empty() => {
                let program = GlProgram {
                    place: event.place,
                    ..GlProgram::default()
                };
                self.programs.insert(call.result, program);
            }
            ("createShader", _) => {
                let stage = stage_of(self.world, argument(call, 0));
                self.stages.insert(call.result, stage);
            }
            ("shaderSource", Some(shader)) => {
                let text = match second {
                    Some(ScriptValue::Text(text)) => Some(text.clone()),
                    _ => None,
                };
                self.sources.insert(shader, text);
            }
            ("attachShader", Some(program)) => {
                if let Some(program) = self.programs.get_mut(&program) {
                    match second.and_then(ScriptValue::object) {
                        Some(shader) => program.shaders.push(shader),
                        None => program.is_open = true,
                    }
                }
            }
            ("getUniformLocation" | "getAttribLocation", Some(program)) => {
                let location = location_of(self.world, call, program, event.place);
                self.locations.insert(call.result, location);
            }
            ("useProgram", Some(program)) => {
                if let Some(program) = self.programs.get_mut(&program) {
                    program.is_used = true;
                }
            }
            ("bindAttribLocation", Some(program)) => {
                if let Some(program) = self.programs.get_mut(&program) {
                    let name = argument(call, 2)
                        .and_then(ScriptValue::text)
                        .map(str::to_string);
                    let index = second.and_then(ScriptValue::number);
                    let place = place_of(call, 2).unwrap_or(event.place);
                    program.bound.push((index, name, place));
                }
            }
            ("transformFeedbackVaryings", Some(program)) => {
                let names = second
                    .and_then(|value| self.world.elements(value))
                    .unwrap_or(&[]);
                let place = place_of(call, 1).unwrap_or(event.place);
                if let Some(program) = self.programs.get_mut(&program) {
                    program.captured = names
                        .iter()
                        .filter_map(|name| match name {
                            ScriptValue::Text(text) => {
                                let place = text.first_place().unwrap_or(place);
                                Some((text.content.clone(), place))
                            }
                            _ => None,
                        })
                        .collect();
                }
            }
            // A program that something else gets may be changed there.
            _ => self.hand_on(call),
        }
    }

    /// Reads a program that another function made.
    fn adopt(&mut self, call: &ForeignCall) {
        let first = argument(call, 0).and_then(ScriptValue::object);
        let first = first.filter(|id| !self.programs.contains_key(id));
        let names = ["useProgram", "getUniformLocation", "getAttribLocation"];
        if let Some(id) = first.filter(|_| names.contains(&&*call.name)) {
            let made = made_of_texts(self.world, id);
            self.programs.extend(made.map(|program| (id, program)));
        }
    }

    /// Notes that programs are handed to functions that are not known.
    fn hand_on(&mut self, call: &ForeignCall) {
        const KNOWN: &[&str] = &[
            "linkProgram",
            "getProgramParameter",
            "getProgramInfoLog",
            "deleteProgram",
            "validateProgram",
            "getActiveUniform",
            "getActiveAttrib",
            "getUniformBlockIndex",
            "uniformBlockBinding",
            "detachShader",
            "log",
            "error",
            "warn",
            "isProgram",
            "getAttachedShaders",
            "getUniformIndices",
            "getActiveUniforms",
            "getFragDataLocation",
            "getUniform",
            "push",
            "set",
            "useProgram",
        ];
        if KNOWN.contains(&&*call.name) {
            return;
        }
        for (value, _) in &call.arguments {
            if let Some(program) = value.object().and_then(|id| self.programs.get_mut(&id)) {
                program.is_open = true;
            }
        }
    }

    /// Reads the shaders of the programs.
    fn read_shaders(&mut self) {
        let mut known: HashMap<(ObjectId, bool), Rc<ShaderInterface>> = HashMap::new();
        for program in self.programs.values_mut() {
            for shader in &program.shaders {
                let text = self.sources.get(shader).cloned().flatten();
                let stage = self.stages.get(shader).copied().flatten();
                let (Some(text), Some(stage)) = (text, stage) else {
                    program.is_open = true;
                    continue;
                };
                let is_vertex = stage == Stage::Vertex;
                let interface = known
                    .entry((*shader, is_vertex))
                    .or_insert_with(|| Rc::new(ShaderInterface::of(&text, stage, (&[], ""))));
                let slot = match stage {
                    Stage::Vertex => &mut program.stages.vertex,
                    Stage::Fragment => &mut program.stages.fragment,
                };
                program.is_open |= slot.replace(interface.clone()).is_some();
            }
            program.is_open |= !program.stages.are_complete();
        }
    }

    /// The location that a value is.
    pub fn location(&self, value: Option<&ScriptValue>) -> Option<(&GlLocation, i32)> {
        let id = value?.object()?;
        if let Some(location) = self.locations.get(&id) {
            return Some((location, 0));
        }
        match &self.world.object(id)?.kind {
            ObjectKind::Foreign(Source::Sum(of, number)) => {
                Some((self.locations.get(of)?, *number))
            }
            _ => None,
        }
    }

    fn follow(&mut self, event: &ScriptEvent) {
        if event.task != self.task {
            self.task = event.task;
            let used = self.programs.values().filter(|p| p.is_used).count();
            // What another function did last is not known, unless there is only one program.
            if used > 1 || self.current == Ok(None) {
                self.current = Err(());
            }
        }
        match &event.kind {
            EventKind::Write {
                object,
                key: None,
                value,
            } => {
                let location = value.object().and_then(|id| self.locations.get(&id));
                if let Some(location) = location.filter(|l| l.name.is_none()) {
                    self.tables.insert(*object, location.program);
                }
            }
            EventKind::Call(call) if &*call.name == "useProgram" => {
                let program = argument(call, 0).and_then(ScriptValue::object);
                self.current = match event.certainty {
                    EventCertainty::Sure => match program {
                        Some(id) if self.programs.contains_key(&id) => Ok(Some(id)),
                        Some(_) => Err(()),
                        None => Ok(None),
                    },
                    _ => Err(()),
                };
            }
            EventKind::Call(call) if call.name.starts_with("draw") && call.this.is_some() => {
                for (id, program) in &mut self.programs {
                    program.is_drawn |= match self.current {
                        Ok(current) => current == Some(*id),
                        Err(()) => program.is_used,
                    };
                }
            }
            EventKind::Call(call) => {
                self.check_lookup(call);
                self.check_setter(call, event);
            }
            _ => {}
        }
    }
}
