//! The step of a ray loop: what is added to a ray parameter, a point or a cell in each iteration.

use super::dependence::{LoopSlice, SliceNode, ValueLane};
use super::form::{RayKind, RayStep};
use crate::reaching_definitions::{Def, DefId};
use rustc_hash::FxHashSet;
use shaderlint_ir::{Binary, OpId, OpKind};
use shaderlint_semantic::builtins::Transfer;
use shaderlint_semantic::{Scalar, Type, VariableId};

/// The moved value of a ray loop.
#[derive(Debug)]
pub(super) struct Stepped {
    pub kind: RayKind,
    /// The head definitions of the ray parameter, point or cell.
    pub heads: Vec<DefId>,
    /// The values of the heads before the loop.
    pub init: Vec<DefId>,
    /// The distances that the step is computed from, or the steps of a grid.
    pub distance: Vec<ValueLane>,
    /// The sums of a head and what is added to it.
    pub moved: Vec<ValueLane>,
    /// The same sums, with what is added.
    pub steps: Vec<RayStep>,
    /// The variable of the heads, with their components.
    pub variable: (VariableId, Vec<u32>),
    /// Where rays start.
    pub origin: RayOrigin,
}

/// The position that rays start at.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum RayOrigin {
    /// The initial value of the heads.
    Init,
    /// An operand of a sum in the loop.
    Value(OpId),
    /// The coordinate origin.
    Zero,
    /// Computed elsewhere.
    Unknown,
}

/// A variable that a loop carries from one iteration to the next.
struct CarriedVariable {
    variable: VariableId,
    ty: Type,
    /// Its heads, by component.
    heads: Vec<(DefId, u32)>,
}

impl CarriedVariable {
    fn slots(&self) -> (VariableId, Vec<u32>) {
        let lanes = self.heads.iter().map(|(_, lane)| *lane);
        (self.variable, lanes.collect())
    }
}

/// The step of a loop; `None` if it is not a ray loop.
pub(super) fn find(slice: &LoopSlice) -> Option<Stepped> {
    let all = carried(slice);
    all.iter()
        .find_map(|c| parameter(slice, c).or_else(|| point(slice, c)))
        .or_else(|| all.iter().find_map(|c| cell(slice, c)))
        .or_else(|| all.iter().find_map(|c| fixed(slice, c)))
}

fn carried(slice: &LoopSlice) -> Vec<CarriedVariable> {
    let (module, defs) = (slice.query.module, slice.query.defs);
    let mut all: Vec<CarriedVariable> = Vec::new();
    for head in defs.heads(slice.id) {
        let Def::Head { slot, .. } = defs.get(head) else {
            continue;
        };
        let (variable, lane) = defs.variable_at(slot);
        let Some(ty) = module.variable(variable).map(|v| v.ty) else {
            continue;
        };
        // The length of a vector has a slot of its own.
        if lane >= ty.components() {
            continue;
        }
        match all.iter_mut().find(|c| c.variable == variable) {
            Some(known) => known.heads.push((head, lane)),
            None => all.push(CarriedVariable {
                variable,
                ty,
                heads: vec![(head, lane)],
            }),
        }
    }
    all
}

/// The only float of a variable in a loop, its initial value and what is added to it.
fn single(slice: &LoopSlice, carried: &CarriedVariable) -> Option<(DefId, DefId, StepTerms)> {
    let &[(head, _)] = carried.heads.as_slice() else {
        return None;
    };
    let is_float = carried.ty.scalar_kind() == Some(Scalar::Float);
    let (init, added) = added(slice, head).filter(|_| is_float)?;
    Some((head, init, added))
}

/// `t += k * d`, with `d` evaluated at a point that depends on `t`.
fn parameter(slice: &LoopSlice, carried: &CarriedVariable) -> Option<Stepped> {
    let (head, init, added) = single(slice, carried)?;
    let heads = vec![head];
    let distance: Vec<ValueLane> = added
        .terms
        .into_iter()
        .filter(|lane| slice.depends(*lane, &heads, true))
        .collect();
    let origin = origin(slice, &heads, &distance);
    (!distance.is_empty()).then_some(Stepped {
        kind: RayKind::Distance,
        heads,
        init: vec![init],
        distance,
        moved: added.sums,
        steps: added.steps,
        variable: carried.slots(),
        origin,
    })
}

