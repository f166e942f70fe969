//! Verifies that the output of a port draws the same as the project: the output is read back, and
//! each pass is compared with its original.

use crate::check::analyze;
use crate::inputs::{Button, Moment, Mouse, Scene};
use crate::options::Options;
use serde::Deserialize;
use shaderlint_exec::{
    COMPARED_SIZE, CompileOptions, Draw, Equality, Filter, Image, ImageShape, OutputSlot, Sampling,
    Texels, Texture, equality,
};
use shaderlint_explain::Checked;
use shaderlint_host::{Feed, Preset};
use shaderlint_ir::lower;
use shaderlint_math::hash;
use shaderlint_port::{File, HostedShader, Target, glsl};
use shaderlint_project::NoFiles;
use shaderlint_project::{Bindings, Composed, PassUnit, Project, Wrapper, bindings, compose};
use shaderlint_semantic::{Pass, Program, Sampler, Scalar, Stage};
use std::sync::Arc;

/// Number of instructions that may run to compare a pass.
const FUEL: u64 = 4_000_000_000;

/// The verification result of one pass.
#[derive(Clone, PartialEq, Debug)]
pub struct Verified {
    /// Title of the pass.
    pub pass: String,
    /// What the pass is compared with.
    pub original: Original,
    /// The result of the comparison, or why it was not possible.
    pub outcome: Result<Equality, String>,
}

/// What a pass of the output is compared with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Original {
    /// The user's code.
    Given,
    /// The repaired code, because the user's code does not compile.
    Repaired,
}

/// Compares the output with the project, pass by pass. If the project was repaired, `given` is the
/// project before: passes that compiled before must still draw the same.
///
/// # Errors
/// If the output cannot be read back.
pub fn verify(
    project: &Project,
    composed: &Composed,
    given: Option<&Composed>,
    target: Target,
    files: &[File],
) -> Result<Vec<Verified>, String> {
    let units_of = |composed| {
        let mut units: Vec<&PassUnit> = drawn_units(composed).collect();
        if let Target::Host(_) = target {
            units.sort_by_key(|unit| unit.program_number(project));
        }
        units
    };
    let units = units_of(composed);
    let made = read_back(target, files, units.len())?;
    let mut before: Vec<_> = given.map_or(Vec::new(), |given| {
        let units = units_of(given).into_iter();
        units.map(|unit| (given, unit)).collect()
    });
    if before.len() != units.len() {
        before.clear();
    }
    if made.len() != units.len() {
        return Err(format!(
            "the output has {} passes, the project has {}",
            made.len(),
            units.len()
        ));
    }
    let all = units.into_iter().zip(made).enumerate();
    let all = all.map(|(at, (unit, text))| {
        let pass = project.passes.get(unit.pass);
        let pass = pass.map_or(String::new(), |p| p.title(unit.pass));
        let given = before.get(at).map(|(given, unit)| given.analysis(unit));
        let (original, analysis) = match given {
            Some(given) if !given.has_errors() => (Original::Given, given),
            Some(_) => (Original::Repaired, composed.analysis(unit)),
            None => (Original::Given, composed.analysis(unit)),
        };
        let outcome = match analysis.has_errors() {
            true => Err("the shader does not compile".to_string()),
            false => match target {
                Target::Host(host) => compare_hosted(project, (unit, analysis), host, &text),
                _ => compare(&analysis.program, &text),
            },
        };
        Verified {
            pass,
            original,
            outcome,
        }
    });
    Ok(all.collect())
}

/// The passes of a project that produce images or sound.
fn drawn_units(composed: &Composed) -> impl Iterator<Item = &PassUnit> {
    composed.units.iter().filter(|u| u.kind != Pass::Common)
}

