//! Names of uniforms: those that nothing sets, and those that no program has.

use super::{Material, UniformKey};
use crate::breach::{Breach, base, nearest};
use crate::interface::DeclaredInput;
use crate::library::Boxing;
use shaderlint_script::{EventKind, ObjectKind, ScriptPlace, Source, World};

impl Material<'_> {
    pub(super) fn check_missing(
        &self,
        world: &World,
        others: &[&Material],
        found: &mut Vec<Breach>,
    ) {
        let own = |of: &Material, name: &str| {
            let is_key = |key: &UniformKey| base(&key.name) == name;
            of.keys.iter().any(is_key) || of.is_set_later(world, name)
        };
        // The same code may make it for several classes, of which each sets its own.
        let same: Vec<&&Material> = others.iter().filter(|o| o.place == self.place).collect();
        let sets = |name: &str| own(self, name) || same.iter().any(|other| own(other, name));
        let all = self.stages.active_uniforms();
        let missing = all
            .iter()
            .filter(|u| !self.maker.gives(&u.name) && !sets(&u.name));
        let missing: Vec<&DeclaredInput> = missing.copied().collect();
        let is_known = |name: &str| {
            self.stages.mention(name) || others.iter().any(|other| other.stages.mention(name))
        };
        let strays = self.keys.iter().filter(|key| !is_known(base(&key.name)));
        let strays: Vec<&UniformKey> = strays.collect();
        let mut named: Vec<&str> = Vec::new();
        for key in &strays {
            let names = missing.iter().map(|u| u.name.as_str());
            let single = match (strays.len(), missing.as_slice()) {
                (1, [one]) if !self.is_open => Some(one.name.as_str()),
                _ => None,
            };
            if let Some(near) = nearest(&key.name, names).or(single) {
                let message = format!(
                    "no shader of this program declares the uniform `{}`",
                    key.name
                );
                let declared = missing
                    .iter()
                    .find(|u| u.name == near)
                    .and_then(|u| u.place);
                let breach = Breach::new("unknown-uniform", key.place, message)
                    .label(declared, "nothing sets this uniform")
                    .note(format!("`{near}` keeps the value 0"))
                    .help(Some(format!("did you mean `{near}`?")));
                found.push(breach);
                named.push(near);
            }
        }
        let required = self.maker.requires.as_deref();
        if let Some(required) = required.filter(|r| !self.is_open && !sets(r)) {
            let sampler = missing.iter().chain(&all).find(|u| u.is_sampler());
            found.push(self.without_required(required, sampler.and_then(|u| u.place)));
        }
        // What nothing is set on may be unused.
        let is_unused = !self.maker.setter.is_empty() && self.keys.is_empty();
        if self.is_open || is_unused {
            return;
        }
        for uniform in missing {
            // A sampler without a value reads what is bound to the first unit.
            let is_first_unit = uniform.is_sampler() && !self.maker.setter.is_empty();
            let is_named = named.contains(&uniform.name.as_str());
            if is_named || is_first_unit || world.is_mentioned(&uniform.name) {
                continue;
            }
            let message = format!("uniform `{}` is never set", uniform.name);
            let place = uniform.place.unwrap_or(self.place);
            let breach = Breach::new("unset-uniform", place, message)
                .label(Some(self.place), "this program gives it no value")
                .note("it is 0 in the shader")
                .help(Some(format!("add `{}` to the uniforms", uniform.name)));
            found.push(breach);
        }
    }

    /// A program without the uniform that its library sets.
    fn without_required(&self, required: &str, sampler: Option<ScriptPlace>) -> Breach {
        let maker = &self.call.name;
        let message = format!("`{maker}` sets `{required}`, which has no uniform");
        Breach::new("unset-uniform", self.place, message)
            .label(sampler, "the image is read from this uniform")
            .note("the pass hands the image to the uniform of this name, if there is one")
            .help(Some(format!("name the uniform `{required}`")))
    }

    /// Checks what is read from the uniforms later.
    pub(super) fn check_accesses(
        &self,
        world: &World,
        others: &[&Material],
        found: &mut Vec<Breach>,
    ) {
        let has = |name: &str| {
            let keys = || {
                self.keys
                    .iter()
                    .chain(others.iter().flat_map(|other| &other.keys))
            };
            // A key that looks like this uniform is reported, once.
            let strays = || keys().filter(|key| !self.stages.mention(base(&key.name)));
            keys().any(|key| key.name == name)
                || self.is_set_later(world, name)
                || self.stages.mention(name)
                    && nearest(name, strays().map(|key| key.name.as_str())).is_some()
        };
        if self.maker.boxing == Boxing::Boxed && !self.is_open {
            // `material.uniforms.name.value`
            for (id, object) in world.objects.iter().enumerate() {
                let Some((holder, name)) = world.member_of(id) else {
                    continue;
                };
                if !self.is_uniforms(world, holder) || has(name) || world.optional.contains(&id) {
                    continue;
                }
                let reads_value = world.objects.iter().any(|o| {
                    matches!(&o.kind,
                    ObjectKind::Foreign(Source::Member(of, key)) if *of == id && &**key == "value")
                });
                let writes_value = world.events.iter().any(|e| {
                    matches!(&e.kind,
                    EventKind::Write { object, .. } if *object == id)
                });
                if reads_value || writes_value {
                    found.push(self.stray_access(name, object.place));
                }
            }
            for event in &world.events {
                if let EventKind::Missing {
                    object,
                    key,
                    is_used: true,
                } = &event.kind
                    && self.uniforms == Some(*object)
                    && !has(key)
                {
                    found.push(self.stray_access(key, event.place));
                }
            }
        }
        if self.maker.boxing == Boxing::Plain && !self.is_open {
            self.check_plain_writes(world, found);
        }
    }

    /// Checks the uniforms of an object that the library copied.
    pub(super) fn check_copied(&self, world: &World, found: &mut Vec<Breach>) {
        let made = world.events.iter().position(|event| match &event.kind {
            EventKind::Call(call) => call.result == self.call.result,
            _ => false,
        });
        for event in world.events.iter().skip(made.unwrap_or(usize::MAX)) {
            let EventKind::Write {
                object,
                key: Some(key),
                ..
            } = &event.kind
            else {
                continue;
            };
            let own = self.keys.iter().find(|k| k.value.object() == Some(*object));
            if let (Some(own), "value") = (own, &**key) {
                let name = &own.name;
                let message = format!(
                    "`{name}` is set on an object that `{}` copied",
                    self.call.name
                );
                let breach = Breach::new("uniform-access", event.place, message)
                    .label(Some(self.place), "copied here")
                    .note("the program reads its own copy of the uniforms")
                    .help(Some(format!("set `uniforms.{name}.value` of the result")));
                found.push(breach);
            }
        }
    }

    /// Checks `filter.resources.group`.
    pub(super) fn check_groups(&self, world: &World, found: &mut Vec<Breach>) {
        let given = self.uniforms.and_then(|id| world.object(id));
        let Some(given) = given.filter(|o| !o.is_open) else {
            return;
        };
        for (id, object) in world.objects.iter().enumerate() {
            let Some((holder, name)) = world.member_of(id) else {
                continue;
            };
            let is_resources = world.member_of(holder) == Some((self.call.result, "resources"));
            let is_known =
                given.properties.iter().any(|p| *p.key == *name) || self.maker.gives(name);
            let is_read = world.objects.iter().any(|o| {
                matches!(&o.kind,
                ObjectKind::Foreign(Source::Member(of, _)) if *of == id)
            });
            if is_resources && !is_known && is_read && !world.optional.contains(&id) {
                let near = nearest(name, given.properties.iter().map(|p| &*p.key)).or_else(|| {
                    let mut starts = given.properties.iter().map(|p| &*p.key);
                    starts.find(|key| key.starts_with(name))
                });
                let message = format!("the program has no resource `{name}`");
                let breach = Breach::new("uniform-access", object.place, message)
                    .label(Some(given.place), "its resources")
                    .help(near.map(|near| format!("did you mean `{near}`?")));
                found.push(breach);
            }
        }
    }

    /// Checks `filter.uniforms.name = ...`.
    pub(super) fn check_plain_writes(&self, world: &World, found: &mut Vec<Breach>) {
        for event in &world.events {
            let EventKind::Write {
                object,
                key: Some(key),
                ..
            } = &event.kind
            else {
                continue;
            };
            let is_it = self.is_uniforms(world, *object) && Some(*object) != self.uniforms;
            if is_it && !self.stages.mention(key) && self.stages.all().all(|s| !s.is_open) {
                found.push(self.stray_access(key, event.place));
            }
        }
    }

    pub(super) fn stray_access(&self, name: &str, place: ScriptPlace) -> Breach {
        let message = format!("the program has no uniform `{name}`");
        let names = self.keys.iter().map(|key| key.name.as_str());
        let near = nearest(name, names);
        let declared = near.and_then(|near| self.keys.iter().find(|key| key.name == near));
        Breach::new("uniform-access", place, message)
            .label(
                declared.map(|key| key.place),
                "this uniform has a similar name",
            )
            .help(near.map(|near| format!("did you mean `{near}`?")))
    }
}
