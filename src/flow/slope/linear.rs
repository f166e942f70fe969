//! Systems of linear inequalities: whether they have a solution, by Fourier-Motzkin elimination; and
//! whether a polynomial is a sum of squares.

use super::form::ScalarId;
use super::polynomial::NodePolynomial;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Most inequalities of a system, more of which count as having a solution.
const MAX_ROWS: usize = 160;
/// Most nodes of a sum of squares.
const MAX_SQUARES: usize = 8;
/// What rounding may do.
const ROUNDING: f64 = 1e-6;

/// A sum of multiples of nodes and a constant, that is at least zero.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Inequality {
    pub factors: BTreeMap<ScalarId, f64>,
    pub constant: f64,
}

impl Inequality {
    pub fn negated(&self) -> Inequality {
        Inequality {
            factors: self.factors.iter().map(|(id, by)| (*id, -by)).collect(),
            constant: -self.constant,
        }
    }

    /// The inequality with a greatest factor of 1; without factors, only what is left of the constant.
    pub fn scaled(mut self) -> Inequality {
        let most = self.factors.values().fold(0.0f64, |m, by| m.max(by.abs()));
        self.factors.retain(|_, by| by.abs() > most * 1e-9);
        if most > 0.0 {
            self.factors.values_mut().for_each(|by| *by /= most);
            self.constant /= most;
        }
        self
    }

    fn factor(&self, id: ScalarId) -> f64 {
        self.factors.get(&id).copied().unwrap_or(0.0)
    }

    /// What follows from two inequalities of which one bounds a node from below and one from above.
    fn without(&self, id: ScalarId, other: &Inequality) -> Inequality {
        let (ours, theirs) = (other.factor(id).abs(), self.factor(id).abs());
        let mut factors = BTreeMap::new();
        for (row, by) in [(self, ours), (other, theirs)] {
            for (node, own) in row.factors.iter().filter(|(node, _)| **node != id) {
                *factors.entry(*node).or_insert(0.0) += own * by;
            }
        }
        Inequality {
            factors,
            constant: self.constant * ours + other.constant * theirs,
        }
    }

    /// The direction, so that of parallel inequalities only the strictest is kept.
    fn direction(&self) -> Vec<(ScalarId, i64)> {
        let factors = self.factors.iter();
        factors
            .map(|(id, by)| (*id, (by * 1e7).round() as i64))
            .collect()
    }
}

/// Whether some inequalities are known to contradict each other.
pub(super) fn is_contradiction(rows: Vec<Inequality>) -> bool {
    let mut rows = rows;
    loop {
        let mut strictest: FxHashMap<Vec<(ScalarId, i64)>, Inequality> = FxHashMap::default();
        for row in rows {
            let row = row.scaled();
            if row.factors.is_empty() {
                if row.constant < -ROUNDING * 0.25 {
                    return true;
                }
                continue;
            }
            let known = strictest
                .entry(row.direction())
                .or_insert_with(|| row.clone());
            if row.constant < known.constant {
                *known = row;
            }
        }
        let mut uses: BTreeMap<ScalarId, (usize, usize)> = BTreeMap::new();
        for (id, by) in strictest.values().flat_map(|row| &row.factors) {
            let (above, below) = uses.entry(*id).or_insert((0, 0));
            *(if *by > 0.0 { above } else { below }) += 1;
        }
        let cheapest = uses
            .iter()
            .min_by_key(|(_, (above, below))| above * below)
            .map(|(id, _)| *id);
        let Some(id) = cheapest else {
            return false;
        };
        let all = strictest.into_values();
        let (with, mut rest): (Vec<Inequality>, Vec<Inequality>) =
            all.partition(|row| row.factor(id) != 0.0);
        let (above, below): (Vec<Inequality>, Vec<Inequality>) =
            with.into_iter().partition(|row| row.factor(id) > 0.0);
        for a in &above {
            rest.extend(below.iter().map(|b| a.without(id, b)));
        }
        if rest.len() > MAX_ROWS {
            return false;
        }
        rows = rest;
    }
}

/// Whether some inequalities imply that another sum is at least zero, up to rounding.
pub(super) fn implies(rows: &[Inequality], sum: &Inequality) -> bool {
    let mut against = sum.clone().scaled().negated();
    if against.factors.is_empty() {
        return sum.constant >= -ROUNDING;
    }
    against.constant -= ROUNDING;
    // Those that share nodes with it, at any distance.
    let mut nodes: Vec<ScalarId> = against.factors.keys().copied().collect();
    let mut rest: Vec<&Inequality> = rows.iter().collect();
    let mut all = vec![against];
    loop {
        let shares = |row: &&Inequality| row.factors.keys().any(|id| nodes.contains(id));
        let (near, far): (Vec<&Inequality>, Vec<&Inequality>) = rest.into_iter().partition(shares);
        if near.is_empty() {
            break;
        }
        nodes.extend(near.iter().flat_map(|row| row.factors.keys()));
        all.extend(near.into_iter().cloned());
        rest = far;
    }
    is_contradiction(all)
}

/// Whether a polynomial of degree two, times a sign, is a sum of squares and a positive constant.
pub(super) fn is_sum_of_squares(polynomial: &NodePolynomial, sign: f64) -> bool {
    let atoms = polynomial.atoms();
    let count = atoms.len() + 1;
    if count > MAX_SQUARES {
        return false;
    }
    let position = |id: ScalarId| atoms.iter().position(|other| *other == id).map(|at| at + 1);
    let mut matrix: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    let mut add = |a: usize, b: usize, by: f64| {
        *matrix.entry((a, b)).or_insert(0.0) += by / 2.0;
        *matrix.entry((b, a)).or_insert(0.0) += by / 2.0;
    };
    for (monomial, by) in &polynomial.0 {
        let by = by * sign;
        let places: Option<Vec<(usize, i32)>> = monomial
            .iter()
            .map(|(id, power)| Some((position(*id)?, *power)))
            .collect();
        match places.as_deref() {
            Some([]) => add(0, 0, by),
            Some([(a, 1)]) => add(0, *a, by),
            Some([(a, 2)]) => add(*a, *a, by),
            Some([(a, 1), (b, 1)]) => add(*a, *b, by),
            _ => return false,
        }
    }
    let most = matrix.values().fold(0.0f64, |most, by| most.max(by.abs()));
    let rounding = most * ROUNDING;
    let cell = |m: &BTreeMap<(usize, usize), f64>, a, b| m.get(&(a, b)).copied().unwrap_or(0.0);
    // Squares are completed one by one, the constant last.
    for pivot in (0..count).rev() {
        let own = cell(&matrix, pivot, pivot);
        if own < -rounding {
            return false;
        }
        for a in 0..pivot {
            let first = cell(&matrix, a, pivot);
            if own <= rounding {
                if first.abs() > rounding {
                    return false;
                }
                continue;
            }
            for b in 0..pivot {
                let second = cell(&matrix, b, pivot);
                *matrix.entry((a, b)).or_insert(0.0) -= first * second / own;
            }
        }
    }
    true
}
