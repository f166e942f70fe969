//! The files of each target.

use super::remark::Remark;
use super::{Args, MainChoice, Target};
#[cfg(feature = "naga")]
use crate::port::naga::{Language, translate};
use crate::port::{
    Composed, Module, Project, VERTEX, glsl, html, json, module, react, rewrite, three,
};
use crate::semantic::Pass;
use std::path::{Path, PathBuf};

/// What is written, and what is to be said of it.
pub(super) struct Made {
    /// The files by path.
    pub(super) files: Vec<(PathBuf, Vec<u8>)>,
    /// The passes that could not be made as asked for.
    pub(super) remarks: Vec<Remark>,
}

/// The target that is asked for; without one the ending of the output tells.
pub(super) fn target_of(args: &Args) -> Target {
    let output = args.output.as_deref().unwrap_or(Path::new(""));
    let ending = output.extension().and_then(|e| e.to_str()).unwrap_or("");
    args.target.unwrap_or(match ending {
        "html" | "htm" => Target::Html,
        "js" | "mjs" => Target::Module,
        "json" => Target::Json,
        #[cfg(feature = "naga")]
        "wgsl" => Target::Wgsl,
        #[cfg(feature = "naga")]
        "spv" => Target::Spirv,
        #[cfg(feature = "naga")]
        "hlsl" => Target::Hlsl,
        #[cfg(feature = "naga")]
        "metal" => Target::Msl,
        _ => Target::Glsl,
    })
}

/// Makes the files of the target.
pub(super) fn make(args: &Args, project: &Project, composed: &Composed) -> Result<Made, String> {
    let output = args.output.clone().unwrap_or_default();
    let one = |text: String| Made {
        files: vec![(output.clone(), text.into_bytes())],
        remarks: Vec::new(),
    };
    match target_of(args) {
        Target::Html => Ok(one(html(project, composed))),
        Target::Json => Ok(one(json(project))),
        Target::Module => Ok(typed(output.clone(), module(project, composed))),
        Target::Three => {
            let other = project.passes.iter().find(|p| p.kind == Pass::Cubemap);
            match other {
                Some(_) => Err(
                    "three.js gets the Image and its buffers; this has a cube map pass. \
                     Write a module instead, with `--target module`"
                        .to_string(),
                ),
                None => Ok(typed(output.clone(), three(project, composed))),
            }
        }
        Target::React => {
            let stem = output
                .file_stem()
                .map_or("shader".into(), |s| s.to_string_lossy());
            let inner = format!("{stem}.module.js");
            let mut made = typed(output.clone(), react(project, &inner));
            let below = typed(output.with_file_name(inner), module(project, composed));
            made.files.extend(below.files);
            Ok(made)
        }
        Target::Glsl => shaders(args, project, composed),
        #[cfg(feature = "naga")]
        target => match language(target) {
            Some(language) => translated(args, project, composed, language),
            None => Err("this target is not known".to_string()),
        },
    }
}

/// The language of a target that naga writes.
#[cfg(feature = "naga")]
fn language(target: Target) -> Option<Language> {
    match target {
        Target::Wgsl => Some(Language::Wgsl),
        Target::Spirv => Some(Language::Spirv),
        Target::Hlsl => Some(Language::Hlsl),
        Target::Msl => Some(Language::Msl),
        _ => None,
    }
}

/// Each pass in another language; those that have no place there are told of.
#[cfg(feature = "naga")]
fn translated(
    args: &Args,
    project: &Project,
    composed: &Composed,
    language: Language,
) -> Result<Made, String> {
    let mut remarks = Vec::new();
    let mut passes = Vec::new();
    for unit in &composed.units {
        let Some(pass) = project.passes.get(unit.pass) else {
            continue;
        };
        match translate(project, composed, unit, language) {
            Ok(Some(bytes)) => passes.push((pass.title(unit.pass), pass.slug(), bytes)),
            // The compiler's own errors are told anyway.
            Ok(None) => {}
            Err(refused) => remarks.push(Remark::refused(pass.title(unit.pass), &refused)),
        }
    }
    let files = match remarks.is_empty() {
        true => named(args, passes, language.ending())?,
        false => Vec::new(),
    };
    Ok(Made { files, remarks })
}

/// A module and its types beside it.
fn typed(path: PathBuf, module: Module) -> Made {
    let types = path.with_extension("d.ts");
    Made {
        files: vec![
            (path, module.code.into_bytes()),
            (types, module.types.into_bytes()),
        ],
        remarks: Vec::new(),
    }
}

/// The fragment shaders, and the vertex shader beside them.
fn shaders(args: &Args, project: &Project, composed: &Composed) -> Result<Made, String> {
    let output = args.output.clone().unwrap_or_default();
    let mut remarks = Vec::new();
    let mut passes = glsl(project, composed);
    if args.main == MainChoice::Rewrite {
        for (pass, unit) in passes.iter_mut().zip(&composed.units) {
            match rewrite(project, composed, unit) {
                Ok(text) => pass.fragment = text,
                Err(reason) => remarks.push(Remark::kept(pass.name.clone(), &reason)),
            }
        }
    }
    let vertex = VERTEX.as_bytes().to_vec();
    let is_alone = passes.len() == 1;
    let passes = passes
        .into_iter()
        .map(|p| (p.name, p.slug, p.fragment.into_bytes()))
        .collect();
    let mut files = named(args, passes, "frag")?;
    files.push(match is_alone {
        true => (output.with_extension("vert"), vertex),
        false => (output.join("pass.vert"), vertex),
    });
    Ok(Made { files, remarks })
}

/// One pass becomes the file named; several go into a folder, under names that the converter gives.
fn named(
    args: &Args,
    passes: Vec<(String, &'static str, Vec<u8>)>,
    ending: &str,
) -> Result<Vec<(PathBuf, Vec<u8>)>, String> {
    let output = args.output.clone().unwrap_or_default();
    if passes.len() < 2 {
        let only = passes.into_iter().map(|(.., text)| (output.clone(), text));
        return Ok(only.collect());
    }
    if args.output.is_none() || output.extension().is_some() {
        let names: Vec<&str> = passes.iter().map(|p| p.0.as_str()).collect();
        return Err(format!(
            "this has {} passes ({}); write a page, with `-o FILE.html`, or name a folder, with \
             `-o FOLDER`",
            names.len(),
            names.join(", ")
        ));
    }
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    for (_, slug, text) in passes {
        let mut path = output.join(format!("{slug}.{ending}"));
        let mut number = 2;
        while files.iter().any(|(p, _)| *p == path) {
            path = output.join(format!("{slug}_{number}.{ending}"));
            number += 1;
        }
        files.push((path, text));
    }
    Ok(files)
}