/// Compares a shader with its text in the output.
fn compare(before: &Program, text: &str) -> Result<Equality, String> {
    let name = match before.stage {
        Stage::Vertex => "pass.vert",
        Stage::Fragment => "pass.frag",
    };
    let report = analyze(name, text, &Options::default(), &NoFiles);
    let after = report.analyses.first();
    let after = after.filter(|a| !a.has_errors);
    let after = after.ok_or("the output does not compile")?;
    equal(before, &after.program, &mut FUEL.clone())
}

/// The programs for a host in their order, each after the common code.
fn read_programs(host: &Preset, files: &[File]) -> Vec<String> {
    let is_named = |file: &&File, end: &str| {
        let stem = file.path.file_stem().unwrap_or_default();
        stem.to_string_lossy().ends_with(end)
    };
    let text = |file: &File| String::from_utf8_lossy(&file.content).into_owned();
    if host.programs == 0 || files.len() < 2 {
        return files.iter().take(1).map(text).collect();
    }
    let common = files.iter().find(|file| is_named(file, "-c"));
    let common = common.map_or(String::new(), text);
    let own = files.iter().filter(|file| !is_named(file, "-c"));
    own.map(|file| common.clone() + &text(file)).collect()
}

/// Compares a pass with its shader for a host.
fn compare_hosted(
    project: &Project,
    (unit, before): (&PassUnit, &Checked),
    host: &'static Preset,
    text: &str,
) -> Result<Equality, String> {
    let after = HostedShader::of(host, text).filter(|after| !after.checked.has_errors());
    let after = after.ok_or("the output does not compile")?;
    // Such hosts do not change the alpha of the image.
    let has_alpha = host.programs > 0 && unit.kind == Pass::Image;
    let buffer = has_alpha.then(|| as_buffer(project, unit)).flatten();
    let in_buffer = buffer.as_ref().and_then(|composed| {
        let unit = composed.units.iter().find(|u| u.pass == unit.pass)?;
        Some(composed.analysis(unit))
    });
    let before = in_buffer.unwrap_or(before);
    let pass = project.passes.get(unit.pass);
    let mut bound = match pass.filter(|pass| pass.wrapper == Wrapper::Own) {
        Some(pass) => pass.bound.clone(),
        None => bindings(&before.program, None),
    };
    for uniform in &mut bound.uniforms {
        if host.rests(uniform.source) {
            uniform.source = Feed::Nothing;
        }
    }
    let after = (&after.checked.program, after.bound);
    equal_bound((&before.program, bound), after, &mut FUEL.clone())
}

/// The project with an image as a buffer, in which alpha is kept.
fn as_buffer(project: &Project, unit: &PassUnit) -> Option<Composed> {
    let mut project = project.clone();
    project.passes.get_mut(unit.pass)?.kind = Pass::Buffer;
    compose(&project, "")
}

/// Compares two shaders in frames that differ in time and mouse. Vertex shaders run one vertex per
/// pixel. `fuel` is the number of instructions that may run, and is reduced by those that ran.
///
/// # Errors
/// If a shader cannot be run, or the varyings differ.
pub fn equal(before: &Program, after: &Program, fuel: &mut u64) -> Result<Equality, String> {
    // Both use the bindings of the original.
    let bound = bindings(before, None);
    equal_bound((before, bound.clone()), (after, bound), fuel)
}

/// Compares two shaders that have inputs of their own.
fn equal_bound(
    before: (&Program, Bindings),
    after: (&Program, Bindings),
    fuel: &mut u64,
) -> Result<Equality, String> {
    let scene = |(program, bound): (&Program, Bindings)| {
        let options = CompileOptions::default();
        let scene = Scene::bound(program, &lower(program), bound, &options);
        scene.map_err(|refusal| refusal.what)
    };
    let stage = before.0.stage;
    let (before, after) = (scene(before)?, scene(after)?);
    let outputs = |scene: &Scene| -> Vec<String> {
        let all = scene.code.outputs.iter();
        all.map(|output| output.name.clone()).collect()
    };
    // Varyings of fragment shaders are matched by name.
    if stage == Stage::Vertex && outputs(&before) != outputs(&after) {
        return Err("the varyings differ in name or order".to_string());
    }
    // Filtering rounds differently in an image that is turned around, and its height divides no
    // place of a pixel, so that no place is between two texels.
    let sampling = match [&before, &after].map(turned) {
        [before, after] if before == after => Sampling::default(),
        _ => Sampling {
            filter: Filter::Nearest,
            ..Sampling::default()
        },
    };
    let noise = Noise::new(sampling);
    let draws = |number| [&before, &after].map(|scene| noise.draw(scene, number));
    let found = equality([&before.code, &after.code], fuel, &draws);
    let is_large = |output: &OutputSlot| output.lanes() < output.scalars();
    match found {
        Equality::SampledEqual { .. } if before.code.outputs.iter().any(is_large) => {
            Err("an output has more than four components, which are not all compared".to_string())
        }
        found => Ok(found),
    }
}

