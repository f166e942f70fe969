//! The files of each target.

use super::{Args, MainChoice, Target};
use crate::port::{
    Composed, Module, NotSafe, Project, VERTEX, glsl, html, json, module, react, rewrite, three,
};
use crate::semantic::Pass;
use std::path::{Path, PathBuf};

/// What is written, and what is to be said of it.
pub(super) struct Made {
    /// The files by path.
    pub(super) files: Vec<(PathBuf, Vec<u8>)>,
    /// The passes that could not be rewritten.
    pub(super) kept: Vec<(String, NotSafe)>,
}

/// The target that is asked for; without one the ending of the output tells.
pub(super) fn target_of(args: &Args) -> Target {
    let output = args.output.as_deref().unwrap_or(Path::new(""));
    let ending = output.extension().and_then(|e| e.to_str()).unwrap_or("");
    args.target.unwrap_or(match ending {
        "html" | "htm" => Target::Html,
        "js" | "mjs" => Target::Module,
        "json" => Target::Json,
        _ => Target::Glsl,
    })
}

/// Makes the files of the target.
pub(super) fn make(args: &Args, project: &Project, composed: &Composed) -> Result<Made, String> {
    let output = args.output.clone().unwrap_or_default();
    let one = |text: String| Made {
        files: vec![(output.clone(), text.into_bytes())],
        kept: Vec::new(),
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
    }
}

/// A module and its types beside it.
fn typed(path: PathBuf, module: Module) -> Made {
    let types = path.with_extension("d.ts");
    Made {
        files: vec![
            (path, module.code.into_bytes()),
            (types, module.types.into_bytes()),
        ],
        kept: Vec::new(),
    }
}

/// One pass becomes the file named and the vertex shader beside it; several go into a folder, under
/// names that the converter gives.
fn shaders(args: &Args, project: &Project, composed: &Composed) -> Result<Made, String> {
    let output = args.output.clone().unwrap_or_default();
    let mut kept = Vec::new();
    let mut passes = glsl(project, composed);
    if args.main == MainChoice::Rewrite {
        for (pass, unit) in passes.iter_mut().zip(&composed.units) {
            match rewrite(project, composed, unit) {
                Ok(text) => pass.fragment = text,
                Err(reason) => kept.push((pass.name.clone(), reason)),
            }
        }
    }
    let vertex = VERTEX.as_bytes().to_vec();
    if let [pass] = &passes[..] {
        let beside = output.with_extension("vert");
        let fragment = pass.fragment.clone().into_bytes();
        let files = vec![(output, fragment), (beside, vertex)];
        return Ok(Made { files, kept });
    }
    if args.output.is_none() || output.extension().is_some() {
        let names: Vec<&str> = passes.iter().map(|p| p.name.as_str()).collect();
        return Err(format!(
            "this has {} passes ({}); write a page, with `-o FILE.html`, or name a folder, with \
             `-o FOLDER`",
            names.len(),
            names.join(", ")
        ));
    }
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    for pass in passes {
        let mut path = output.join(format!("{}.frag", pass.slug));
        let mut number = 2;
        while files.iter().any(|(p, _)| *p == path) {
            path = output.join(format!("{}_{number}.frag", pass.slug));
            number += 1;
        }
        files.push((path, pass.fragment.into_bytes()));
    }
    files.push((output.join("pass.vert"), vertex));
    Ok(Made { files, kept })
}
