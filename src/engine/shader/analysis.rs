//! A checked shader that outlives the check, for editors and sample runs.

use super::reading::code_of;
use shaderlint_explain::Checked;
use shaderlint_host::Preset;
use shaderlint_ir::Module;
use shaderlint_lint::{CachedFacts, Facts};
use shaderlint_semantic::{Completeness, Program};
use shaderlint_text::{FileId, Sources};
use std::sync::Arc;

/// A checked shader with further analyses, each computed on first use. It owns its data and can be
/// shared between threads.
pub struct Analysis {
    /// The checked program.
    pub program: Arc<Program>,
    /// Whether it is a complete shader or a fragment.
    pub completeness: Completeness,
    /// Whether the browser would reject it.
    pub has_errors: bool,
    /// The host that runs it, set by the user or detected.
    pub host: Option<&'static Preset>,
    /// The texts that it consists of, in order.
    files: Vec<FileId>,
    known: Arc<CachedFacts>,
}

impl Analysis {
    /// A checked shader and the texts that it consists of, in order. `known` holds the analyses that
    /// the rules have computed already.
    pub fn new(
        checked: Checked,
        has_errors: bool,
        host: Option<&'static Preset>,
        files: &[FileId],
        known: Arc<CachedFacts>,
    ) -> Analysis {
        Analysis {
            program: Arc::new(checked.program),
            completeness: checked.completeness,
            has_errors,
            host,
            files: files.to_vec(),
            known,
        }
    }

    /// The source texts that its spans refer to.
    pub fn sources(&self) -> &Arc<Sources> {
        &self.program.sources
    }

    /// The user's code of the shader, with what it includes.
    pub fn user_code(&self) -> String {
        code_of(self.sources(), &self.files)
    }

    /// The texts that it consists of, in order.
    pub fn files(&self) -> &[FileId] {
        &self.files
    }

    /// The IR of the shader.
    pub fn module(&self) -> &Arc<Module> {
        self.known.module(&self.program)
    }

    /// The facts about the shader. Analyses are computed once.
    pub fn facts(&self) -> Facts<'_> {
        Facts::of(&self.program, &self.known)
    }
}

const _: () = {
    const fn is_shared<T: Send + Sync + 'static>() {}
    is_shared::<Analysis>();
};
