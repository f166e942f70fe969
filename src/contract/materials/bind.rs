//! Which places of scripts name and set the uniforms of a program.

use super::Material;
use crate::bindings::{
    InputSetting, InputValue, ProgramBindings, is_increment, value_of, value_of_all,
};
use shaderlint_script::{
    EventKind, ForeignCall, ObjectId, ScriptEvent, ScriptPlace, ScriptValue, World,
};

impl Material<'_> {
    /// The inputs with the places that name and set them. `release` is the one of three.js.
    pub fn bind(&self, world: &World, release: Option<u32>) -> ProgramBindings {
        let mut found = ProgramBindings::new(self.place, &self.stages);
        for key in &self.keys {
            found.mention(world, &key.name, key.place);
            let (value, _) = self.value(world, key);
            let value = value.and_then(|value| value_of(world, value, release));
            let place = key.place;
            found.set(&key.name, InputSetting { place, value });
        }
        // What is set on an instance changes its uniform.
        for (name, place) in self.instances(world).into_iter().flatten() {
            if found.input(name).is_some() {
                found.mention(world, name, place);
                found.set(name, InputSetting { place, value: None });
            }
        }
        for (id, place) in &world.reads {
            if self.holds_uniforms(world, *id) {
                found.mention(world, world.code(*place).unwrap_or(""), *place);
            }
        }
        for event in &world.events {
            match &event.kind {
                EventKind::Write { object, key, value } => {
                    let written = (*object, key.as_deref(), value);
                    self.bind_write(world, written, event.place, &mut found);
                }
                EventKind::Call(call) => self.bind_call(world, call, event, &mut found),
                EventKind::Missing { .. } => {}
            }
        }
        found
    }

    /// Whether the members of an object are the uniforms.
    fn holds_uniforms(&self, world: &World, id: ObjectId) -> bool {
        self.is_uniforms(world, id) || world.is_foreign(id) && self.is_in_result(world, id)
    }

    fn bind_write(
        &self,
        world: &World,
        (object, key, value): (ObjectId, Option<&str>, &ScriptValue),
        place: ScriptPlace,
        found: &mut ProgramBindings,
    ) {
        let owner = self.owner_of(world, object);
        if let Some(name) = self.name_of(world, object).or(owner) {
            let value = match key {
                _ if is_increment(world, place) => Some(InputValue::Time),
                Some("value") => value_of(world, value, None),
                // `vector.x = 1`
                _ => None,
            };
            found.set(&name, InputSetting { place, value });
        } else if self.holds_uniforms(world, object) {
            let Some(key) = key else {
                return found.computed.push((None, place));
            };
            found.mention(world, key, place);
            let value = world.get(value, "value").unwrap_or(value);
            let value = value_of(world, value, None);
            found.set(key, InputSetting { place, value });
        }
    }

    fn bind_call(
        &self,
        world: &World,
        call: &ForeignCall,
        event: &ScriptEvent,
        found: &mut ProgramBindings,
    ) {
        if call.result == self.call.result {
            return;
        }
        let place = event.place;
        if let Some(name) = call.this.and_then(|id| self.owner_of(world, id)) {
            let all = call.arguments.iter().map(|(value, _)| value);
            let is_set = &*call.name == "set" && call.arguments.len() > 1;
            let value = is_set.then(|| value_of_all(world, all)).flatten();
            return found.set(&name, InputSetting { place, value });
        }
        let is_own = call.this == Some(self.call.result);
        let is_setter = !self.maker.setter.is_empty() || call.name.starts_with("setUniform");
        if let Some((name, place)) = call.arguments.first().filter(|_| is_own && is_setter) {
            match name.text() {
                Some(name) => found.mention(world, name, *place),
                None if name.object().is_none() => found.computed.push((None, *place)),
                None => {}
            }
        }
        for (value, _) in &call.arguments {
            let Some(id) = value.object() else { continue };
            let name = self.name_of(world, id).or_else(|| self.owner_of(world, id));
            let is_all = self.uniforms == Some(id) && !call.is_new;
            for input in &mut found.inputs {
                input.escapes |= is_all || name.as_deref() == Some(&*input.name);
            }
        }
    }

    /// The uniform whose value an object is.
    fn owner_of(&self, world: &World, id: ObjectId) -> Option<String> {
        if let Some((of, "value")) = world.member_of(id) {
            return self.name_of(world, of);
        }
        let is_it = |value: Option<&ScriptValue>| value.and_then(ScriptValue::object) == Some(id);
        let key = self.keys.iter().find(|key| is_it(self.value(world, key).0));
        key.map(|key| key.name.clone())
    }
}
