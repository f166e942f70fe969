//! One shader of an input.

use super::analysis::Analysis;
use super::reading::{PresumedCompleteness, Reading, Readings};
use shaderlint_detect::embed::Embedder;
use shaderlint_host::Preset;
use shaderlint_lint::SkippedRules;
use shaderlint_project::MissingInclude;
use shaderlint_project::PassUnit;
use shaderlint_semantic::{Completeness, Dialect, Stage};
use shaderlint_syntax::GlContext;
use shaderlint_syntax::Version;
use shaderlint_text::FileId;
use std::collections::BTreeSet;

/// One shader of an input.
pub struct ShaderInput {
    /// The possible readings of the text.
    pub readings: Readings,
    /// Whether the types of its channels are inferred.
    pub infer_channels: bool,
    /// Its index among the embedded shaders of a page or script.
    pub embedded: Option<usize>,
    /// The page or script that contains it.
    pub embedder: Embedder,
    /// By channel: whether its texture has mipmaps; `None` if unknown.
    pub mipmapped: [Option<bool>; 4],
    /// Includes that were not found.
    pub missing: Vec<MissingInclude>,
    /// Whether its files are all that scripts make a shader of.
    pub is_joined: bool,
    /// Whether it is of a library that adds only macros and the chunks that it imports.
    pub is_of_library: bool,
    /// The host that composes the shader, if the composed text is what is checked.
    pub host: Option<&'static Preset>,
    /// The checked shader, if it is kept.
    pub analysis: Option<Analysis>,
}

impl ShaderInput {
    /// A shader on its own.
    pub fn new(readings: Readings) -> ShaderInput {
        ShaderInput {
            infer_channels: readings.is_shadertoy(),
            readings,
            embedded: None,
            embedder: Embedder::default(),
            mipmapped: [None; 4],
            missing: Vec::new(),
            is_joined: false,
            is_of_library: false,
            host: None,
            analysis: None,
        }
    }

    /// A pass of an export, or of a project that its host composes.
    pub fn of_pass(unit: PassUnit, host: Option<&'static Preset>) -> ShaderInput {
        let reading = Reading {
            files: unit.files,
            stage: Stage::Fragment,
            dialect: match host {
                Some(_) => Dialect::WebGl,
                None => Dialect::ShaderToy(unit.kind),
            },
            context: GlContext::WEBGL2,
        };
        ShaderInput {
            host,
            infer_channels: false,
            mipmapped: unit.mipmapped,
            ..ShaderInput::new(Readings::of_complete(reading))
        }
    }

    /// The most likely reading.
    pub fn reading(&self) -> Option<&Reading> {
        self.readings.all.first()
    }

    /// Whether it may be linked with another stage.
    pub fn may_be_program(&self) -> bool {
        self.readings.presumed != PresumedCompleteness::Excerpt
            && self.reading().is_some_and(|r| !r.dialect.is_shadertoy())
    }
}

/// One shader of a file, and how far rules checked it.
#[derive(Clone, Debug)]
pub struct Shader {
    /// The last of its files.
    pub file: Option<FileId>,
    /// Vertex or fragment stage.
    pub stage: Stage,
    /// Number of tokens and macro calls.
    pub size: usize,
    /// ShaderToy pass or WebGL shader.
    pub dialect: Dialect,
    /// GLSL version.
    pub version: Version,
    /// Whether it is a complete shader or a fragment.
    pub completeness: Completeness,
    /// Where rules did not run.
    pub skipped: SkippedRules,
    /// Whether the browser would reject it.
    pub has_errors: bool,
    /// Number of findings dropped because there are too many.
    pub left_out: usize,
    /// Names that its host has to declare.
    pub holes: BTreeSet<String>,
    /// The hosts that may complete it.
    pub hosts: Vec<String>,
    /// The host that composes the shader, if the composed text was checked.
    pub host: Option<&'static Preset>,
    /// The release of the library whose chunks it includes.
    pub release: Option<u32>,
    /// Includes that were not found.
    pub missing: Vec<MissingInclude>,
}
