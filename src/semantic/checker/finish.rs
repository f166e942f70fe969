//! Checks that need the complete shader.

use super::*;

/// A loop that never terminates if its variable is never written to.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopCheck {
    pub variable: VariableId,
    pub keyword: Extent,
}

impl Checker<'_> {
    pub(super) fn finish(&mut self) {
        self.note_uses();
        self.check_entry();
        if !self.gave_up() {
            self.check_outputs();
            self.check_fragment_variables();
            self.check_total_size();
            for LoopCheck { variable, keyword } in std::mem::take(&mut self.loops) {
                if self
                    .variables
                    .get(variable.0 as usize)
                    .is_some_and(|v| !v.written)
                {
                    self.reject(keyword, StatementError::Endless(Some(variable)));
                }
            }
            self.check_calls();
        }
    }

    /// Adds the number of further uses to the errors about undeclared names.
    fn note_uses(&mut self) {
        for (index, uses) in std::mem::take(&mut self.undeclared).into_values() {
            if uses > 0 {
                self.add_aside(index, Aside::Used(uses));
            }
        }
    }
}
