//! Nodes as polynomials: for cancellation, equality and partial derivatives.

use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::node::Scalars;
use std::collections::BTreeMap;

/// Most terms of a polynomial.
const MAX_TERMS: usize = 300;

/// Powers of nodes.
type Monomial = Vec<(ScalarId, i32)>;

/// A sum of multiples of monomials.
#[derive(Clone, Default, Debug)]
pub(super) struct NodePolynomial(pub BTreeMap<Monomial, f64>);

impl NodePolynomial {
    /// A node with its sums multiplied out; `None` if there are too many terms.
    pub fn of(scalars: &Scalars, id: ScalarId) -> Option<NodePolynomial> {
        NodePolynomial::expanded(scalars, id, false)
    }

    /// The same, but factors that do not depend on the point are left as they are, so that they cancel
    /// with their inverses.
    pub fn of_point(scalars: &Scalars, id: ScalarId) -> Option<NodePolynomial> {
        NodePolynomial::expanded(scalars, id, true)
    }

    fn expanded(scalars: &Scalars, id: ScalarId, keeps: bool) -> Option<NodePolynomial> {
        let mut made = NodePolynomial::default();
        if !scalars.is_shallow(id) {
            return None;
        }
        match scalars.get(id) {
            ScalarForm::Const(value) => made.add(Vec::new(), value.get()),
            ScalarForm::Sum(terms, constant) => {
                made.add(Vec::new(), constant.get());
                for (term, by) in terms {
                    for (monomial, own) in NodePolynomial::expanded(scalars, *term, keeps)?.0 {
                        made.add(monomial, own * by.get());
                    }
                }
            }
            ScalarForm::Product(factors) => {
                made.add(Vec::new(), 1.0);
                for (factor, power) in factors {
                    made = made.times(scalars, (*factor, *power), keeps)?;
                }
            }
            _ => made.add(vec![(id, 1)], 1.0),
        }
        (made.0.len() <= MAX_TERMS).then_some(made)
    }

    fn add(&mut self, monomial: Monomial, by: f64) {
        let sum = self.0.entry(monomial).or_insert(0.0);
        let most = sum.abs().max(by.abs());
        *sum += by;
        if sum.abs() <= most * 1e-9 {
            *sum = 0.0;
        }
    }

    fn times(
        self,
        scalars: &Scalars,
        (factor, power): (ScalarId, i32),
        keeps: bool,
    ) -> Option<NodePolynomial> {
        let by = match scalars.get(factor) {
            ScalarForm::Sum(..) if power > 0 && (!keeps || scalars.varies(factor)) => {
                let by = NodePolynomial::expanded(scalars, factor, keeps)?;
                let mut made = self;
                for _ in 0..power {
                    made = made.product(scalars, &by)?.reduced(scalars)?;
                }
                return Some(made);
            }
            _ => NodePolynomial([(vec![(factor, power)], 1.0)].into()),
        };
        self.product(scalars, &by)?.reduced(scalars)
    }

    /// Replaces squares of sines by those of cosines, so that `sin(a)^2 + cos(a)^2` is 1.
    fn reduced(mut self, scalars: &Scalars) -> Option<NodePolynomial> {
        let find = |monomial: &Monomial| {
            monomial
                .iter()
                .find_map(|&(id, power)| match *scalars.get(id) {
                    ScalarForm::Of(ScalarFunction::Sin, angle) if power >= 2 => {
                        Some((id, scalars.cosine(angle)?))
                    }
                    _ => None,
                })
        };
        for _ in 0..MAX_TERMS {
            let found = self.0.keys().find_map(|m| Some((m.clone(), find(m)?)));
            let Some((monomial, (sin, cos))) = found else {
                return Some(self.tidy());
            };
            let by = self.0.remove(&monomial)?;
            let rest = monomial.into_iter().map(|(id, power)| match id == sin {
                true => (id, power - 2),
                false => (id, power),
            });
            let rest: Monomial = rest.filter(|(_, power)| *power != 0).collect();
            let square = NodePolynomial([(vec![(cos, 2)], -by)].into());
            let other = NodePolynomial([(rest.clone(), 1.0)].into()).product(scalars, &square)?;
            self.add(rest, by);
            for (monomial, by) in other.0 {
                self.add(monomial, by);
            }
        }
        None
    }

