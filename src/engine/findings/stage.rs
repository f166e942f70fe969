//! What the stages of a check work on.

use super::report::Report;
use crate::check_context::CheckContext;
use crate::hosts::host::Hosts;
use crate::options::Options;
use crate::shader::shader_input::ShaderInput;
use shaderlint_detect::kind::FileKind;
use shaderlint_diagnostic::{Applicability, Diagnostic};
use shaderlint_explain::Checked;
use shaderlint_host::Preset;
use shaderlint_lint::{Allows, CachedFacts, SkippedRules};
use shaderlint_project::Hushed;
use shaderlint_text::{Encoding, Sources, Span};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A stage of a check: adds findings, or changes or drops those of earlier stages.
pub enum FindingStage {
    /// Looks at one shader of a file.
    Shader(fn(&mut ShaderCheck)),
    /// Looks at a file, all of whose shaders have been looked at.
    File(fn(&mut FileCheck)),
}

/// A shader that is checked.
pub struct ShaderCheck<'a> {
    pub sources: &'a Arc<Sources>,
    pub part: &'a ShaderInput,
    pub hosts: &'a Hosts<'a>,
    pub options: &'a Options,
    /// The program, and the findings so far.
    pub checked: Checked,
    /// The analyses that rules have computed.
    pub known: Arc<CachedFacts>,
    /// Whether the browser would reject it.
    pub has_errors: bool,
    /// Where rules did not run.
    pub skipped: SkippedRules,
    /// Number of findings dropped because there are too many.
    pub left_out: usize,
    /// The suppression comments of the file.
    pub allows: &'a mut Allows,
    /// Names that the hosts of the file have to declare.
    pub unresolved: &'a mut Unresolved,
}

impl ShaderCheck<'_> {
    /// The host that runs the shader: detected, or set by the user.
    pub fn host(&self) -> Option<&'static Preset> {
        self.part.host.or(self.options.host.preset)
    }
}

/// A file that is checked.
pub struct FileCheck<'a> {
    pub name: &'a str,
    pub kind: FileKind,
    pub encoding: Encoding,
    pub context: CheckContext<'a>,
    pub parts: Vec<ShaderInput>,
    /// The shader in another file that it is linked with.
    pub partner: Option<ShaderInput>,
    /// Findings about the file itself.
    pub problems: Vec<Diagnostic>,
    /// Files whose findings are not reported here.
    pub hushed: Hushed,
    /// The suppression comments.
    pub allows: Allows,
    /// Names that hosts have to declare.
    pub unresolved: Unresolved,
    /// The result so far, with the findings.
    pub report: Report,
}

/// The names that the hosts of a file have to declare, and the first use.
#[derive(Default)]
pub struct Unresolved {
    pub first: Option<Span>,
    pub names: BTreeSet<String>,
}

/// Makes all fixes unsafe, so that a person decides.
pub fn ask_first<'d>(diagnostics: impl IntoIterator<Item = &'d mut Diagnostic>) {
    for fix in diagnostics.into_iter().filter_map(|d| d.fix.as_mut()) {
        fix.applicability = Applicability::Unsafe;
    }
}
