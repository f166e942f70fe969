//! The motion of a ray loop: what its steps are, and which point they lead to.

use super::dependence::{LoopSlice, SliceNode, ValueLane};
use super::form::{HitTest, RayKind, RayMotion, RayStep};
use super::step::{Stepped, point_on_ray};
use crate::reaching_definitions::{Def, DefId};
use shaderlint_ir::{OpId, OpKind};

/// The motion of a loop; empty for loops that do not move by a distance.
pub(super) fn motion(slice: &LoopSlice, stepped: &Stepped, hit: Option<&HitTest>) -> RayMotion {
    if stepped.kind != RayKind::Distance {
        return RayMotion::default();
    }
    let mut steps: Vec<RayStep> = stepped.steps.clone();
    steps.sort_unstable_by_key(|step| (step.sum, step.term));
    steps.dedup();
    let (variable, lanes) = stepped.variable.clone();
    let is_parameter = lanes.len() == 1;
    RayMotion {
        moved: Some((variable, lanes)),
        steps,
        point: is_parameter.then(|| point_on_ray(slice, stepped)).flatten(),
        field: field(slice, stepped),
        is_counted: hit.is_none_or(|hit| is_counted(slice, stepped, hit.condition)),
    }
}

/// The distance that the scene returns: the result of a call in the distance, or the distance itself.
fn field(slice: &LoopSlice, stepped: &Stepped) -> Option<ValueLane> {
    let module = slice.query.module;
    let first = *stepped.distance.first()?;
    let cores = slice.cores(first, &stepped.heads, &stepped.moved);
    let is_call = |op: OpId| matches!(module.op(op).kind, OpKind::Call(..));
    let mut calls: Vec<ValueLane> = cores.into_iter().filter(|(op, _)| is_call(*op)).collect();
    calls.sort_unstable();
    match calls.as_slice() {
        [call] => Some(*call),
        [] => Some(first),
        _ => None,
    }
}

/// Whether a definition is the length of a vector, which has a slot of its own.
fn is_length(slice: &LoopSlice, def: DefId) -> bool {
    let Def::Head { slot, .. } = slice.query.defs.get(def) else {
        return false;
    };
    let (variable, lane) = slice.query.defs.variable_at(slot);
    let variable = slice.query.module.variable(variable);
    variable.is_some_and(|v| v.ty.is_vector() && lane >= v.ty.components())
}

/// Whether a condition depends on a value that each iteration computes from that of the previous one,
/// other than the position: a counter, a sum, the smallest distance so far.
fn is_counted(slice: &LoopSlice, stepped: &Stepped, condition: OpId) -> bool {
    let defs = slice.query.defs;
    let mut heads = Vec::new();
    let is_complete = slice.walk((condition, 0), |node, _| {
        let SliceNode::Def(def) = node else {
            return true;
        };
        let is_head = matches!(defs.get(def), Def::Head { of, .. } if of == slice.id);
        if is_head && !stepped.heads.contains(&def) && !is_length(slice, def) {
            heads.push(def);
        }
        !is_head && slice.is_inside(def)
    });
    let own = |head| {
        let Def::Head { back, .. } = defs.get(head) else {
            return true;
        };
        slice.def_depends(back, head, &stepped.moved)
    };
    !is_complete || heads.into_iter().any(own)
}
