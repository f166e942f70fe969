//! Rotated frames: nodes that are linear in the same nodes, with orthogonal rows of coefficients.
//!
//! `c * x - s * z` and `s * x + c * z` are the coordinates of a rotated point, however the rotation is
//! written: their gradients are as orthogonal as those of `x` and `z`.

use super::form::{ScalarForm, ScalarId};
use super::node::Scalars;
use super::polynomial::NodePolynomial;
use rustc_hash::FxHashMap;

/// Most nodes of which a row consists.
const MAX_ATOMS: usize = 4;
/// Most rows over the same nodes.
const MAX_ROWS: usize = 48;

/// A row of a frame.
#[derive(Clone, Debug)]
pub(super) struct FrameRow {
    /// The first node of the frame.
    pub frame: ScalarId,
    pub index: u32,
    /// The length of its row of coefficients.
    pub norm: f64,
    /// The nodes that the frame is a rotation of.
    pub atoms: Vec<ScalarId>,
}

/// The frames of a function.
#[derive(Default)]
pub(super) struct Frames(FxHashMap<ScalarId, FrameRow>);

/// A node as a linear combination: the coefficients, by atom.
struct LinearRow {
    node: ScalarId,
    factors: Vec<(ScalarId, ScalarId)>,
    is_constant: bool,
}

impl Frames {
    pub fn row(&self, id: ScalarId) -> Option<&FrameRow> {
        self.0.get(&id)
    }

    pub fn of(scalars: &mut Scalars, nodes: &[ScalarId]) -> Frames {
        let mut all: Vec<LinearRow> = Vec::new();
        for &node in nodes {
            let is_sum = matches!(
                scalars.get(node),
                ScalarForm::Sum(..) | ScalarForm::Product(_)
            );
            if is_sum && scalars.varies(node) {
                all.extend(linear(scalars, node));
            }
        }
        // Rows that share nodes. Those of a rotation come after those that it is composed of, and are
        // taken first.
        all.sort_by_key(|row| {
            (
                std::cmp::Reverse(row.factors.len()),
                std::cmp::Reverse(row.node),
            )
        });
        let mut groups: Vec<(Vec<ScalarId>, Vec<LinearRow>)> = Vec::new();
        for row in all {
            let has = |atoms: &[ScalarId]| row.factors.iter().all(|(a, _)| atoms.contains(a));
            match groups.iter_mut().find(|(atoms, _)| has(atoms)) {
                Some((_, rows)) => rows.push(row),
                None => {
                    let atoms = row.factors.iter().map(|(atom, _)| *atom).collect();
                    groups.push((atoms, vec![row]));
                }
            }
        }
        let mut frames = Frames::default();
        for (atoms, mut rows) in groups {
            rows.sort_by_key(|row| std::cmp::Reverse(row.node));
            rows.truncate(MAX_ROWS);
            while let Some(first) = (!rows.is_empty()).then(|| rows.remove(0)) {
                frames.group(scalars, &atoms, first, &mut rows);
            }
        }
        frames
    }

    /// Makes a frame of a row and of those that are orthogonal to it.
    fn group(
        &mut self,
        scalars: &mut Scalars,
        atoms: &[ScalarId],
        first: LinearRow,
        rows: &mut Vec<LinearRow>,
    ) {
        let mut members = vec![first];
        let mut at = 0;
        while let Some(row) = rows.get(at) {
            let is_orthogonal = members.len() < atoms.len()
                && members
                    .iter()
                    .all(|other| product(scalars, other, row) < 0.02);
            match is_orthogonal {
                true => members.push(rows.remove(at)),
                false => at += 1,
            }
        }
        if members.len() == 1 && members.iter().all(|row| row.is_constant) {
            return;
        }
        let of = |atom: &&ScalarId| {
            let mut all = members.iter().flat_map(|row| &row.factors);
            all.any(|(other, _)| other == *atom)
        };
        let atoms: Vec<ScalarId> = atoms.iter().filter(of).copied().collect();
        let mut sums = Vec::new();
        let mut is_exact = true;
        for (a, row) in members.iter().enumerate() {
            let mut sum = 0.0;
            for (b, other) in members.iter().enumerate() {
                let product = product(scalars, row, other);
                is_exact &= a == b || product < 1e-7;
                sum += product;
            }
            sums.push(sum);
        }
        let most = sums.iter().fold(0.0f64, |a, b| a.max(*b));
        let Some(frame) = members.first().map(|row| row.node) else {
            return;
        };
        for ((index, row), sum) in (0..).zip(&members).zip(sums) {
            let norm = if is_exact { sum } else { most }.sqrt();
            if norm.is_finite() {
                let row_of = FrameRow {
                    frame,
                    index,
                    norm,
                    atoms: atoms.clone(),
                };
                self.0.insert(row.node, row_of);
            }
        }
    }
}

/// The greatest magnitude of the scalar product of two rows.
fn product(scalars: &mut Scalars, a: &LinearRow, b: &LinearRow) -> f64 {
    let mut sum = scalars.number(0.0);
    for (atom, x) in &a.factors {
        if let Some((_, y)) = b.factors.iter().find(|(other, _)| other == atom) {
            let product = scalars.multiply(*x, *y);
            sum = scalars.add(sum, product);
        }
    }
    let simple = NodePolynomial::of(scalars, sum).map(|polynomial| polynomial.node(scalars));
    scalars.span(simple.unwrap_or(sum)).most()
}

/// A node as a linear combination of several nodes that depend on the point.
fn linear(scalars: &mut Scalars, node: ScalarId) -> Option<LinearRow> {
    let polynomial = NodePolynomial::of(scalars, node)?;
    let mut rows: Vec<(ScalarId, NodePolynomial)> = Vec::new();
    for (monomial, by) in polynomial.0 {
        let varies = |(id, _): &&(ScalarId, i32)| scalars.varies(*id);
        let mut varying = monomial.iter().filter(varies);
        let Some(&(atom, power)) = varying.next() else {
            continue;
        };
        if power != 1 || varying.next().is_some() {
            return None;
        }
        let rest = monomial
            .iter()
            .copied()
            .filter(|(id, _)| *id != atom)
            .collect();
        match rows.iter_mut().find(|(known, _)| *known == atom) {
            Some((_, row)) => *row.0.entry(rest).or_insert(0.0) += by,
            None => rows.push((atom, NodePolynomial([(rest, by)].into()))),
        }
    }
    if rows.len() < 2 || rows.len() > MAX_ATOMS {
        return None;
    }
    rows.sort_by_key(|(atom, _)| *atom);
    let factors = rows.iter().map(|(atom, row)| (*atom, row.node(scalars)));
    let factors: Vec<(ScalarId, ScalarId)> = factors.collect();
    let is_constant = factors.iter().all(|(_, id)| scalars.value(*id).is_some());
    Some(LinearRow {
        node,
        factors,
        is_constant,
    })
}
