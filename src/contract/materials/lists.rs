//! The lists of names and the stores of shaders that some libraries ask for.

use super::{Material, stored};
use crate::breach::Breach;
use crate::library::at;
use shaderlint_script::{EventKind, ScriptValue, World};
use shaderlint_semantic::Stage;

impl Material<'_> {
    /// Checks the lists of names that a program is made with.
    pub(super) fn check_lists(&self, world: &World, found: &mut Vec<Breach>) {
        found.extend(self.wrong.iter().cloned());
        let names = |value: &ScriptValue| -> Option<Vec<String>> {
            let all = world.elements(value)?.iter();
            all.map(|value| value.text().map(str::to_string)).collect()
        };
        let place = |path: &[String]| {
            let index = path.first().and_then(|index| index.parse::<usize>().ok());
            index
                .and_then(|index| self.call.arguments.get(index))
                .map_or(self.place, |(_, place)| *place)
        };
        if !self.maker.store.is_empty()
            && let Some(list) = self.attributes.as_ref().and_then(names)
        {
            let inputs = self.stages.vertex.iter().flat_map(|s| &s.inputs);
            for attribute in inputs.filter(|a| a.is_active && !list.contains(&a.name)) {
                let message = format!(
                    "attribute `{}` is not in the list `attributes`",
                    attribute.name
                );
                let breach = Breach::new(
                    "attribute-data",
                    attribute.place.unwrap_or(self.place),
                    message,
                )
                .label(Some(place(&self.maker.attributes)), "the list")
                .note("it gets no data");
                found.push(breach);
            }
        }
        let listed = at(world, self.call, &self.maker.listed);
        if self.maker.is_limited
            && let Some(list) = listed.as_ref().and_then(names)
        {
            for uniform in self.stages.active_uniforms() {
                if list.contains(&uniform.name)
                    || uniform.is_sampler()
                    || self.maker.gives(&uniform.name)
                {
                    continue;
                }
                let message = format!(
                    "uniform `{}` is not in the list of parameters",
                    uniform.name
                );
                let breach = Breach::new("unset-uniform", place(&self.maker.listed), message)
                    .label(uniform.place, "declared here")
                    .note("only listed uniforms can be set: it is 0 in the shader");
                found.push(breach);
            }
        }
        if self.maker.store.is_empty() {
            return;
        }
        for (index, stage) in [Stage::Vertex, Stage::Fragment].into_iter().enumerate() {
            let path = self.maker.stages.get(index).filter(|path| !path.is_empty());
            let name = path.and_then(|path| at(world, self.call, path));
            let Some(name) = name.as_ref().and_then(ScriptValue::text) else {
                continue;
            };
            let keys = world.events.iter().filter_map(|event| match &event.kind {
                EventKind::Write {
                    key: Some(key),
                    value: ScriptValue::Text(_),
                    ..
                } => Some((key, event.place)),
                _ => None,
            });
            let near = keys.clone().find(|(key, _)| key.starts_with(name));
            if stored(world, name, stage).is_some() || near.is_none() || stage == Stage::Vertex {
                continue;
            }
            let message = format!("no fragment shader is stored as `{name}FragmentShader`");
            let breach = Breach::new("program-state", near.map_or(self.place, |(_, place)| place), message)
                .label(Some(self.place), format!("`{name}` is used here"))
                .note("the names of stored shaders end with `VertexShader`, `FragmentShader` or `PixelShader`");
            found.push(breach);
        }
    }
}
