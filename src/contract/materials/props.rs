//! Commands of regl: arguments, and arrays by their elements.

use super::{Material, UniformKey, values::wrong_value};
use crate::breach::{Breach, nearest};
use crate::fit::misfit;
use crate::library::Boxing;
use crate::shape::ValueShape;
use shaderlint_script::{EventKind, ObjectKind, ScriptValue, World};

impl Material<'_> {
    /// Checks the arguments of a command of regl: `regl.prop('name')`.
    pub(super) fn check_props(&self, world: &World, found: &mut Vec<Breach>) {
        if self.maker.boxing == Boxing::Grouped {
            self.check_groups(world, found);
            self.check_named_types(world, found);
        }
        if self.maker.copies {
            self.check_copied(world, found);
        }
        let props = self.keys.iter().filter_map(|key| {
            let call = world.call_of(key.value.object()?)?;
            let name = call.arguments.first()?.0.text()?;
            (&*call.name == "prop" && !name.contains(['.', '['])).then_some((key, name))
        });
        for (key, name) in props {
            for event in &world.events {
                let EventKind::Call(call) = &event.kind else {
                    continue;
                };
                if call.callee != Some(self.call.result) {
                    continue;
                }
                let Some((argument, place)) = call.arguments.first() else {
                    continue;
                };
                let all = world
                    .elements(argument)
                    .map_or(vec![argument.clone()], <[ScriptValue]>::to_vec);
                for props in all {
                    let object = props.object().and_then(|id| world.object(id));
                    let Some(object) =
                        object.filter(|o| matches!(o.kind, ObjectKind::Plain) && !o.is_open)
                    else {
                        continue;
                    };
                    let Some(property) = object.properties.iter().find(|p| &*p.key == name) else {
                        let near = nearest(name, object.properties.iter().map(|p| &*p.key));
                        let message = format!("uniform `{}` gets no `{name}`", key.name);
                        let breach = Breach::new("unset-uniform", *place, message)
                            .label(
                                Some(key.place),
                                "its value is this property of the argument",
                            )
                            .help(near.map(|near| format!("`{near}` has a similar name")));
                        found.push(breach);
                        continue;
                    };
                    let uniform = self.declared(&key.name).filter(|u| u.is_active);
                    let shape = ValueShape::of(world, &property.value);
                    if let Some(uniform) = uniform
                        && let Some(wrong) = misfit(&shape, uniform, self.maker.boxing)
                    {
                        found.push(wrong_value(property.place, uniform, &wrong));
                    }
                }
            }
        }
        self.check_array_elements(found);
    }

    /// Checks that each element of an array has a value: `'centers[0]'`, `'centers[1]'`.
    pub(super) fn check_array_elements(&self, found: &mut Vec<Breach>) {
        if self.is_open {
            return;
        }
        for uniform in self.stages.active_uniforms() {
            let set: Vec<&UniformKey> = self
                .keys
                .iter()
                .filter(|key| {
                    key.name
                        .strip_prefix(&uniform.name)
                        .is_some_and(|rest| rest.starts_with('['))
                })
                .collect();
            let index = |key: &&UniformKey| {
                let rest = key.name.get(uniform.name.len() + 1..)?;
                rest.split(']').next()?.parse::<u32>().ok()
            };
            let known: Vec<u32> = set.iter().filter_map(index).collect();
            if known.is_empty() || known.len() < set.len() {
                continue;
            }
            let missing = (0..uniform.ty.array.min(64)).find(|at| !known.contains(at));
            let (Some(missing), Some(last)) = (missing, set.last()) else {
                continue;
            };
            let message = format!("`{}[{missing}]` is never set", uniform.name);
            let breach = Breach::new("unset-uniform", last.place, message)
                .label(uniform.place, format!("a `{}`", uniform.type_name));
            found.push(breach);
        }
    }
}