/// The number of images whose upper row comes first.
fn turned(scene: &Scene) -> usize {
    let inputs = scene.given.bound.inputs.iter();
    inputs.filter(|input| !input.sampler.vflip).count()
}

/// The frame with a number.
fn moment(number: usize) -> Moment {
    // Times double from frame to frame.
    let mut moment = Moment::at(0.35 * ((1_u64 << number.min(20)) - 1) as f64);
    let at = [40.0 + 70.0 * number as f64, 300.0 - 33.0 * number as f64];
    moment.mouse = match number % 3 {
        0 => None,
        1 => Some(Button::Down),
        _ => Some(Button::Up),
    }
    .map(|button| Mouse { at, button });
    moment
}

/// Pseudorandom textures and values for inputs that the player does not set.
struct Noise {
    flat: Option<Arc<Image>>,
    /// The same with the upper row first.
    flipped: Option<Arc<Image>>,
    volume: Option<Arc<Image>>,
    cube: Option<Arc<Image>>,
    layers: Option<Arc<Image>>,
    sampling: Sampling,
}

impl Noise {
    fn new(sampling: Sampling) -> Noise {
        let of = |shape, size: [u32; 3], seed: &dyn Fn(u32) -> u32| {
            let count = size.iter().product::<u32>();
            let texels = (0..count).map(|n| hash(seed(n)).to_le_bytes()).collect();
            let image = Image::new(shape, size, Texels::Unorm8(texels));
            image.ok().map(Arc::new)
        };
        let image = |shape, size| of(shape, size, &|n| n);
        Noise {
            flat: image(ImageShape::Flat, [64, 61, 1]),
            flipped: of(ImageShape::Flat, [64, 61, 1], &|n| {
                (60 - n / 64) * 64 + n % 64
            }),
            sampling,
            volume: image(ImageShape::Volume, [16, 16, 16]),
            cube: image(ImageShape::Cube, [32, 32, 6]),
            layers: image(ImageShape::Layers, [16, 16, 4]),
        }
    }

    fn of(&self, sampler: Sampler) -> Option<&Arc<Image>> {
        use Sampler as S;
        match sampler {
            S::Sampler2D => self.flat.as_ref(),
            S::Sampler3D => self.volume.as_ref(),
            S::SamplerCube => self.cube.as_ref(),
            S::Sampler2DArray => self.layers.as_ref(),
            _ => None,
        }
    }

