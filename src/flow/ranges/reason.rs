//! Explains the bounds of a range: which operation determines a bound, for the notes of messages.

use super::Query;
use super::interval::Interval;
use super::node::{Node, NodeSubject};
use crate::reaching_definitions::{Def, DefId, Slot};
use shaderlint_ir::{Binary, OpId, OpKind, Root, Unary};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_semantic::{BuiltinId, VariableId};
use shaderlint_syntax::ast::List;

/// Maximum number of steps back.
const MAX_STEPS: u32 = 64;

/// A bound of a range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// The lower bound.
    Low,
    /// The upper bound.
    High,
}

impl Side {
    const fn other(self) -> Side {
        match self {
            Side::Low => Side::High,
            Side::High => Side::Low,
        }
    }

    fn of(self, range: &Interval) -> f64 {
        match self {
            Side::Low => range.lo.value,
            Side::High => range.hi.value,
        }
    }
}

/// What determines a bound.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Giver {
    /// A built-in function.
    Builtin(BuiltinId),
    /// A literal or constant.
    Constant,
    /// A comparison that is true or false.
    Condition(bool),
    /// The condition of a loop that counts.
    Loop,
    /// A variable set by the host or the language.
    Host(VariableId),
    /// Arithmetic.
    Operation,
}

/// The origin of a bound.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reason {
    /// The operation to show in the source.
    pub op: OpId,
    /// The kind of origin.
    pub giver: Giver,
    /// The range of the value at the origin.
    pub range: Interval,
}

/// A step back towards the origin.
enum Back {
    /// The bound is that of another value.
    To(Node, Side),
    /// The origin.
    Stop(OpId, Giver),
}

