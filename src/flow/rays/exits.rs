//! The exits of a ray loop: at a hit, and beyond the scene.

use super::dependence::{LoopSlice, SliceNode, ValueLane};
use super::form::{HitTest, RayKind};
use super::step::Stepped;
use crate::reaching_definitions::Def;
use rustc_hash::FxHashSet;
use shaderlint_ir::{Binary, Loop, OpId, OpKind, Provenance, Region, Step, Unary};

/// Most exits, and conditions per exit, that are analysed.
const MAX_EXITS: usize = 24;

/// A condition on the path to an exit, and its value there.
#[derive(Clone, Copy)]
struct ExitCondition {
    condition: OpId,
    truth: bool,
    /// The `if`; `None` for the condition of the loop.
    branch: Option<Provenance>,
}

/// The test that ends a loop at a hit, and whether another one ends it beyond the scene.
pub(super) fn exits(
    slice: &LoopSlice,
    stepped: &Stepped,
    looped: &Loop,
) -> (Option<HitTest>, bool) {
    let mut exits: Vec<Vec<ExitCondition>> = Vec::new();
    if let Some(condition) = looped.condition {
        exits.push(vec![ExitCondition {
            condition,
            truth: false,
            branch: None,
        }]);
    }
    for part in looped.parts() {
        collect(slice, part, true, &mut Vec::new(), &mut exits);
    }
    let cores: FxHashSet<ValueLane> = stepped
        .distance
        .iter()
        .flat_map(|lane| slice.cores(*lane, &stepped.heads, &stepped.moved))
        .collect();
    let tests = ExitTests {
        slice,
        stepped,
        cores,
    };
    let mut hits: Vec<HitTest> = Vec::new();
    let mut ends_far = false;
    for exit in exits {
        let mut own = None;
        for passed in exit.iter().rev() {
            let mut leaves = Vec::new();
            tests.leaves(passed.condition, passed.truth, 8, &mut leaves);
            let is_only = leaves.len() == 1;
            for (leaf, truth) in leaves {
                match tests.hit(leaf, truth) {
                    true => {
                        own = own.or(Some(HitTest {
                            condition: leaf,
                            truth,
                            branch: passed
                                .branch
                                .filter(|_| is_only && leaf == passed.condition),
                            is_late: tests.is_late(leaf),
                        }));
                    }
                    false => ends_far |= tests.is_far(leaf, truth),
                }
            }
        }
        hits.extend(own);
    }
    hits.dedup();
    let hit = match hits.as_slice() {
        [hit] => Some(*hit),
        _ => None,
    };
    (hit, ends_far)
}

/// Collects the conditions on the way to each exit in a region.
fn collect(
    slice: &LoopSlice,
    region: Region,
    is_innermost: bool,
    path: &mut Vec<ExitCondition>,
    exits: &mut Vec<Vec<ExitCondition>>,
) {
    let module = slice.query.module;
    let depth = path.len();
    for step in module.steps(region) {
        if exits.len() >= MAX_EXITS || path.len() >= MAX_EXITS || slice.spend().is_none() {
            break;
        }
        match *step {
            Step::If {
                condition,
                then,
                otherwise,
                origin,
            } => {
                let passed = |truth| ExitCondition {
                    condition,
                    truth,
                    branch: Some(origin),
                };
                for (side, truth) in [(then, true), (otherwise, false)] {
                    path.push(passed(truth));
                    collect(slice, side, is_innermost, path, exits);
                    path.pop();
                }
                // Only the other side goes on.
                let leaves = |side| module.steps(side).last().is_some_and(Step::is_jump);
                match (leaves(then), leaves(otherwise)) {
                    (true, false) => path.push(passed(false)),
                    (false, true) => path.push(passed(true)),
                    _ => {}
                }
            }
            Step::Loop(id) => {
                if let Some(inner) = module.looped(id) {
                    for part in inner.parts() {
                        collect(slice, part, false, path, exits);
                    }
                }
            }
            Step::Break(_) if is_innermost => exits.push(path.clone()),
            Step::Return(..) | Step::Discard(_) => exits.push(path.clone()),
            _ => {}
        }
    }
    path.truncate(depth);
}

