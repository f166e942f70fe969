//! The values of a function as scalar expressions: sums, products and functions of coordinates.
//!
//! Nodes are interned and simplified when they are made, so that equal expressions mostly have equal
//! ids. Operands have smaller ids than what is made of them.

use super::form::{ScalarBits, ScalarForm, ScalarFunction, ScalarId};
use super::interval::RealSpan;
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_ir::OpId;
use std::cell::Cell;

/// Most nodes of a function.
const MAX_SCALARS: usize = 40_000;
/// The deepest nesting of sums and products that is treated as a polynomial.
const MAX_HEIGHT: u32 = 40;
/// The highest power of a sum that stays a product.
const MAX_POWER: i32 = 64;

/// All nodes of a function.
pub(super) struct Scalars {
    all: Vec<ScalarForm>,
    ids: FxHashMap<ScalarForm, ScalarId>,
    /// By node: whether it depends on the point.
    varies: Vec<bool>,
    /// By node: its range.
    spans: Vec<RealSpan>,
    /// By node: how deep sums and products are nested in it.
    heights: Vec<u32>,
    /// By node: the operation that made it first.
    ops: Vec<Option<OpId>>,
    /// The operation that is evaluated.
    pub at: Option<OpId>,
    fixed: u32,
    /// How many more terms of polynomials may be multiplied.
    products: Cell<u32>,
}

impl Scalars {
    pub fn new() -> Scalars {
        Scalars {
            all: Vec::new(),
            ids: FxHashMap::default(),
            varies: Vec::new(),
            spans: Vec::new(),
            heights: Vec::new(),
            ops: Vec::new(),
            at: None,
            fixed: 0,
            products: Cell::new(0),
        }
    }

    /// How many terms of polynomials may be multiplied from now on.
    pub fn allow_products(&self, count: u32) {
        self.products.set(count);
    }

    /// Multiplies some terms, if so many may be multiplied.
    pub fn spend_products(&self, count: usize) -> Option<()> {
        let left = self.products.get().checked_sub(count as u32)?;
        self.products.set(left);
        Some(())
    }

    /// Whether there are too many nodes to go on.
    pub fn is_full(&self) -> bool {
        self.all.len() > MAX_SCALARS
    }

    pub fn get(&self, id: ScalarId) -> &ScalarForm {
        const ZERO: &ScalarForm = &ScalarForm::Const(ScalarBits::ZERO);
        self.all.get(id.0 as usize).unwrap_or(ZERO)
    }

    pub fn varies(&self, id: ScalarId) -> bool {
        self.varies.get(id.0 as usize).copied().unwrap_or(false)
    }

    pub fn span(&self, id: ScalarId) -> RealSpan {
        self.spans
            .get(id.0 as usize)
            .copied()
            .unwrap_or(RealSpan::ANY)
    }

    fn height(&self, id: ScalarId) -> u32 {
        self.heights.get(id.0 as usize).copied().unwrap_or(0)
    }

    /// Whether a node can be treated as a polynomial.
    pub fn is_shallow(&self, id: ScalarId) -> bool {
        self.height(id) <= MAX_HEIGHT
    }

    pub fn op(&self, id: ScalarId) -> Option<OpId> {
        self.ops.get(id.0 as usize).copied().flatten()
    }

    pub fn value(&self, id: ScalarId) -> Option<f64> {
        match self.get(id) {
            ScalarForm::Const(value) => Some(value.get()),
            _ => None,
        }
    }

    /// Calls `each` with the operands of a node.
    pub fn each(&self, id: ScalarId, mut each: impl FnMut(ScalarId)) {
        match self.get(id) {
            ScalarForm::Const(_)
            | ScalarForm::Coordinate(_)
            | ScalarForm::Fixed(_)
            | ScalarForm::Unknown(_) => {}
            ScalarForm::Sum(terms, _) => terms.iter().for_each(|(term, _)| each(*term)),
            ScalarForm::Product(factors) => factors.iter().for_each(|(factor, _)| each(*factor)),
            ScalarForm::Of(_, a) | ScalarForm::IsNegative(a) | ScalarForm::Not(a) => each(*a),
            ScalarForm::Power(a, b)
            | ScalarForm::ArcTangent(a, b)
            | ScalarForm::Min(a, b)
            | ScalarForm::Max(a, b)
            | ScalarForm::And(a, b) => [*a, *b].into_iter().for_each(each),
            ScalarForm::Select(a, b, c) => [*a, *b, *c].into_iter().for_each(each),
        }
    }