impl Query<'_> {
    /// The origin of a bound of a component of a value.
    pub fn reason(&self, op: OpId, lane: u32, side: Side) -> Option<Reason> {
        let (mut node, mut side) = (Node::lane(self.defs, op, lane)?, side);
        let mut named = op;
        for _ in 0..MAX_STEPS {
            let back = match node.subject(self.defs) {
                NodeSubject::Lane(op, lane) => {
                    named = op;
                    self.source(op, lane, side)
                }
                NodeSubject::Def(def) => self.source_of_def(def, side, named),
            };
            match back {
                Back::To(next, end) => (node, side) = (next, end),
                Back::Stop(op, giver) => {
                    let range = self.at(node);
                    return Some(Reason { op, giver, range });
                }
            }
        }
        None
    }

    fn at(&self, node: Node) -> Interval {
        match node.subject(self.defs) {
            NodeSubject::Lane(op, lane) => self.lane(op, lane),
            NodeSubject::Def(def) => self.def(def),
        }
    }

    /// The first of several values that has the bound.
    fn with_end(&self, nodes: impl Iterator<Item = Node>, side: Side, end: f64) -> Option<Back> {
        let mut nodes = nodes.take(MAX_STEPS as usize);
        let found = nodes.find(|node| side.of(&self.at(*node)) == end)?;
        Some(Back::To(found, side))
    }

    fn source(&self, op: OpId, lane: u32, side: Side) -> Back {
        let (module, defs) = (self.module, self.defs);
        let end = side.of(&self.lane(op, lane));
        let stop = Back::Stop(op, Giver::Operation);
        let of = |op, lane| Node::lane(defs, op, lane);
        let next = match module.op(op).kind {
            OpKind::Const(_) => return Back::Stop(op, Giver::Constant),
            OpKind::Load(_) => Some(Back::To(Node::def(defs, defs.seen(op, lane)), side)),
            OpKind::Unary(Unary::Negate, a) => of(a, lane).map(|a| Back::To(a, side.other())),
            OpKind::Convert(a) => of(a, lane).map(|a| Back::To(a, side)),
            OpKind::Binary(kind, a, b) => self.operand(kind, (a, b), lane, side),
            OpKind::Select {
                then, otherwise, ..
            } => {
                let sides = [of(then, lane), of(otherwise, lane)];
                self.with_end(sides.into_iter().flatten(), side, end)
            }
            OpKind::Builtin(function, list) => {
                return self.source_of_call(op, function, list, (lane, side));
            }
            OpKind::Call(function, _) => {
                let values = defs.returns_of(function).iter();
                self.with_end(values.filter_map(|v| of(*v, lane)), side, end)
            }
            _ => defs
                .part_of(module, op, lane)
                .and_then(|(op, lane)| of(op, lane))
                .map(|part| Back::To(part, side)),
        };
        next.unwrap_or(stop)
    }

    /// The operand that varies, if the other is constant.
    fn operand(&self, kind: Binary, (a, b): (OpId, OpId), lane: u32, side: Side) -> Option<Back> {
        let (x, y) = (self.lane(a, lane), self.lane(b, lane));
        if kind == Binary::Multiply {
            // A zero bound comes from a factor that is zero.
            let factors = [(x, a), (y, b)];
            let zero = factors
                .iter()
                .find(|(range, _)| side.of(range) == 0.0 && range.holds(0.0));
            if let Some((_, factor)) = zero {
                return Node::lane(self.defs, *factor, lane).map(|node| Back::To(node, side));
            }
        }
        let (single, varying, is_left) = match (x.single(), y.single()) {
            (Some(single), None) => (single, b, false),
            (None, Some(single)) => (single, a, true),
            _ => return None,
        };
        let is_flipped = match kind {
            Binary::Add => false,
            Binary::Subtract => !is_left,
            Binary::Multiply => single < 0.0,
            Binary::Divide if is_left => single < 0.0,
            _ => return None,
        };
        let node = Node::lane(self.defs, varying, lane)?;
        let range = self.at(node);
        let side = if is_flipped { side.other() } else { side };
        let is_known = side.of(&range).is_finite() || range.takes_both_signs();
        is_known.then_some(Back::To(node, side))
    }

    fn source_of_call(
        &self,
        op: OpId,
        function: BuiltinId,
        list: List,
        (lane, side): (u32, Side),
    ) -> Back {
        use Transfer as T;
        let module = self.module;
        let stop = Back::Stop(op, Giver::Builtin(function));
        let own = |op: OpId| module.operand_lane(op, lane);
        let args = module.operands(list);
        let mut nodes = args
            .iter()
            .filter_map(|a| Node::lane(self.defs, *a, own(*a)));
        let next = match function.transfer() {
            T::Rising(_) | T::Rounded(_) => nodes
                .next()
                .filter(|node| side.of(&self.at(*node)).is_finite())
                .map(|node| Back::To(node, side)),
            T::Minimum | T::Maximum | T::Between | T::Blend => {
                let end = side.of(&self.lane(op, lane));
                let varying = nodes.filter(|node| self.at(*node).single().is_none());
                self.with_end(varying, side, end)
            }
            _ => None,
        };
        next.unwrap_or(stop)
    }

    fn source_of_def(&self, def: DefId, side: Side, named: OpId) -> Back {
        let defs = self.defs;
        let of = |def: &DefId| Node::def(defs, *def);
        let end = side.of(&self.def(def));
        let next = match defs.get(def) {
            Def::Stored { value, lane } => {
                Node::lane(defs, value, lane).map(|node| Back::To(node, side))
            }
            Def::Refined { of: before, by } => {
                if side.of(&self.def(before)) != end {
                    return match self.is_counted(before) {
                        true => Back::Stop(by.comparison, Giver::Loop),
                        false => Back::Stop(by.comparison, Giver::Condition(by.truth)),
                    };
                }
                Some(Back::To(of(&before), side))
            }
            Def::Merge { sides, .. } => self.with_end(defs.list(sides).iter().map(of), side, end),
            Def::Head { init, back, .. } => self.with_end([init, back].iter().map(of), side, end),
            Def::Entry(slot) => return self.source_of_entry(slot, side, (end, named)),
            Def::Measured(_) | Def::Unknown => None,
        };
        next.unwrap_or(Back::Stop(named, Giver::Operation))
    }

    fn source_of_entry(&self, slot: Slot, side: Side, (end, named): (f64, OpId)) -> Back {
        let defs = self.defs;
        let (id, _) = defs.variable_at(slot);
        let root = self.module.variable(id).map(|v| v.root);
        let next = match root {
            Some(Root::Uniform | Root::Input) => return Back::Stop(named, Giver::Host(id)),
            Some(Root::Global | Root::Output) => {
                let writes = defs.global_writes(slot).iter();
                self.with_end(writes.map(|def| Node::def(defs, *def)), side, end)
            }
            _ => defs.passed(self.module, slot).and_then(|passed| {
                let nodes = passed.args();
                let nodes = nodes.filter_map(|arg| Node::lane(defs, arg, passed.lane));
                self.with_end(nodes, side, end)
            }),
        };
        next.unwrap_or(Back::Stop(named, Giver::Operation))
    }
}
