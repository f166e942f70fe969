//! The conditions known on the current path (facts), and what follows from them (correlated
//! branches).

use super::state::PartMask;
use rustc_hash::{FxHashMap, FxHasher};
use shaderlint_ir::{Access, Binary, Module, OpId, OpKind, Root, Unary};
use shaderlint_semantic::VariableId;
use std::hash::{Hash, Hasher};

/// Maximum depth to which conditions are hashed.
const MAX_DEPTH: u32 = 8;

/// A condition, identified by a hash of its operations, and its value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Fact {
    key: u64,
    truth: bool,
}

impl Fact {
    /// The opposite fact.
    pub fn negated(self) -> Fact {
        Fact {
            truth: !self.truth,
            ..self
        }
    }
}

/// Components of a variable that are assigned wherever a fact holds.
#[derive(Clone, Copy)]
struct Consequence {
    fact: Fact,
    variable: VariableId,
    mask: PartMask,
}

/// A condition, and whether it is true.
pub(super) type KnownCondition = (OpId, bool);

/// The conditions known on the path to the current point.
#[derive(Default)]
pub(super) struct Conditions {
    facts: Vec<Fact>,
    /// The conditions of the facts, undecomposed.
    pub(super) held: Vec<KnownCondition>,
    consequences: Vec<Consequence>,
    /// By load: the version of its variable, counted in writes.
    versions: FxHashMap<OpId, u32>,
    /// By variable: the number of writes so far.
    writes: FxHashMap<VariableId, u32>,
    /// The number of calls so far; each may write to globals.
    calls: u32,
}

/// A point to which [`Conditions`] can be rolled back.
#[derive(Clone, Copy)]
pub(super) struct ConditionsMark {
    facts: usize,
    held: usize,
    consequences: usize,
}

impl Conditions {
    /// Resets everything for another function.
    pub fn clear(&mut self) {
        *self = Conditions::default();
    }

    /// The current point, for [`Conditions::undo`].
    pub fn mark(&self) -> ConditionsMark {
        ConditionsMark {
            facts: self.facts.len(),
            held: self.held.len(),
            consequences: self.consequences.len(),
        }
    }

    /// Rolls back to a point.
    pub fn undo(&mut self, mark: ConditionsMark) {
        self.facts.truncate(mark.facts);
        self.held.truncate(mark.held);
        self.consequences.truncate(mark.consequences);
    }

    /// Invalidates facts about a variable that is written to.
    pub fn written(&mut self, variable: VariableId) {
        *self.writes.entry(variable).or_insert(0) += 1;
    }

    /// Records that a variable became unassigned.
    pub fn reset(&mut self, variable: VariableId) {
        self.written(variable);
        for consequence in &mut self.consequences {
            if consequence.variable == variable {
                consequence.mask = 0;
            }
        }
    }

    /// Invalidates facts about globals, as a function is called.
    pub fn called(&mut self) {
        self.calls += 1;
    }

    /// Records the version of the variable that a load reads.
    pub fn loaded(&mut self, module: &Module, load: OpId, variable: VariableId) {
        let mut version = self.writes.get(&variable).copied().unwrap_or(0);
        let root = module.variable(variable).map(|v| v.root);
        if matches!(root, Some(Root::Global | Root::Output)) {
            version = version.wrapping_add(self.calls << 16);
        }
        self.versions.insert(load, version);
    }

    /// All facts that follow from a condition with a known value: the condition and its operands.
    fn facts_of(&self, module: &Module, condition: OpId, truth: bool) -> Vec<Fact> {
        let mut found = Vec::new();
        let mut todo = vec![(condition, truth, 0)];
        while let Some((op, truth, depth)) = todo.pop() {
            found.extend(self.fact(module, op, truth));
            if depth >= MAX_DEPTH {
                continue;
            }
            match module.op(op).kind {
                OpKind::Unary(Unary::Not, a) => todo.push((a, !truth, depth + 1)),
                OpKind::Binary(Binary::And, a, b) if truth => {
                    todo.extend([(a, true, depth + 1), (b, true, depth + 1)]);
                }
                OpKind::Binary(Binary::Or, a, b) if !truth => {
                    todo.extend([(a, false, depth + 1), (b, false, depth + 1)]);
                }
                _ => {}
            }
        }
        found
    }

