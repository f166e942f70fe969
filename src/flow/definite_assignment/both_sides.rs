//! Reads that both sides of a branch have in common.

use super::walk::AssignmentWalk;

/// Most reads of a side that are compared with those of the other.
const MAX_READS: usize = 64;

impl AssignmentWalk<'_> {
    /// What both sides of a branch read is read whatever the condition is. The reads of the sides start at
    /// `first` and `second`.
    pub(super) fn join_reads(&mut self, first: usize, second: usize) {
        let inside = self.branches.len() + 1;
        if second - first > MAX_READS {
            return;
        }
        let mut at = second;
        while let Some(&read) = self.findings.reads.get(at) {
            let depth = self.depths.get(at).copied();
            let is_same = |i: &usize| {
                let other = self.findings.reads.get(*i);
                let is_direct = [self.depths.get(*i).copied(), depth] == [Some(inside); 2];
                is_direct
                    && other
                        .is_some_and(|o| o.variable == read.variable && o.missing == read.missing)
            };
            let Some(same) = (first..second).find(is_same) else {
                at += 1;
                continue;
            };
            self.findings.reads.remove(at);
            self.depths.remove(at);
            let since = self.since.get(&read.variable).copied().unwrap_or(0);
            let is_unwritten = self.written(read.variable) & read.missing == 0;
            let guarded = self.branches.iter().any(|b| b.0 > since);
            if let (Some(read), Some(depth)) =
                (self.findings.reads.get_mut(same), self.depths.get_mut(same))
            {
                read.guarded = guarded;
                read.always |= !guarded && is_unwritten;
                *depth = self.branches.len();
            }
        }
    }
}
