//! Joints: whether two expressions are equal on the surface where a condition changes.
//!
//! `sign(s) * sqrt(min(dot(a, a), dot(b, b)))` is continuous if the minimum is zero wherever `s` is: at
//! the border of a shape. So is a choice between a face and an edge, if both distances are the same where
//! the choice changes. In general, a function with a condition `g < 0` is continuous there if its
//! expressions for both sides are equal where `g` is zero.
//!
//! This is decided by cases. Where `g` is zero and linear in a node, that node is replaced. Minima,
//! magnitudes and conditions are replaced by one of their sides, where the linear inequalities of the
//! case imply which; otherwise the case is split. What is left are polynomials over roots and other
//! nodes, which are compared.
//!
//! Why other conditions may be taken as they are on the surface: where surfaces cross, both are left
//! within any neighbourhood, and equality holds in the limit. The argument of a condition that changes on
//! the very same surface is zero in the whole case: then all combinations must be equal.

use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::interval::RealSpan;
use super::linear::{Inequality, implies, is_sum_of_squares};
use super::node::Scalars;
use super::polynomial::NodePolynomial;
use rustc_hash::FxHashMap;

/// Most nested cases.
const MAX_DEPTH: u32 = 16;
/// How much the coefficients of equal polynomials may differ: constants are written with five digits.
const TOLERANCE: f64 = 2e-5;

/// What is known of a case.
#[derive(Clone, Default)]
struct WallCase {
    /// Linear over nodes and products of nodes.
    known: Vec<Inequality>,
    /// An expression that is zero, of which nothing was replaced yet.
    zero: Option<ScalarId>,
    /// A node that is an integer.
    integer: Option<ScalarId>,
}

/// The expressions that are compared.
pub(super) struct WallProof<'s> {
    scalars: &'s mut Scalars,
    left: &'s mut u32,
    /// Square roots that are known, with what is below them.
    roots: Vec<(ScalarId, NodePolynomial)>,
}

/// What is known of the sign of a node.
#[derive(Clone, Copy, PartialEq)]
struct KnownSign {
    is_above: bool,
    is_below: bool,
}