    /// The fact that a condition has this value; `None` if it cannot be hashed.
    pub fn fact(&self, module: &Module, condition: OpId, truth: bool) -> Option<Fact> {
        let (op, truth) = straight(module, condition, truth);
        let key = self.number(module, op)?;
        Some(Fact { key, truth })
    }

    /// The hash of a value's operations; `None` if they are too deep or not pure.
    pub fn number(&self, module: &Module, op: OpId) -> Option<u64> {
        let mut hasher = FxHasher::default();
        self.hash(module, op, 0, &mut hasher)?;
        Some(hasher.finish())
    }

    fn hash(&self, module: &Module, op: OpId, depth: u32, to: &mut FxHasher) -> Option<()> {
        if depth > MAX_DEPTH {
            return None;
        }
        let found = module.op(op);
        match found.kind {
            OpKind::Const(_) => module.constant(op).iter().for_each(|v| v.bits().hash(to)),
            OpKind::Load(place) => {
                let place = module.place(place);
                place.variable.hash(to);
                self.versions.get(&op)?.hash(to);
                for access in module.path(place) {
                    std::mem::discriminant(access).hash(to);
                    if !matches!(access, Access::Computed(_)) {
                        access.hash(to);
                    }
                }
            }
            OpKind::Unary(unary, _) => unary.hash(to),
            // All orderings are normalised to `<`.
            OpKind::Binary(Binary::Greater | Binary::LessEqual | Binary::GreaterEqual, ..) => {
                Binary::Less.hash(to);
            }
            OpKind::Binary(binary, ..) => binary.hash(to),
            OpKind::Same { .. } => 1u8.hash(to),
            OpKind::Swizzle(_, lanes) => lanes.hash(to),
            OpKind::Extract(_, number) => number.hash(to),
            OpKind::Convert(_) => found.ty.hash(to),
            OpKind::Builtin(function, _) => function.hash(to),
            _ => return None,
        }
        std::mem::discriminant(&found.kind).hash(to);
        let mut all = Some(());
        let mut operand = |o: OpId| {
            let (o, truth) = straight(module, o, true);
            truth.hash(to);
            all = all.and_then(|()| self.hash(module, o, depth + 1, to));
        };
        match found.kind {
            OpKind::Binary(Binary::Greater | Binary::LessEqual, a, b) => {
                operand(b);
                operand(a);
            }
            _ => module.each_operand(op, operand),
        }
        all
    }

    /// Records that a condition has this value from here on.
    pub fn learn(&mut self, module: &Module, condition: OpId, truth: bool) {
        let facts = self.facts_of(module, condition, truth);
        self.facts.extend(facts);
        self.held.push((condition, truth));
    }

    /// Records that components of a variable are assigned where a fact holds. Returns those that
    /// are also assigned where it does not hold.
    pub fn follows(&mut self, fact: Fact, variable: VariableId, mask: PartMask) -> PartMask {
        let other = fact.negated();
        let others = self.consequences.iter();
        let others = others.filter(|c| c.variable == variable && c.fact == other);
        let both = others.fold(0, |all, c| all | c.mask) & mask;
        self.consequences.push(Consequence {
            fact,
            variable,
            mask,
        });
        both
    }

    /// The components of a variable that are assigned because of the current facts.
    pub fn known(&self, variable: VariableId) -> PartMask {
        let own = self.consequences.iter();
        let own = own.filter(|c| c.variable == variable && self.facts.contains(&c.fact));
        own.fold(0, |all, c| all | c.mask)
    }
}

/// Strips negations from a condition: `!a`, and the negated forms of comparisons.
fn straight(module: &Module, mut op: OpId, mut truth: bool) -> (OpId, bool) {
    loop {
        match module.op(op).kind {
            OpKind::Unary(Unary::Not, a) => {
                op = a;
                truth = !truth;
            }
            OpKind::Binary(Binary::GreaterEqual | Binary::LessEqual, ..)
            | OpKind::Same { negated: true, .. } => return (op, !truth),
            _ => return (op, truth),
        }
    }
}
