//! Continuity: a function that jumps has no slope, however flat it is on both sides.
//!
//! A function may jump where the argument of a `floor` is an integer, and where a condition changes. It
//! does not if both sides are the same expression there: the repetition of a mirrored shape, noise
//! between the points of a grid, the minimum written as an `if`.

use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::joint::WallProof;
use super::node::Scalars;
use super::polynomial::NodePolynomial;
use rustc_hash::{FxHashMap, FxHashSet};

/// Most nodes that are made again.
const MAX_WORK: u32 = 100_000;
/// Most nodes that are made again to prove that a condition is continuous by cases.
const MAX_PROOF: u32 = 20_000;
/// Most nodes through which all uses of a condition go, that are tried.
const MAX_JOINTS: usize = 12;

/// The first place where a function may jump; `None` if it is continuous. `nodes` are all nodes of the
/// function in topological order, `is_flat` says whether a node is constant between jumps.
pub(super) fn jump(
    scalars: &mut Scalars,
    nodes: &[ScalarId],
    is_flat: impl Fn(ScalarId) -> bool,
) -> Option<ScalarId> {
    let mut left = MAX_WORK;
    let mut walls = Vec::new();
    for &node in nodes {
        match *scalars.get(node) {
            ScalarForm::Of(ScalarFunction::Floor, inner) if !is_flat(inner) => {
                walls.push((node, inner));
            }
            ScalarForm::IsNegative(inner) if !is_flat(inner) => walls.push((node, inner)),
            _ => {}
        }
    }
    walls
        .into_iter()
        .find(|wall| !is_continuous(scalars, nodes, *wall, &mut left))
        .map(|(node, _)| node)
}

/// Whether a function is continuous where a node jumps: that is where another node is zero or an
/// integer.
///
/// It is if any node is through which all uses of the jumping one go.
fn is_continuous(
    scalars: &mut Scalars,
    nodes: &[ScalarId],
    (node, inner): (ScalarId, ScalarId),
    left: &mut u32,
) -> bool {
    let is_floor = matches!(scalars.get(node), ScalarForm::Of(..));
    let sides = match is_floor {
        true => {
            let one = scalars.number(1.0);
            [inner, scalars.subtract(inner, one)]
        }
        false => [scalars.truth(true), scalars.truth(false)],
    };
    let equal = match is_floor {
        true => Vec::new(),
        false => solved(scalars, inner),
    };
    let joints = joints(scalars, nodes, node);
    for joint in &joints {
        let below = scalars.below(*joint);
        let at = (*joint, below.as_slice());
        if is_joined(scalars, at, (node, sides), None, left)
            || equal
                .iter()
                .any(|equal| is_joined(scalars, at, (node, sides), Some(*equal), left))
        {
            return true;
        }
    }
    let mut work = MAX_PROOF.min(*left);
    let before = work;
    let is_proved = joints.iter().any(|joint| {
        let below = scalars.below(*joint);
        if below.len() as u32 > work / 8 {
            return false;
        }
        let (zero, sides, integer) = match is_floor {
            true => {
                let integer = scalars.unknown();
                let one = scalars.number(1.0);
                let sides = [integer, scalars.subtract(integer, one)];
                (scalars.subtract(inner, integer), sides, Some(integer))
            }
            false => (inner, sides, None),
        };
        let both = sides.map(|side| {
            let known = [(node, side)].into_iter().collect();
            replaced(scalars, *joint, &below, known, &mut work)
        });
        match both {
            [Some(a), Some(b)] => WallProof::new(scalars, &mut work).joins([a, b], zero, integer),
            _ => false,
        }
    });
    *left = left.saturating_sub(before - work);
    is_proved
}

/// The numbers through which all uses of a node go, in topological order.
fn joints(scalars: &Scalars, nodes: &[ScalarId], node: ScalarId) -> Vec<ScalarId> {
    let mut uses: FxHashMap<ScalarId, u32> = FxHashMap::default();
    let mut affected: FxHashSet<ScalarId> = [node].into_iter().collect();
    for &user in nodes.iter().filter(|user| **user > node) {
        let mut is_affected = false;
        scalars.each(user, |operand| {
            if affected.contains(&operand) {
                is_affected = true;
                *uses.entry(operand).or_insert(0) += 1;
            }
        });
        if is_affected {
            affected.insert(user);
        }
    }
    let mut open = uses.get(&node).copied().unwrap_or(0);
    let mut found = Vec::new();
    for &user in nodes.iter().filter(|user| **user > node) {
        if !affected.contains(&user) {
            continue;
        }
        scalars.each(user, |operand| {
            open -= u32::from(affected.contains(&operand))
        });
        let is_number = !matches!(
            scalars.get(user),
            ScalarForm::IsNegative(_) | ScalarForm::Not(_) | ScalarForm::And(..)
        );
        if open == 0 && is_number {
            found.push(user);
        }
        open += uses.get(&user).copied().unwrap_or(0);
    }
    // The function itself is the last one.
    let last = found.last().copied();
    found.truncate(MAX_JOINTS);
    if let Some(last) = last.filter(|last| !found.contains(last)) {
        found.push(last);
    }
    found
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
        let nodes = scalars.below(made);
        replaced(scalars, made, &nodes, equal.into_iter().collect(), left)
    });
    match both {
        [Some(a), Some(b)] => scalars.is_same(a, b),
        _ => false,
    }
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
