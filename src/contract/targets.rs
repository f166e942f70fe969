//! Where programs draw: outputs, render targets and blending.

use crate::breach::Breach;
use crate::materials::Material;
use crate::webgl::constant;
use shaderlint_script::{
    EventKind, ForeignCall, ObjectId, ScriptEvent, ScriptPlace, ScriptValue, World,
};

/// Adds what is wrong with the targets of programs.
pub fn check(world: &World, materials: &[Material], found: &mut Vec<Breach>) {
    let calls: Vec<(&ForeignCall, &ScriptEvent)> = world
        .events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::Call(call) => Some((call, event)),
            _ => None,
        })
        .collect();
    check_extensions(world, &calls, found);
    check_draw_buffers(world, &calls, found);
    check_targets(world, &calls, materials, found);
    check_blending(world, &calls, materials, found);
}

/// Extensions of WebGL1 for what a script does.
const NEEDED: &[(&str, usize, &str, &str)] = &[
    ("texImage2D", 7, "FLOAT", "OES_texture_float"),
    ("texImage2D", 4, "FLOAT", "OES_texture_float"),
    ("drawElements", 2, "UNSIGNED_INT", "OES_element_index_uint"),
];

/// Checks that a script of WebGL1 enables the extensions for what it does.
fn check_extensions(
    world: &World,
    calls: &[(&ForeignCall, &ScriptEvent)],
    found: &mut Vec<Breach>,
) {
    let contexts = calls.iter().filter(|(call, _)| &*call.name == "getContext");
    let kinds: Vec<Option<&str>> = contexts
        .map(|(call, _)| call.arguments.first().and_then(|(value, _)| value.text()))
        .collect();
    let is_webgl1 = |kind: &Option<&str>| matches!(kind, Some("webgl" | "experimental-webgl"));
    if kinds.is_empty() || !kinds.iter().all(is_webgl1) {
        return;
    }
    let asked = calls
        .iter()
        .filter(|(call, _)| &*call.name == "getExtension");
    let names: Vec<Option<&str>> = asked
        .map(|(call, _)| call.arguments.first().and_then(|(value, _)| value.text()))
        .collect();
    if names.iter().any(Option::is_none) {
        return;
    }
    for (function, index, needing, extension) in NEEDED {
        let uses = calls.iter().find(|(call, _)| {
            let argument = call.arguments.get(*index).map(|(value, _)| value);
            *function == &*call.name && constant(world, argument) == Some(needing)
        });
        if let Some((_, event)) = uses.filter(|_| !names.contains(&Some(extension))) {
            let message = format!("`{needing}` needs the extension `{extension}`");
            let breach = Breach::new("render-target", event.place, message)
                .note("WebGL reports INVALID_ENUM, and the call has no effect")
                .help(Some(format!(
                    "call `gl.getExtension(\"{extension}\")` first"
                )));
            found.push(breach);
        }
    }
}

/// The number of outputs that a text writes through `gl_FragData`.
fn fragment_data(text: &str) -> usize {
    let indices = text.split("gl_FragData").skip(1).filter_map(|rest| {
        let inside = rest.trim_start().strip_prefix('[')?.split(']').next()?;
        inside.trim().parse::<usize>().ok()
    });
    indices.max().map_or(0, |last| last + 1)
}

/// Checks that all outputs of the only program with several are drawn.
fn check_draw_buffers(
    world: &World,
    calls: &[(&ForeignCall, &ScriptEvent)],
    found: &mut Vec<Breach>,
) {
    let texts = calls
        .iter()
        .filter(|(call, _)| &*call.name == "shaderSource");
    let outputs = texts.filter_map(|(call, _)| match call.arguments.get(1) {
        Some((ScriptValue::Text(text), _)) => Some(fragment_data(&text.content)),
        _ => None,
    });
    let needed = outputs.max().unwrap_or(0);
    let lists = calls
        .iter()
        .filter(|(call, _)| call.name.starts_with("drawBuffers"));
    let lists: Vec<(usize, ScriptPlace)> = lists
        .filter_map(|(call, event)| {
            let all = world.elements(&call.arguments.first()?.0)?;
            Some((all.len(), event.place))
        })
        .collect();
    let most = lists.iter().map(|(count, _)| *count).max().unwrap_or(0);
    if let Some((_, place)) = lists.iter().find(|(count, _)| *count == most)
        && most < needed
    {
        let message =
            format!("a shader writes {needed} outputs of `gl_FragData`, {most} are drawn");
        let breach = Breach::new("render-target", *place, message)
            .note("an output without a draw buffer is lost");
        found.push(breach);
    }
}

/// The materials of the meshes that are added to a scene.
fn materials_of<'m>(
    world: &World,
    calls: &[(&ForeignCall, &ScriptEvent)],
    scene: ObjectId,
    materials: &'m [Material],
) -> Vec<&'m Material<'m>> {
    let added = calls
        .iter()
        .filter(|(call, _)| &*call.name == "add" && call.this == Some(scene));
    let meshes = added.flat_map(|(call, _)| &call.arguments);
    let meshes = meshes.filter_map(|(value, _)| world.call_of(value.object()?));
    let used = meshes
        .flat_map(|mesh| &mesh.arguments)
        .filter_map(|(value, _)| value.object());
    let used: Vec<ObjectId> = used.collect();
    materials
        .iter()
        .filter(|m| used.contains(&m.call.result))
        .collect()
}

