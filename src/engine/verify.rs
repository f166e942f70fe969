//! Whether what was written of a project draws what the project draws: it is read back as who uses it
//! would read it, and each pass is compared with its original.

use super::play::{Button, Moment, Mouse, Scene};
use super::{NoFiles, Options, analyze};
use crate::exec::{
    COMPARED_SIZE, CompileOptions, Draw, Equality, Image, ImageShape, Sampling, Texels, Texture,
    equality,
};
use crate::ir::lower;
use crate::port::{Composed, File, Project, Target, bindings, glsl};
use crate::semantic::{Pass, Program, Sampler, Stage};
use serde::Deserialize;
use std::sync::Arc;

/// What is known of a pass.
#[derive(Clone, PartialEq, Debug)]
pub struct Verified {
    /// What the user calls it.
    pub pass: String,
    /// How it compares with its original; else why that is not known.
    pub outcome: Result<Equality, String>,
}

/// Compares what is to be written with the project that it is made of, pass by pass.
///
/// # Errors
/// Why what is written cannot be read back.
pub fn verify(
    project: &Project,
    composed: &Composed,
    target: Target,
    files: &[File],
) -> Result<Vec<Verified>, String> {
    let made = read_back(target, files)?;
    let units = composed.units.iter().filter(|u| u.kind != Pass::Common);
    let units: Vec<_> = units.collect();
    if made.len() != units.len() {
        return Err(format!(
            "{} passes are written, and there are {}",
            made.len(),
            units.len()
        ));
    }
    let all = units.into_iter().zip(made).map(|(unit, text)| {
        let pass = project.passes.get(unit.pass);
        let pass = pass.map_or(String::new(), |p| p.title(unit.pass));
        let outcome = match unit.stage {
            Stage::Vertex => Err("vertex shaders are not compared".to_string()),
            Stage::Fragment if composed.analysis(unit).has_errors() => {
                Err("it does not compile".to_string())
            }
            Stage::Fragment => compare(&composed.analysis(unit).program, &text),
        };
        Verified { pass, outcome }
    });
    Ok(all.collect())
}

/// Compares a shader with the text that it became.
fn compare(before: &Program, text: &str) -> Result<Equality, String> {
    let report = analyze("pass.frag", text, &Options::default(), &NoFiles);
    let after = report.analyses.first();
    let after = after.filter(|a| !a.has_errors);
    let after = after.ok_or("what was written does not compile")?;
    equal(before, &after.program)
}

/// Compares two shaders at moments that differ in time and mouse.
///
/// # Errors
/// What of them cannot be run.
pub fn equal(before: &Program, after: &Program) -> Result<Equality, String> {
    // Both get what the names mean in the original.
    let scene = |program: &Program| {
        let options = CompileOptions::default();
        let scene = Scene::bound(program, &lower(program), bindings(before), &options);
        scene.map_err(|refusal| refusal.what)
    };
    let (before, after) = (scene(before)?, scene(after)?);
    let noise = Noise::new();
    Ok(equality([&before.code, &after.code], &|number| {
        [&before, &after].map(|scene| noise.draw(scene, number))
    }))
}

