//! VEDA: fragment shaders with a JSON header that lists passes and turns inputs on.
//!
//! The preset describes the format. Vertex shaders and models of passes are not drawn.

use super::complete::{changed, changes, completions_of, defaults, modern};
use super::isf::{head, is_identifier, object, target_size};
use super::{Clues, Completion, HostCode, Plan, PlannedPass, Sign, read_buffer, sampled};
use crate::{Input, InputKind, PassDraw, SignalForm};
use serde_json::{Map, Value};
use shaderlint_host::{OWN, Preset, preset};
use shaderlint_syntax::Version;
use std::sync::Arc;

/// The name of its preset.
const HOST: &str = "veda";

pub(super) static CODE: HostCode = HostCode {
    host: HOST,
    signs,
    plan: Some(plan),
    declare: None,
};

/// Samplers of devices.
const DEVICES: [&str; 3] = ["midi", "note", "gamepad"];
/// An image with one black pixel.
const BLACK: &str = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mNgAAAAAgAB5Sfe/AAAAABJRU5ErkJggg==";

/// Header keys of ISF that VEDA does not have.
const OTHERS: [&str; 2] = ["INPUTS", "ISFVSN"];
/// Header keys of VEDA.
const KEYS: [&str; 12] = [
    "PASSES",
    "IMPORTED",
    "audio",
    "midi",
    "keyboard",
    "gamepad",
    "camera",
    "pixelRatio",
    "frameskip",
    "glslify",
    "vertexCount",
    "vertexMode",
];

fn signs(clues: &Clues) -> Vec<Sign> {
    let Some(Ok(settings)) = head(clues.text).map(object) else {
        return Vec::new();
    };
    let key = KEYS.iter().find(|key| settings.contains_key(**key));
    let is_other = OTHERS.iter().any(|key| settings.contains_key(*key));
    // ISF declares the inputs of its shaders; those of VEDA do it themselves.
    let declares = preset(HOST).is_some_and(|host| {
        let mut uniforms = clues.uniforms.iter();
        uniforms.any(|u| host.sets(&u.name, &u.ty) || host.defined.contains(&u.name))
    });
    match key {
        Some(key) if !is_other && declares => {
            vec![Sign::form(format!("a JSON header with `{key}`"), 4 * OWN)]
        }
        _ => Vec::new(),
    }
}

fn plan(clues: &Clues) -> Plan {
    let settings = match head(clues.text).map(object) {
        Some(Ok(settings)) => settings,
        _ => Map::new(),
    };
    let passes = settings.get("PASSES").and_then(Value::as_array);
    let passes: Vec<&Map<String, Value>> = passes
        .into_iter()
        .flatten()
        .filter_map(Value::as_object)
        .collect();
    let usual = Map::new();
    let passes = match passes.as_slice() {
        [] => vec![&usual],
        _ => passes,
    };
    let mut plan = Plan {
        notes: ignored(&settings),
        ..Plan::default()
    };
    let inputs = inputs(clues, &settings, &passes, &mut plan.notes);
    for (index, pass) in passes.iter().enumerate() {
        let is_last = index + 1 == passes.len();
        let name = target(pass);
        if name.is_none() && !is_last {
            continue;
        }
        let candidates = candidates(clues, pass, index, &mut plan);
        let mut planned = match name {
            Some(name) => PlannedPass::buffer(name, candidates),
            None => PlannedPass::image(candidates),
        };
        planned.is_of_text = !pass.contains_key("fs");
        planned.inputs.clone_from(&inputs);
        plan.passes.push(planned);
        plan.draws.push(PassDraw {
            size: target_size(
                ["WIDTH", "HEIGHT"].map(|key| pass.get(key)),
                &mut plan.notes,
            )
            .filter(|_| name.is_some()),
            is_float: pass.get("FLOAT").is_some_and(|v| *v == Value::Bool(true)),
            ..PassDraw::default()
        });
        if let Some(name) = name.filter(|_| is_last) {
            plan.passes.push(PlannedPass::copy_of(name));
            plan.draws.push(PassDraw::default());
        }
        if ["vs", "MODEL"].iter().any(|key| pass.contains_key(*key)) {
            plan.notes.push(format!(
                "pass {index} has a vertex shader or a model, which is not drawn; its fragment shader fills the image"
            ));
        }
    }
    plan
}