/// `p += direction * d`, with `d` evaluated at `p` and a loop-invariant direction.
fn point(slice: &LoopSlice, carried: &CarriedVariable) -> Option<Stepped> {
    let is_point = carried.ty.is_vector()
        && carried.ty.components() >= 3
        && carried.ty.scalar_kind() == Some(Scalar::Float);
    if !is_point || carried.heads.len() < 3 {
        return None;
    }
    let heads: Vec<DefId> = carried.heads.iter().map(|(head, _)| *head).collect();
    let (mut inits, mut distance) = (Vec::new(), Vec::new());
    let (mut moved, mut steps) = (Vec::new(), Vec::new());
    for &(head, _) in &carried.heads {
        let (init, added) = added(slice, head)?;
        inits.push(init);
        moved.extend(added.sums);
        steps.extend(added.steps);
        for term in added.terms {
            distance.push(along(slice, term, &heads, 8)?);
        }
    }
    (!distance.is_empty()).then_some(Stepped {
        kind: RayKind::Distance,
        heads,
        init: inits,
        distance,
        moved,
        steps,
        variable: carried.slots(),
        origin: RayOrigin::Init,
    })
}

/// The distance in `direction * d` for a loop-invariant direction.
fn along(
    slice: &LoopSlice,
    (op, lane): ValueLane,
    heads: &[DefId],
    depth: u32,
) -> Option<ValueLane> {
    let rest = depth.checked_sub(1)?;
    slice.spend()?;
    let (module, defs) = (slice.query.module, slice.query.defs);
    match module.op(op).kind {
        OpKind::Load(_) => match defs.get(defs.unrefined(defs.seen(op, lane))) {
            Def::Stored { value, lane } => along(slice, (value, lane), heads, rest),
            _ => None,
        },
        OpKind::Binary(Binary::Multiply | Binary::Divide, a, b) => {
            let number = |op| match module.op(op).kind {
                OpKind::Splat(number) => Some((number, 0)),
                _ => None,
            };
            let moving = |lane: ValueLane| slice.depends(lane, heads, true).then_some(lane);
            match (slice.is_invariant(a), slice.is_invariant(b)) {
                (true, false) => number(b)
                    .and_then(moving)
                    .or_else(|| along(slice, (b, lane), heads, rest)),
                (false, true) => number(a)
                    .and_then(moving)
                    .or_else(|| along(slice, (a, lane), heads, rest)),
                // `direction * d * k`, where `k` depends on the iteration.
                (false, false) => {
                    number(b)?;
                    along(slice, (a, lane), heads, rest)
                }
                (true, true) => None,
            }
        }
        _ => {
            let part = defs.part_of(module, op, lane)?;
            along(slice, part, heads, rest)
        }
    }
}

/// A cell whose components are integers that change by at most one.
fn cell(slice: &LoopSlice, carried: &CarriedVariable) -> Option<Stepped> {
    let is_cell = carried.ty.is_vector() && carried.ty.components() == 3;
    if !is_cell || carried.heads.len() != 3 {
        return None;
    }
    let is_integer = carried.ty.scalar_kind() == Some(Scalar::Int);
    let heads: Vec<DefId> = carried.heads.iter().map(|(head, _)| *head).collect();
    let (mut inits, mut steps) = (Vec::new(), Vec::new());
    for &(head, _) in &carried.heads {
        let (init, added) = added(slice, head)?;
        let is_small = |&(op, lane): &ValueLane| {
            let range = slice.query.lane(op, lane);
            range.lo.value >= -1.0 && range.hi.value <= 1.0 && !slice.is_invariant(op)
        };
        if !added.terms.iter().all(is_small) || !(is_integer || is_rounded(slice, init)) {
            return None;
        }
        inits.push(init);
        steps.extend(added.terms);
    }
    Some(Stepped {
        kind: RayKind::Grid,
        heads,
        init: inits,
        distance: steps,
        moved: Vec::new(),
        steps: Vec::new(),
        variable: carried.slots(),
        origin: RayOrigin::Init,
    })
}

