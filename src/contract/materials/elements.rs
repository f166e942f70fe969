//! Instances of a class that a library makes of shaders, also as elements of React: `<waveMaterial uTime={1} />`.

use super::Material;
use crate::breach::{Breach, nearest};
use crate::library::is_property;
use shaderlint_script::{EventKind, ForeignCall, ObjectKind, ScriptPlace, World};

impl Material<'_> {
    /// Checks what is set on instances of the class: names that only look like those of uniforms.
    pub(super) fn check_instances(&self, world: &World, found: &mut Vec<Breach>) {
        if self.is_open {
            return;
        }
        for all in self.instances(world) {
            for (name, place) in &all {
                let rest = self.keys.iter().map(|key| key.name.as_str());
                let rest = rest.filter(|known| all.iter().all(|(given, _)| given != known));
                let is_known = self.stages.mention(name) || is_property(name);
                if !is_known && nearest(name, rest).is_some() {
                    found.push(self.stray_access(name, *place));
                }
            }
        }
    }

    /// The names that are set on each instance of the class.
    pub(super) fn instances<'v>(&self, world: &'v World) -> Vec<Vec<(&'v str, ScriptPlace)>> {
        if !self.maker.is_class {
            return Vec::new();
        }
        let calls = || {
            world.events.iter().filter_map(|event| match &event.kind {
                EventKind::Call(call) => Some(call),
                _ => None,
            })
        };
        let names: Vec<String> = calls()
            .filter_map(|call| self.registered(world, call))
            .collect();
        let own = calls().filter(|call| match call.callee {
            _ if !call.is_new => false,
            Some(class) => class == self.call.result,
            None => names.iter().any(|name| **name == *call.name),
        });
        let set = own.map(|call| {
            let attributes = call.arguments.first().filter(|_| call.callee.is_none());
            let attributes = attributes.and_then(|(value, _)| world.object(value.object()?));
            let attributes = attributes.map_or(&[][..], |object| &object.properties);
            let given = attributes.iter().map(|p| (&*p.key, p.place));
            let later = world.events.iter().filter_map(|event| match &event.kind {
                EventKind::Write {
                    object,
                    key: Some(key),
                    ..
                } if *object == call.result => Some((&**key, event.place)),
                _ => None,
            });
            given.chain(later).collect()
        });
        set.collect()
    }

    /// The name of its elements if a call registers the class: `extend({ WaveMaterial })`.
    fn registered(&self, world: &World, call: &ForeignCall) -> Option<String> {
        let object = world.object(call.arguments.first()?.0.object()?)?;
        let ObjectKind::Plain = object.kind else {
            return None;
        };
        let is_it = |value: Option<_>| value == Some(self.call.result);
        let own = object.properties.iter().find(|p| is_it(p.value.object()))?;
        let mut letters = own.key.chars();
        let first = letters.next()?.to_ascii_lowercase();
        Some(format!("{first}{}", letters.as_str()))
    }
}
