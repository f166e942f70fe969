//! The instructions that the VM may execute without a jump for each.

use crate::bytecode::Instr;

/// The instructions after the current one, of which it may execute some, too: components of vectors
/// follow each other with the same operation, and need no jump for each.
pub(super) struct Following<'c> {
    pub body: &'c [Instr],
    /// The index of the next instruction.
    pub at: usize,
}

impl Following<'_> {
    /// The next instruction, if it is chosen; it is then the current one.
    #[inline(always)]
    pub fn next_if<T>(&mut self, chosen: impl Fn(Instr) -> Option<T>) -> Option<T> {
        let found = chosen(*self.body.get(self.at)?)?;
        self.at += 1;
        Some(found)
    }
}
