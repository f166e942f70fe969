//! The uniforms that scripts give values: keys of objects, and calls of setters.

use super::{Material, UniformKey, values::wrong_value};
use crate::fit::misfit;
use crate::library::{Boxing, LibraryExport};
use crate::shape::ValueShape;
use shaderlint_script::{EventKind, ObjectKind, ScriptValue, Source, World};

impl Material<'_> {
    /// Reads the uniforms of an object.
    pub(super) fn read(&mut self, world: &World, value: &ScriptValue, depth: usize) {
        let Some(object) = value.object().and_then(|id| world.object(id)) else {
            self.is_open = true;
            return;
        };
        match &object.kind {
            ObjectKind::Plain => {
                self.is_open |= object.is_open;
                for property in &object.properties {
                    let inner = match self.maker.boxing {
                        Boxing::Grouped if depth == 0 => Some(&property.value),
                        _ => None,
                    };
                    let group = inner.filter(|value| {
                        let has_value = world.get(value, "value").is_some();
                        let object = value.object().and_then(|id| world.object(id));
                        !has_value && object.is_some_and(|o| matches!(o.kind, ObjectKind::Plain))
                    });
                    if let Some(group) = group {
                        self.read(world, &group.clone(), depth + 1);
                        continue;
                    }
                    let name = match self.maker.boxing {
                        Boxing::Named => {
                            let name = world.get(&property.value, "name");
                            match name.and_then(ScriptValue::text) {
                                Some(name) => name.to_string(),
                                None => {
                                    self.is_open = true;
                                    continue;
                                }
                            }
                        }
                        _ => property.key.to_string(),
                    };
                    // `centers[0]`
                    self.keys.push(UniformKey {
                        name,
                        value: property.value.clone(),
                        place: property.place,
                    });
                }
            }
            ObjectKind::Foreign(Source::Event(_)) if depth < 4 => {
                let call = value.object().and_then(|id| world.call_of(id));
                match call {
                    Some(call) if call.is_new && &*call.name == "Map" => {
                        self.read_map(world, call.arguments.first().map(|(value, _)| value));
                    }
                    Some(call) if ["clone", "merge", "cloneUniforms"].contains(&&*call.name) => {
                        for (argument, _) in &call.arguments {
                            match world.elements(argument) {
                                Some(all) => {
                                    all.iter().for_each(|one| self.read(world, one, depth + 1))
                                }
                                None => self.read(world, argument, depth + 1),
                            }
                        }
                        self.uniforms = None;
                    }
                    _ => self.is_open = true,
                }
            }
            _ => self.is_open = true,
        }
    }

    /// Reads the uniforms in `new Map([[name, value]])`.
    fn read_map(&mut self, world: &World, pairs: Option<&ScriptValue>) {
        let Some(pairs) = pairs.and_then(|value| world.elements(value)) else {
            self.is_open = true;
            return;
        };
        for pair in pairs {
            match world.elements(pair) {
                Some([ScriptValue::Text(name), value]) if !name.is_open => {
                    self.keys.push(UniformKey {
                        name: name.content.clone(),
                        value: value.clone(),
                        place: name.first_place().unwrap_or(self.place),
                    });
                }
                _ => self.is_open = true,
            }
        }
    }

    /// Reads the calls that set uniforms by their names.
    pub(super) fn read_setters(&mut self, world: &World) {
        for event in &world.events {
            let EventKind::Call(call) = &event.kind else {
                continue;
            };
            let is_typed = self.maker.has_typed_setters();
            let shape = typed_setter(&call.name).filter(|_| is_typed);
            if shape.is_none() && (is_typed || !self.maker.is_setter(&call.name)) {
                continue;
            }
            let is_own = call.this == Some(self.call.result);
            let takes = call.arguments.first().and_then(|(value, _)| value.object());
            // A callback of a post process gets its effect.
            let is_effect = is_typed && call.this.is_some_and(|id| world.call_of(id).is_none());
            let values = match (is_own || is_effect, takes == Some(self.call.result)) {
                (true, _) => call.arguments.first().zip(call.arguments.get(1)),
                (false, true) => {
                    for (values, _) in call.arguments.get(1..).unwrap_or(&[]) {
                        match world.elements(values) {
                            Some(all) => all.iter().for_each(|one| self.read(world, one, 0)),
                            None => self.read(world, values, 0),
                        }
                    }
                    continue;
                }
                _ => continue,
            };
            let Some(((name, place), (value, _))) = values else {
                continue;
            };
            let Some(name) = name.text().map(str::to_string) else {
                self.is_open = true;
                continue;
            };
            if is_effect && !is_own && self.stages.uniform(&name).is_none() {
                continue;
            }
            if let (Some(uniform), Some(shape)) = (self.stages.uniform(&name), &shape)
                && let Some(wrong) =
                    misfit(shape, uniform, self.maker.boxing).filter(|_| uniform.is_active)
            {
                self.wrong.push(wrong_value(event.place, uniform, &wrong));
            }
            let value = if shape.is_some() {
                ScriptValue::Undefined
            } else {
                value.clone()
            };
            self.keys.push(UniformKey {
                name,
                value,
                place: *place,
            });
        }
        // Who gets the program may set others.
        self.is_open |= world.events.iter().any(|event| match &event.kind {
            EventKind::Call(call) => {
                let gets = call
                    .arguments
                    .iter()
                    .any(|(value, _)| value.object() == Some(self.call.result));
                let is_known = call
                    .callee
                    .is_none_or(|id| LibraryExport::of(world, Some(id)).is_some());
                gets && !is_known && call.this.is_none()
            }
            _ => false,
        });
    }

    /// Reads attributes of an element as `uniforms-uTime-value={...}`.
    pub(super) fn read_attributes(&mut self, world: &World) {
        let attributes = self
            .call
            .arguments
            .first()
            .and_then(|(value, _)| world.object(value.object()?));
        for property in attributes.map_or(&[][..], |o| &o.properties) {
            let name = property.key.strip_prefix("uniforms-");
            if let Some(name) = name.and_then(|rest| rest.strip_suffix("-value")) {
                self.keys.push(UniformKey {
                    name: name.to_string(),
                    value: property.value.clone(),
                    place: property.place,
                });
            }
        }
    }
}

/// The type of value that a method sets: `setVector2`.
pub(super) fn typed_setter(name: &str) -> Option<ValueShape> {
    let kind = name.strip_prefix("set")?;
    Some(match kind {
        "Float" | "Int" | "UInt" => ValueShape::Number,
        "Bool" => ValueShape::Bool,
        "Vector2" | "Vector3" | "Vector4" | "Color3" | "Color4" | "Quaternion" => {
            let size = kind
                .chars()
                .last()
                .and_then(|c| c.to_digit(10))
                .unwrap_or(4);
            ValueShape::Vector(size, kind.to_string())
        }
        "Float2" | "Float3" | "Float4" => ValueShape::Numbers(
            kind.chars()
                .last()
                .and_then(|c| c.to_digit(10))
                .map(|n| n as usize),
        ),
        "Matrix" => ValueShape::Matrix(4, kind.to_string()),
        "Matrix3x3" => ValueShape::Matrix(3, kind.to_string()),
        "Matrix2x2" => ValueShape::Matrix(2, kind.to_string()),
        "Texture" => ValueShape::Texture,
        "Floats"
        | "Array2"
        | "Array3"
        | "Array4"
        | "Matrices"
        | "TextureArray"
        | "Uniform"
        | "ExternalTexture"
        | "TextureFromPostProcess" => ValueShape::Unknown,
        _ => return None,
    })
}