/// The moment with a number.
fn moment(number: usize) -> Moment {
    // Each twice as late as the one before it.
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

/// Textures and numbers that look as if thrown, for all that a shader is given by nobody.
struct Noise {
    flat: Option<Arc<Image>>,
    volume: Option<Arc<Image>>,
    cube: Option<Arc<Image>>,
    layers: Option<Arc<Image>>,
}

/// A number that looks as if thrown.
const fn thrown(seed: u32) -> u32 {
    let mut x = seed.wrapping_mul(0x9e37_79b1) ^ 0x85eb_ca6b;
    x = (x ^ (x >> 15)).wrapping_mul(0x2c1b_3c6d);
    x = (x ^ (x >> 12)).wrapping_mul(0x297a_2d39);
    x ^ (x >> 15)
}

impl Noise {
    fn new() -> Noise {
        let image = |shape, size: [u32; 3]| {
            let count = size.iter().product::<u32>();
            let texels = (0..count).map(|n| thrown(n).to_le_bytes()).collect();
            let image = Image::new(shape, size, Texels::Unorm8(texels));
            image.ok().map(Arc::new)
        };
        Noise {
            flat: image(ImageShape::Flat, [64, 64, 1]),
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

    /// A draw of a moment. What nothing sets gets numbers by its name.
    fn draw<'s>(&self, scene: &'s Scene, number: usize) -> Draw<'s> {
        let mut draw = scene.draw(COMPARED_SIZE, &moment(number));
        for name in scene.zeros() {
            let Some(slot) = scene.code.uniforms.iter().find(|u| u.name == *name) else {
                continue;
            };
            let count = slot.ty.element().components() * slot.ty.array.max(1);
            let seed = name
                .bytes()
                .fold(number as u32, |s, b| thrown(s ^ u32::from(b)));
            let scalars = (0..count).map(|n| f64::from(thrown(seed + n) % 1000) / 500.0);
            draw.set(name, &scalars.collect::<Vec<f64>>());
        }
        for slot in &scene.code.samplers {
            if let Some(image) = self.of(slot.sampler) {
                let texture = Texture {
                    image: Arc::clone(image),
                    sampling: Sampling::default(),
                };
                draw.bind(&slot.name, texture);
            }
        }
        draw
    }
}

/// What a page or a module holds.
#[derive(Deserialize)]
struct Held {
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

/// The fragment shaders of what is to be written, in the order of the passes.
fn read_back(target: Target, files: &[File]) -> Result<Vec<String>, String> {
    let texts = files
        .iter()
        .filter_map(|f| Some((f, std::str::from_utf8(&f.content).ok()?)));
    match target {
        Target::Glsl => {
            let is_vertex = |f: &File| f.path.extension().is_some_and(|e| e == "vert");
            let shaders = texts.filter(|(file, _)| !is_vertex(file));
            Ok(shaders.map(|(_, text)| text.to_string()).collect())
        }
        Target::Json => {
            let mut texts = texts;
            let (_, text) = texts.next_back().ok_or("nothing is written")?;
            let mut project = Project::from_json(text).map_err(|e| e.to_string())?;
            let composed = project.resolve("").map_err(|e| e.to_string())?;
            let passes = glsl(&project, &composed);
            Ok(passes.into_iter().map(|p| p.fragment).collect())
        }
        Target::Html | Target::Module | Target::Three | Target::React => {
            let held = texts.filter_map(|(_, text)| held(text)).next();
            let held = held.ok_or("the project is not found in what is written")?;
            Ok(held.passes.iter().map(|pass| held.joined(pass)).collect())
        }
        #[cfg(feature = "naga")]
        Target::Wgsl | Target::Spirv | Target::Hlsl | Target::Msl => {
            Err("shaders in other languages are not read back".to_string())
        }
    }
}

/// The project that stands in a page or a module.
fn held(text: &str) -> Option<Held> {
    let starts = ["id=\"project\">", "const PROJECT = "];
    let (_, rest) = starts.iter().find_map(|start| text.split_once(start))?;
    let mut values = serde_json::Deserializer::from_str(rest).into_iter::<Held>();
    values.next()?.ok()
}

impl Held {
    /// The texts of a pass as the player joins them: behind every text of the user but the last
    /// comes a line break.
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
    use crate::semantic::analyze_fragment;

    const BEFORE: &str = "#version 300 es\nprecision highp float; uniform float u; out vec4 c;\n\
                          void main() { c = vec4(sin(u), gl_FragCoord.x * 0.01, u, 1); }\n";

    fn check(after: &str, expected: fn(&Result<Equality, String>) -> bool) {
        let before = analyze_fragment(BEFORE);
        let found = compare(&before.program, after);
        assert!(expected(&found), "{found:?}\n{after}");
    }

    /// Another name, another way, another picture, and no shader.
    #[test]
    fn what_became_of_a_shader_is_compared() {
        check(&BEFORE.replace("c;", "d;").replace("c =", "d ="), |found| {
            *found == Ok(Equality::Proved)
        });
        check(&BEFORE.replace("* 0.01, u,", "* 0.01, -(-u),"), |found| {
            matches!(found, Ok(Equality::Seen { .. }))
        });
        check(&BEFORE.replace("u, 1)", "u + 0.001, 1)"), |found| {
            matches!(found, Ok(Equality::Differs { .. }))
        });
        check("nothing", Result::is_err);
    }
}
