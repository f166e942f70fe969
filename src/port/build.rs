//! The files of each target, as they are to be written.

#[cfg(feature = "naga")]
use super::naga::{FirstRow, Refused, TargetLanguage};
#[cfg(feature = "naga")]
use super::translated::translated;
use super::{
    Composed, NotSafe, Project, ScriptModule, glsl, html, json, module, react, rewrite, three,
};
use shaderlint_diagnostic::{Diagnostic, Origin, Severity};
use shaderlint_semantic::{Pass, Stage};
use shaderlint_text::Span;
use std::fmt;
use std::path::{Path, PathBuf};

/// What is made of a project.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Target {
    /// One page with everything in it
    Html,
    /// A fragment shader for each pass, and the vertex shader
    Glsl,
    /// An ES module without dependencies, which exports `mount(canvas, options)`
    Module,
    /// A module for three.js: a RawShaderMaterial and its update function
    Three,
    /// A React component, over a module beside it
    React,
    /// The project itself, as an export
    Json,
    /// A WGSL shader for each pass, for WebGPU
    #[cfg(feature = "naga")]
    Wgsl,
    /// A SPIR-V module for each pass, for Vulkan
    #[cfg(feature = "naga")]
    Spirv,
    /// An HLSL shader for each pass, for Direct3D
    #[cfg(feature = "naga")]
    Hlsl,
    /// An MSL shader for each pass, for Metal
    #[cfg(feature = "naga")]
    Msl,
}

impl Target {
    /// What the ending of a file's name asks for.
    ///
    /// # Errors
    /// Where it asks for nothing that can be made.
    pub fn of_path(path: &Path) -> Result<Target, BadEnding> {
        Ok(
            match path.extension().and_then(|e| e.to_str()).unwrap_or("") {
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
                "metal" | "msl" => Target::Msl,
                #[cfg(not(feature = "naga"))]
                ending @ ("wgsl" | "spv" | "hlsl" | "metal" | "msl") => {
                    return Err(BadEnding::NotBuilt(ending.to_string()));
                }
                "" | "frag" | "glsl" | "fs" | "fsh" => Target::Glsl,
                other => return Err(BadEnding::Unknown(other.to_string())),
            },
        )
    }

    /// How the names of its files end.
    pub fn ending(self) -> &'static str {
        match self {
            Target::Html => "html",
            Target::Json => "json",
            Target::Module | Target::Three | Target::React => "js",
            Target::Glsl => "frag",
            #[cfg(feature = "naga")]
            Target::Wgsl => "wgsl",
            #[cfg(feature = "naga")]
            Target::Spirv => "spv",
            #[cfg(feature = "naga")]
            Target::Hlsl => "hlsl",
            #[cfg(feature = "naga")]
            Target::Msl => "metal",
        }
    }

    /// The language that naga writes for it.
    #[cfg(feature = "naga")]
    pub fn language(self) -> Option<TargetLanguage> {
        match self {
            Target::Wgsl => Some(TargetLanguage::Wgsl),
            Target::Spirv => Some(TargetLanguage::Spirv),
            Target::Hlsl => Some(TargetLanguage::Hlsl),
            Target::Msl => Some(TargetLanguage::Msl),
            _ => None,
        }
    }

    /// Whether it is shaders alone, which read nothing themselves.
    pub fn is_shaders(self) -> bool {
        !matches!(
            self,
            Target::Html | Target::Module | Target::Three | Target::React | Target::Json
        )
    }
}

/// The ending of a file's name that tells no target.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BadEnding {
    /// This program was built without its language.
    NotBuilt(String),
    /// It is that of something else.
    Unknown(String),
}

impl fmt::Display for BadEnding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BadEnding::NotBuilt(ending) => write!(
                f,
                "this program was built without the language of `.{ending}` files; build it with \
                 `cargo install --path . --features naga`"
            ),
            BadEnding::Unknown(ending) => {
                write!(f, "nothing is made for the ending `.{ending}`; ")?;
                f.write_str(match ending.as_str() {
                    "vert" => "write `-o NAME.frag`, and the vertex shader lies beside it",
                    "jsx" | "tsx" => "say `--target react`",
                    "ts" => "say `--target module`; its types lie beside it",
                    _ => "`.html`, `.js`, `.json` and `.frag` tell the target, or say `--target`",
                })
            }
        }
    }
}

/// How plain shaders get their `main`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum MainChoice {
    /// The player's header, then the code as it is
    #[default]
    Wrap,
    /// `mainImage` becomes `main`, where the picture stays the same
    Rewrite,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Order<'a> {
    /// What is to be made.
    pub target: Target,
    /// How plain shaders get their `main`.
    pub main: MainChoice,
    /// Where it goes.
    pub output: Destination<'a>,
    /// Whether what a host must know of a shader in another language is written beside it.
    #[cfg(feature = "naga")]
    pub interface: bool,
    /// Which row of a picture lies first, drawn by a shader in another language.
    #[cfg(feature = "naga")]
    pub first_row: FirstRow,
    /// The version of a page that a server shows; it loads itself anew when it hears of another.
    pub version: Option<&'a str>,
}

/// Where what is made goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Destination<'a> {
    /// Nowhere yet: one file without a name.
    Standard,
    /// To this file; files beside it get its name.
    File(&'a Path),
    /// Into this folder, under names of their own, where it is shaders.
    Folder(&'a Path),
}

impl<'a> Destination<'a> {
    fn path(self) -> &'a Path {
        match self {
            Destination::Standard => Path::new(""),
            Destination::File(path) | Destination::Folder(path) => path,
        }
    }
}

/// A file that is to be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// Its path, like that of the order.
    pub path: PathBuf,
    /// What it holds.
    pub content: Vec<u8>,
}

