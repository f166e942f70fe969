//! Assumptions under which a gradient is bounded.

use super::form::ScalarId;
use super::interval::RealSpan;
use rustc_hash::FxHashMap;

/// Assumptions about the ranges of nodes and the truth of conditions.
#[derive(Clone, Default, Debug)]
pub(super) struct SlopeAssumptions {
    pub spans: FxHashMap<ScalarId, RealSpan>,
    pub truths: FxHashMap<ScalarId, bool>,
}

impl SlopeAssumptions {
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty() && self.truths.is_empty()
    }

    pub fn span(&self, id: ScalarId) -> Option<RealSpan> {
        self.spans.get(&id).copied()
    }

    pub fn truth(&self, id: ScalarId) -> Option<bool> {
        self.truths.get(&id).copied()
    }
}
