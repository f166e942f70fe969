//! Equality of values: whether two operations always compute the same result.

use super::reaching_definitions::ReachingDefinitions;
use shaderlint_ir::{Module, OpId, OpKind};

/// Maximum number of operations compared per query.
const BUDGET: u32 = 48;

/// Whether two operations compute the same value wherever both have run. Compares expression trees
/// up to a depth; `false` where that does not prove it.
pub fn is_same(module: &Module, defs: &ReachingDefinitions, a: OpId, b: OpId) -> bool {
    let mut left = BUDGET;
    same(module, defs, a, b, &mut left)
}

fn same(module: &Module, defs: &ReachingDefinitions, a: OpId, b: OpId, left: &mut u32) -> bool {
    if a == b {
        return true;
    }
    let Some(rest) = left.checked_sub(1) else {
        return false;
    };
    *left = rest;
    if module.ty(a) != module.ty(b) {
        return false;
    }
    let mut both = |x: OpId, y: OpId| same(module, defs, x, y, left);
    match (module.op(a).kind, module.op(b).kind) {
        (OpKind::Load(_), OpKind::Load(_)) => is_same_load(module, defs, a, b),
        (OpKind::Const(_), OpKind::Const(_)) => module.constant(a) == module.constant(b),
        (OpKind::Unary(op, x), OpKind::Unary(other, y)) => op == other && both(x, y),
        (OpKind::Binary(op, x, y), OpKind::Binary(other, z, w)) => {
            op == other && both(x, z) && both(y, w)
        }
        (OpKind::MatrixProduct(x, y), OpKind::MatrixProduct(z, w)) => both(x, z) && both(y, w),
        (OpKind::Convert(x), OpKind::Convert(y)) | (OpKind::Splat(x), OpKind::Splat(y)) => {
            both(x, y)
        }
        (OpKind::Swizzle(x, lanes), OpKind::Swizzle(y, others)) => lanes == others && both(x, y),
        (OpKind::Extract(x, number), OpKind::Extract(y, other)) => number == other && both(x, y),
        (
            OpKind::ExtractComputed { base: x, index: i },
            OpKind::ExtractComputed { base: y, index: j },
        ) => both(x, y) && both(i, j),
        (OpKind::Compose(x), OpKind::Compose(y)) => all(module, x, y, both),
        (OpKind::Builtin(overload, x), OpKind::Builtin(other, y)) => {
            overload == other && all(module, x, y, both)
        }
        (OpKind::Call(function, x), OpKind::Call(other, y)) => {
            function == other && defs.is_pure(function) && all(module, x, y, both)
        }
        _ => false,
    }
}

fn all(
    module: &Module,
    a: shaderlint_syntax::ast::List,
    b: shaderlint_syntax::ast::List,
    mut both: impl FnMut(OpId, OpId) -> bool,
) -> bool {
    let (a, b) = (module.operands(a), module.operands(b));
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| both(*x, *y))
}

/// Whether the same definitions reach two loads in all components. Elements of an array are not
/// distinguished.
fn is_same_load(module: &Module, defs: &ReachingDefinitions, a: OpId, b: OpId) -> bool {
    let (OpKind::Load(place), OpKind::Load(other)) = (module.op(a).kind, module.op(b).kind) else {
        return false;
    };
    let (place, other) = (module.place(place), module.place(other));
    let lanes = defs.lanes_of(a);
    let sees = |op, lane| defs.copied_from(module, defs.seen(op, lane));
    let known = |lane| defs.get(sees(a, lane)) != super::reaching_definitions::Def::Unknown;
    // The length is determined by the components, so it is not compared.
    let components = module.ty(a).components().max(1).min(lanes);
    let is_one = (0..components).all(|lane| known(lane) && sees(a, lane) == sees(b, lane));
    let path = module.path(place);
    let has_element = |p: &[shaderlint_ir::Access]| {
        use shaderlint_ir::Access::{Computed, Element};
        p.iter().any(|a| matches!(a, Computed(_) | Element(_)))
    };
    let is_path_same = place.variable == other.variable && path == module.path(other);
    let is_plain = !has_element(path) && !has_element(module.path(other));
    lanes > 0 && is_one && (is_plain || is_path_same)
}
