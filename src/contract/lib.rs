//! The contract between scripts and shaders: what a program sets, and what its shaders declare.
//!
//! The program around the shaders is evaluated (`shaderlint_script`); then the calls of WebGL and of libraries
//! are compared with the interfaces of the shaders that they get. Nothing is reported that depends on a value
//! that is not known.
#![cfg_attr(test, allow(clippy::string_slice))]

mod bindings;
mod breach;
mod compiled;
mod feeds;
mod fit;
mod interface;
mod library;
mod link;
mod materials;
mod patches;
mod shape;
mod targets;
mod webgl;

pub use bindings::{BoundInput, InputSetting, InputValue, ProgramBindings};
pub use breach::Breach;
pub use library::{is_given_to_patches, is_library, may_make_programs};
pub use patches::NEWEST;
use shaderlint_script::{Loader, ScriptPlace, World, evaluate};
use shaderlint_text::LineIndex;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What was found in a program.
#[derive(Debug)]
pub struct Contract {
    /// The files of the program, the root first.
    pub files: Vec<(PathBuf, Arc<str>)>,
    /// Where its scripts and shaders disagree, in no order.
    pub breaches: Vec<Breach>,
    /// The programs, with the places that name and set their inputs.
    pub bindings: Vec<ProgramBindings>,
}

impl Contract {
    /// File and line of a place: `main.js:12`.
    pub fn line(&self, place: ScriptPlace) -> Option<String> {
        let (path, text) = self.files.get(place.file)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Some(format!("{name}:{}", LineIndex::new(text).line(place.start)))
    }
}

/// Checks the program that starts with a script. `release` is the one of three.js that it uses, if that is known;
/// [`NEWEST`] if it asks for no certain one.
pub fn check(
    (path, text): (&Path, &str),
    release: Option<u32>,
    loader: &dyn Loader,
) -> Option<Contract> {
    evaluate((path, text), loader, |world| read(world, release))
}

fn read(world: &World, release: Option<u32>) -> Contract {
    let mut breaches = Vec::new();
    let materials = materials::check(world, &mut breaches);
    let mut bindings: Vec<ProgramBindings> =
        materials.iter().map(|m| m.bind(world, release)).collect();
    feeds::check(world, &materials, &mut breaches, &mut bindings);
    compiled::check(world, &materials, &mut breaches);
    webgl::check(world, &mut breaches, &mut bindings);
    patches::check(world, release, &mut breaches);
    targets::check(world, &materials, &mut breaches);
    // What was not evaluated may set or feed the rest.
    if world.is_cut {
        breaches.retain(|b| b.rule != "unset-uniform" && b.rule != "attribute-data");
        let inputs = bindings.iter_mut().flat_map(|program| &mut program.inputs);
        inputs.for_each(|input| input.escapes = true);
    }
    for program in &mut bindings {
        program.mentions.sort();
        program.mentions.dedup();
    }
    breaches.sort_by(|a, b| (a.place, a.rule, &a.message).cmp(&(b.place, b.rule, &b.message)));
    breaches.dedup_by(|a, b| a.place == b.place && a.rule == b.rule);
    Contract {
        files: world.files.clone(),
        breaches,
        bindings,
    }
}
