//! Termination of bisection: each iteration moves one of two bounds to the midpoint.

use crate::ranges::Query;
use crate::reaching_definitions::{Def, DefId};
use shaderlint_ir::{Binary, LoopId, OpId, OpKind};
use shaderlint_semantic::BuiltinId;
use shaderlint_semantic::builtins::Transfer;

/// Maximum nesting of the conditions that choose which bound moves.
const MAX_DEPTH: u32 = 4;

/// Whether a value is the distance between two bounds of a bisection.
pub(super) fn halves(query: Query, looped: LoopId, distance: OpId) -> bool {
    let module = query.module;
    let mut at = distance;
    if let OpKind::Builtin(function, list) = module.op(at).kind
        && matches!(function.transfer(), Transfer::Magnitude)
        && let [inner] = module.operands(list)
    {
        at = *inner;
    }
    let (left, right) = match module.op(at).kind {
        OpKind::Binary(Binary::Subtract, left, right) => (left, right),
        OpKind::Builtin(BuiltinId::Distance, list) => match module.operands(list) {
            [left, right] => (*left, *right),
            _ => return false,
        },
        _ => return false,
    };
    let Some(bounds) = head(query, looped, left).zip(head(query, looped, right)) else {
        return false;
    };
    let back = |head| match query.defs.get(head) {
        Def::Head { back, .. } => Some(back),
        _ => None,
    };
    let both = back(bounds.0).zip(back(bounds.1));
    both.is_some_and(|both| comes_together(query, looped, bounds, both, MAX_DEPTH))
}

/// Whether on every path one bound becomes the midpoint and the other is unchanged.
fn comes_together(
    query: Query,
    looped: LoopId,
    heads: (DefId, DefId),
    now: (DefId, DefId),
    depth: u32,
) -> bool {
    let defs = query.defs;
    let now = (defs.unrefined(now.0), defs.unrefined(now.1));
    if now.0 == heads.0 {
        return is_midpoint(query, looped, heads, now.1);
    }
    if now.1 == heads.1 {
        return is_midpoint(query, looped, heads, now.0);
    }
    let (
        Def::Merge {
            sides: first,
            condition: one,
            ..
        },
        Def::Merge {
            sides: second,
            condition: other,
            ..
        },
    ) = (defs.get(now.0), defs.get(now.1))
    else {
        return false;
    };
    let pairs = defs.list(first).iter().zip(defs.list(second));
    one == other
        && first.len == second.len
        && depth > 0
        && pairs
            .into_iter()
            .all(|(a, b)| comes_together(query, looped, heads, (*a, *b), depth - 1))
}

/// Whether a definition is a midpoint: `(a + b) / 2`, `(a + b) * 0.5` or `mix(a, b, t)` with 0 < t
/// < 1.
fn is_midpoint(query: Query, looped: LoopId, heads: (DefId, DefId), def: DefId) -> bool {
    let module = query.module;
    let Some(value) = value_of(query, def) else {
        return false;
    };
    let is_pair = |a, b| {
        let found = head(query, looped, a).zip(head(query, looped, b));
        found == Some(heads) || found == Some((heads.1, heads.0))
    };
    let is_sum = |op| match module.op(op).kind {
        OpKind::Binary(Binary::Add, a, b) => is_pair(a, b),
        _ => false,
    };
    let is = |op, number: f64| query.lane(op, 0).single() == Some(number);
    match module.op(value).kind {
        OpKind::Binary(Binary::Multiply, a, b) => {
            is_sum(a) && is(b, 0.5) || is_sum(b) && is(a, 0.5)
        }
        OpKind::Binary(Binary::Divide, a, b) => is_sum(a) && is(b, 2.0),
        OpKind::Builtin(BuiltinId::Mix, list) => match module.operands(list) {
            [a, b, amount] => {
                let amount = query.lane(*amount, 0);
                is_pair(*a, *b) && amount.lo.value > 0.0 && amount.hi.value < 1.0
            }
            _ => false,
        },
        _ => false,
    }
}

/// The value stored in a variable, copies followed.
fn value_of(query: Query, def: DefId) -> Option<OpId> {
    let (module, defs) = (query.module, query.defs);
    match defs.get(defs.copied_from(module, def)) {
        Def::Stored { value, .. } if module.ty(value).is_scalar() => Some(value),
        _ => None,
    }
}

/// The loop head that a value is a copy of.
fn head(query: Query, looped: LoopId, op: OpId) -> Option<DefId> {
    let (module, defs) = (query.module, query.defs);
    let OpKind::Load(_) = module.op(op).kind else {
        return None;
    };
    let def = defs.copied_from(module, defs.seen(op, 0));
    matches!(defs.get(def), Def::Head { of, .. } if of == looped).then_some(def)
}