    /// All nodes that a node consists of, in topological order.
    pub fn below(&self, root: ScalarId) -> Vec<ScalarId> {
        let mut seen = FxHashSet::default();
        let mut todo = vec![root];
        let mut found = Vec::new();
        while let Some(id) = todo.pop() {
            if seen.insert(id) {
                found.push(id);
                self.each(id, |operand| todo.push(operand));
            }
        }
        found.sort_unstable();
        found
    }

    fn add_node(&mut self, node: ScalarForm) -> ScalarId {
        if let Some(id) = self.ids.get(&node) {
            return *id;
        }
        let id = ScalarId(self.all.len() as u32);
        let span = super::interval::of_node(&node, |id| self.span(id));
        self.all.push(node.clone());
        self.spans.push(span);
        self.ops.push(self.at);
        let mut varies = matches!(node, ScalarForm::Coordinate(_) | ScalarForm::Unknown(_));
        self.each(id, |operand| varies |= self.varies(operand));
        self.varies.push(varies);
        let mut height = 0;
        if matches!(node, ScalarForm::Sum(..) | ScalarForm::Product(_)) {
            self.each(id, |operand| height = height.max(self.height(operand) + 1));
        }
        self.heights.push(height);
        self.ids.insert(node, id);
        id
    }

    pub fn number(&mut self, value: f64) -> ScalarId {
        self.add_node(ScalarForm::Const(ScalarBits::of(value)))
    }

    pub fn truth(&mut self, is: bool) -> ScalarId {
        self.number(f64::from(u8::from(is)))
    }

    pub fn coordinate(&mut self, index: u32) -> ScalarId {
        self.add_node(ScalarForm::Coordinate(index))
    }

    /// A number that does not depend on the point, in a range.
    pub fn fixed(&mut self, span: RealSpan) -> ScalarId {
        self.fixed += 1;
        let id = self.add_node(ScalarForm::Fixed(self.fixed));
        if let Some(known) = self.spans.get_mut(id.0 as usize) {
            *known = span;
        }
        id
    }

    /// A number that may depend on the point in any way.
    pub fn unknown(&mut self) -> ScalarId {
        self.fixed += 1;
        self.add_node(ScalarForm::Unknown(self.fixed))
    }

    /// The cosine of an angle, if there is one.
    pub fn cosine(&self, angle: ScalarId) -> Option<ScalarId> {
        let node = ScalarForm::Of(ScalarFunction::Cos, angle);
        self.ids.get(&node).copied()
    }

    /// A node as multiples of others and a constant.
    fn terms(&self, id: ScalarId) -> (Vec<(ScalarId, f64)>, f64) {
        match self.get(id) {
            ScalarForm::Const(value) => (Vec::new(), value.get()),
            ScalarForm::Sum(terms, constant) => {
                let terms = terms.iter().map(|(term, by)| (*term, by.get()));
                (terms.collect(), constant.get())
            }
            _ => (vec![(id, 1.0)], 0.0),
        }
    }

