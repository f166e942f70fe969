//! A checked shader that outlives the call that checked it: what editors and runs keep.

use shaderlint_host::Preset;
use shaderlint_ir::Module;
use shaderlint_lint::{Facts, Known};
use shaderlint_semantic::{Checked, Program, Wholeness};
use shaderlint_text::Sources;
use std::sync::Arc;

/// A checked shader, and what else is found out of it, each when it is first asked for. It owns all
/// that it speaks of; threads can share it.
pub struct Analysis {
    /// What the shader means.
    pub program: Arc<Program>,
    /// How much of a shader it is.
    pub wholeness: Wholeness,
    /// Whether the browser would refuse it as it stands.
    pub has_errors: bool,
    /// Who runs it, as the user says or the text asks for.
    pub host: Option<&'static Preset>,
    known: Arc<Known>,
}

impl Analysis {
    /// `known` is what the rules have found out already.
    pub(super) fn new(
        checked: Checked,
        has_errors: bool,
        host: Option<&'static Preset>,
        known: Arc<Known>,
    ) -> Analysis {
        Analysis {
            program: Arc::new(checked.program),
            wholeness: checked.wholeness,
            has_errors,
            host,
            known,
        }
    }

    /// The texts that its places point into.
    pub fn sources(&self) -> &Arc<Sources> {
        &self.program.sources
    }

    /// The shader in the middle form.
    pub fn module(&self) -> &Arc<Module> {
        self.known.module(&self.program)
    }

    /// What the shader does. Whatever was asked for before is still known.
    pub fn facts(&self) -> Facts<'_> {
        Facts::of(&self.program, &self.known)
    }
}

const _: () = {
    const fn is_shared<T: Send + Sync + 'static>() {}
    is_shared::<Analysis>();
};