/// `t += step`, with a function evaluated at `origin + direction * t`.
fn fixed(slice: &LoopSlice, carried: &CarriedVariable) -> Option<Stepped> {
    let (head, init, added) = single(slice, carried)?;
    let (module, heads) = (slice.query.module, vec![head]);
    let call = slice
        .looped
        .ops
        .ops()
        .find(|op| match module.op(*op).kind {
            OpKind::Call(_, list) => {
                let mut points = module.operands(list).iter().filter(|a| slice.is_point(**a));
                points.any(|a| slice.depends((*a, 0), &heads, false))
            }
            _ => false,
        })?;
    let distance = vec![(call, 0)];
    let is_ray = matches!(origin(slice, &heads, &distance), RayOrigin::Value(_));
    is_ray.then_some(Stepped {
        kind: RayKind::Fixed,
        heads,
        init: vec![init],
        distance,
        moved: added.sums,
        steps: added.steps,
        variable: carried.slots(),
        origin: RayOrigin::Unknown,
    })
}

/// Whether a definition is the result of `floor` or the like.
fn is_rounded(slice: &LoopSlice, def: DefId) -> bool {
    let (module, defs) = (slice.query.module, slice.query.defs);
    let def = defs.copied_from(module, def);
    let Def::Stored {
        mut value,
        mut lane,
    } = defs.get(def)
    else {
        return false;
    };
    while let Some(part) = defs.part_of(module, value, lane) {
        (value, lane) = part;
    }
    match module.op(value).kind {
        OpKind::Builtin(function, _) => matches!(function.transfer(), Transfer::Rounded(_)),
        _ => false,
    }
}

/// What an iteration adds to a head.
#[derive(Default)]
struct StepTerms {
    /// The terms.
    terms: Vec<ValueLane>,
    /// The sums with the head.
    sums: Vec<ValueLane>,
    /// The same sums, with their terms.
    steps: Vec<RayStep>,
}

impl StepTerms {
    fn push(&mut self, (sum, lane): ValueLane, term: OpId) {
        self.terms.push((term, lane));
        self.sums.push((sum, lane));
        self.steps.push(RayStep { sum, term });
    }
}

/// The value of a head before the loop, and what an iteration adds to it; `None` if it changes in
/// another way, or not at all.
fn added(slice: &LoopSlice, head: DefId) -> Option<(DefId, StepTerms)> {
    let defs = slice.query.defs;
    let Def::Head { init, back, .. } = defs.get(head) else {
        return None;
    };
    let mut added = StepTerms::default();
    let is_sum = sum_def(slice, back, head, &mut added, 24);
    (is_sum && !added.terms.is_empty()).then_some((defs.unrefined(init), added))
}

fn sum_def(slice: &LoopSlice, def: DefId, head: DefId, added: &mut StepTerms, depth: u32) -> bool {
    let defs = slice.query.defs;
    let (def, Some(rest)) = (defs.unrefined(def), depth.checked_sub(1)) else {
        return false;
    };
    if def == head {
        return true;
    }
    match defs.get(def) {
        Def::Stored { value, lane } => sum(slice, (value, lane), head, added, rest),
        Def::Merge { sides, .. } => {
            let mut sides = defs.list(sides).iter();
            sides.all(|side| sum_def(slice, *side, head, added, rest))
        }
        _ => false,
    }
}

