//! Nodes of the range graph: components of operations and definitions, numbered together.

use super::interval::Interval;
use crate::reaching_definitions::{DefId, ReachingDefinitions};
use shaderlint_ir::OpId;

/// Gives the range of a node; `None` if it never has a value.
pub(super) trait GetRange: FnMut(Node) -> Option<Interval> {}

impl<F: FnMut(Node) -> Option<Interval>> GetRange for F {}

/// A component of an operation, or a definition.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Node(pub u32);

/// What a node represents.
#[derive(Clone, Copy, Debug)]
pub(super) enum NodeSubject {
    /// A component of an operation's value.
    Lane(OpId, u32),
    /// A definition.
    Def(DefId),
}

impl Node {
    pub(super) fn count(defs: &ReachingDefinitions) -> usize {
        (defs.lane_count() + defs.len()) as usize
    }

    /// The node of a component of an operation; `None` if the index is out of range.
    pub(super) fn lane(defs: &ReachingDefinitions, op: OpId, lane: u32) -> Option<Node> {
        (lane < defs.lanes_of(op)).then(|| Node(defs.first_lane(op) + lane))
    }

    /// The node of a definition.
    pub(super) fn def(defs: &ReachingDefinitions, id: DefId) -> Node {
        Node(defs.lane_count() + id.0)
    }

    /// What the node represents.
    pub(super) fn subject(self, defs: &ReachingDefinitions) -> NodeSubject {
        match self.0.checked_sub(defs.lane_count()) {
            Some(def) => NodeSubject::Def(DefId(def)),
            None => {
                let (op, lane) = defs.op_at(self.0);
                NodeSubject::Lane(op, lane)
            }
        }
    }
}
