//! Which places of scripts name and set the inputs of programs of WebGL.

use super::replay::{GlReplay, argument};
use super::setters::Setter;
use crate::bindings::{InputSetting, ProgramBindings, value_of_all};
use shaderlint_script::{EventKind, ObjectId, ScriptValue};
use std::collections::BTreeMap;

impl GlReplay<'_> {
    /// The inputs of the programs with the places that name and set them.
    pub fn bind(&self) -> impl Iterator<Item = ProgramBindings> {
        let world = self.world;
        let programs = self.programs.iter();
        let new = programs.map(|(id, p)| (*id, ProgramBindings::new(p.place, &p.stages)));
        let mut all: BTreeMap<ObjectId, ProgramBindings> = new.collect();
        for location in self.locations.values() {
            let Some(found) = all.get_mut(&location.program) else {
                continue;
            };
            match &location.name {
                Some(name) => found.mention(world, name, location.place),
                // What WebGL lists is named by the shader.
                None if location.is_listed => {}
                None => found.computed.push(location.place),
            }
        }
        for (id, program) in &self.programs {
            let names = program
                .bound
                .iter()
                .filter_map(|(_, name, place)| Some((name.as_ref()?, place)));
            for (name, place) in names {
                if let Some(found) = all.get_mut(id) {
                    found.mention(world, name, *place);
                }
            }
        }
        for (table, place) in &world.reads {
            let file = world.files.get(place.file);
            let name =
                file.and_then(|(_, text)| text.get(place.start as usize..place.end as usize));
            let program = self.tables.get(table).and_then(|id| all.get_mut(id));
            if let (Some(name), Some(found)) = (name, program) {
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
            let set = self.uniform_location(argument(call, 0));
            let Some((program, Some(name), _)) = set else {
                continue;
            };
            let values = call.arguments.iter().map(|(value, _)| value);
            let values: Vec<&ScriptValue> = match setter.columns {
                1 => values.skip(1).collect(),
                // After `transpose`.
                _ => values.skip(2).collect(),
            };
            let value = value_of_all(world, values.into_iter());
            let place = event.place;
            if let Some(found) = all.get_mut(&program) {
                found.set(&name, InputSetting { place, value });
            }
        }
        all.into_values().map(ProgramBindings::finish)
    }
}