    /// A draw of a frame. Uniforms that are not set get values derived from their name.
    fn draw<'s>(&self, scene: &'s Scene, number: usize) -> Draw<'s> {
        let mut draw = scene.draw(COMPARED_SIZE, &moment(number));
        for name in scene.zeros() {
            let Some(slot) = scene.code.uniforms.iter().find(|u| u.name == *name) else {
                continue;
            };
            let count = slot.ty.element().components() * slot.ty.array.max(1);
            let seed = by_name(name, number as u32);
            let scalars = (0..count).map(|n| f64::from(hash(seed.wrapping_add(n)) % 1000) / 500.0);
            draw.set(name, &scalars.collect::<Vec<f64>>());
        }
        for slot in &scene.code.samplers {
            let bound = &scene.given.bound.inputs;
            let input = bound
                .iter()
                .find(|i| i.uniform.as_deref() == Some(&slot.name));
            let image = match input.is_some_and(|i| !i.sampler.vflip) {
                true if slot.sampler == Sampler::Sampler2D => self.flipped.as_ref(),
                _ => self.of(slot.sampler),
            };
            if let Some(image) = image {
                let texture = Texture {
                    image: Arc::clone(image),
                    sampling: self.sampling,
                };
                draw.bind(&slot.name, texture);
            }
        }
        let is_known = |name: &str| {
            let mut varyings = scene.given.bound.varyings.iter();
            PIXEL_INPUTS.contains(&name) || varyings.any(|v| v.place == name)
        };
        for slot in scene
            .code
            .inputs
            .iter()
            .filter(|slot| !is_known(&slot.name))
        {
            let planes = match slot.ty.scalar_kind() {
                Some(Scalar::Float) => thrown(&slot.name, number as u32, slot.ty.components()),
                // Each pixel has its own number.
                _ => vec![[-0.5 - 0.5 * ROW, 1.0, ROW]; slot.ty.components() as usize],
            };
            draw.input(&slot.name, &planes);
        }
        draw
    }
}

/// Built-in inputs of fragment shaders.
const PIXEL_INPUTS: [&str; 3] = ["gl_FragCoord", "gl_FrontFacing", "gl_PointCoord"];
/// Number of pixels in a row of the compared image.
const ROW: f32 = COMPARED_SIZE[0] as f32;

/// Planes for an input that is not set, derived from its name: from -1 to 3 at some point, with a
/// slope of at most twice that over the image.
fn thrown(name: &str, seed: u32, count: u32) -> Vec<[f32; 3]> {
    let seed = by_name(name, seed);
    let number = |n: u32| (hash(seed.wrapping_add(n)) % 1000) as f32 / 250.0 - 1.0;
    let plane = |n: u32| [number(n), number(n + 1) / ROW, number(n + 2) / ROW];
    (0..count).map(|n| plane(3 * n)).collect()
}

/// A hash of a name.
fn by_name(name: &str, seed: u32) -> u32 {
    let bytes = name.bytes().map(u32::from);
    bytes.fold(seed, |known, byte| hash(known ^ byte))
}

/// The JSON that a page or module contains.
#[derive(Deserialize)]
struct HeldCode {
    files: Vec<HeldFile>,
    passes: Vec<HeldPass>,
}

#[derive(Deserialize)]
struct HeldFile {
    text: String,
    hidden: bool,
}

#[derive(Deserialize)]
struct HeldPass {
    files: Vec<usize>,
}

/// The shaders in the output, in the order of the `count` passes.
fn read_back(target: Target, files: &[File], count: usize) -> Result<Vec<String>, String> {
    let texts = files
        .iter()
        .filter_map(|f| Some((f, std::str::from_utf8(&f.content).ok()?)));
    match target {
        Target::Glsl => {
            // The shaders of the other stage follow.
            let own = texts.take(count);
            Ok(own.map(|(_, text)| text.to_string()).collect())
        }
        Target::Json => {
            let mut texts = texts;
            let (_, text) = texts.next_back().ok_or("the output is empty")?;
            let mut project = Project::from_json(text).map_err(|e| e.to_string())?;
            let composed = project.resolve("").map_err(|e| e.to_string())?;
            let passes = glsl(&project, &composed);
            Ok(passes.into_iter().map(|p| p.text).collect())
        }
        Target::Html | Target::Module | Target::Three | Target::React => {
            let held = texts.filter_map(|(_, text)| held(text)).next();
            let held = held.ok_or("the output does not contain the project")?;
            Ok(held.passes.iter().map(|pass| held.joined(pass)).collect())
        }
        Target::Host(host) => Ok(read_programs(host, files)),
        #[cfg(feature = "naga")]
        Target::ThreeWebgpu | Target::Wgsl | Target::Spirv | Target::Hlsl | Target::Msl => {
            Err("output in this language cannot be verified".to_string())
        }
    }
}