struct ExitTests<'a, 'x> {
    slice: &'a LoopSlice<'x>,
    stepped: &'a Stepped,
    cores: FxHashSet<ValueLane>,
}

impl ExitTests<'_, '_> {
    /// The atomic conditions that a condition consists of.
    fn leaves(&self, op: OpId, truth: bool, depth: u32, found: &mut Vec<(OpId, bool)>) {
        let (module, defs) = (self.slice.query.module, self.slice.query.defs);
        let (Some(rest), Some(())) = (depth.checked_sub(1), self.slice.spend()) else {
            return;
        };
        match module.op(op).kind {
            OpKind::Const(_) => {}
            OpKind::Unary(Unary::Not, a) => self.leaves(a, !truth, rest, found),
            OpKind::Binary(Binary::And | Binary::Or, a, b) => {
                self.leaves(a, truth, rest, found);
                self.leaves(b, truth, rest, found);
            }
            OpKind::Load(_) => {
                let def = defs.unrefined(defs.seen(op, 0));
                match defs.get(def) {
                    Def::Stored { value, .. } => self.leaves(value, truth, rest, found),
                    Def::Merge {
                        sides, condition, ..
                    } => {
                        for (side, held) in defs.list(sides).iter().zip([true, false]) {
                            let Def::Stored { value, .. } = defs.get(defs.unrefined(*side)) else {
                                continue;
                            };
                            match (module.constant(value), condition) {
                                // A flag that is set under a condition.
                                ([constant], Some(condition)) if constant.as_bool() == truth => {
                                    self.leaves(condition, held, rest, found);
                                }
                                _ => self.leaves(value, truth, rest, found),
                            }
                        }
                    }
                    _ => found.push((op, truth)),
                }
            }
            _ => {
                if !found.contains(&(op, truth)) {
                    found.push((op, truth));
                }
            }
        }
    }

    /// The smaller and the larger side of a comparison that has this value.
    fn sides(&self, op: OpId, truth: bool) -> Option<[OpId; 2]> {
        let OpKind::Binary(kind, a, b) = self.slice.query.module.op(op).kind else {
            return None;
        };
        let is_less = match kind {
            Binary::Less | Binary::LessEqual => truth,
            Binary::Greater | Binary::GreaterEqual => !truth,
            _ => return None,
        };
        Some(if is_less { [a, b] } else { [b, a] })
    }

    fn hit(&self, op: OpId, truth: bool) -> bool {
        let (slice, heads) = (self.slice, &self.stepped.heads);
        if self.stepped.kind == RayKind::Grid {
            let lanes = [(op, 0)];
            return slice.called(&lanes, heads).is_some();
        }
        let Some([small, large]) = self.sides(op, truth) else {
            return false;
        };
        let is_shared =
            |lane: &ValueLane| self.cores.contains(lane) && slice.depends(*lane, heads, true);
        let cores = |op| slice.cores((op, 0), heads, &self.stepped.moved);
        cores(small).iter().any(is_shared) && !cores(large).iter().any(is_shared)
    }

    /// Whether a condition depends on a value that the previous iteration has left, other than the
    /// position.
    fn is_late(&self, op: OpId) -> bool {
        let slice = self.slice;
        let (defs, heads) = (slice.query.defs, &self.stepped.heads);
        let mut is_late = false;
        slice.walk((op, 0), |node, _| {
            let SliceNode::Def(def) = node else {
                return true;
            };
            let is_head = matches!(defs.get(def), Def::Head { of, .. } if of == slice.id);
            is_late |= is_head && !heads.contains(&def);
            !is_head && slice.is_inside(def)
        });
        is_late
    }

    /// Whether a condition ends rays that are far from the start, or from everything.
    fn is_far(&self, op: OpId, truth: bool) -> bool {
        match self.sides(op, truth) {
            Some([small, large]) => {
                let heads = &self.stepped.heads;
                [small, large]
                    .iter()
                    .any(|side| self.slice.depends((*side, 0), heads, false))
            }
            None => self.slice.depends((op, 0), &self.stepped.heads, false),
        }
    }
}
