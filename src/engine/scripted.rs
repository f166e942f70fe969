//! The values that scripts give the uniforms of a shader.

use crate::contracts::contracts;
use crate::options::Options;
use shaderlint_contract::{BoundInput, Contract, InputValue};
use shaderlint_host::Feed;
use shaderlint_project::{Files, Project};
use shaderlint_script::ScriptPlace;
use shaderlint_text::path::plain;

/// A uniform and the value that scripts give it.
#[derive(Clone, PartialEq, Debug)]
pub struct ScriptedValue {
    /// Its name.
    pub name: String,
    /// Its first value.
    pub value: InputValue,
    /// File and line of the script: `main.js:9`.
    pub place: String,
    /// Whether nothing changes it.
    pub is_constant: bool,
}

/// The values of the uniforms that a file declares, as the scripts around it set them. Those that programs set
/// differently are left out.
pub fn scripted(
    path: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
) -> Vec<ScriptedValue> {
    let own = plain(&files.here().join(path));
    let mut found: Vec<ScriptedValue> = Vec::new();
    let mut unequal: Vec<String> = Vec::new();
    for contract in contracts(path, text, options, files) {
        let is_own = |place: &ScriptPlace| {
            let file = contract.files.get(place.file);
            file.is_some_and(|(path, _)| plain(&files.here().join(path)) == own)
        };
        let inputs = contract.bindings.iter().flat_map(|program| &program.inputs);
        for input in inputs.filter(|i| !i.is_attribute && i.declared.iter().any(is_own)) {
            let value = scripted_value(&contract, input);
            match found.iter_mut().find(|known| known.name == input.name) {
                Some(known) => {
                    let is_equal = value.as_ref().is_some_and(|v| v.value == known.value);
                    known.is_constant &= is_equal && value.as_ref().is_some_and(|v| v.is_constant);
                    unequal.extend(value.filter(|_| !is_equal).map(|v| v.name));
                }
                None => found.extend(value),
            }
        }
    }
    found.retain(|value| !unequal.contains(&value.name));
    found
}

fn scripted_value(contract: &Contract, input: &BoundInput) -> Option<ScriptedValue> {
    let (value, place) = input.value()?;
    Some(ScriptedValue {
        name: input.name.clone(),
        is_constant: input.is_constant(),
        value: value.clone(),
        place: contract.line(place)?,
    })
}

/// Gives the uniforms of a project whose meaning is not known the values of scripts. What the text itself describes
/// stays as it is.
pub fn set_from_scripts(project: &mut Project, values: &[ScriptedValue]) {
    let mut set = Vec::new();
    for scripted in values {
        let (name, value) = (&scripted.name, &scripted.value);
        let mut all = project.controls.iter().skip(project.described);
        let Some(at) = all.position(|c| c.name == *name) else {
            continue;
        };
        let mut control = project.controls.remove(at + project.described);
        let feed = match (value, control.value.len()) {
            (InputValue::Time, 1) => Some(Feed::Time),
            (InputValue::FrameSize, 2) => Some(Feed::Resolution),
            (InputValue::Numbers(numbers), count) if numbers.len() == count => {
                let ends = control.min.iter_mut().zip(&mut control.max).zip(numbers);
                ends.for_each(|((low, high), n)| (*low, *high) = (low.min(*n), high.max(*n)));
                control.value.clone_from(numbers);
                project.controls.insert(project.described, control);
                project.described += 1;
                None
            }
            _ => {
                project.controls.push(control);
                continue;
            }
        };
        for bound in project.passes.iter_mut().map(|pass| &mut pass.bound) {
            bound.controls.retain(|c| feed.is_none() || c.name != *name);
            let own = bound.uniforms.iter_mut().filter(|u| u.name == *name);
            own.for_each(|uniform| uniform.source = feed.unwrap_or(uniform.source));
        }
        set.push(format!("`{name}` = {value} ({})", scripted.place));
    }
    if !set.is_empty() {
        let set = set.join(", ");
        let note = format!("scripts give these uniforms their first values: {set}");
        project.notes.push(note);
    }
}