/// What is to be written, and what is to be said of it.
#[derive(Default)]
pub struct Build {
    /// The files, the one that was asked for first.
    pub files: Vec<File>,
    /// The passes that could not be made as asked for.
    pub remarks: Vec<Remark>,
}

/// Why nothing can be made.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BuildError {
    /// Modules for three.js have no place for a cube map pass.
    Cubemap,
    /// These passes do not go into one file.
    NeedsFolder(Vec<String>),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::Cubemap => f.write_str(
                "three.js gets the Image and its buffers; this has a cube map pass. \
                 Write a module instead, with `--target module`",
            ),
            BuildError::NeedsFolder(names) => write!(
                f,
                "this has {} passes ({}); write a page, with `-o FILE.html`, or name a folder, with \
                 `-o FOLDER`",
                names.len(),
                names.join(", ")
            ),
        }
    }
}

/// Makes the files of a target.
///
/// # Errors
/// Where the project does not go into what was asked for.
pub fn build(project: &Project, composed: &Composed, order: Order) -> Result<Build, BuildError> {
    let output = order.output.path();
    let one = |text: String| Build::of(vec![file(output, text)]);
    match order.target {
        Target::Html => Ok(one(html(project, composed, order.version))),
        Target::Json => Ok(one(json(project))),
        Target::Module => Ok(Build::of(typed(output, module(project, composed)))),
        Target::Three => match project.passes.iter().any(|p| p.kind == Pass::Cubemap) {
            true => Err(BuildError::Cubemap),
            false => Ok(Build::of(typed(output, three(project, composed)))),
        },
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
        #[cfg(feature = "naga")]
        Target::Wgsl | Target::Spirv | Target::Hlsl | Target::Msl => {
            translated(order, project, composed)
        }
    }
}

impl Build {
    fn of(files: Vec<File>) -> Build {
        Build {
            files,
            remarks: Vec::new(),
        }
    }
}

pub(super) fn file(path: &Path, content: impl Into<Vec<u8>>) -> File {
    File {
        path: path.to_path_buf(),
        content: content.into(),
    }
}

/// A module and its types beside it.
fn typed(path: &Path, module: ScriptModule) -> Vec<File> {
    let types = file(&path.with_extension("d.ts"), module.types);
    vec![file(path, module.code), types]
}

/// The shaders of the passes, and those of the other stage beside them.
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
        ending: ending(p.stage),
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
        // Each has its own beside it.
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
    // Beside standard output lies nothing.
    if order.output != Destination::Standard {
        files.extend(beside);
    }
    Ok(Build { files, remarks })
}

/// How files of a stage end.
fn ending(stage: Stage) -> &'static str {
    match stage {
        Stage::Fragment => "frag",
        Stage::Vertex => "vert",
    }
}

/// Where the shader of a stage goes, where the shaders of a pass have this name: who asks for
/// `points.frag` or `points.glsl` gets the fragment shader there and the vertex shader beside it.
fn shader_path(name: &Path, stage: Stage) -> PathBuf {
    let names_vertices = name.extension().is_some_and(|e| e == ending(Stage::Vertex));
    match stage {
        Stage::Fragment if !names_vertices => name.to_path_buf(),
        _ => name.with_extension(ending(stage)),
    }
}

/// What is to become a file.
pub(super) struct NamedPass {
    /// What the user calls it.
    pub name: String,
    /// What its file is called in a folder.
    pub slug: String,
    /// How that ends.
    pub ending: &'static str,
    /// What it holds.
    pub content: Vec<u8>,
}

/// One pass may become the file named; several go into a folder, under names of their own.
pub(super) fn named(order: Order, passes: Vec<NamedPass>) -> Result<Vec<File>, BuildError> {
    let folder = match order.output {
        Destination::Folder(folder) => folder,
        other if passes.len() < 2 => {
            let only = passes.into_iter().map(|p| file(other.path(), p.content));
            return Ok(only.collect());
        }
        _ => {
            let names = passes.into_iter().map(|p| p.name);
            return Err(BuildError::NeedsFolder(names.collect()));
        }
    };
    let mut files: Vec<File> = Vec::new();
    for pass in passes {
        let NamedPass { slug, ending, .. } = &pass;
        let mut path = folder.join(format!("{slug}.{ending}"));
        let mut number = 2;
        while files.iter().any(|f| f.path == path) {
            path = folder.join(format!("{slug}_{number}.{ending}"));
            number += 1;
        }
        files.push(file(&path, pass.content));
    }
    Ok(files)
}

/// What is to be said of a pass that could not be made as asked for.
pub struct Remark {
    /// What the user calls the pass.
    pub pass: String,
    /// How bad it is; nothing is written if it is an error.
    pub severity: Severity,
    /// What is wrong.
    pub message: String,
    /// Where; empty where it is the whole pass.
    pub span: Span,
    rule: &'static str,
}

impl Remark {
    /// A pass that was to be rewritten, and is not.
    fn kept(pass: String, reason: &NotSafe) -> Remark {
        Remark {
            pass,
            severity: Severity::Warning,
            message: format!("this stays behind the player's header: {}", reason.message),
            span: reason.span,
            rule: "kept-main",
        }
    }

    /// A pass that has no form in the language that was asked for.
    #[cfg(feature = "naga")]
    pub(super) fn refused(pass: String, reason: &Refused) -> Remark {
        Remark {
            pass,
            severity: Severity::Error,
            message: reason.message.clone(),
            span: reason.span,
            rule: "not-portable",
        }
    }

    /// The remark as a finding.
    pub fn diagnostic(&self) -> Diagnostic {
        let message = self.message.clone();
        Diagnostic::new(
            self.rule,
            Origin::Compiler,
            self.severity,
            self.span,
            message,
        )
    }
}