/// Whether a component is a head plus some terms.
fn sum(
    slice: &LoopSlice,
    (op, lane): ValueLane,
    head: DefId,
    added: &mut StepTerms,
    depth: u32,
) -> bool {
    let (Some(rest), Some(())) = (depth.checked_sub(1), slice.spend()) else {
        return false;
    };
    let (module, defs) = (slice.query.module, slice.query.defs);
    let known = added.terms.len();
    match module.op(op).kind {
        OpKind::Load(_) => sum_def(slice, defs.seen(op, lane), head, added, rest),
        OpKind::Binary(Binary::Add, a, b) => {
            if sum(slice, (a, lane), head, added, rest) {
                added.push((op, lane), b);
                return true;
            }
            added.terms.truncate(known);
            added.steps.truncate(known);
            let is_sum = sum(slice, (b, lane), head, added, rest);
            added.push((op, lane), a);
            is_sum
        }
        OpKind::Binary(Binary::Subtract, a, b) => {
            let is_sum = sum(slice, (a, lane), head, added, rest);
            added.push((op, lane), b);
            is_sum
        }
        OpKind::Select {
            then, otherwise, ..
        } => {
            sum(slice, (then, lane), head, added, rest)
                && sum(slice, (otherwise, lane), head, added, rest)
        }
        // `t = min(t + d, far)`
        OpKind::Builtin(function, list)
            if matches!(function.transfer(), Transfer::Minimum | Transfer::Between) =>
        {
            let first = module.operands(list).first();
            first.is_some_and(|a| sum(slice, (*a, lane), head, added, rest))
        }
        _ => match defs.part_of(module, op, lane) {
            Some(part) => sum(slice, part, head, added, rest),
            None => false,
        },
    }
}

/// Where rays start that are given by a parameter: the invariant part of the first point that depends
/// on it.
fn origin(slice: &LoopSlice, heads: &[DefId], distance: &[ValueLane]) -> RayOrigin {
    let module = slice.query.module;
    let mut has_direction = false;
    for op in points(slice, heads, distance) {
        match module.op(op).kind {
            OpKind::Binary(Binary::Add | Binary::Subtract, a, b) => {
                match (slice.is_invariant(a), slice.is_invariant(b)) {
                    (true, false) => return RayOrigin::Value(a),
                    (false, true) => return RayOrigin::Value(b),
                    _ => {}
                }
            }
            OpKind::Binary(Binary::Multiply, a, b) => {
                has_direction |= slice.is_invariant(a) != slice.is_invariant(b);
            }
            _ => {}
        }
    }
    match has_direction {
        true => RayOrigin::Zero,
        false => RayOrigin::Unknown,
    }
}

/// The point `origin + direction * t` of a ray that is given by a parameter.
pub(super) fn point_on_ray(slice: &LoopSlice, stepped: &Stepped) -> Option<OpId> {
    let module = slice.query.module;
    let mut all = points(slice, &stepped.heads, &stepped.distance).into_iter();
    all.find(|op| match module.op(*op).kind {
        OpKind::Binary(Binary::Add | Binary::Subtract, a, b) => {
            slice.is_invariant(a) != slice.is_invariant(b)
        }
        _ => false,
    })
}

/// The points in a loop that a distance depends on, in order of evaluation.
fn points(slice: &LoopSlice, heads: &[DefId], distance: &[ValueLane]) -> Vec<OpId> {
    let mut points: Vec<OpId> = Vec::new();
    for &lane in distance {
        slice.walk(lane, |node, _| match node {
            SliceNode::Lane(op, _) => {
                if slice.is_point(op) && slice.looped.ops.contains(op) {
                    points.push(op);
                }
                true
            }
            SliceNode::Def(def) => !heads.contains(&def) && slice.is_inside(def),
        });
    }
    points.sort_unstable();
    points.dedup();
    points
}

/// Whether a loop sums up something else along the ray, other than the distance itself.
pub(super) fn accumulates(slice: &LoopSlice, stepped: &Stepped) -> bool {
    let cores = |lane| slice.cores(lane, &stepped.heads, &stepped.moved);
    let distance: FxHashSet<ValueLane> = stepped.distance.iter().flat_map(|d| cores(*d)).collect();
    let others = carried(slice).into_iter().flat_map(|c| c.heads);
    let mut others = others.filter(|(head, _)| !stepped.heads.contains(head));
    others.any(|(head, _)| {
        added(slice, head).is_some_and(|(_, added)| {
            let mut terms = added.terms.into_iter();
            terms.any(|term| {
                slice.depends(term, &stepped.heads, true)
                    && !cores(term).iter().any(|core| distance.contains(core))
            })
        })
    })
}