impl<'s> WallProof<'s> {
    pub fn new(scalars: &'s mut Scalars, left: &'s mut u32) -> WallProof<'s> {
        WallProof {
            scalars,
            left,
            roots: Vec::new(),
        }
    }

    /// Whether two expressions are equal where another one is zero, and a node is an integer.
    pub fn joins(
        &mut self,
        sides: [ScalarId; 2],
        zero: ScalarId,
        integer: Option<ScalarId>,
    ) -> bool {
        let case = WallCase {
            zero: Some(zero),
            integer,
            ..WallCase::default()
        };
        self.are_equal(sides, case, MAX_DEPTH)
    }

    fn are_equal(&mut self, sides: [ScalarId; 2], mut case: WallCase, depth: u32) -> bool {
        if *self.left == 0 || self.scalars.is_full() {
            return false;
        }
        let mut sides = sides;
        if let Some(zero) = case.zero {
            let zero = self.simplified(zero, &case, None);
            case.zero = Some(zero);
            if self.open_sign(&[zero]).is_none() {
                case.zero = None;
                match self.solved(zero, &mut case) {
                    Some(swap) => sides = sides.map(|side| self.simplified(side, &case, swap)),
                    None => return true,
                }
            }
        }
        if case.zero.is_none() {
            sides = sides.map(|side| self.simplified(side, &case, None));
            let [a, b] = sides;
            if self.is_about(a, b) {
                return true;
            }
        }
        let [a, b] = sides;
        let open = match case.zero {
            Some(zero) => self.open_sign(&[zero]),
            None => self.open_sign(&[a, b]),
        };
        match open.zip(depth.checked_sub(1)) {
            Some((node, depth)) => self.split(node, sides, case, depth),
            None => false,
        }
    }

    /// Whether two expressions are equal in both cases of a sign.
    fn split(&mut self, node: ScalarId, sides: [ScalarId; 2], case: WallCase, depth: u32) -> bool {
        let Some(of) = self.sign_argument(node) else {
            return false;
        };
        let is_condition = matches!(self.scalars.get(node), ScalarForm::IsNegative(_));
        let sign = self.sign(of, &case);
        if is_condition && sign.is_above && sign.is_below {
            return self.are_equal_for_all(node, sides, case, depth);
        }
        if let Some([below, above]) = self.integer_sides(of, &case) {
            let mut is_equal = true;
            for half in [below, above] {
                is_equal = is_equal && self.are_equal(sides, half, depth);
            }
            return is_equal;
        }
        let Some(row) = self.row(of) else {
            return false;
        };
        [row.negated(), row].into_iter().all(|row| {
            let mut half = case.clone();
            half.known.push(row);
            self.are_equal(sides, half, depth)
        })
    }

    /// Whether two expressions are equal, whatever a condition is that changes on the same surface.
    fn are_equal_for_all(
        &mut self,
        node: ScalarId,
        sides: [ScalarId; 2],
        case: WallCase,
        depth: u32,
    ) -> bool {
        let truths = [true, false].map(|is| self.scalars.truth(is));
        let [[a, b], [c, d]] =
            sides.map(|side| truths.map(|is| self.simplified(side, &case, Some((node, is)))));
        let pairs = [[a, c], [a, d], [b, c]];
        pairs
            .into_iter()
            .all(|pair| self.are_equal(pair, case.clone(), depth))
    }

    /// The cases of a sign of a multiple of the integer and a constant.
    fn integer_sides(&mut self, of: ScalarId, case: &WallCase) -> Option<[WallCase; 2]> {
        let integer = case.integer?;
        let row = self.row(of)?;
        let [(node, by)] = row.factors.iter().collect::<Vec<_>>()[..] else {
            return None;
        };
        if *node != integer {
            return None;
        }
        let root = -row.constant / by;
        // Above or at the root, and below it.
        let first = (root - 1e-6).ceil();
        let bound = |factor: f64, constant: f64| Inequality {
            factors: [(integer, factor)].into(),
            constant,
        };
        let mut halves = [case.clone(), case.clone()];
        let bounds = [bound(1.0, -first), bound(-1.0, first - 1.0)];
        for (half, bound) in halves.iter_mut().zip(bounds) {
            half.known.push(bound);
            let ends = |by: f64| {
                let rows = half.known.iter();
                let own = rows.filter(|row| row.factors.len() == 1);
                let ends = own.filter_map(|row| Some((row.factors.get(&integer)?, row.constant)));
                let ends = ends.filter(|(own, _)| **own * by > 0.0);
                ends.map(|(own, constant)| -constant / own)
                    .collect::<Vec<f64>>()
            };
            let lo = ends(1.0).into_iter().fold(f64::NEG_INFINITY, f64::max);
            let hi = ends(-1.0).into_iter().fold(f64::INFINITY, f64::min);
            if lo == hi && half.zero.is_none() {
                let value = self.scalars.number(lo);
                half.zero = Some(self.scalars.subtract(integer, value));
            }
        }
        Some(halves)
    }

    /// Adds to a case that an expression is zero. Returns the node that is replaced, and by what;
    /// `None` if the case is impossible.
    fn solved(
        &mut self,
        zero: ScalarId,
        case: &mut WallCase,
    ) -> Option<Option<(ScalarId, ScalarId)>> {
        let Some(row) = self.row(zero) else {
            return Some(None);
        };
        let both = [row.clone(), row.negated()];
        if both.iter().any(|row| self.contradicts(row, case)) {
            return None;
        }
        case.known.extend(both);
        let Some(polynomial) = NodePolynomial::of(self.scalars, zero) else {
            return Some(None);
        };
        let mut candidates = Vec::new();
        for atom in polynomial.atoms() {
            let partial = polynomial.partial(atom);
            let by = partial.0.get(&Vec::new()).copied();
            let is_linear = partial.0.len() == 1 && self.scalars.varies(atom);
            if let Some(by) = by.filter(|by| is_linear && by.abs() > 1e-9) {
                let is_plain = matches!(self.scalars.get(atom), ScalarForm::Coordinate(_));
                candidates.push((!is_plain, by, atom));
            }
        }
        // The one that is multiplied by most, so that the rest is small.
        let best = candidates.into_iter().min_by(|a, b| {
            let by_form = a.0.cmp(&b.0);
            by_form.then(b.1.abs().total_cmp(&a.1.abs()))
        });
        Some(best.map(|(_, by, atom)| {
            let mut rest = polynomial.clone();
            rest.0.remove(&vec![(atom, 1)]);
            let rest = rest.node(self.scalars);
            (atom, self.scalars.scale(rest, -1.0 / by))
        }))
    }

    fn contradicts(&mut self, row: &Inequality, case: &WallCase) -> bool {
        let mut against = row.negated().scaled();
        against.constant -= 1e-5;
        self.is_implied(&against, case)
    }

    /// An expression with all that the case decides.
    fn simplified(
        &mut self,
        root: ScalarId,
        case: &WallCase,
        swap: Option<(ScalarId, ScalarId)>,
    ) -> ScalarId {
        let mut made: FxHashMap<ScalarId, ScalarId> = FxHashMap::default();
        for node in self.scalars.below(root) {
            *self.left = self.left.saturating_sub(1);
            if *self.left == 0 {
                return root;
            }
            let of = |id: ScalarId| made.get(&id).copied().unwrap_or(id);
            let mut is_new = false;
            self.scalars
                .each(node, |operand| is_new |= of(operand) != operand);
            let new = match swap {
                Some((old, new)) if old == node => new,
                _ if is_new => self.scalars.remake(node, of),
                _ => node,
            };
            let new = self.decided(new, case);
            made.insert(node, new);
        }
        made.get(&root).copied().unwrap_or(root)
    }

    /// A node as the side of it that the case decides on.
    fn decided(&mut self, node: ScalarId, case: &WallCase) -> ScalarId {
        if let ScalarForm::Of(ScalarFunction::Sqrt, of) = *self.scalars.get(node) {
            return self.root(node, of, case);
        }
        let Some(of) = self.sign_argument(node) else {
            return node;
        };
        let sign = self.sign(of, case);
        match (self.scalars.get(node), sign.is_above, sign.is_below) {
            (_, false, false) => node,
            (ScalarForm::Min(a, _) | ScalarForm::Max(_, a), _, true) => *a,
            (ScalarForm::Min(_, b) | ScalarForm::Max(b, _), ..) => *b,
            (ScalarForm::Of(..), true, _) => of,
            (ScalarForm::Of(..), ..) => self.scalars.negate(of),
            (ScalarForm::IsNegative(_), true, false) => self.scalars.truth(false),
            (ScalarForm::IsNegative(_), false, true) => self.scalars.truth(true),
            _ => node,
        }
    }

    /// The number on whose sign a node depends.
    fn sign_argument(&mut self, node: ScalarId) -> Option<ScalarId> {
        match *self.scalars.get(node) {
            ScalarForm::Min(a, b) | ScalarForm::Max(a, b) => Some(self.scalars.subtract(a, b)),
            ScalarForm::Of(ScalarFunction::Abs, of) | ScalarForm::IsNegative(of) => Some(of),
            _ => None,
        }
    }

    /// The innermost node that depends on an open sign, of one side rather than of both.
    fn open_sign(&mut self, sides: &[ScalarId]) -> Option<ScalarId> {
        let mut found: Vec<Vec<ScalarId>> = Vec::new();
        for side in sides {
            let all = self.scalars.below(*side).into_iter();
            let open = all.filter(|id| {
                self.scalars.varies(*id) && {
                    let form = self.scalars.get(*id);
                    matches!(
                        form,
                        ScalarForm::Min(..)
                            | ScalarForm::Max(..)
                            | ScalarForm::Of(ScalarFunction::Abs, _)
                            | ScalarForm::IsNegative(_)
                    )
                }
            });
            found.push(open.collect());
        }
        let count = |id: &ScalarId| found.iter().filter(|all| all.contains(id)).count();
        let all = found.iter().flatten();
        all.min_by_key(|id| (count(id), **id)).copied()
    }

    /// A square root: the magnitude of what is squared, or a multiple of a root that is known.
    fn root(&mut self, node: ScalarId, of: ScalarId, case: &WallCase) -> ScalarId {
        let Some(polynomial) = NodePolynomial::of(self.scalars, of) else {
            return node;
        };
        if polynomial.0.values().all(|by| by.abs() < 1e-9) {
            return self.scalars.number(0.0);
        }
        for (known, square) in &self.roots {
            if let Some(by) = ratio(&polynomial, square) {
                return self.scalars.scale(*known, by.sqrt());
            }
        }
        if let Some(linear) = self.squared(&polynomial) {
            let made = self.scalars.of(ScalarFunction::Abs, linear);
            return self.decided(made, case);
        }
        self.roots.push((node, polynomial));
        node
    }

    /// The sum of which a polynomial is the square.
    fn squared(&mut self, polynomial: &NodePolynomial) -> Option<ScalarId> {
        let squares = polynomial.0.iter().filter_map(|(monomial, by)| {
            let [(atom, 2)] = monomial.as_slice() else {
                return None;
            };
            Some((*atom, *by))
        });
        let (atom, by) = squares.max_by(|a, b| a.1.total_cmp(&b.1))?;
        if by <= 1e-12 {
            return None;
        }
        let first = by.sqrt();
        let mut rest = NodePolynomial::default();
        for (monomial, by) in &polynomial.0 {
            if let Some(at) = monomial
                .iter()
                .position(|(id, power)| *id == atom && *power == 1)
            {
                let mut other = monomial.clone();
                other.remove(at);
                rest.0.insert(other, by / (2.0 * first));
            }
        }
        rest.0.insert(vec![(atom, 1)], first);
        let square = rest.product(self.scalars, &rest)?;
        let made = rest.node(self.scalars);
        is_near(polynomial, &square).then_some(made)
    }

    /// A polynomial as a linear sum of its monomials.
    fn row(&mut self, id: ScalarId) -> Option<Inequality> {
        let polynomial = NodePolynomial::of(self.scalars, id)?;
        let mut row = Inequality {
            factors: Default::default(),
            constant: 0.0,
        };
        for (monomial, by) in &polynomial.0 {
            if monomial.is_empty() {
                row.constant += by;
                continue;
            }
            let node = self.scalars.product(monomial.clone(), 1.0);
            *row.factors.entry(node).or_insert(0.0) += by;
        }
        Some(row)
    }

    fn is_implied(&mut self, row: &Inequality, case: &WallCase) -> bool {
        *self.left = self.left.saturating_sub(16);
        let mut rows = case.known.clone();
        let used = rows.iter().chain([row]).flat_map(|row| row.factors.keys());
        let mut nodes: Vec<ScalarId> = used.copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        for node in nodes {
            let RealSpan { lo, hi } = self.scalars.span(node);
            for (by, end) in [(1.0, -lo), (-1.0, hi)] {
                if end.is_finite() {
                    rows.push(Inequality {
                        factors: [(node, by)].into(),
                        constant: end,
                    });
                }
            }
        }
        implies(&rows, row)
    }

    fn sign(&mut self, of: ScalarId, case: &WallCase) -> KnownSign {
        let span = self.scalars.span(of);
        let mut sign = KnownSign {
            is_above: span.lo >= 0.0,
            is_below: span.hi <= 0.0,
        };
        if !self.scalars.varies(of) && case.known.is_empty() {
            return sign;
        }
        if let Some(squares) = self.compared_roots(of) {
            return self.sign(squares, case);
        }
        let Some(row) = self.row(of) else {
            return sign;
        };
        let negated = row.negated();
        sign.is_above = sign.is_above || self.is_implied(&row, case);
        sign.is_below = sign.is_below || self.is_implied(&negated, case);
        if sign.is_above || sign.is_below {
            return sign;
        }
        if let Some(polynomial) = NodePolynomial::of(self.scalars, of) {
            let least = self.least_parabola(&polynomial, case, 1.0);
            sign.is_above = least.unwrap_or_else(|| is_sum_of_squares(&polynomial, 1.0));
            let least = self.least_parabola(&polynomial, case, -1.0);
            sign.is_below = least.unwrap_or_else(|| is_sum_of_squares(&polynomial, -1.0));
        }
        sign
    }

    /// A difference of two square roots as the difference of what is below them, with the same sign.
    fn compared_roots(&mut self, of: ScalarId) -> Option<ScalarId> {
        let ScalarForm::Sum(terms, constant) = self.scalars.get(of) else {
            return None;
        };
        let [(a, x), (b, y)] = terms[..] else {
            return None;
        };
        let (x, y) = (x.get(), y.get());
        if constant.get() != 0.0 || x * y >= 0.0 {
            return None;
        }
        let below = |id: ScalarId| match *self.scalars.get(id) {
            ScalarForm::Of(ScalarFunction::Sqrt, of) => Some(of),
            _ => None,
        };
        let first = below(a);
        let second = below(b);
        if first.is_none() && second.is_none() {
            return None;
        }
        let is_positive = |id: ScalarId| self.scalars.span(id).lo >= 0.0;
        if !is_positive(a) || !is_positive(b) {
            return None;
        }
        let first = first.unwrap_or_else(|| self.scalars.multiply(a, a));
        let second = second.unwrap_or_else(|| self.scalars.multiply(b, b));
        Some(
            self.scalars
                .combine((first, x * x.abs()), (second, y * y.abs())),
        )
    }

    /// Whether a polynomial of one node with a degree of two is positive over the range of that node.
    fn least_parabola(&mut self, p: &NodePolynomial, case: &WallCase, sign: f64) -> Option<bool> {
        let [atom] = p.atoms()[..] else {
            return None;
        };
        let at = |power: i32| match power {
            0 => p.0.get(&Vec::new()).copied().unwrap_or(0.0) * sign,
            _ => p.0.get(&vec![(atom, power)]).copied().unwrap_or(0.0) * sign,
        };
        if p.0
            .keys()
            .flatten()
            .any(|(_, power)| !(1..=2).contains(power))
        {
            return None;
        }
        let mut range = self.scalars.span(atom);
        for row in case.known.iter().filter(|row| row.factors.len() == 1) {
            if let Some(by) = row.factors.get(&atom) {
                let end = -row.constant / by;
                range = range.meet(match *by > 0.0 {
                    true => RealSpan::new(end, f64::INFINITY),
                    false => RealSpan::new(f64::NEG_INFINITY, end),
                });
            }
        }
        let (square, linear, constant) = (at(2), at(1), at(0));
        let value = |x: f64| (square * x + linear) * x + constant;
        let lowest = -linear / (2.0 * square);
        let mut points = vec![range.lo, range.hi];
        if square > 0.0 {
            points = vec![lowest.clamp(range.lo.min(range.hi), range.hi.max(range.lo))];
        }
        let least = points.into_iter().map(|x| match x.is_finite() {
            true => value(x),
            false => f64::NEG_INFINITY,
        });
        Some(least.fold(f64::INFINITY, f64::min) >= -1e-6)
    }

    /// Whether two expressions are equal up to the rounding of constants.
    fn is_about(&mut self, a: ScalarId, b: ScalarId) -> bool {
        if a == b {
            return true;
        }
        let forms = [a, b].map(|id| NodePolynomial::of(self.scalars, id));
        match forms {
            [Some(a), Some(b)] => is_near(&a, &b),
            _ => false,
        }
    }
}

/// Whether the coefficients of two polynomials are equal up to rounding.
fn is_near(a: &NodePolynomial, b: &NodePolynomial) -> bool {
    let all = a.0.values().chain(b.0.values());
    let most = all.fold(1.0f64, |most, by| most.max(by.abs()));
    let mut keys = a.0.keys().chain(b.0.keys());
    keys.all(|key| {
        let of = |p: &NodePolynomial| p.0.get(key).copied().unwrap_or(0.0);
        (of(a) - of(b)).abs() <= most * TOLERANCE
    })
}

/// The positive number by which a polynomial is a multiple of another.
fn ratio(a: &NodePolynomial, b: &NodePolynomial) -> Option<f64> {
    let greatest = b.0.iter().max_by(|x, y| x.1.abs().total_cmp(&y.1.abs()))?;
    let by = a.0.get(greatest.0)? / greatest.1;
    let scaled = NodePolynomial(b.0.iter().map(|(m, own)| (m.clone(), own * by)).collect());
    (by > 0.0 && is_near(a, &scaled)).then_some(by)
}
