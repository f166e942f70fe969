//! Uniforms that scripts set with WebGL.

use super::replay::{GlLocation, GlProgram, GlReplay, argument, place_of};
use super::setters::Setter;
use crate::bindings::ProgramBindings;
use crate::breach::{Breach, base, nearest};
use crate::interface::DeclaredInput;
use crate::shape::{ValueShape, frame_size};
use shaderlint_script::{
    EventCertainty, EventKind, ForeignCall, ObjectId, ObjectKind, ScriptEvent, ScriptPlace,
    ScriptValue, Source, World,
};
use std::collections::BTreeMap;

/// Whether a value is a size in CSS pixels.
pub fn is_css_size(world: &World, value: &ScriptValue) -> bool {
    frame_size(world, value).is_some_and(|(_, is_css)| is_css)
}

/// Whether a program multiplies sizes by the number of device pixels per CSS pixel.
pub fn uses_pixel_ratio(world: &World) -> bool {
    world.objects.iter().any(|o| match &o.kind {
        ObjectKind::Foreign(Source::Global(name) | Source::Member(_, name)) => {
            &**name == "devicePixelRatio"
        }
        _ => false,
    })
}

impl GlReplay<'_> {
    /// The location that a value is, also one of a table by names.
    pub fn uniform_location(
        &self,
        value: Option<&ScriptValue>,
    ) -> Option<(ObjectId, Option<String>, ScriptPlace)> {
        if let Some((location, _)) = self.location(value).filter(|(l, _)| !l.is_attribute) {
            return Some((location.program, location.name.clone(), location.place));
        }
        let (table, name) = self.world.member_of(value?.object()?)?;
        let program = self.tables.get(&table)?;
        Some((*program, Some(name.to_string()), ScriptPlace::default()))
    }

    /// Checks a call that looks up a name.
    pub fn check_lookup(&mut self, call: &ForeignCall) {
        let Some(GlLocation {
            program,
            name: Some(name),
            is_attribute,
            place,
            is_listed,
        }) = self.locations.get(&call.result)
        else {
            return;
        };
        let (place, is_attribute, is_listed) = (*place, *is_attribute, *is_listed);
        let Some(program) = self.programs.get(program) else {
            return;
        };
        let word = base(name);
        let names: Vec<&str> = match is_attribute {
            true => {
                let inputs = program.stages.vertex.iter().flat_map(|s| &s.inputs);
                inputs.map(|a| a.name.as_str()).collect()
            }
            false => {
                let uniforms = program.stages.all().flat_map(|s| &s.uniforms);
                uniforms.map(|u| u.name.as_str()).collect()
            }
        };
        if program.is_open || names.contains(&word) || program.stages.mention(word) {
            return self.verdicts.good(place);
        }
        let kind = if is_attribute { "attribute" } else { "uniform" };
        let near = nearest(word, names.iter().copied());
        if is_listed && near.is_none() {
            return;
        }
        let declared = near.and_then(|near| {
            let all = program.stages.all();
            all.flat_map(|s| s.uniforms.iter().chain(&s.inputs))
                .find(|d| d.name == near)?
                .place
        });
        let note = match is_attribute {
            true => "the location is -1, which no function accepts",
            false => "the location is null, so setting it has no effect",
        };
        let rule = if is_attribute {
            "attribute-data"
        } else {
            "unknown-uniform"
        };
        let message = format!("no shader of this program declares the {kind} `{word}`");
        let breach = Breach::new(rule, place, message)
            .label(declared, "this one has a similar name")
            .note(note)
            .help(near.map(|near| format!("did you mean `{near}`?")));
        self.verdicts.bad(breach);
    }

    /// Checks a call that sets a uniform.
    pub fn check_setter(&mut self, call: &ForeignCall, event: &ScriptEvent) {
        let Some(setter) = Setter::named(&call.name) else {
            return;
        };
        let Some((id, Some(name), looked_up)) = self.uniform_location(argument(call, 0)) else {
            return;
        };
        let Some(program) = self.programs.get(&id) else {
            return;
        };
        let place = event.place;
        if program.is_open {
            return self.verdicts.good(place);
        }
        let word = base(&name);
        let Some(uniform) = program.stages.uniform(word) else {
            let is_elsewhere = self
                .programs
                .values()
                .any(|p| p.stages.uniform(word).is_some());
            let is_reported = !matches!(self.verdicts.0.get(&looked_up), Some(None));
            if program.stages.mention(word) || !is_elsewhere || is_reported {
                return;
            }
            let message = format!("`{word}` is not a uniform of this program");
            let breach = Breach::new("program-state", place, message)
                .label(Some(program.place), "this program")
                .note("the location is null, so setting it has no effect");
            return self.verdicts.bad(breach);
        };
        if !uniform.is_active || event.certainty == EventCertainty::Alternative {
            return self.verdicts.good(place);
        }
        let breach = self
            .wrong_setter(setter, call, uniform, &name, place)
            .or_else(|| {
                let is_current = match self.current {
                    Ok(current) => current == Some(id),
                    Err(()) => true,
                };
                (!is_current).then(|| self.wrong_program(program, uniform, place))
            });
        let breach = breach.or_else(|| self.css_size(setter, call, program, uniform, place));
        match breach {
            Some(breach) => self.verdicts.bad(breach),
            None => self.verdicts.good(place),
        }
    }

    fn wrong_setter(
        &self,
        setter: Setter,
        call: &ForeignCall,
        uniform: &DeclaredInput,
        name: &str,
        place: ScriptPlace,
    ) -> Option<Breach> {
        let has_member = name.contains('.');
        if has_member || uniform.is_struct() {
            return None;
        }
        if !setter.fits(uniform)? {
            let message = format!(
                "`{}` cannot set uniform `{}`, a `{}`",
                call.name, uniform.name, uniform.type_name
            );
            let needed = setter.name_for(uniform);
            let breach = Breach::new("uniform-type", place, message)
                .label(
                    uniform.place,
                    format!("declared as `{}`", uniform.type_name),
                )
                .note("WebGL reports INVALID_OPERATION, and the uniform keeps its value")
                .help(needed.map(|name| format!("use `{name}`")));
            return Some(breach);
        }
        if !setter.is_array {
            return None;
        }
        let data = if setter.columns > 1 { 2 } else { 1 };
        // With an offset and a length, only a part is read.
        if call.arguments.len() > data + 1 {
            return None;
        }
        let ValueShape::Numbers(Some(length)) = ValueShape::of(self.world, argument(call, data)?)
        else {
            return None;
        };
        let size = setter.components();
        let is_array = uniform.ty.array > 0;
        if length % size == 0 && length > 0 && (is_array || length == size) {
            return None;
        }
        let message = format!(
            "uniform `{}` is a `{}`, but gets {length} numbers",
            uniform.name, uniform.type_name
        );
        let expected = if is_array { "a multiple of " } else { "" };
        let breach = Breach::new("uniform-type", place_of(call, data).unwrap_or(place), message)
            .label(uniform.place, format!("declared as `{}`", uniform.type_name))
            .note(format!("`{}` expects {expected}{size} numbers; WebGL reports an error, and the uniform keeps its value", call.name));
        Some(breach)
    }

    fn wrong_program(
        &self,
        program: &GlProgram,
        uniform: &DeclaredInput,
        place: ScriptPlace,
    ) -> Breach {
        let current = self
            .current
            .ok()
            .flatten()
            .and_then(|id| self.programs.get(&id));
        let message = match current {
            Some(_) => format!(
                "uniform `{}` is set while another program is in use",
                uniform.name
            ),
            None => format!("uniform `{}` is set before `useProgram`", uniform.name),
        };
        Breach::new("program-state", place, message)
            .label(Some(program.place), "the uniform belongs to this program")
            .note("WebGL reports INVALID_OPERATION, and the uniform keeps its value")
            .help(Some("call `useProgram` with its program first".to_string()))
    }

    /// A size in CSS pixels for a shader that divides positions in device pixels by it.
    fn css_size(
        &self,
        setter: Setter,
        call: &ForeignCall,
        program: &GlProgram,
        uniform: &DeclaredInput,
        place: ScriptPlace,
    ) -> Option<Breach> {
        let all = call.arguments.get(1..)?;
        let is_css =
            setter.rows >= 2 && all.iter().take(2).all(|(v, _)| is_css_size(self.world, v));
        let divides = |uniform: &DeclaredInput| {
            let fragment = program.stages.fragment.as_ref();
            fragment.is_some_and(|s| s.divides_coordinates(&uniform.name))
        };
        (is_css && divides(uniform) && uses_pixel_ratio(self.world))
            .then(|| css_size(uniform, place))
    }

    /// Reports uniforms that nothing sets.
    pub fn check_unset(
        &self,
        bindings: &BTreeMap<ObjectId, ProgramBindings>,
        found: &mut Vec<Breach>,
    ) {
        // Another module may set what it looks up.
        let looked_up = self
            .locations
            .values()
            .filter(|l| l.name.is_none())
            .map(|l| l.program);
        let open: Vec<ObjectId> = looked_up.collect();
        for (id, program) in &self.programs {
            if program.is_open || !program.is_drawn || open.contains(id) {
                continue;
            }
            let is_set = |name: &str| {
                let input = bindings.get(id).and_then(|bound| bound.input(name));
                input.is_some_and(|input| input.escapes || !input.settings.is_empty())
            };
            for uniform in program.stages.active_uniforms() {
                if uniform.is_sampler() || is_set(&uniform.name) {
                    continue;
                }
                // A name that is looked up wrongly is reported there.
                let is_misspelled = self.verdicts.0.values().flatten().any(|breach| {
                    let help = breach.help.as_deref().unwrap_or("");
                    breach.rule == "unknown-uniform"
                        && help.contains(&format!("`{}`", uniform.name))
                });
                let is_elsewhere = self.locations.values().any(|l| {
                    l.program == *id
                        && l.name.as_deref().map(base) == Some(&uniform.name)
                        && self.escapes(l)
                });
                if is_misspelled || is_elsewhere {
                    continue;
                }
                let message = format!("uniform `{}` is never set", uniform.name);
                let place = uniform.place.unwrap_or(program.place);
                let breach = Breach::new("unset-uniform", place, message)
                    .label(Some(program.place), "this program")
                    .note("it is 0 in the shader");
                found.push(breach);
            }
        }
    }

    /// Whether a location may be used by code that is not followed.
    fn escapes(&self, location: &GlLocation) -> bool {
        let id = self
            .locations
            .iter()
            .find(|(_, l)| l.place == location.place)
            .map(|(id, _)| *id);
        let Some(id) = id else { return false };
        self.world.events.iter().any(|event| match &event.kind {
            EventKind::Call(call) => {
                let takes = call
                    .arguments
                    .iter()
                    .any(|(value, _)| value.object() == Some(id));
                takes && Setter::named(&call.name).is_none()
            }
            _ => false,
        })
    }
}

/// A size in CSS pixels for a shader that divides `gl_FragCoord` by it.
pub fn css_size(uniform: &DeclaredInput, place: ScriptPlace) -> Breach {
    let message = format!("uniform `{}` is a size in CSS pixels", uniform.name);
    Breach::new("screen-size", place, message)
        .label(uniform.place, "`gl_FragCoord` is divided by it")
        .note("`gl_FragCoord` counts device pixels, and this program uses the device pixel ratio")
        .help(Some(
            "use the size of the drawing buffer: `canvas.width` and `canvas.height`".to_string(),
        ))
}
