//! A shader for a host as that host completes it.

use crate::Bindings;
use shaderlint_explain::Checked;
use shaderlint_host::{HostVersion, Preset};
use shaderlint_project::{Clues, Completion, TextChange, best, bind, plan};

/// A checked shader of a host.
pub struct HostedShader {
    /// The completed shader.
    pub checked: Checked,
    /// The values of its inputs.
    pub bound: Bindings,
    /// The address of its code.
    base: u32,
    /// The changes that completed the text.
    changes: Vec<TextChange>,
}

impl HostedShader {
    /// Completes a text as a host does, in the version that it compiles.
    pub fn of(host: &'static Preset, text: &str) -> Option<HostedShader> {
        let plan = plan(host, &Clues::of(text))?;
        let pass = plan.passes.into_iter().rfind(|pass| pass.is_of_text)?;
        let is_old = host.version == HostVersion::Es100;
        let fits = |c: &Completion| !is_old || !c.before.starts_with("#version 300");
        let candidates = pass.candidates.into_iter().filter(fits).collect();
        let completion = best(candidates)?;
        let added = host.template.as_ref().map_or("", |t| t.host.as_str());
        let completion = match added {
            "" => completion,
            added => completion.with_end(added),
        };
        let checked = completion.check()?;
        let base = match completion.before.is_empty() {
            true => 0,
            false => checked.program.sources.files().get(1)?.base,
        };
        let bound = bind(&checked.program, host, (&[], &[]), None, None);
        Some(HostedShader {
            checked,
            bound,
            base,
            changes: completion.changes,
        })
    }

    /// The offset in the text for an address in the completed shader; `None` for added text.
    pub(super) fn offset(&self, address: u32) -> Option<usize> {
        if !self.checked.program.sources.is_user(address) {
            return None;
        }
        let mut offset = address.checked_sub(self.base)? as usize;
        for change in &self.changes {
            if offset < change.range.start + change.put.len() {
                break;
            }
            offset = (offset + change.range.len()).checked_sub(change.put.len())?;
        }
        Some(offset)
    }
}