/// Whether a value is a texture of a target.
fn is_texture_of(world: &World, value: &ScriptValue, target: ObjectId) -> bool {
    let mut id = value.object();
    for _ in 0..3 {
        let Some(of) = id else { return false };
        match world.member_of(of) {
            Some((holder, name)) if holder == target => return name.starts_with("texture"),
            holder => id = holder.map(|(holder, _)| holder),
        }
    }
    false
}

/// Follows which scene is rendered to which target of three.js.
fn check_targets(
    world: &World,
    calls: &[(&ForeignCall, &ScriptEvent)],
    materials: &[Material],
    found: &mut Vec<Breach>,
) {
    let mut current: Option<ObjectId> = None;
    let mut task = 0;
    for (call, event) in calls {
        if event.task != task {
            (current, task) = (None, event.task);
        }
        let first = call.arguments.first().and_then(|(value, _)| value.object());
        match &*call.name {
            "setRenderTarget" => current = first,
            "render" => {
                let (Some(scene), Some(target)) = (first, current) else {
                    continue;
                };
                let Some(made) = world
                    .call_of(target)
                    .filter(|made| made.name.ends_with("RenderTarget"))
                else {
                    continue;
                };
                let options = made.arguments.get(2).map(|(value, _)| value);
                let count = options.and_then(|options| world.get(options, "count"));
                let count = match (options, count) {
                    (_, Some(count)) => count.number(),
                    _ => Some(1.0),
                };
                for material in materials_of(world, calls, scene, materials) {
                    // A pass of a library gets its textures from others.
                    let is_near = material.place.file == event.place.file;
                    let reads = |value: &ScriptValue| is_texture_of(world, value, target);
                    if is_near && material.reads(world, reads) {
                        let message =
                            "a texture is read while it is drawn to (feedback)".to_string();
                        let breach = Breach::new("render-target", event.place, message)
                            .label(
                                Some(material.place),
                                "this material reads a texture of the target",
                            )
                            .note("drawing reports INVALID_OPERATION, and nothing is drawn");
                        found.push(breach);
                        continue;
                    }
                    let made_at = world.object(target).map_or(event.place, |o| o.place);
                    found.extend(uneven_outputs(material, count, made_at));
                }
            }
            _ => {}
        }
    }
}

/// Outputs of a shader for a target with another number of textures.
fn uneven_outputs(material: &Material, count: Option<f64>, place: ScriptPlace) -> Option<Breach> {
    let fragment = material.stages.fragment.as_ref()?;
    let outputs = fragment.outputs.len();
    let count = count.filter(|count| outputs > 0 && *count as usize != outputs)?;
    let message = format!("a target with {count} textures gets {outputs} outputs of a shader");
    let note = match (count as usize) < outputs {
        true => "the other outputs are lost",
        false => "drawing reports INVALID_OPERATION, and nothing is drawn",
    };
    let last = fragment.outputs.last().and_then(|o| o.place);
    let breach = Breach::new("render-target", place, message)
        .label(last, "the last output")
        .note(note)
        .help(Some(format!("use `count: {outputs}`")));
    Some(breach)
}

/// Options of a material that say what its alpha is for.
const BLENDING: &[&str] = &[
    "transparent",
    "blending",
    "alphaTest",
    "alphaHash",
    "premultipliedAlpha",
    "blendSrc",
    "alphaToCoverage",
    "depthWrite",
    "depthTest",
];

/// Checks that the alpha of a material is used.
fn check_blending(
    world: &World,
    calls: &[(&ForeignCall, &ScriptEvent)],
    materials: &[Material],
    found: &mut Vec<Breach>,
) {
    // What is drawn to a texture may be data, whose alpha another shader reads.
    let draws_elsewhere = calls.iter().any(|(call, _)| {
        &*call.name == "setRenderTarget"
            || call.name.ends_with("RenderTarget")
            || call.name.ends_with("Composer")
    });
    if draws_elsewhere {
        return;
    }
    for material in materials
        .iter()
        .filter(|m| m.call.name.ends_with("haderMaterial"))
    {
        let options = material
            .call
            .arguments
            .first()
            .and_then(|(value, _)| world.object(value.object()?));
        // Of a class, each user says what its alpha is for.
        let is_class = world
            .object(material.call.result)
            .is_none_or(|o| o.class.is_some());
        let is_drawn = calls.iter().any(|(call, _)| {
            let mut all = call.arguments.iter();
            call.is_new && all.any(|(value, _)| value.object() == Some(material.call.result))
        });
        let Some(options) = options.filter(|o| !o.is_open && !is_class && is_drawn) else {
            continue;
        };
        let has = options
            .properties
            .iter()
            .any(|p| BLENDING.contains(&&*p.key));
        let later = world.events.iter().any(|event| match &event.kind {
            EventKind::Write { object, key, .. } => {
                *object == material.call.result
                    && key.as_ref().is_none_or(|key| BLENDING.contains(&&**key))
            }
            _ => false,
        });
        let alpha = material.stages.fragment.as_ref().and_then(|s| s.alpha());
        let Some((alpha, place)) = alpha.filter(|_| !has && !later) else {
            continue;
        };
        let message = format!("alpha `{alpha}` has no effect without `transparent: true`");
        let breach = Breach::new("render-target", material.place, message)
            .label(place, "written to `gl_FragColor` here")
            .help(Some("add `transparent: true`, or write 1.0".to_string()));
        found.push(breach);
    }
}