    /// A sum of multiples of nodes that are not sums, and a constant.
    pub fn sum(&mut self, mut terms: Vec<(ScalarId, f64)>, constant: f64) -> ScalarId {
        terms.sort_by_key(|(term, _)| *term);
        let mut merged: Vec<(ScalarId, f64, f64)> = Vec::with_capacity(terms.len());
        for (term, by) in terms {
            match merged.last_mut() {
                Some((last, sum, most)) if *last == term => {
                    *sum += by;
                    *most = most.max(by.abs());
                }
                _ => merged.push((term, by, by.abs())),
            }
        }
        // What rounding leaves of terms that cancel.
        merged.retain(|(_, by, most)| by.abs() > most * 1e-7);
        match merged.as_slice() {
            [] => self.number(constant),
            [(term, by, _)] if *by == 1.0 && constant == 0.0 => *term,
            _ => {
                let fraction = self.fraction(&merged, constant);
                let terms = merged
                    .iter()
                    .map(|(term, by, _)| (*term, ScalarBits::of(*by)));
                let node = ScalarForm::Sum(terms.collect(), ScalarBits::of(constant));
                let id = self.add_node(node);
                if let (Some(fraction), Some(known)) = (fraction, self.spans.get_mut(id.0 as usize))
                {
                    *known = known.meet(fraction);
                }
                id
            }
        }
    }

    /// The range of `x - floor(x)`, times a factor, plus a constant.
    fn fraction(&self, terms: &[(ScalarId, f64, f64)], constant: f64) -> Option<RealSpan> {
        terms.iter().find_map(|&(floor, by, _)| {
            let ScalarForm::Of(ScalarFunction::Floor, inner) = *self.get(floor) else {
                return None;
            };
            let (whole, own) = self.terms(inner);
            let others = terms.iter().filter(|(term, ..)| *term != floor);
            let is_same = |((a, x, _), (b, y)): (&(ScalarId, f64, f64), &(ScalarId, f64))| {
                a == b && (x + y * by).abs() <= x.abs() * 1e-9
            };
            (whole.len() + 1 == terms.len() && others.zip(&whole).all(is_same)).then(|| {
                RealSpan::new(0.0, 1.0)
                    .scale(-by)
                    .add(RealSpan::of(constant + own * by))
            })
        })
    }

    /// `a * by_a + b * by_b`
    pub fn combine(&mut self, (a, by_a): (ScalarId, f64), (b, by_b): (ScalarId, f64)) -> ScalarId {
        let (mut terms, first) = self.terms(a);
        let (others, second) = self.terms(b);
        terms.iter_mut().for_each(|(_, by)| *by *= by_a);
        terms.extend(others.into_iter().map(|(term, by)| (term, by * by_b)));
        self.sum(terms, first * by_a + second * by_b)
    }

    pub fn add(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        self.combine((a, 1.0), (b, 1.0))
    }

    pub fn subtract(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        self.combine((a, 1.0), (b, -1.0))
    }

    pub fn scale(&mut self, a: ScalarId, by: f64) -> ScalarId {
        let (terms, constant) = self.terms(a);
        let terms = terms.into_iter().map(|(term, own)| (term, own * by));
        self.sum(terms.collect(), constant * by)
    }

    pub fn negate(&mut self, a: ScalarId) -> ScalarId {
        self.scale(a, -1.0)
    }

    /// A node as a multiple of a node whose first term has the factor 1.
    pub fn monic(&mut self, id: ScalarId) -> (f64, ScalarId) {
        let ScalarForm::Sum(terms, _) = self.get(id) else {
            return (1.0, id);
        };
        let by = terms.first().map_or(1.0, |(_, by)| by.get());
        (by, self.scale(id, 1.0 / by))
    }

    /// A node as a factor and powers of nodes.
    fn factors(&mut self, id: ScalarId) -> (f64, Vec<(ScalarId, i32)>) {
        let (by, rest) = match self.get(id) {
            ScalarForm::Const(value) => return (value.get(), Vec::new()),
            _ => self.monic(id),
        };
        match self.get(rest) {
            ScalarForm::Product(factors) => (by, factors.clone()),
            _ => (by, vec![(rest, 1)]),
        }
    }