/// The project in a page or a module.
fn held(text: &str) -> Option<HeldCode> {
    let starts = ["id=\"project\">", "const PROJECT = "];
    let (_, rest) = starts.iter().find_map(|start| text.split_once(start))?;
    let mut values = serde_json::Deserializer::from_str(rest).into_iter::<HeldCode>();
    values.next()?.ok()
}

impl HeldCode {
    /// The text of a pass as the player joins it: a line break follows every file of the user
    /// except the last.
    fn joined(&self, pass: &HeldPass) -> String {
        let mut text = String::new();
        for (n, file) in pass.files.iter().enumerate() {
            let Some(file) = self.files.get(*file) else {
                continue;
            };
            text.push_str(&file.text);
            if !file.hidden && n + 1 < pass.files.len() {
                text.push('\n');
            }
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_explain::analyze_fragment;

    const BEFORE: &str = "#version 300 es\nprecision highp float; uniform float u; out vec4 c;\n\
                          void main() { c = vec4(sin(u), gl_FragCoord.x * 0.01, u, 1); }\n";

    fn check(after: &str, expected: fn(&Result<Equality, String>) -> bool) {
        let before = analyze_fragment(BEFORE);
        let found = compare(&before.program, after);
        assert!(expected(&found), "{found:?}\n{after}");
    }

    /// Compares a vertex shader with its text in the output.
    fn compare_vertices(before: &str, after: &str) -> Result<Equality, String> {
        let report = analyze("pass.vert", before, &Options::default(), &NoFiles);
        compare(&report.analyses.first().unwrap().program, after)
    }

    /// Varyings are matched by name, and all vertices are compared.
    #[test]
    fn edited_vertex_shaders_are_compared() {
        let text = "#version 300 es\nin vec3 at; out vec2 place; uniform mat4 m;\n\
                    void main() { gl_Position = m * vec4(at, 1); place = at.xy * 0.5; }\n";
        let check = |after: &str, expected: fn(&Result<Equality, String>) -> bool| {
            let found = compare_vertices(text, after);
            assert!(expected(&found), "{found:?}\n{after}");
        };
        check(
            &text.replace("out vec2 place;", "/**/ out vec2 place;"),
            |found| *found == Ok(Equality::Proved),
        );
        check(&text.replace("at.xy * 0.5", "-(-at.xy) * 0.5"), |found| {
            matches!(found, Ok(Equality::SampledEqual { .. }))
        });
        check(&text.replace("at, 1)", "at + 0.01, 1)"), |found| {
            matches!(found, Ok(Equality::Differs { .. }))
        });
        check(&text.replace("place", "position"), Result::is_err);
        // Depends on the number of the vertex.
        let text = "#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID % 7); }\n";
        let found = compare_vertices(text, &text.replace("% 7", "% 14 % 7"));
        assert!(
            matches!(found, Ok(Equality::SampledEqual { .. })),
            "{found:?}"
        );
        let found = compare_vertices(text, &text.replace("% 7", "% 17"));
        assert!(matches!(found, Ok(Equality::Differs { .. })), "{found:?}");
    }

    /// Renamed variables, other operations, other images, and invalid shaders.
    #[test]
    fn edited_fragment_shaders_are_compared() {
        check(&BEFORE.replace("c;", "d;").replace("c =", "d ="), |found| {
            *found == Ok(Equality::Proved)
        });
        check(&BEFORE.replace("* 0.01, u,", "* 0.01, -(-u),"), |found| {
            matches!(found, Ok(Equality::SampledEqual { .. }))
        });
        check(&BEFORE.replace("u, 1)", "u + 0.001, 1)"), |found| {
            matches!(found, Ok(Equality::Differs { .. }))
        });
        check("nothing", Result::is_err);
    }
}
