//! One shader of an input.

use super::analysis::Analysis;
use super::include::MissingInclude;
use super::reading::{Reading, Readings, Standing};
use shaderlint_host::Preset;
use shaderlint_lint::Unrun;
use shaderlint_port::PassUnit;
use shaderlint_semantic::{Dialect, Stage, Wholeness};
use shaderlint_syntax::Version;
use shaderlint_text::FileId;
use shaderlint_text::embed::Embedder;
use std::collections::BTreeSet;

/// One shader of an input.
pub struct Part {
    /// The ways to read it.
    pub readings: Readings,
    /// Whether its channels may be of any type.
    pub infer_channels: bool,
    /// The page or script around it.
    pub embedder: Embedder,
    /// By channel: whether its texture has mipmaps, where that is known.
    pub mipmapped: [Option<bool>; 4],
    /// What it includes and is not found.
    pub missing: Vec<MissingInclude>,
    /// Who runs it, where it is checked as what its host makes of it.
    pub host: Option<&'static Preset>,
    /// What came of checking it, where that is kept.
    pub analysis: Option<Analysis>,
}

impl Part {
    /// A pass of an export.
    pub fn of_pass(unit: PassUnit) -> Part {
        let reading = Reading {
            files: unit.files,
            stage: Stage::Fragment,
            dialect: Dialect::ShaderToy(unit.kind),
        };
        Part {
            readings: Readings::whole(reading),
            infer_channels: false,
            embedder: Embedder::default(),
            mipmapped: unit.mipmapped,
            missing: Vec::new(),
            host: None,
            analysis: None,
        }
    }

    /// A shader with all that its host puts around it.
    pub fn hosted(readings: Readings, host: &'static Preset) -> Part {
        Part {
            readings,
            infer_channels: false,
            embedder: Embedder::default(),
            mipmapped: [None; 4],
            missing: Vec::new(),
            host: Some(host),
            analysis: None,
        }
    }

    /// The likeliest way to read it.
    pub fn reading(&self) -> Option<&Reading> {
        self.readings.all.first()
    }

    /// Whether it may be linked with another stage.
    pub fn may_be_program(&self) -> bool {
        self.readings.standing != Standing::Excerpt
            && self.reading().is_some_and(|r| !r.dialect.is_shadertoy())
    }
}

/// What was read as one shader, and how far rules looked at it.
#[derive(Clone, Debug)]
pub struct Shader {
    /// Its last file.
    pub file: Option<FileId>,
    /// The stage.
    pub stage: Stage,
    /// How many tokens and macro calls it has.
    pub size: usize,
    /// Who runs it.
    pub dialect: Dialect,
    /// The version of the language.
    pub version: Version,
    /// How much of it is at hand.
    pub wholeness: Wholeness,
    /// Where no rule looked.
    pub unrun: Unrun,
    /// Whether the browser would refuse it as it stands.
    pub has_errors: bool,
    /// Findings of the rules that are not kept, since there are too many.
    pub left_out: usize,
    /// What its host has to declare.
    pub holes: BTreeSet<String>,
    /// The hosts that are thought to complete it.
    pub hosts: Vec<String>,
    /// Who runs it, where it was checked as what its host makes of it.
    pub host: Option<&'static Preset>,
    /// What it includes and is not found.
    pub missing: Vec<MissingInclude>,
}