    /// The product of powers, times a factor.
    pub fn product(&mut self, mut factors: Vec<(ScalarId, i32)>, mut by: f64) -> ScalarId {
        let mut done: Vec<(ScalarId, i32)> = Vec::new();
        while let Some((id, power)) = factors.pop() {
            match self.get(id).clone() {
                ScalarForm::Const(value) => by *= value.get().powi(power),
                ScalarForm::Product(inner) => {
                    factors.extend(inner.into_iter().map(|(id, own)| (id, own * power)));
                }
                ScalarForm::Sum(terms, _)
                    if terms.first().is_some_and(|(_, by)| by.get() != 1.0) =>
                {
                    let (own, rest) = self.monic(id);
                    by *= own.powi(power);
                    factors.push((rest, power));
                }
                _ => match done.iter_mut().find(|(known, _)| *known == id) {
                    Some((_, known)) => *known += power,
                    None => done.push((id, power)),
                },
            }
        }
        done.retain(|(_, power)| *power != 0);
        if by == 0.0 {
            return self.number(0.0);
        }
        // Squares of square roots and magnitudes.
        let position = done.iter().position(|(id, power)| {
            power.abs() > 1
                && matches!(
                    self.get(*id),
                    ScalarForm::Of(ScalarFunction::Sqrt | ScalarFunction::Abs, _)
                )
        });
        if let Some((id, power)) = position.map(|at| done.swap_remove(at)) {
            if let ScalarForm::Of(function, inner) = *self.get(id) {
                let squares = power / 2;
                let each = if function == ScalarFunction::Sqrt {
                    1
                } else {
                    2
                };
                done.push((inner, squares * each));
                if power % 2 != 0 {
                    let rest = self.product(done, by);
                    return self.multiply_by(rest, (id, power % 2));
                }
            }
            return self.product(done, by);
        }
        done.sort_unstable();
        let rest = match done.as_slice() {
            [] => return self.number(by),
            [(id, 1)] => return self.scale(*id, by),
            _ => self.add_node(ScalarForm::Product(done)),
        };
        self.scale(rest, by)
    }

    /// Multiplies by a power of a square root or magnitude that the product does not contain.
    fn multiply_by(&mut self, a: ScalarId, by: (ScalarId, i32)) -> ScalarId {
        let (own, mut factors) = self.factors(a);
        if factors.iter().any(|(id, _)| *id == by.0) {
            factors.push(by);
            return self.product(factors, own);
        }
        factors.push(by);
        factors.sort_unstable();
        let rest = match factors.as_slice() {
            [(id, 1)] => *id,
            _ => self.add_node(ScalarForm::Product(factors)),
        };
        self.scale(rest, own)
    }

    pub fn multiply(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let (by, mut factors) = self.factors(a);
        let (other, others) = self.factors(b);
        factors.extend(others);
        self.product(factors, by * other)
    }

    pub fn divide(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let (by, mut factors) = self.factors(a);
        let (other, others) = self.factors(b);
        factors.extend(others.into_iter().map(|(id, power)| (id, -power)));
        self.product(factors, by / other)
    }

