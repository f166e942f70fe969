//! Builds the output files of each target.

use super::host_output::for_host;
use super::html::embed::{embed, still_name};
use super::order::{Destination, MainChoice, Order, Target};
use super::output::{Build, BuildError, File, NamedPass, Remark, file, named};
#[cfg(feature = "naga")]
use super::script::three_webgpu;
#[cfg(feature = "naga")]
use super::translated::translated;
#[cfg(feature = "naga")]
use super::webgpu::{NoWebGpu, webgpu_passes};
use super::{
    Composed, PlayerPage, Poster, Project, ScriptModule, Still, glsl, html, json, module, react,
    rewrite, three,
};
use shaderlint_semantic::{Pass, Stage};
use std::path::{Path, PathBuf};

/// Builds the files of a target.
///
/// # Errors
/// If the target does not support the project.
pub fn build(project: &Project, composed: &Composed, order: Order) -> Result<Build, BuildError> {
    let output = order.output.path();
    let one = |text: String| Build::of(vec![file(output, text)]);
    match order.target {
        Target::Html => Ok(Build::of(match order.poster {
            Some(poster) => embedded(project, composed, poster, order),
            None => paged(
                order,
                &html(project, composed, order.version, order.playground),
            ),
        })),
        Target::Json => Ok(one(json(project))),
        Target::Module => Ok(Build::of(typed(output, module(project, composed)))),
        Target::Three => match project.passes.iter().any(|p| p.kind == Pass::Cubemap) {
            true => Err(BuildError::Cubemap),
            false => Ok(Build::of(typed(output, three(project, composed)))),
        },
        #[cfg(feature = "naga")]
        Target::ThreeWebgpu => for_webgpu(project, composed, output),
        Target::React => {
            let stem = output.file_stem();
            let stem = stem.map_or("shader".into(), |s| s.to_string_lossy());
            let inner = format!("{stem}.module.js");
            let mut files = typed(output, react(project, &inner));
            let inner = output.with_file_name(inner);
            files.extend(typed(&inner, module(project, composed)));
            Ok(Build::of(files))
        }
        Target::Glsl => shaders(order, project, composed),
        Target::Host(host) => for_host(order, project, composed, host),
        #[cfg(feature = "naga")]
        Target::Wgsl | Target::Spirv | Target::Hlsl | Target::Msl => {
            translated(order, project, composed)
        }
    }
}

/// The module for WebGPURenderer; passes that cannot be translated become remarks.
#[cfg(feature = "naga")]
fn for_webgpu(project: &Project, composed: &Composed, output: &Path) -> Result<Build, BuildError> {
    match webgpu_passes(project, composed) {
        Ok(passes) => Ok(Build::of(typed(output, three_webgpu(project, &passes)))),
        Err(NoWebGpu::Unsupported(reason)) => Err(BuildError::NoWebGpu(reason)),
        Err(NoWebGpu::Errors) => Ok(Build::default()),
        Err(NoWebGpu::Refused(pass, reason)) => Ok(Build {
            files: Vec::new(),
            remarks: vec![Remark::refused(pass, &reason)],
        }),
    }
}

/// A page for frames of other pages. If its address is known, its still image is also a file beside
/// it, since link previews require one.
fn embedded(project: &Project, composed: &Composed, poster: &Poster, order: Order) -> Vec<File> {
    let output = order.output.path();
    let mut files = paged(order, &embed(project, composed, poster, output));
    if let (Some(still), Some(_)) = (&poster.still, &poster.address) {
        files.push(still_file(output, still));
    }
    files
}

/// A still image as a file beside its page.
pub fn still_file(page: &Path, still: &Still) -> File {
    file(&page.with_file_name(still_name(page)), still.png.as_slice())
}

/// A page as one file, or with its script and its style beside it.
fn paged(order: Order, page: &PlayerPage) -> Vec<File> {
    let output = order.output.path();
    if !order.split {
        return vec![file(output, page.whole())];
    }
    let paths = ["js", "css"].map(|extension| output.with_extension(extension));
    let [script_path, style_path] = &paths;
    let name = |path: &Path| {
        let name = path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    };
    let [html, script, style] = page.split(&name(script_path), &name(style_path));
    vec![
        file(output, html),
        file(script_path, script),
        file(style_path, style),
    ]
}

/// A module and its type declarations.
fn typed(path: &Path, module: ScriptModule) -> Vec<File> {
    let types = file(&path.with_extension("d.ts"), module.types);
    vec![file(path, module.code), types]
}

/// The shaders of the passes, each with its partner of the other stage.
fn shaders(order: Order, project: &Project, composed: &Composed) -> Result<Build, BuildError> {
    let mut remarks = Vec::new();
    let mut passes = glsl(project, composed);
    if order.main == MainChoice::Rewrite {
        for (pass, unit) in passes.iter_mut().zip(&composed.units) {
            match rewrite(project, composed, unit) {
                Ok(text) => pass.text = text,
                Err(reason) => remarks.push(Remark::kept(pass.name.clone(), &reason)),
            }
        }
    }
    let partners: Vec<(Stage, String)> = passes
        .iter_mut()
        .map(|p| (p.stage, std::mem::take(&mut p.partner)))
        .collect();
    let named_passes = passes.into_iter().map(|p| NamedPass {
        extension: extension(p.stage),
        content: p.text.into_bytes(),
        slug: p.slug.to_string(),
        name: p.name,
    });
    let mut files = named(order, named_passes.collect())?;
    let is_one = partners.windows(2).all(|pair| pair.first() == pair.last());
    let beside: Vec<File> = match (&partners[..], order.output) {
        ([(Stage::Fragment, vertex), ..], Destination::Folder(folder)) if is_one => {
            vec![file(&folder.join("pass.vert"), vertex.as_str())]
        }
        // Each shader has its own partner.
        _ => {
            let pairs = files.iter().zip(&partners);
            let pairs = pairs.map(|(named, (stage, partner))| {
                file(&shader_path(&named.path, stage.other()), partner.as_str())
            });
            pairs.collect()
        }
    };
    for (own, (stage, _)) in files.iter_mut().zip(&partners) {
        own.path = shader_path(&own.path, *stage);
    }
    // Standard output takes only the first file.
    if order.output != Destination::Standard {
        files.extend(beside);
    }
    Ok(Build { files, remarks })
}

/// The file extension of a stage.
fn extension(stage: Stage) -> &'static str {
    match stage {
        Stage::Fragment => "frag",
        Stage::Vertex => "vert",
    }
}

/// The path of a stage's shader for a given output name: for `points.frag` or `points.glsl` the
/// fragment shader has that name and the vertex shader is next to it.
fn shader_path(name: &Path, stage: Stage) -> PathBuf {
    let names_vertices = name
        .extension()
        .is_some_and(|e| e == extension(Stage::Vertex));
    match stage {
        Stage::Fragment if !names_vertices => name.to_path_buf(),
        _ => name.with_extension(extension(stage)),
    }
}