/// What the samplers read: images, buffers, sound, the keyboard, and devices without values.
fn inputs(
    clues: &Clues,
    settings: &Map<String, Value>,
    passes: &[&Map<String, Value>],
    notes: &mut Vec<String>,
) -> Vec<Input> {
    let mut inputs = imported(settings);
    inputs.extend(passes.iter().filter_map(|pass| {
        let name = target(pass)?;
        Some(read_buffer(name, name))
    }));
    for (name, signal) in [
        ("spectrum", SignalForm::Spectrum),
        ("samples", SignalForm::Wave),
    ] {
        let input = sampled(name, InputKind::Music, ("linear", "clamp"));
        inputs.push(Input { signal, ..input });
    }
    inputs.push(sampled("key", InputKind::Keyboard, ("nearest", "clamp")));
    let is_known = |name: &str| inputs.iter().any(|i| i.uniform.as_deref() == Some(name));
    let devices = clues.uniforms.iter().filter(|u| u.ty == "sampler2D");
    let devices = devices.map(|u| u.name.as_str());
    let devices: Vec<&str> = devices
        .filter(|name| DEVICES.contains(name) || name.starts_with("osc_"))
        .filter(|name| !is_known(name))
        .collect();
    if !devices.is_empty() {
        let names = devices.join("`, `");
        notes.push(format!(
            "devices that the page does not read, set to zero: `{names}`"
        ));
    }
    inputs.extend(devices.into_iter().map(|name| Input {
        urls: vec![BLACK.to_string()],
        ..sampled(name, InputKind::Texture, ("nearest", "clamp"))
    }));
    inputs
}

/// Notes about settings that the page does not apply.
fn ignored(settings: &Map<String, Value>) -> Vec<String> {
    let number = |key: &str| settings.get(key).and_then(Value::as_f64);
    let mut notes = Vec::new();
    if let Some(ratio) = number("pixelRatio").filter(|ratio| *ratio > 1.0) {
        let scale = (1000.0 / ratio).round() / 1000.0;
        notes.push(format!(
            "`pixelRatio` is not applied; `#scale={scale}` in the address of the page draws as coarsely"
        ));
    }
    if number("frameskip").is_some_and(|skip| skip > 1.0) {
        notes.push("`frameskip` is not applied: the page draws all frames".to_string());
    }
    notes
}

/// The name of the buffer that a pass draws into.
fn target(pass: &Map<String, Value>) -> Option<&str> {
    let name = pass.get("TARGET").and_then(Value::as_str);
    name.filter(|name| is_identifier(name))
}

/// The images that a header imports.
fn imported(settings: &Map<String, Value>) -> Vec<Input> {
    let all = settings.get("IMPORTED").and_then(Value::as_object);
    let all = all.into_iter().flatten();
    all.filter(|(name, _)| is_identifier(name))
        .map(|(name, item)| {
            let mut input = sampled(name, InputKind::Texture, ("linear", "repeat"));
            if let Some(path) = item.get("PATH").and_then(Value::as_str) {
                input.src = path.to_string();
            }
            input
        })
        .collect()
}

/// The completed text of a pass: of the file that it names, or of the text itself.
fn candidates(
    clues: &Clues,
    pass: &Map<String, Value>,
    index: usize,
    plan: &mut Plan,
) -> Vec<Completion> {
    let Some(host) = preset(HOST) else {
        return completions_of(clues);
    };
    let Some(path) = pass.get("fs").and_then(Value::as_str) else {
        return numbered(clues, host, index);
    };
    let path = path.trim_start_matches("./").to_string();
    match clues.siblings.get(&path) {
        Some(Some(text)) => numbered(&Clues::of(text), host, index),
        Some(None) => {
            plan.notes.push(format!(
                "pass {index}: file `{path}` not found; the pass stays empty"
            ));
            vec![Completion::bare(
                "precision highp float;\nvoid main() {\n    gl_FragColor = vec4(0.0);\n}\n",
            )]
        }
        None => {
            plan.requested.push(path);
            numbered(clues, host, index)
        }
    }
}

/// A text that runs as a pass with a number.
fn numbered(clues: &Clues, host: &Preset, index: usize) -> Vec<Completion> {
    let defined: String = host
        .defined
        .iter()
        .map(|name| format!("#define {name} {index}\n"))
        .collect();
    let changes = changes(clues.text, host);
    let code: Arc<str> = Arc::from(changed(clues.text, &changes));
    [defaults(Version::Es100), modern(clues)]
        .into_iter()
        .map(|before| Completion {
            code: code.clone(),
            changes: changes.clone(),
            ..Completion::after(before + &defined, "")
        })
        .collect()
}