    pub fn power(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => self.number(a.powf(b)),
            (_, Some(b)) if b.fract() == 0.0 && b.abs() <= f64::from(MAX_POWER) => {
                let (by, factors) = self.factors(a);
                let power = b as i32;
                let factors = factors.into_iter().map(|(id, own)| (id, own * power));
                self.product(factors.collect(), by.powi(power))
            }
            (_, Some(0.5)) => self.of(ScalarFunction::Sqrt, a),
            _ => self.add_node(ScalarForm::Power(a, b)),
        }
    }

    pub fn arc_tangent(&mut self, y: ScalarId, x: ScalarId) -> ScalarId {
        match (self.value(y), self.value(x)) {
            (Some(y), Some(x)) => self.number(y.atan2(x)),
            _ => self.add_node(ScalarForm::ArcTangent(y, x)),
        }
    }

    pub fn of(&mut self, function: ScalarFunction, a: ScalarId) -> ScalarId {
        if let Some(value) = self.value(a) {
            return self.number(function.value(value));
        }
        match (function, self.get(a).clone()) {
            (ScalarFunction::Sqrt, ScalarForm::Min(x, y)) => {
                let (x, y) = (self.of(function, x), self.of(function, y));
                self.min(x, y)
            }
            (ScalarFunction::Sqrt, ScalarForm::Max(x, y)) => {
                let (x, y) = (self.of(function, x), self.of(function, y));
                self.max(x, y)
            }
            (ScalarFunction::Sqrt, ScalarForm::Select(c, x, y)) => {
                let (x, y) = (self.of(function, x), self.of(function, y));
                self.select(c, x, y)
            }
            (ScalarFunction::Sqrt, _) => {
                let (by, factors) = self.factors(a);
                if by > 0.0 && factors.iter().all(|(_, power)| power % 2 == 0) {
                    let halves = factors.into_iter().map(|(id, power)| (id, power / 2));
                    let root = self.product(halves.collect(), by.sqrt());
                    return self.of(ScalarFunction::Abs, root);
                }
                self.add_node(ScalarForm::Of(function, a))
            }
            (ScalarFunction::Abs, _) if self.span(a).lo >= 0.0 => a,
            (ScalarFunction::Abs, _) if self.span(a).hi <= 0.0 => self.negate(a),
            (ScalarFunction::Abs, _) => {
                let (by, rest) = self.monic(a);
                // Sums keep their size, so that those of a rotated point have the same.
                let is_sum = matches!(self.get(rest), ScalarForm::Sum(..));
                let (by, inner) = match is_sum {
                    true => (1.0, self.scale(rest, by.abs())),
                    false => (by.abs(), rest),
                };
                let node = self.add_node(ScalarForm::Of(function, inner));
                self.scale(node, by)
            }
            (ScalarFunction::Same, _) if !self.is_product_sum(a) => a,
            (ScalarFunction::Floor, ScalarForm::Of(ScalarFunction::Floor, _)) => a,
            (ScalarFunction::Exp, ScalarForm::Of(ScalarFunction::Log, x)) => x,
            (ScalarFunction::Log, ScalarForm::Of(ScalarFunction::Exp, x)) => x,
            _ => self.add_node(ScalarForm::Of(function, a)),
        }
    }

    /// Whether a node is a sum with products of nodes that depend on the point.
    fn is_product_sum(&self, id: ScalarId) -> bool {
        let ScalarForm::Sum(terms, _) = self.get(id) else {
            return false;
        };
        terms.iter().any(|(term, _)| match self.get(*term) {
            ScalarForm::Product(factors) => {
                let varying = factors.iter().filter(|(id, _)| self.varies(*id));
                varying.map(|(_, power)| power.abs()).sum::<i32>() > 1
            }
            _ => false,
        })
    }

    pub fn min(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let (first, second) = (self.span(a), self.span(b));
        if a == b || first.hi <= second.lo {
            return a;
        }
        if second.hi <= first.lo {
            return b;
        }
        self.add_node(ScalarForm::Min(a.min(b), a.max(b)))
    }

    pub fn max(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let (first, second) = (self.span(a), self.span(b));
        if a == b || first.lo >= second.hi {
            return a;
        }
        if second.lo >= first.hi {
            return b;
        }
        self.add_node(ScalarForm::Max(a.min(b), a.max(b)))
    }

    pub fn is_negative(&mut self, a: ScalarId) -> ScalarId {
        let span = self.span(a);
        if span.hi < 0.0 || span.lo >= 0.0 {
            return self.truth(span.hi < 0.0);
        }
        let (by, rest) = self.monic(a);
        let rest = self.scale(rest, by.signum());
        self.add_node(ScalarForm::IsNegative(rest))
    }

    pub fn is_less(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let difference = self.subtract(a, b);
        self.is_negative(difference)
    }

    pub fn not(&mut self, a: ScalarId) -> ScalarId {
        match *self.get(a) {
            ScalarForm::Const(value) => self.truth(value.get() == 0.0),
            ScalarForm::Not(inner) => inner,
            _ => self.add_node(ScalarForm::Not(a)),
        }
    }

    pub fn and(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        match (self.value(a), self.value(b)) {
            (Some(value), _) => return if value == 0.0 { a } else { b },
            (_, Some(value)) => return if value == 0.0 { b } else { a },
            _ if a == b => return a,
            _ => {}
        }
        if self.not(a) == b {
            return self.truth(false);
        }
        // A condition that the other one contains.
        match (self.get(a), self.get(b)) {
            (ScalarForm::And(x, y), _) if *x == b || *y == b => a,
            (_, ScalarForm::And(x, y)) if *x == a || *y == a => b,
            _ => self.add_node(ScalarForm::And(a.min(b), a.max(b))),
        }
    }

    pub fn or(&mut self, a: ScalarId, b: ScalarId) -> ScalarId {
        let (a, b) = (self.not(a), self.not(b));
        let neither = self.and(a, b);
        self.not(neither)
    }

    pub fn select(&mut self, condition: ScalarId, a: ScalarId, b: ScalarId) -> ScalarId {
        if a == b {
            return a;
        }
        match *self.get(condition) {
            ScalarForm::Const(value) => return if value.get() != 0.0 { a } else { b },
            ScalarForm::Not(inner) => return self.select(inner, b, a),
            // `a < b ? a : b`
            ScalarForm::IsNegative(of) => {
                let difference = self.subtract(a, b);
                if self.is_same_direction(difference, of) {
                    return self.min(a, b);
                }
                let difference = self.negate(difference);
                if self.is_same_direction(difference, of) {
                    return self.max(a, b);
                }
            }
            _ => {}
        }
        let b = match *self.get(b) {
            ScalarForm::Select(other, _, rest) if other == condition => rest,
            _ => b,
        };
        let a = match *self.get(a) {
            ScalarForm::Select(other, first, _) if other == condition => first,
            _ => a,
        };
        if a == b {
            return a;
        }
        self.add_node(ScalarForm::Select(condition, a, b))
    }

    /// Whether two nodes have the same sign.
    fn is_same_direction(&mut self, a: ScalarId, b: ScalarId) -> bool {
        if a == b {
            return true;
        }
        let ((by, first), (other, second)) = (self.monic(a), self.monic(b));
        first == second && by * other > 0.0
    }

    /// A condition that is selected by another.
    pub fn select_condition(&mut self, by: ScalarId, a: ScalarId, b: ScalarId) -> ScalarId {
        if a == b {
            return a;
        }
        let first = self.and(by, a);
        let not = self.not(by);
        let second = self.and(not, b);
        self.or(first, second)
    }

    /// Makes a node again with other operands.
    pub fn remake(&mut self, id: ScalarId, of: impl Fn(ScalarId) -> ScalarId) -> ScalarId {
        match self.get(id).clone() {
            ScalarForm::Const(_)
            | ScalarForm::Coordinate(_)
            | ScalarForm::Fixed(_)
            | ScalarForm::Unknown(_) => id,
            ScalarForm::Sum(terms, constant) => {
                let (mut all, mut sum) = (Vec::new(), constant.get());
                for (term, by) in terms {
                    let (inner, own) = self.terms(of(term));
                    let by = by.get();
                    all.extend(inner.into_iter().map(|(term, own)| (term, own * by)));
                    sum += own * by;
                }
                self.sum(all, sum)
            }
            ScalarForm::Product(factors) => {
                let factors = factors.into_iter().map(|(id, power)| (of(id), power));
                self.product(factors.collect(), 1.0)
            }
            ScalarForm::Of(function, a) => self.of(function, of(a)),
            ScalarForm::Power(a, b) => self.power(of(a), of(b)),
            ScalarForm::ArcTangent(a, b) => self.arc_tangent(of(a), of(b)),
            ScalarForm::Min(a, b) => self.min(of(a), of(b)),
            ScalarForm::Max(a, b) => self.max(of(a), of(b)),
            ScalarForm::Select(c, a, b) => self.select(of(c), of(a), of(b)),
            ScalarForm::IsNegative(a) => self.is_negative(of(a)),
            ScalarForm::Not(a) => self.not(of(a)),
            ScalarForm::And(a, b) => self.and(of(a), of(b)),
        }
    }
}
