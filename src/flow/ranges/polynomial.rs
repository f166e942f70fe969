//! Values as polynomials, to apply a condition to a different expression of the same values:
//! `dot(p, p) < 1.0` bounds `1.0 - p.x * p.x - p.y * p.y`.

use super::Query;
use super::interval::{Interval, above, below};
use super::node::Node;
use crate::reaching_definitions::Def;
use shaderlint_ir::{Binary, OpId, OpKind, Unary};
use shaderlint_semantic::builtins::Transfer;

/// Maximum number of factors of a term.
const FACTORS: usize = 4;
const MAX_TERMS: usize = 12;
/// Maximum number of operations expanded per query.
const BUDGET: u32 = 40;

/// The factors of a term as node numbers plus one, sorted, padded with 0 at the start.
type Factors = [u32; FACTORS];

/// A sum of products of opaque values, with coefficients.
#[derive(Clone, Default, Debug)]
pub(super) struct Polynomial {
    terms: Vec<(Factors, f64)>,
}

impl Polynomial {
    fn constant(value: f64) -> Polynomial {
        Polynomial {
            terms: vec![([0; FACTORS], value)],
        }
    }

    fn atom(node: Node) -> Polynomial {
        let mut factors = [0; FACTORS];
        factors[FACTORS - 1] = node.0 + 1;
        Polynomial {
            terms: vec![(factors, 1.0)],
        }
    }

    /// `self + by * other`
    fn plus(mut self, other: &Polynomial, by: f64) -> Option<Polynomial> {
        for (factors, weight) in &other.terms {
            self.add(*factors, weight * by);
        }
        (self.terms.len() <= MAX_TERMS).then_some(self)
    }

    fn add(&mut self, factors: Factors, weight: f64) {
        match self.terms.iter_mut().find(|(f, _)| *f == factors) {
            Some((_, sum)) => *sum += weight,
            None => self.terms.push((factors, weight)),
        }
    }

    fn times(&self, other: &Polynomial) -> Option<Polynomial> {
        let mut product = Polynomial::default();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let mut all = [0; 2 * FACTORS];
                let (first, second) = all.split_at_mut(FACTORS);
                first.copy_from_slice(a);
                second.copy_from_slice(b);
                all.sort_unstable();
                let (none, factors) = all.split_at(FACTORS);
                if none.iter().any(|f| *f != 0) {
                    return None;
                }
                product.add(factors.try_into().ok()?, x * y);
            }
        }
        (product.terms.len() <= MAX_TERMS).then_some(product)
    }

    /// The constant term, and the other terms.
    fn without_constant(&self) -> (f64, impl Iterator<Item = &(Factors, f64)>) {
        let is_rest = |term: &&(Factors, f64)| term.0 != [0; FACTORS] && term.1 != 0.0;
        let alone = self.terms.iter().find(|(f, _)| *f == [0; FACTORS]);
        let rest = self.terms.iter().filter(is_rest);
        (alone.map_or(0.0, |(_, v)| *v), rest)
    }

    /// Returns `factor` and `rest` such that `self` is `factor * other + rest`.
    pub(super) fn in_terms_of(&self, other: &Polynomial) -> Option<(f64, f64)> {
        let (own, terms) = self.without_constant();
        let (with, others) = other.without_constant();
        let mut factor = None;
        let mut count = 0;
        for (factors, weight) in terms {
            let (_, found) = other.terms.iter().find(|(f, _)| f == factors)?;
            let ratio = weight / found;
            if !ratio.is_finite() || factor.is_some_and(|f: f64| (f - ratio).abs() > 1e-9) {
                return None;
            }
            factor = Some(ratio);
            count += 1;
        }
        let factor = factor.filter(|_| count == others.count())?;
        Some((factor, own - factor * with))
    }
}

