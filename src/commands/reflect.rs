//! `shaderlint reflect` and `shaderlint types`: what shaders declare for the program around them.

use serde::Serialize;
use shaderlint_contract::is_given_to_patches;
use shaderlint_diagnostic::{Facet, Severity};
use shaderlint_engine::{Options, analyze};
use shaderlint_project::Files;
use shaderlint_reflect::{Reflection, TypeStyle, UniformTypes};
use shaderlint_text::{CompiledText, Role};

/// A shader of a file.
#[derive(Debug, Serialize)]
pub struct ReflectedShader {
    /// The name of the file.
    pub file: String,
    /// The line on which its text starts, from 1.
    pub line: u32,
    /// The host that runs it, if one is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub host: Option<&'static str>,
    /// What it declares.
    #[serde(flatten)]
    pub declares: Reflection,
}

/// The shaders of a file.
pub struct FileReflection {
    /// Those that compile.
    pub shaders: Vec<ReflectedShader>,
    /// Number of those with errors, of which not everything is known.
    pub broken: usize,
}

/// What the shaders of a file declare.
///
/// # Errors
/// Why the file is not read as one with shaders.
pub fn reflect(
    (name, text): (&str, &str),
    options: &Options,
    files: &dyn Files,
) -> Result<FileReflection, String> {
    let report = analyze(name, text, options, files);
    if let Some(unread) = report.unread {
        return Err(unread.to_string());
    }
    // What a stage declares is also known if it cannot be linked with another one.
    let errors = report.diagnostics.iter();
    let errors = errors.filter(|d| d.severity == Severity::Error && !d.has(Facet::Links));
    let broken: Vec<u32> = errors.map(|d| d.span.start).collect();
    let mut found = FileReflection {
        shaders: Vec::new(),
        broken: usize::from(report.analyses.is_empty() && !broken.is_empty()),
    };
    for analysis in &report.analyses {
        let (sources, files) = (analysis.sources(), analysis.files());
        let texts = files.iter().filter_map(|id| sources.code(*id));
        let own: Vec<_> = texts.filter(|text| text.role == Role::User).collect();
        let is_in = |text: &CompiledText, at: &u32| {
            at.checked_sub(text.base)
                .is_some_and(|at| at as usize <= text.text.len())
        };
        if broken
            .iter()
            .any(|at| own.iter().any(|text| is_in(text, at)))
        {
            found.broken += 1;
            continue;
        }
        let start = own.first().map_or(0, |text| text.base);
        let start = sources
            .file_at(start)
            .map(|file| file.shown_position(start));
        let mut shaders = report.shaders.iter();
        let is_open = shaders.any(|s| s.file == files.last().copied() && !s.missing.is_empty());
        found.shaders.push(ReflectedShader {
            file: name.to_string(),
            line: start.map_or(1, |position| position.line),
            host: analysis.host.map(|host| host.name),
            declares: Reflection {
                open: is_open,
                ..Reflection::of(&analysis.program, files)
            },
        });
    }
    Ok(found)
}

/// Declarations whose uniforms have these types.
pub fn type_style(uniforms: UniformTypes) -> TypeStyle<'static> {
    TypeStyle {
        uniforms,
        is_given: &is_given_to_patches,
    }
}

/// What `shaderlint reflect` prints.
#[derive(Serialize)]
pub struct ReflectionList<'a> {
    /// The version of the format: fields are only ever added.
    schema: u32,
    shaders: &'a [ReflectedShader],
}

impl<'a> ReflectionList<'a> {
    /// Lists shaders.
    pub fn new(shaders: &'a [ReflectedShader]) -> ReflectionList<'a> {
        ReflectionList { schema: 1, shaders }
    }
}
