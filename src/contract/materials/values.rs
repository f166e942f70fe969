//! Values of uniforms: their types, and how they are written.

use super::Material;
use crate::breach::{Breach, base};
use crate::fit::misfit;
use crate::interface::DeclaredInput;
use crate::library::Boxing;
use crate::shape::ValueShape;
use shaderlint_script::{EventCertainty, EventKind, ScriptPlace, ScriptValue, World};

impl Material<'_> {
    pub(super) fn check_values(&self, world: &World, found: &mut Vec<Breach>) {
        for key in &self.keys {
            let base = base(&key.name);
            let is_element = base.len() < key.name.len();
            let Some(uniform) = self.declared(base).filter(|u| u.is_active) else {
                continue;
            };
            let (value, lacks) = self.value(world, key);
            if lacks {
                let name = &key.name;
                let message = match self.maker.boxing {
                    Boxing::Grouped => format!("uniform `{name}` has no `value` and `type`"),
                    _ => format!("the value of uniform `{name}` is not in `{{ value }}`"),
                };
                let breach = Breach::new("uniform-access", key.place, message)
                    .label(uniform.place, "declared here")
                    .note("the library reads `value` from it, which is undefined: the uniform stays 0")
                    .help(Some(format!("write `{name}: {{ value: ... }}`")));
                found.push(breach);
                continue;
            }
            let Some(value) = value.filter(|_| !is_element) else {
                continue;
            };
            let shape = ValueShape::of(world, value);
            if let Some(wrong) = misfit(&shape, uniform, self.maker.boxing) {
                // A placeholder until the first value is known.
                if !self.is_written(world, key) {
                    found.push(wrong_value(key.place, uniform, &wrong));
                }
            }
        }
        self.check_writes(world, found);
    }

    /// Checks values that are set later.
    pub(super) fn check_writes(&self, world: &World, found: &mut Vec<Breach>) {
        for event in &world.events {
            let EventKind::Write {
                object,
                key: Some(key),
                value,
            } = &event.kind
            else {
                continue;
            };
            if event.certainty == EventCertainty::Alternative {
                continue;
            }
            // `uniforms.name.value = ...`
            let name = self.name_of(world, *object);
            if let (Some(name), "value") = (&name, &**key)
                && let Some(uniform) = self.declared(name).filter(|u| u.is_active)
            {
                let shape = ValueShape::of(world, value);
                if let Some(wrong) = misfit(&shape, uniform, self.maker.boxing) {
                    found.push(wrong_value(event.place, uniform, &wrong));
                }
            }
            if self.maker.boxing != Boxing::Boxed {
                continue;
            }
            let is_bare = value.primitive().is_some()
                || matches!(
                    ValueShape::of(world, value),
                    ValueShape::Vector(..) | ValueShape::Matrix(..)
                );
            // `uniforms.name = 1`
            if self.is_uniforms(world, *object) && is_bare && self.declared(key).is_some() {
                let message =
                    format!("uniform `{key}` is replaced by a value without `{{ value }}`");
                let breach = Breach::new("uniform-access", event.place, message)
                    .note("the library reads `value` from it, which is undefined")
                    .help(Some(format!("set `{key}.value`")));
                found.push(breach);
            }
            // `material.name = 1`
            let has_own = world
                .object(*object)
                .is_none_or(|o| o.is_open || o.class.is_some_and(|c| world.declares(c, key)));
            let is_own = self.keys.iter().any(|k| k.name == **key) && !has_own;
            if *object == self.call.result && is_own && is_bare && self.declared(key).is_some() {
                let message = format!("`{key}` is set on the material, not on its uniform");
                let breach = Breach::new("uniform-access", event.place, message)
                    .note("the shader reads the uniform, which keeps its value")
                    .help(Some(format!("set `uniforms.{key}.value`")));
                found.push(breach);
            }
        }
    }

    /// Checks the types that a script names: `{ value, type: 'vec2<f32>' }`.
    pub(super) fn check_named_types(&self, world: &World, found: &mut Vec<Breach>) {
        for key in &self.keys {
            let named = world.get(&key.value, "type").and_then(ScriptValue::text);
            let (Some(named), Some(uniform)) = (named, self.declared(&key.name)) else {
                continue;
            };
            let glsl = match named.split_once('<') {
                None => ["f32", "i32", "u32"]
                    .iter()
                    .zip(["float", "int", "uint"])
                    .find(|(n, _)| **n == named)
                    .map(|(_, glsl)| glsl.to_string()),
                Some((shape, rest)) => {
                    let square = shape
                        .strip_prefix("mat")
                        .and_then(|size| size.split_once('x'));
                    let shape = match square {
                        Some((a, b)) if a == b => format!("mat{a}"),
                        _ => shape.to_string(),
                    };
                    Some(match rest {
                        "i32>" => format!("i{shape}"),
                        "u32>" => format!("u{shape}"),
                        _ => shape,
                    })
                }
            };
            let is_bool = uniform.type_name.starts_with('b');
            let Some(glsl) =
                glsl.filter(|glsl| *glsl != uniform.type_name && uniform.ty.array == 0 && !is_bool)
            else {
                continue;
            };
            found.push(wrong_value(
                key.place,
                uniform,
                &format!("the type `{named}`, a `{glsl}`"),
            ));
        }
    }
}

/// A value that does not fit its uniform.
pub(super) fn wrong_value(place: ScriptPlace, uniform: &DeclaredInput, wrong: &str) -> Breach {
    let message = format!(
        "uniform `{}` is a `{}`, but gets {wrong}",
        uniform.name, uniform.type_name
    );
    Breach::new("uniform-type", place, message).label(
        uniform.place,
        format!("declared as `{}`", uniform.type_name),
    )
}
