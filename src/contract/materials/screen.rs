//! Sizes of the screen.

use super::Material;
use crate::breach::Breach;
use crate::webgl::{css_size, is_css_size};
use shaderlint_script::{EventKind, ObjectId, ObjectKind, ScriptPlace, ScriptValue, Source, World};

impl Material<'_> {
    /// Checks sizes of the screen: `gl_FragCoord` counts device pixels.
    pub(super) fn check_screen(&self, world: &World, found: &mut Vec<Breach>) {
        let scales = world.events.iter().any(|event| match &event.kind {
            EventKind::Call(call) => {
                let ratio = call.arguments.first().map(|(value, _)| value);
                &*call.name == "setPixelRatio"
                    && ratio.is_some_and(|ratio| ratio.number() != Some(1.0))
            }
            _ => false,
        });
        let Some(fragment) = self.stages.fragment.as_ref().filter(|_| scales) else {
            return;
        };
        for key in &self.keys {
            let Some(uniform) = self.declared(&key.name) else {
                continue;
            };
            if !fragment.divides_coordinates(&key.name) {
                continue;
            }
            let (value, _) = self.value(world, key);
            let value = value.and_then(ScriptValue::object);
            let mut sets = Vec::new();
            for event in &world.events {
                let EventKind::Call(call) = &event.kind else {
                    continue;
                };
                let is_own = |id: ObjectId| match world.object(id).map(|o| &o.kind) {
                    Some(ObjectKind::Foreign(Source::Member(of, member))) => {
                        &**member == "value"
                            && self.name_of(world, *of).as_deref() == Some(&*key.name)
                    }
                    _ => value == Some(id),
                };
                if &*call.name == "set" && call.this.is_some_and(is_own) {
                    sets.push((call, event.place));
                }
            }
            let first = value
                .and_then(|id| world.call_of(id))
                .filter(|_| sets.is_empty());
            sets.extend(first.map(|call| (call, key.place)));
            for (call, place) in sets {
                let all = call.arguments.get(..2).unwrap_or(&[]);
                let is_css = |(value, _): &(ScriptValue, ScriptPlace)| {
                    is_css_size(world, value) || is_set_size(world, value)
                };
                if all.len() == 2 && all.iter().all(is_css) {
                    found.push(css_size(uniform, place));
                }
            }
        }
    }
}

/// Whether a value is a size that `renderer.setSize` gets or `renderer.getSize` gives, both in CSS pixels.
pub(super) fn is_set_size(world: &World, value: &ScriptValue) -> bool {
    let given = world.events.iter().any(|event| match &event.kind {
        EventKind::Call(call) if &*call.name == "setSize" => call
            .arguments
            .iter()
            .take(2)
            .any(|(size, _)| size.is_same(value)),
        _ => false,
    });
    let object = value.object().and_then(|id| world.object(id));
    let asked = match object.map(|o| &o.kind) {
        Some(ObjectKind::Foreign(Source::Member(of, _))) => world
            .call_of(*of)
            .is_some_and(|call| &*call.name == "getSize"),
        _ => false,
    };
    given || asked
}