impl Query<'_> {
    /// Narrows a value by a comparison of another expression of the same values.
    pub(super) fn narrow_by_terms(
        &self,
        (left, right): (OpId, OpId),
        relation: Binary,
        own: &Polynomial,
        range: &mut Interval,
    ) {
        let Some(difference) = self.difference(left, right) else {
            return;
        };
        let Some((factor, rest)) = own.in_terms_of(&difference) else {
            return;
        };
        let is_less = matches!(relation, Binary::Less | Binary::LessEqual);
        if !is_less && !matches!(relation, Binary::Greater | Binary::GreaterEqual) {
            return;
        }
        // The comparison is equivalent to one of the difference with zero.
        let is_strict = matches!(relation, Binary::Less | Binary::Greater);
        match (is_less == (factor > 0.0), is_strict) {
            (true, true) => range.lower(below(rest)),
            (true, false) => range.lower(rest),
            (false, true) => range.raise(above(rest)),
            (false, false) => range.raise(rest),
        }
    }

    /// The difference of the two sides of a comparison, or of their squares if one is a length.
    fn difference(&self, left: OpId, right: OpId) -> Option<Polynomial> {
        if let Some(square) = self.squared_length(left) {
            return square.plus(&self.squared_number(right)?, -1.0);
        }
        if let Some(square) = self.squared_length(right) {
            return self.squared_number(left)?.plus(&square, -1.0);
        }
        self.terms(left, 0)?.plus(&self.terms(right, 0)?, -1.0)
    }

    fn squared_number(&self, op: OpId) -> Option<Polynomial> {
        let value = self.lane(op, 0).single().filter(|v| *v >= 0.0)?;
        Some(Polynomial::constant(value * value))
    }

    fn squared_length(&self, op: OpId) -> Option<Polynomial> {
        let Some((made, 0)) = self.made(op, 0) else {
            return None;
        };
        let OpKind::Builtin(function, list) = self.module.op(made).kind else {
            return None;
        };
        let &[of] = self.module.operands(list) else {
            return None;
        };
        let is_length = matches!(function.transfer(), Transfer::Norm);
        let mut left = BUDGET;
        self.dot(of, of, &mut left).filter(|_| is_length)
    }

    /// The operation that a value is a copy of.
    fn made(&self, op: OpId, lane: u32) -> Option<(OpId, u32)> {
        let (mut op, mut lane) = (op, lane);
        for _ in 0..8 {
            let OpKind::Load(_) = self.module.op(op).kind else {
                return Some((op, lane));
            };
            match self.defs.get(self.defs.unrefined(self.defs.seen(op, lane))) {
                Def::Stored { value, lane: at } => (op, lane) = (value, at),
                _ => return None,
            }
        }
        None
    }

    /// A component of a value as a polynomial.
    pub(super) fn terms(&self, op: OpId, lane: u32) -> Option<Polynomial> {
        let mut left = BUDGET;
        self.polynomial(op, lane, &mut left)
    }

    fn polynomial(&self, op: OpId, lane: u32, left: &mut u32) -> Option<Polynomial> {
        *left = left.checked_sub(1)?;
        let (module, defs) = (self.module, self.defs);
        if let Some(value) = self.lane(op, lane).single() {
            return Some(Polynomial::constant(value));
        }
        match module.op(op).kind {
            OpKind::Load(_) => {
                let def = defs.unrefined(defs.seen(op, lane));
                match defs.get(def) {
                    Def::Stored { value, lane } => self.polynomial(value, lane, left),
                    _ => Some(Polynomial::atom(Node::def(defs, def))),
                }
            }
            OpKind::Unary(Unary::Negate, a) => {
                let a = self.polynomial(a, lane, left)?;
                Polynomial::default().plus(&a, -1.0)
            }
            OpKind::Binary(Binary::Add, a, b) => {
                let a = self.polynomial(a, lane, left)?;
                a.plus(&self.polynomial(b, lane, left)?, 1.0)
            }
            OpKind::Binary(Binary::Subtract, a, b) => {
                let a = self.polynomial(a, lane, left)?;
                a.plus(&self.polynomial(b, lane, left)?, -1.0)
            }
            OpKind::Binary(Binary::Multiply, a, b) => {
                let a = self.polynomial(a, lane, left)?;
                a.times(&self.polynomial(b, lane, left)?)
            }
            OpKind::Builtin(function, list) => match (function.transfer(), module.operands(list)) {
                (Transfer::Product, &[a, b]) => self.dot(a, b, left),
                _ => Some(Polynomial::atom(Node::lane(defs, op, lane)?)),
            },
            _ => match defs.part_of(module, op, lane) {
                Some((part, lane)) => self.polynomial(part, lane, left),
                None => Some(Polynomial::atom(Node::lane(defs, op, lane)?)),
            },
        }
    }

    fn dot(&self, a: OpId, b: OpId, left: &mut u32) -> Option<Polynomial> {
        let mut sum = Polynomial::default();
        for lane in 0..self.module.ty(a).components() {
            let x = self.polynomial(a, lane, left)?;
            let y = self.polynomial(b, lane, left)?;
            sum = sum.plus(&x.times(&y)?, 1.0)?;
        }
        Some(sum)
    }
}
