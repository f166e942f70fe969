//! Programs that libraries make of shaders and an object with the values of uniforms.

mod bind;
mod elements;
mod keys;
mod lists;
mod names;
mod props;
mod screen;
mod values;

use crate::breach::Breach;
use crate::interface::{DeclaredInput, ShaderInterface, Stages};
use crate::library::{Boxing, Maker, at, maker_of};
use crate::link;
use crate::shape::ValueShape;
use shaderlint_script::{
    EventKind, ForeignCall, KnownText, ObjectId, ObjectKind, ScriptEvent, ScriptPlace, ScriptValue,
    Source, World,
};
use shaderlint_semantic::Stage;
use std::rc::Rc;

/// A program that a library makes.
pub struct Material<'w> {
    /// What makes it.
    pub maker: &'static Maker,
    /// The call that makes it.
    pub call: &'w ForeignCall,
    /// Where it is made.
    pub place: ScriptPlace,
    /// The macros that it defines: names, values and places.
    pub macros: Vec<(String, String, ScriptPlace)>,
    /// Its shaders.
    pub stages: Stages,
    /// The attributes that it is given itself.
    pub attributes: Option<ScriptValue>,
    /// The object of the uniforms.
    uniforms: Option<ObjectId>,
    keys: Vec<UniformKey>,
    /// Values that do not fit, found while the program was read.
    wrong: Vec<Breach>,
    /// Whether there may be other uniforms.
    is_open: bool,
}

/// A uniform that a script gives a value.
#[derive(Clone)]
struct UniformKey {
    name: String,
    value: ScriptValue,
    place: ScriptPlace,
}

/// Adds what is wrong with the programs of libraries.
pub fn check<'w>(world: &'w World, found: &mut Vec<Breach>) -> Vec<Material<'w>> {
    let materials = read(world);
    for material in &materials {
        // An object that other programs use too is for all of them.
        let is_shared = |other: &&Material| {
            other.call.result != material.call.result
                && (other.uniforms.is_some() && other.uniforms == material.uniforms
                    || other.place == material.place)
        };
        let others: Vec<&Material> = materials.iter().filter(is_shared).collect();
        link::check(&material.stages, material.place, found);
        material.check_values(world, found);
        material.check_props(world, found);
        material.check_screen(world, found);
        material.check_lists(world, found);
        material.check_missing(world, &others, found);
        material.check_accesses(world, &others, found);
        material.check_instances(world, found);
    }
    materials
}

/// The programs that libraries make.
fn read<'w>(world: &'w World) -> Vec<Material<'w>> {
    world
        .events
        .iter()
        .filter_map(|event| material(world, event))
        .collect()
}

fn material<'w>(world: &'w World, event: &'w ScriptEvent) -> Option<Material<'w>> {
    let EventKind::Call(call) = &event.kind else {
        return None;
    };
    let maker = maker_of(world, call)?;
    let macros = macros(world, call, maker);
    let stage = |index: usize, stage: Stage| {
        let path = maker.stages.get(index).filter(|path| !path.is_empty())?;
        match at(world, call, path)? {
            ScriptValue::Text(text) => {
                let text = match maker.store.is_empty() {
                    true => text,
                    false => stored(world, &text.content, stage)?,
                };
                Some(Rc::new(ShaderInterface::of(
                    &text,
                    stage,
                    (&macros, maker.before()),
                )))
            }
            _ => None,
        }
    };
    let stages = Stages {
        vertex: stage(0, Stage::Vertex),
        fragment: stage(1, Stage::Fragment),
    };
    let given = at(world, call, &maker.uniforms);
    let mut material = Material {
        maker,
        call,
        place: event.place,
        macros: macros.clone(),
        stages,
        attributes: at(world, call, &maker.attributes),
        uniforms: given.as_ref().and_then(ScriptValue::object),
        keys: Vec::new(),
        wrong: Vec::new(),
        is_open: call.is_open,
    };
    // The object that holds them may get others.
    let holder = maker
        .uniforms
        .split_last()
        .and_then(|(_, path)| at(world, call, path));
    let holder = holder.and_then(|value| world.object(value.object()?));
    material.is_open |= holder.is_some_and(|o| o.is_open);
    if !maker.setter.is_empty() {
        material.read_setters(world);
    } else if let Some(given) = given {
        material.read(world, &given, 0);
    } else {
        material.is_open |= holder.is_none_or(|o| !matches!(o.kind, ObjectKind::Plain));
        material.is_open |= maker.uniforms.len() < 2;
    }
    material.read_attributes(world);
    Some(material)
}

/// A shader that a script stores under a name.
fn stored(world: &World, name: &str, stage: Stage) -> Option<Rc<KnownText>> {
    let ends: &[&str] = match stage {
        Stage::Vertex => &["VertexShader"],
        Stage::Fragment => &["FragmentShader", "PixelShader"],
    };
    world
        .events
        .iter()
        .rev()
        .find_map(|event| match &event.kind {
            EventKind::Write {
                key: Some(key),
                value: ScriptValue::Text(text),
                ..
            } => {
                let end = key.strip_prefix(name)?;
                ends.contains(&end).then(|| text.clone())
            }
            _ => None,
        })
}

/// The macros that a script defines.
fn macros(world: &World, call: &ForeignCall, maker: &Maker) -> Vec<(String, String, ScriptPlace)> {
    let object = at(world, call, &maker.defines).and_then(|value| world.object(value.object()?));
    let properties = object.map_or(&[][..], |o| &o.properties);
    let macros = properties.iter().filter_map(|p| {
        let value = match &p.value {
            ScriptValue::Number(number) => number.to_string(),
            ScriptValue::Text(text) if !text.is_open => text.content.clone(),
            // `false` defines nothing.
            ScriptValue::Bool(true) => "true".to_string(),
            // What is not known neither, here.
            _ => return None,
        };
        Some((p.key.to_string(), value, p.place))
    });
    macros.collect()
}

