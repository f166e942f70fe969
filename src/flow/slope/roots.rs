//! Square roots and logarithms: their slopes are bounded by what is below them as a whole, not by its
//! slope and its least value.

use super::assumptions::SlopeAssumptions;
use super::bound::{CaseMemo, GradientBounds, MAX_NESTING};
use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::gradient::FieldGradient;
use super::interval::RealSpan;
use rustc_hash::FxHashMap;

impl GradientBounds<'_> {
    /// The numbers of which a node is the sum of squares: factors and nodes. Constants are left out.
    pub fn squares(&self, id: ScalarId) -> Option<Vec<(f64, ScalarId)>> {
        let square = |id: ScalarId, by: f64| match self.scalars.get(id) {
            ScalarForm::Product(factors) => match factors.as_slice() {
                [(factor, 2)] if by >= 0.0 => Some((by.sqrt(), *factor)),
                _ => None,
            },
            _ => None,
        };
        match self.scalars.get(id) {
            ScalarForm::Sum(terms, constant) if constant.get() >= 0.0 => {
                let mut rows = Vec::new();
                for (term, by) in terms {
                    if self.scalars.varies(*term) {
                        rows.push(square(*term, by.get())?);
                    } else if by.get() < 0.0 || self.scalars.span(*term).lo < 0.0 {
                        return None;
                    }
                }
                Some(rows)
            }
            ScalarForm::Product(_) => Some(vec![square(id, 1.0)?]),
            _ => None,
        }
    }

    /// An upper bound of the slope of a positive number divided by the number.
    pub fn log_slope(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> f64 {
        let span = self.span(id, given, memo, depth);
        if depth > MAX_NESTING {
            return f64::INFINITY;
        }
        let plain = match span.lo > 0.0 {
            true => self.gradient(id, given, memo, depth).norm / span.lo,
            false => f64::INFINITY,
        };
        if !self.scalars.varies(id) {
            return 0.0;
        }
        let ratio = match self.scalars.get(id).clone() {
            ScalarForm::Of(ScalarFunction::Exp, a) => self.gradient(a, given, memo, depth).norm,
            ScalarForm::Sum(terms, constant) if constant.get() >= 0.0 => {
                let mut most = 0.0f64;
                for (term, by) in terms {
                    let is_positive = self.span(term, given, memo, depth).lo >= 0.0;
                    if by.get() < 0.0 || !is_positive {
                        return plain;
                    }
                    most = most.max(self.log_slope(term, given, memo, depth + 1));
                }
                most
            }
            ScalarForm::Product(factors) => {
                let mut sum = 0.0;
                for (factor, power) in factors {
                    let ratio = self.log_slope(factor, given, memo, depth + 1);
                    sum += ratio * f64::from(power.abs());
                }
                sum
            }
            ScalarForm::Power(a, b) => {
                let by = self.span(b, given, memo, depth).most();
                match self.scalars.varies(b) {
                    true => f64::INFINITY,
                    false => self.log_slope(a, given, memo, depth + 1) * by,
                }
            }
            _ => f64::INFINITY,
        };
        ratio.min(plain)
    }

    pub fn square_root(
        &mut self,
        id: ScalarId,
        a: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        let Some(rows) = self.squares(a) else {
            let slope = self.root_slope(a, given, memo, depth);
            let of = self.gradient(a, given, memo, depth);
            return self.direction(id, &[&of], slope);
        };
        let mut gradients = Vec::new();
        for &(by, row) in &rows {
            let row = self.gradient(row, given, memo, depth);
            gradients.push(row.scale(RealSpan::of(by)));
        }
        gradients.retain(|row| row.norm > 0.0);
        let plain = self.norm_of_rows(&gradients.iter().collect::<Vec<_>>());
        let most = gradients
            .iter()
            .fold(0.0f64, |most, row| most.max(row.norm));
        if plain > most * (1.0 + 1e-6) || !plain.is_finite() {
            let others = self.stationary(a, &rows, given, memo, depth);
            if self.norm_of_rows(&others.iter().collect::<Vec<_>>()) < plain {
                gradients = others;
            }
        }
        let rows: Vec<&FieldGradient> = gradients.iter().collect();
        if let [only] = rows.as_slice() {
            return only.scale(RealSpan::within(1.0));
        }
        let norm = self.norm_of_rows(&rows);
        self.direction(id, &rows, norm)
    }

    /// The gradients of the rows of a sum of squares, without the nodes on which the sum does not depend
    /// because it is least or greatest there: the position of the nearest point of a segment.
    fn stationary(
        &mut self,
        square: ScalarId,
        rows: &[(f64, ScalarId)],
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> Vec<FieldGradient> {
        let mut frozen = Vec::new();
        let atoms = match self.scalars.is_shallow(square) {
            true => self.atoms(square),
            false => None,
        };
        for atom in atoms.into_iter().flatten() {
            if matches!(self.scalars.get(atom), ScalarForm::Coordinate(_)) {
                continue;
            }
            let derivative = self.derivative(square, atom, &mut FxHashMap::default());
            let Some(derivative) = derivative else {
                break;
            };
            let derivative = self.resolve(derivative, given, memo, depth);
            if self.scalars.is_zero(derivative) {
                frozen.push(atom);
            }
        }
        let mut gradients = Vec::new();
        if frozen.is_empty() {
            gradients.push(FieldGradient::unknown());
            return gradients;
        }
        for (by, row) in rows {
            let Some(partials) = self.written_partials(*row) else {
                return vec![FieldGradient::unknown()];
            };
            let partials = partials
                .into_iter()
                .filter(|(atom, _)| !frozen.contains(atom));
            let gradient = self.chain(partials.collect(), given, memo, depth);
            gradients.push(gradient.scale(RealSpan::of(*by)));
        }
        gradients.retain(|row| row.norm > 0.0);
        gradients
    }

    /// A number `k` so that the slope of a node is at most `2 k` times its square root.
    fn root_slope(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> f64 {
        if !self.scalars.varies(id) {
            return 0.0;
        }
        if depth > MAX_NESTING {
            return f64::INFINITY;
        }
        let least = self.span(id, given, memo, depth).lo;
        let plain = match least > 0.0 {
            true => self.gradient(id, given, memo, depth).norm / (2.0 * least.sqrt()),
            false => f64::INFINITY,
        };
        let other = match self.scalars.get(id).clone() {
            ScalarForm::Min(a, b) | ScalarForm::Max(a, b) | ScalarForm::Select(_, a, b) => {
                let first = self.root_slope(a, given, memo, depth + 1);
                first.max(self.root_slope(b, given, memo, depth + 1))
            }
            ScalarForm::Sum(terms, constant) if constant.get() >= 0.0 => {
                let mut sum = 0.0;
                for (term, by) in terms {
                    let is_positive = self.span(term, given, memo, depth).lo >= 0.0;
                    if by.get() < 0.0 || !is_positive {
                        return plain;
                    }
                    let slope = self.root_slope(term, given, memo, depth + 1);
                    sum += by.get() * slope * slope;
                }
                sum.sqrt()
            }
            ScalarForm::Product(factors) => match factors.as_slice() {
                [(factor, 2)] => self.gradient(*factor, given, memo, depth).norm,
                _ => f64::INFINITY,
            },
            _ => f64::INFINITY,
        };
        other.min(plain)
    }
}
