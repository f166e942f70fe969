//! Distance fields: the functions that ray loops move by.

use super::ranges::Query;
use super::rays::{RayKind, RayLoop};
use shaderlint_ir::Layout;
use shaderlint_semantic::{FunctionRef, Type, VariableId};

/// A function as a field over a point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct DistanceField {
    /// The function.
    pub function: FunctionRef,
    /// The parameter that is the point.
    pub point: VariableId,
    /// The scalar of the result that is the distance.
    pub scalar: u32,
}

impl DistanceField {
    /// The field that a ray loop moves by; `None` if it is not a function of a point.
    pub fn of(query: Query, ray: &RayLoop) -> Option<DistanceField> {
        let module = query.module;
        let scene = ray.scene.filter(|_| ray.kind == RayKind::Distance)?;
        let function = module.function(scene.function)?;
        let point = *module.parameters(function).get(scene.point? as usize)?;
        let layout = Layout::of(query.program);
        Some(DistanceField {
            function: scene.function,
            point,
            scalar: scalar_at(&layout, function.returns, scene.lane)?,
        })
    }
}

/// The fields that the distance loops of a shader move by, each once.
pub fn fields<'r>(query: Query, rays: impl Iterator<Item = &'r RayLoop>) -> Vec<DistanceField> {
    let mut found: Vec<DistanceField> = Vec::new();
    for field in rays.filter_map(|ray| DistanceField::of(query, ray)) {
        if !found.contains(&field) {
            found.push(field);
        }
    }
    found
}

/// The scalar that is in a lane; `None` for the length of a vector.
fn scalar_at(layout: &Layout, ty: Type, lane: u32) -> Option<u32> {
    if ty.is_scalar() {
        return (lane == 0).then_some(0);
    }
    let mut parts = (0..layout.count(ty)).filter_map(|index| layout.part(ty, index));
    let part = parts.rfind(|part| part.lane <= lane)?;
    let inner = lane - part.lane;
    let is_inside = inner < layout.lanes(part.ty);
    let scalar = scalar_at(layout, part.ty, inner).filter(|_| is_inside)?;
    Some(part.scalar? + scalar)
}
