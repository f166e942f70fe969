//! Slopes of distance fields: upper bounds of their Lipschitz constants.
//!
//! A ray that moves by the value of a function does not jump over its surface if the function is at most
//! as steep as a distance: `|f(p) - f(q)| <= |p - q|`. The function is executed symbolically, as scalar
//! expressions of the coordinates. The gradient of each is bounded from those of its operands, as
//! combinations of generators, which know what is orthogonal; with cases for the signs that matter, and
//! partial derivatives where terms cancel. It must be continuous, too.
//!
//! Related work: Galin, Guérin, Paris and Peytavie, *Segment Tracing Using Local Lipschitz Bounds*, 2020;
//! Sharp and Jacobson, *Spelunking the Deep*, 2022.

mod assumptions;
mod bound;
mod cases;
mod chain;
mod continuity;
mod execute;
mod form;
mod frame;
mod globals;
mod gradient;
mod interval;
mod joint;
mod linear;
mod node;
mod operation;
mod polynomial;
mod roots;
#[cfg(test)]
mod tests;
mod verdict;

use super::ranges::Query;
use super::rays::{RayKind, RayLoop};
use bound::GradientBounds;
use execute::SymbolicExecution;
use form::{ScalarForm, ScalarFunction, ScalarId};
use node::Scalars;
use rustc_hash::FxHashSet;
use shaderlint_ir::Layout;
use shaderlint_semantic::Type;
pub use verdict::{DistanceField, Obstacle, STEEPEST_DISTANCE, Slope, SlopeObstacle};

/// Most terms of polynomials that are multiplied to find a bound, and to prove that there is no jump.
const MAX_PRODUCTS: u32 = 300_000;

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

/// A bound of the slope of a field, over all points.
pub fn slope(query: Query, field: DistanceField) -> Slope {
    let module = query.module;
    let written = globals::written(module);
    let mut scalars = Scalars::new();
    let known_globals = globals::known_globals(query, &written, &mut scalars, field.function);
    let mut execution = SymbolicExecution::new((query.program, module), &written, &mut scalars);
    let root = match execution.run((field.function, field.point), known_globals) {
        Ok(values) => values.get(field.scalar as usize).copied(),
        Err(obstacle) => return Slope::Unknown(obstacle),
    };
    let mut vectors = std::mem::take(&mut execution.vectors);
    vectors.sort_unstable();
    vectors.dedup();
    match root {
        Some(root) => slope_of(&mut scalars, root, &vectors),
        None => Slope::Unknown(Obstacle {
            why: SlopeObstacle::Body,
            at: None,
        }),
    }
}

fn slope_of(scalars: &mut Scalars, root: ScalarId, vectors: &[Vec<ScalarId>]) -> Slope {
    let nodes = scalars.below(root);
    if let Some(obstacle) = opaque(scalars, root) {
        return Slope::Unknown(obstacle);
    }
    scalars.allow_products(MAX_PRODUCTS);
    let mut bounds = GradientBounds::new(scalars, &nodes);
    bounds.solve(&nodes, vectors);
    let known = std::mem::take(&mut bounds.known);
    let norm = |id: ScalarId| known.get(&id).map_or(0.0, |g| g.norm);
    let most = norm(root);
    if !most.is_finite() {
        return Slope::Unknown(obstacle_at(scalars, root, norm));
    }
    scalars.allow_products(MAX_PRODUCTS);
    match continuity::jump(scalars, &nodes, |id| norm(id) == 0.0) {
        Some(node) => Slope::Unknown(Obstacle {
            why: SlopeObstacle::Discontinuity,
            at: scalars.op(node),
        }),
        None => Slope::AtMost(most),
    }
}

/// A node of which nothing is known and from which the gradient follows.
fn opaque(scalars: &Scalars, root: ScalarId) -> Option<Obstacle> {
    let mut seen = FxHashSet::default();
    let mut todo = vec![root];
    while let Some(id) = todo.pop() {
        match *scalars.get(id) {
            ScalarForm::Unknown(_) => {
                return Some(Obstacle {
                    why: SlopeObstacle::Operation,
                    at: scalars.op(id),
                });
            }
            ScalarForm::Of(ScalarFunction::Floor, _) => {}
            ScalarForm::Select(_, a, b) => {
                todo.extend([a, b].into_iter().filter(|id| seen.insert(*id)))
            }
            _ => scalars.each(id, |operand| {
                if scalars.varies(operand) && seen.insert(operand) {
                    todo.push(operand);
                }
            }),
        }
    }
    None
}

/// The first node without a bound.
fn obstacle_at(scalars: &Scalars, root: ScalarId, norm: impl Fn(ScalarId) -> f64) -> Obstacle {
    let mut at = root;
    loop {
        let mut next = None;
        scalars.each(at, |operand| {
            if next.is_none() && !norm(operand).is_finite() {
                next = Some(operand);
            }
        });
        match next {
            Some(operand) => at = operand,
            None => break,
        }
    }
    Obstacle {
        why: match scalars.get(at) {
            ScalarForm::Unknown(_) => SlopeObstacle::Operation,
            _ => SlopeObstacle::Unbounded,
        },
        at: scalars.op(at),
    }
}