impl Material<'_> {
    /// The value of a uniform, and whether it is in an object that lacks `value`.
    fn value<'v>(&self, world: &'v World, key: &'v UniformKey) -> (Option<&'v ScriptValue>, bool) {
        match self.maker.boxing {
            Boxing::Plain => (Some(&key.value), false),
            boxing => match &key.value {
                ScriptValue::Undefined | ScriptValue::Null => (None, false),
                ScriptValue::Object(id) => match world.object(*id).map(|o| &o.kind) {
                    Some(ObjectKind::Plain) => {
                        let value = world.get(&key.value, "value");
                        let is_open = world.object(*id).is_some_and(|o| o.is_open);
                        let lacks = value.is_none() && !is_open && boxing != Boxing::Grouped;
                        (value, lacks)
                    }
                    Some(ObjectKind::Array(_)) => (None, boxing != Boxing::Grouped),
                    // `new Uniform(value)`
                    Some(ObjectKind::Foreign(Source::Event(_))) => {
                        let call = world.call_of(*id).filter(|call| call.is_new);
                        match call {
                            Some(call) if &*call.name == "Uniform" => {
                                (call.arguments.first().map(|(value, _)| value), false)
                            }
                            Some(_) => {
                                let shape = ValueShape::of(world, &key.value);
                                let is_value = matches!(
                                    shape,
                                    ValueShape::Vector(..) | ValueShape::Matrix(..)
                                );
                                (None, is_value && boxing != Boxing::Grouped)
                            }
                            None => (None, false),
                        }
                    }
                    _ => (None, false),
                },
                // A number, text or boolean.
                _ => (None, true),
            },
        }
    }

    /// Whether a uniform has a value of some kind.
    pub fn reads(&self, world: &World, is: impl Fn(&ScriptValue) -> bool) -> bool {
        let constant = self.keys.iter().filter(|key| !self.is_written(world, key));
        let mut values = constant.filter_map(|key| self.value(world, key).0);
        values.any(is)
    }

    /// Whether the value of a uniform is set later.
    fn is_written(&self, world: &World, key: &UniformKey) -> bool {
        world.events.iter().any(|event| match &event.kind {
            EventKind::Write {
                object, key: of, ..
            } => {
                let is_value = of.as_ref().is_none_or(|key| &**key == "value");
                // One whose name is not known may be any.
                let is_any = match world.object(*object).map(|o| &o.kind) {
                    Some(ObjectKind::Foreign(Source::Unknown)) => true,
                    _ => self.name_of(world, *object).as_deref() == Some(&*key.name),
                };
                is_value && is_any
            }
            _ => false,
        })
    }

    /// The uniform that a key is for.
    fn declared(&self, name: &str) -> Option<&DeclaredInput> {
        self.stages.uniform(name)
    }

    /// Whether an object is the one that holds the uniforms.
    fn is_uniforms(&self, world: &World, id: ObjectId) -> bool {
        let own = Some((self.call.result, "uniforms"));
        self.uniforms == Some(id) || world.member_of(id) == own
    }

    /// The uniform whose object this is.
    fn name_of(&self, world: &World, id: ObjectId) -> Option<String> {
        if let Some(key) = self.keys.iter().find(|key| key.value.object() == Some(id)) {
            return Some(key.name.clone());
        }
        let (holder, name) = world.member_of(id)?;
        self.is_uniforms(world, holder).then(|| name.to_string())
    }

    /// Whether something sets a uniform later, by its name.
    fn is_set_later(&self, world: &World, name: &str) -> bool {
        world.events.iter().any(|event| match &event.kind {
            EventKind::Write { object, key, .. } => {
                // A group takes no uniforms later.
                let is_fixed = self.maker.boxing == Boxing::Grouped;
                let is_it = !is_fixed && key.as_ref().is_none_or(|key| **key == *name);
                is_it && (self.is_uniforms(world, *object) || self.is_in_result(world, *object))
            }
            // A command of regl without shaders sets uniforms for those that it calls.
            EventKind::Call(call)
                if self.maker.name == "(call)" && call.callee == self.call.callee =>
            {
                let is_other = call.result != self.call.result;
                let uniforms = at(world, call, &self.maker.uniforms).filter(|_| is_other);
                let has = |uniforms: &ScriptValue| {
                    let object = uniforms.object().and_then(|id| world.object(id));
                    object.is_some_and(|o| o.is_open) || world.get(uniforms, name).is_some()
                };
                let makes = maker_of(world, call).is_some();
                uniforms.is_some_and(|uniforms| !makes && has(&uniforms))
            }
            // Functions that take names: `setUniform('name', value)`.
            EventKind::Call(call) => {
                call.this == Some(self.call.result)
                    && call.arguments.iter().any(|(value, _)| match value {
                        ScriptValue::Text(text) => text.is_open || text.content == name,
                        _ => false,
                    })
            }
            EventKind::Missing { .. } => false,
        })
    }

    /// Whether an object is a part of what the library made.
    fn is_in_result(&self, world: &World, id: ObjectId) -> bool {
        let mut id = id;
        for _ in 0..6 {
            match world.object(id).map(|o| &o.kind) {
                Some(ObjectKind::Foreign(Source::Member(object, name))) => {
                    if *object == self.call.result {
                        return ["uniforms", "resources", "uniformValues"].contains(&&**name);
                    }
                    id = *object;
                }
                _ => return false,
            }
        }
        false
    }
}
