//! What ranges are asked of: lanes of operations, and definitions, under one number.

use crate::defs::{DefId, Defs};
use shaderlint_ir::OpId;

/// A lane of an operation, or a definition.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Node(pub u32);

/// What a number stands for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Subject {
    /// A lane of an operation's value.
    Lane(OpId, u32),
    /// What a lane of a variable holds.
    Def(DefId),
}

impl Node {
    /// How many there are.
    pub(super) fn count(defs: &Defs) -> usize {
        (defs.lane_count() + defs.len()) as usize
    }

    /// A lane of an operation's value, if it has as many.
    pub(super) fn lane(defs: &Defs, op: OpId, lane: u32) -> Option<Node> {
        (lane < defs.lanes_of(op)).then(|| Node(defs.first_lane(op) + lane))
    }

    /// A definition.
    pub(super) fn def(defs: &Defs, id: DefId) -> Node {
        Node(defs.lane_count() + id.0)
    }

    /// What it stands for.
    pub(super) fn subject(self, defs: &Defs) -> Subject {
        match self.0.checked_sub(defs.lane_count()) {
            Some(def) => Subject::Def(DefId(def)),
            None => {
                let (op, lane) = defs.op_at(self.0);
                Subject::Lane(op, lane)
            }
        }
    }
}