    pub fn product(&self, scalars: &Scalars, other: &NodePolynomial) -> Option<NodePolynomial> {
        scalars.spend_products(self.0.len() * other.0.len())?;
        let mut made = NodePolynomial::default();
        for (a, by) in &self.0 {
            for (b, other) in &other.0 {
                let mut both = a.clone();
                for (id, power) in b {
                    match both.iter_mut().find(|(known, _)| known == id) {
                        Some((_, known)) => *known += power,
                        None => both.push((*id, *power)),
                    }
                }
                both.retain(|(_, power)| *power != 0);
                both.sort_unstable();
                made.add(both, by * other);
            }
            if made.0.len() > MAX_TERMS {
                return None;
            }
        }
        Some(made.tidy())
    }

    fn tidy(mut self) -> NodePolynomial {
        self.0.retain(|_, by| *by != 0.0);
        self
    }

    /// The node of a polynomial.
    pub fn node(&self, scalars: &mut Scalars) -> ScalarId {
        let (mut terms, mut constant) = (Vec::new(), 0.0);
        for (monomial, by) in &self.0 {
            if monomial.is_empty() {
                constant += by;
                continue;
            }
            let node = scalars.product(monomial.clone(), 1.0);
            terms.push((node, *by));
        }
        let mut sum = scalars.number(constant);
        for term in terms {
            sum = scalars.combine((sum, 1.0), term);
        }
        sum
    }

    /// The nodes that the monomials consist of.
    pub fn atoms(&self) -> Vec<ScalarId> {
        let all = self.0.keys().flatten().map(|(id, _)| *id);
        let mut atoms: Vec<ScalarId> = all.collect();
        atoms.sort_unstable();
        atoms.dedup();
        atoms
    }

    /// The partial derivative with respect to an atom.
    pub fn partial(&self, atom: ScalarId) -> NodePolynomial {
        let mut made = NodePolynomial::default();
        for (monomial, by) in &self.0 {
            let Some((_, power)) = monomial.iter().find(|(id, _)| *id == atom) else {
                continue;
            };
            let rest = monomial.iter().map(|(id, own)| match *id == atom {
                true => (*id, own - 1),
                false => (*id, *own),
            });
            let rest = rest.filter(|(_, power)| *power != 0).collect();
            made.add(rest, by * f64::from(*power));
        }
        made.tidy()
    }
}

impl Scalars {
    /// Whether two nodes are equal as polynomials.
    pub fn is_same(&mut self, a: ScalarId, b: ScalarId) -> bool {
        if a == b {
            return true;
        }
        let difference = self.subtract(a, b);
        let forms = [NodePolynomial::of, NodePolynomial::of_point];
        forms.into_iter().any(|form| {
            let rest = form(self, difference);
            rest.is_some_and(|rest| rest.0.values().all(|by| by.abs() <= 1e-6))
        })
    }

    /// Whether a node is zero, with its fractions brought to a common denominator.
    pub fn is_zero(&mut self, id: ScalarId) -> bool {
        let Some(polynomial) = NodePolynomial::of(self, id) else {
            return false;
        };
        let mut below: BTreeMap<ScalarId, i32> = BTreeMap::new();
        for (factor, power) in polynomial.0.keys().flatten() {
            let known = below.entry(*factor).or_insert(0);
            *known = (*known).max(-power);
        }
        below.retain(|_, power| *power > 0);
        let denominator = NodePolynomial([(below.into_iter().collect(), 1.0)].into());
        let Some(above) = polynomial.product(self, &denominator) else {
            return false;
        };
        let above = above.node(self);
        let rest = NodePolynomial::of(self, above);
        rest.is_some_and(|rest| rest.0.values().all(|by| by.abs() <= 1e-7))
    }

    /// A node as `factor * key + constant`, where nodes that differ by a factor and a constant have the
    /// same key.
    pub fn key(&mut self, id: ScalarId) -> (f64, ScalarId, f64) {
        let expanded = match self.get(id) {
            ScalarForm::Sum(..) => NodePolynomial::of_point(self, id).map(|p| p.tidy()),
            _ => None,
        };
        let node = expanded.map_or(id, |p| p.node(self));
        let (terms, constant) = match self.get(node) {
            ScalarForm::Const(value) => return (0.0, node, value.get()),
            ScalarForm::Sum(terms, constant) => (terms.clone(), constant.get()),
            _ => return (1.0, node, 0.0),
        };
        let by = terms.first().map_or(1.0, |(_, by)| by.get());
        let terms = terms.into_iter().map(|(term, own)| {
            // Rounded, so that equal keys are equal.
            let own = own.get() / by;
            (term, f64::from(own as f32))
        });
        let key = self.sum(terms.collect(), 0.0);
        (by, key, constant)
    }
}
