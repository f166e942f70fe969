//! Polynomials: their partial derivatives, in which terms cancel, and blends of gradients.

use super::assumptions::SlopeAssumptions;
use super::bound::{CaseMemo, GradientBounds};
use super::form::{ScalarForm, ScalarId};
use super::gradient::FieldGradient;
use super::interval::RealSpan;
use super::polynomial::NodePolynomial;
use rustc_hash::{FxHashMap, FxHashSet};

/// Most nodes of a polynomial.
const MAX_ATOMS: usize = 40;

impl GradientBounds<'_> {
    /// The partial derivatives of a node as a polynomial, by atom that depends on the point: as they are
    /// written, and with sums multiplied out, where terms cancel.
    pub fn partials(&mut self, id: ScalarId) -> Vec<Vec<(ScalarId, ScalarId)>> {
        if let Some(known) = self.polynomials.get(&id) {
            return known.clone();
        }
        let mut made = Vec::new();
        made.extend(self.written_partials(id));
        if let Some(polynomial) = NodePolynomial::of_point(self.scalars, id) {
            let atoms = polynomial.atoms().into_iter();
            let atoms: Vec<ScalarId> = atoms.filter(|a| self.scalars.varies(*a)).collect();
            let partials = atoms.into_iter().map(|atom| {
                let partial = polynomial.partial(atom);
                (atom, partial.node(self.scalars))
            });
            made.push(partials.collect());
        }
        self.polynomials.insert(id, made.clone());
        made
    }

    /// The partial derivatives of a node as it is written; `None` if it is too large.
    pub fn written_partials(&mut self, id: ScalarId) -> Option<Vec<(ScalarId, ScalarId)>> {
        let mut written = Vec::new();
        for atom in self.atoms(id)? {
            let mut known = FxHashMap::default();
            written.push((atom, self.derivative(id, atom, &mut known)?));
        }
        Some(written)
    }

    /// The nodes that depend on the point and of which a node is a polynomial; `None` if there are too
    /// many.
    pub fn atoms(&self, id: ScalarId) -> Option<Vec<ScalarId>> {
        let mut seen = FxHashSet::default();
        let mut todo = vec![id];
        let mut found = Vec::new();
        while let Some(id) = todo.pop() {
            if !self.scalars.varies(id) || !seen.insert(id) {
                continue;
            }
            match self.scalars.get(id) {
                ScalarForm::Sum(..) | ScalarForm::Product(_) => {
                    self.scalars.each(id, |operand| todo.push(operand));
                }
                _ => found.push(id),
            }
        }
        found.sort_unstable();
        (found.len() <= MAX_ATOMS).then_some(found)
    }

    pub fn derivative(
        &mut self,
        id: ScalarId,
        atom: ScalarId,
        known: &mut FxHashMap<ScalarId, ScalarId>,
    ) -> Option<ScalarId> {
        if id == atom {
            return Some(self.scalars.number(1.0));
        }
        if !self.scalars.varies(id) {
            return Some(self.scalars.number(0.0));
        }
        if let Some(known) = known.get(&id) {
            return Some(*known);
        }
        let mut sum = self.scalars.number(0.0);
        match self.scalars.get(id).clone() {
            ScalarForm::Sum(terms, _) => {
                self.scalars.spend_products(terms.len())?;
                for (term, by) in terms {
                    let part = self.derivative(term, atom, known)?;
                    sum = self.scalars.combine((sum, 1.0), (part, by.get()));
                }
            }
            ScalarForm::Product(factors) => {
                self.scalars.spend_products(factors.len() * 2)?;
                for (at, (factor, power)) in factors.iter().enumerate() {
                    let inner = self.derivative(*factor, atom, known)?;
                    let mut rest = factors.clone();
                    if let Some((_, own)) = rest.get_mut(at) {
                        *own -= 1;
                    }
                    let rest = self.scalars.product(rest, f64::from(*power));
                    let part = self.scalars.multiply(rest, inner);
                    sum = self.scalars.add(sum, part);
                }
            }
            _ => {}
        }
        known.insert(id, sum);
        Some(sum)
    }

    /// A better bound for a polynomial, if there is one: by the frame that it belongs to, or by its
    /// partial derivatives, in which terms cancel.
    pub fn improved(
        &mut self,
        id: ScalarId,
        plain: FieldGradient,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        if let Some(row) = self.frames.row(id).cloned() {
            let mut rows = Vec::new();
            for atom in &row.atoms {
                rows.push(self.gradient(*atom, given, memo, depth));
            }
            let rows: Vec<&FieldGradient> = rows.iter().collect();
            let norm = self.norm_of_rows(&rows) * row.norm;
            if norm.is_finite() && norm <= plain.norm * (1.0 + 1e-5) {
                let mut support: Vec<u32> =
                    rows.iter().flat_map(|r| &r.parts).map(|p| p.0).collect();
                support.sort_unstable();
                support.dedup();
                let own = self.generators.of(row.frame, row.index, support);
                return FieldGradient {
                    parts: vec![(own, RealSpan::within(norm))],
                    norm,
                };
            }
        }
        if plain.norm == 0.0 || !self.scalars.is_shallow(id) {
            return plain;
        }
        let resolved = self.resolve(id, given, memo, depth);
        if !self.scalars.is_shallow(resolved) {
            return plain;
        }
        let mut best = plain;
        for partials in self.partials(resolved) {
            let made = self.chain(partials, given, memo, depth);
            if made.norm < best.norm {
                best = made;
            }
        }
        best
    }

    /// The chain rule: the gradients of atoms, times the partial derivatives.
    pub fn chain(
        &mut self,
        partials: Vec<(ScalarId, ScalarId)>,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        let mut terms = Vec::new();
        for (atom, partial) in partials {
            let gradient = self.gradient(atom, given, memo, depth);
            if gradient.norm > 0.0 {
                terms.push((gradient, partial));
            }
        }
        let mut sum = FieldGradient::ZERO;
        for (gradient, partial) in &terms {
            let by = self.span(*partial, given, memo, depth);
            sum = sum.add(&gradient.scale(by));
        }
        sum.norm = sum.norm.min(self.generators.norm(&[&sum]));
        if let Some(blend) = self.blend(&terms, given, memo, depth)
            && blend.norm < sum.norm
        {
            sum = blend;
        }
        sum
    }

    /// The sum of gradients with factors that are linear in one number: it is greatest at an end of
    /// the range of that number.
    fn blend(
        &mut self,
        terms: &[(FieldGradient, ScalarId)],
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> Option<FieldGradient> {
        let mut number = None;
        let mut factors = Vec::new();
        for (gradient, partial) in terms {
            let (by, key, constant) = self.key(*partial);
            if by != 0.0 {
                if number.is_some_and(|known| known != key) {
                    return None;
                }
                number = Some(key);
            }
            factors.push((gradient, by, constant));
        }
        let mut range = self.span(number?, given, memo, depth);
        for (_, partial) in terms {
            let (by, _, constant) = self.key(*partial);
            if by != 0.0 {
                let own = self.span(*partial, given, memo, depth);
                range = range.meet(own.add(RealSpan::of(-constant)).scale(1.0 / by));
            }
        }
        if range.is_empty() {
            return None;
        }
        if !range.most().is_finite() {
            return None;
        }
        let at = |value: f64| {
            let each = factors.iter().map(|(gradient, by, constant)| {
                gradient.scale(RealSpan::of(by * value + constant))
            });
            each.fold(FieldGradient::ZERO, |sum, term| sum.add(&term))
        };
        let ends = [range.lo, range.hi].map(|end| {
            let mut sum = at(end);
            sum.norm = sum.norm.min(self.generators.norm(&[&sum]));
            sum
        });
        let [first, second] = &ends;
        Some(first.hull(second))
    }
}
