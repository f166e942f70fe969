//! The values that scripts give the uniforms of a shader.

use crate::contracts::contracts;
use crate::options::Options;
use shaderlint_contract::{BoundInput, Contract, InputValue};
use shaderlint_host::Feed;
use shaderlint_project::{Files, Project};
use shaderlint_script::ScriptPlace;
use shaderlint_text::LineIndex;
use shaderlint_text::path::plain;
use std::path::Path;

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
            let known = found.iter_mut().find(|known| known.name == input.name);
            match (known, scripted_value(&contract, input)) {
                (Some(known), Some(value)) if known.value == value.value => {
                    known.is_constant &= value.is_constant;
                }
                (Some(_), Some(_)) => unequal.push(input.name.clone()),
                (Some(known), None) => known.is_constant = false,
                (None, value) => found.extend(value),
            }
        }
    }
    found.retain(|value| !unequal.contains(&value.name));
    found
}

fn scripted_value(contract: &Contract, input: &BoundInput) -> Option<ScriptedValue> {
    let is_time = input
        .settings
        .iter()
        .find(|s| s.value == Some(InputValue::Time));
    let (value, place) = match is_time {
        Some(setting) => (InputValue::Time, setting.place),
        None => input
            .initial()
            .map(|(value, place)| (value.clone(), place))?,
    };
    let (path, text) = contract.files.get(place.file)?;
    let line = LineIndex::new(text).line(place.start);
    Some(ScriptedValue {
        name: input.name.clone(),
        is_constant: input.constant().is_some(),
        value,
        place: format!("{}:{line}", Path::new(path.file_name()?).display()),
    })
}

/// Gives the uniforms of a project whose meaning is not known the values of scripts. What the text itself describes
/// stays as it is.
pub fn set_from_scripts(project: &mut Project, values: &[ScriptedValue]) {
    let mut set = Vec::new();
    for ScriptedValue {
        name, value, place, ..
    } in values
    {
        let at = project.controls.iter().position(|c| c.name == *name);
        let Some(at) = at.filter(|at| *at >= project.described) else {
            continue;
        };
        let mut control = project.controls.remove(at);
        let feed = match value {
            InputValue::Time => Some(Feed::Time),
            InputValue::FrameSize => Some(Feed::Resolution),
            InputValue::Numbers(_) => None,
        };
        match (value, feed) {
            (_, Some(feed)) if control.value.len() == feed_size(feed) => {
                for pass in &mut project.passes {
                    let bound = &mut pass.bound;
                    bound.controls.retain(|c| c.name != *name);
                    let own = bound.uniforms.iter_mut().filter(|u| u.name == *name);
                    own.for_each(|uniform| uniform.source = feed);
                }
            }
            (InputValue::Numbers(numbers), _) if numbers.len() == control.value.len() => {
                for ((low, high), number) in
                    control.min.iter_mut().zip(&mut control.max).zip(numbers)
                {
                    (*low, *high) = (low.min(*number), high.max(*number));
                }
                control.value.clone_from(numbers);
                project.controls.insert(project.described, control);
                project.described += 1;
            }
            _ => {
                project.controls.insert(at, control);
                continue;
            }
        }
        set.push(format!("`{name}` = {value} ({place})"));
    }
    if !set.is_empty() {
        let set = set.join(", ");
        project.notes.push(format!(
            "scripts give these uniforms their first values: {set}"
        ));
    }
}

/// Number of components of a value.
fn feed_size(feed: Feed) -> usize {
    if feed == Feed::Resolution { 2 } else { 1 }
}
