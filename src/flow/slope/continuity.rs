//! Continuity: a function that jumps has no slope, however flat it is on both sides.
//!
//! A function may jump where the argument of a `floor` is an integer, and where a condition changes. It
//! does not if both sides are the same expression there: the repetition of a mirrored shape, noise
//! between the points of a grid, the minimum written as an `if`.

use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::node::Scalars;
use super::polynomial::NodePolynomial;
use rustc_hash::FxHashMap;

/// Most nodes that are made again.
const MAX_WORK: u32 = 400_000;

/// The first place where a function may jump; `None` if it is continuous. `nodes` are all nodes of the
/// function in topological order, `is_flat` says whether a node is constant between jumps.
pub(super) fn jump(
    scalars: &mut Scalars,
    root: ScalarId,
    nodes: &[ScalarId],
    is_flat: impl Fn(ScalarId) -> bool,
) -> Option<ScalarId> {
    let mut left = MAX_WORK;
    for &node in nodes {
        let is_jump = match *scalars.get(node) {
            ScalarForm::Of(ScalarFunction::Floor, inner) if !is_flat(inner) => {
                let one = scalars.number(1.0);
                let below = scalars.subtract(inner, one);
                !is_joined(
                    scalars,
                    (root, nodes),
                    (node, [inner, below]),
                    None,
                    &mut left,
                )
            }
            ScalarForm::IsNegative(inner) if !is_flat(inner) => {
                let sides = [scalars.truth(true), scalars.truth(false)];
                let joined = |scalars: &mut Scalars, equal, left: &mut u32| {
                    is_joined(scalars, (root, nodes), (node, sides), equal, left)
                };
                !joined(scalars, None, &mut left)
                    && !solved(scalars, inner)
                        .into_iter()
                        .any(|equal| joined(scalars, Some(equal), &mut left))
            }
            _ => false,
        };
        if is_jump {
            return Some(node);
        }
    }
    None
}

/// Whether a function is the same for both values of a node, where two other nodes are equal.
fn is_joined(
    scalars: &mut Scalars,
    (root, nodes): (ScalarId, &[ScalarId]),
    (node, sides): (ScalarId, [ScalarId; 2]),
    equal: Option<(ScalarId, ScalarId)>,
    left: &mut u32,
) -> bool {
    let both = sides.map(|side| {
        let mut known = FxHashMap::default();
        known.insert(node, side);
        let made = replaced(scalars, root, nodes, known, left)?;
        if equal.is_none() {
            return Some(made);
        }
        let nodes = below(scalars, made);
        replaced(scalars, made, &nodes, equal.into_iter().collect(), left)
    });
    match both {
        [Some(a), Some(b)] => scalars.is_same(a, b),
        _ => false,
    }
}

/// All nodes that a node consists of, in topological order.
pub(super) fn below(scalars: &Scalars, root: ScalarId) -> Vec<ScalarId> {
    let mut seen = vec![false; scalars.len()];
    let mut todo = vec![root];
    let mut found = Vec::new();
    while let Some(id) = todo.pop() {
        match seen.get_mut(id.0 as usize) {
            Some(seen) if !*seen => *seen = true,
            _ => continue,
        }
        found.push(id);
        scalars.each(id, |operand| todo.push(operand));
    }
    found.sort_unstable();
    found
}

/// The nodes that are other expressions where a node is zero.
fn solved(scalars: &mut Scalars, zero: ScalarId) -> Vec<(ScalarId, ScalarId)> {
    let Some(polynomial) = NodePolynomial::of(scalars, zero) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for atom in polynomial.atoms().into_iter().rev() {
        let partial = polynomial.partial(atom).node(scalars);
        let Some(by) = scalars.value(partial).filter(|_| scalars.varies(atom)) else {
            continue;
        };
        let mut rest = polynomial.clone();
        rest.0
            .retain(|monomial, _| !monomial.iter().any(|(id, _)| *id == atom));
        let rest = rest.node(scalars);
        found.push((atom, scalars.scale(rest, -1.0 / by)));
    }
    found
}

/// A node with some nodes replaced by others.
fn replaced(
    scalars: &mut Scalars,
    root: ScalarId,
    nodes: &[ScalarId],
    mut known: FxHashMap<ScalarId, ScalarId>,
    left: &mut u32,
) -> Option<ScalarId> {
    for &node in nodes {
        if known.contains_key(&node) {
            continue;
        }
        let mut differs = false;
        scalars.each(node, |operand| {
            differs |= known.get(&operand).is_some_and(|new| *new != operand);
        });
        if differs {
            *left = left.checked_sub(1)?;
            if scalars.is_full() {
                return None;
            }
            let made = scalars.remake(node, |id| known.get(&id).copied().unwrap_or(id));
            known.insert(node, made);
        }
    }
    Some(known.get(&root).copied().unwrap_or(root))
}
