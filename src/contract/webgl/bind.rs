//! Which places of scripts name and set the inputs of programs of WebGL.

use super::replay::{GlReplay, argument};
use super::setters::Setter;
use crate::bindings::{InputSetting, ProgramBindings, value_of_all};
use shaderlint_script::{EventKind, ObjectId};
use std::collections::BTreeMap;

impl GlReplay<'_> {
    /// The inputs of the programs with the places that name and set them.
    pub fn bind(&self) -> BTreeMap<ObjectId, ProgramBindings> {
        let world = self.world;
        let programs = self.programs.iter();
        let new = programs.map(|(id, p)| (*id, ProgramBindings::new(p.place, &p.stages)));
        let mut all: BTreeMap<ObjectId, ProgramBindings> = new.collect();
        for location in self.locations.values() {
            match (all.get_mut(&location.program), &location.name) {
                (Some(found), Some(name)) => found.mention(world, name, location.place),
                // What WebGL lists is named by the shader.
                (Some(found), None) if !location.is_listed => {
                    found.computed.push((None, location.place));
                }
                _ => {}
            }
        }
        for (id, program) in &self.programs {
            let Some(found) = all.get_mut(id) else {
                continue;
            };
            for (_, name, place) in &program.bound {
                if let Some(name) = name {
                    found.mention(world, name, *place);
                }
            }
            found
                .inputs
                .iter_mut()
                .for_each(|input| input.escapes = program.is_open);
        }
        for (table, place) in &world.reads {
            let program = self.tables.get(table).and_then(|id| all.get_mut(id));
            if let (Some(name), Some(found)) = (world.code(*place), program) {
                found.mention(world, name, *place);
            }
        }
        for event in &world.events {
            let EventKind::Call(call) = &event.kind else {
                continue;
            };
            let Some(setter) = Setter::named(&call.name) else {
                continue;
            };
            let known = self.uniform_location(argument(call, 0));
            let Some((program, Some(name), _)) = known else {
                // It may set any.
                let is_it = |id: &ObjectId| known.as_ref().is_none_or(|(of, _, _)| of == id);
                let programs = all.iter_mut().filter(|(id, _)| is_it(id));
                let inputs = programs.flat_map(|(_, program)| &mut program.inputs);
                inputs.for_each(|input| input.escapes = true);
                continue;
            };
            // After the location and `transpose`.
            let first = if setter.columns > 1 { 2 } else { 1 };
            let values = call.arguments.iter().skip(first).map(|(value, _)| value);
            let value = value_of_all(world, values);
            let place = event.place;
            if let Some(found) = all.get_mut(&program) {
                found.set(&name, InputSetting { place, value });
            }
        }
        all
    }
}
