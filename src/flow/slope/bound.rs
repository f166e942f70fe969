//! Bounds of gradients: from the operands of a node to the node.

use super::assumptions::SlopeAssumptions;
use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::frame::Frames;
use super::gradient::{FieldGradient, Generators};
use super::interval::RealSpan;
use super::node::Scalars;
use rustc_hash::{FxHashMap, FxHashSet};

/// How far cases are followed into the operands of a node.
const CASE_DEPTH: u32 = 14;
/// How far the operands of a logarithm or square root are followed.
pub(super) const MAX_NESTING: u32 = 40;
/// Most gradients and ranges that are computed under assumptions.
const MAX_WORK: u32 = 30_000;

/// Gradients of the nodes of a function.
pub(super) struct GradientBounds<'s> {
    pub scalars: &'s mut Scalars,
    pub generators: Generators,
    pub frames: Frames,
    /// Without assumptions.
    pub known: FxHashMap<ScalarId, FieldGradient>,
    /// Of components of vectors that are directions of their own: their gradients before.
    apart: FxHashMap<ScalarId, FieldGradient>,
    keys: FxHashMap<ScalarId, (f64, ScalarId, f64)>,
    pub polynomials: FxHashMap<ScalarId, Vec<Vec<(ScalarId, ScalarId)>>>,
    pub left: u32,
}

/// What is computed under some assumptions.
#[derive(Default)]
pub(super) struct CaseMemo {
    pub gradients: FxHashMap<ScalarId, FieldGradient>,
    pub spans: FxHashMap<ScalarId, RealSpan>,
    resolved: FxHashMap<ScalarId, ScalarId>,
}

impl<'s> GradientBounds<'s> {
    pub fn new(scalars: &'s mut Scalars, nodes: &[ScalarId]) -> GradientBounds<'s> {
        let frames = Frames::of(scalars, nodes);
        GradientBounds {
            scalars,
            generators: Generators::default(),
            frames,
            known: FxHashMap::default(),
            apart: FxHashMap::default(),
            keys: FxHashMap::default(),
            polynomials: FxHashMap::default(),
            left: MAX_WORK,
        }
    }

    /// Computes the gradients of nodes, given in topological order.
    pub fn solve(&mut self, nodes: &[ScalarId], vectors: &[Vec<ScalarId>]) {
        let components: FxHashSet<ScalarId> = vectors.iter().flatten().copied().collect();
        let mut uses = self.uses(nodes);
        uses.extend(&components);
        let mut by_last: FxHashMap<ScalarId, Vec<&Vec<ScalarId>>> = FxHashMap::default();
        for vector in vectors {
            if let Some(last) = vector.iter().max() {
                by_last.entry(*last).or_default().push(vector);
            }
        }
        for &node in nodes {
            let none = SlopeAssumptions::default();
            let mut memo = CaseMemo::default();
            let mut made = self.compute(node, &none, &mut memo, 0);
            let mut target = self.target(node);
            if components.contains(&node) {
                target = target.min(self.least_term(node));
            }
            if uses.contains(&node) && made.norm > target * (1.0 + 1e-6) {
                let better = self.by_cases(node, &made, target);
                if better.norm < made.norm {
                    made = better;
                }
            }
            self.known.insert(node, made);
            for vector in by_last.get(&node).into_iter().flatten() {
                self.join(vector);
            }
        }
    }

    /// Makes the components of a vector directions of their own, if together they are no steeper than
    /// each alone, which their gradients do not show: after a reflection by cases.
    fn join(&mut self, vector: &[ScalarId]) {
        let rows = vector.iter().map(|id| self.known.get(id).cloned());
        let Some(rows) = rows.collect::<Option<Vec<FieldGradient>>>() else {
            return;
        };
        let most = rows.iter().fold(0.0f64, |most, row| most.max(row.norm));
        let rows: Vec<&FieldGradient> = rows.iter().collect();
        let plain = self.norm_of_rows(&rows);
        if !most.is_finite() || plain <= most * (1.0 + 1e-5) {
            return;
        }
        let mut squares = Vec::new();
        for id in vector {
            squares.push((self.scalars.multiply(*id, *id), 1.0));
        }
        let square = self.scalars.sum(squares, 0.0);
        let length = self.scalars.of(ScalarFunction::Sqrt, square);
        let made = self.direction(length, &rows, plain);
        let made = self.by_cases(length, &made, most);
        if made.norm > most * (1.0 + 1e-5) {
            return;
        }
        let mut support: Vec<u32> = rows.iter().flat_map(|r| &r.parts).map(|p| p.0).collect();
        support.sort_unstable();
        support.dedup();
        for (index, id) in (0..).zip(vector) {
            let own = self.generators.of(length, index, support.clone());
            let gradient = FieldGradient {
                parts: vec![(own, RealSpan::within(made.norm))],
                norm: made.norm,
            };
            if let Some(before) = self.known.insert(*id, gradient) {
                self.apart.insert(*id, before);
            }
        }
    }

    /// The nodes whose gradients others need as a whole, not as terms of a polynomial.
    fn uses(&self, nodes: &[ScalarId]) -> FxHashSet<ScalarId> {
        let mut found: FxHashSet<ScalarId> = nodes.last().copied().into_iter().collect();
        for &node in nodes {
            match self.scalars.get(node) {
                ScalarForm::Sum(..) | ScalarForm::Product(_) => {
                    self.scalars.each(node, |operand| {
                        let of = self.scalars.get(operand);
                        if !matches!(of, ScalarForm::Sum(..) | ScalarForm::Product(_)) {
                            found.insert(operand);
                        }
                    })
                }
                ScalarForm::IsNegative(_) => {}
                ScalarForm::Of(ScalarFunction::Floor, _) => {}
                ScalarForm::Of(ScalarFunction::Sqrt, of) if self.squares(*of).is_some() => {
                    let rows = self.squares(*of).unwrap_or_default();
                    found.extend(rows.into_iter().map(|(_, row)| row));
                }
                _ => self.scalars.each(node, |operand| {
                    found.insert(operand);
                }),
            }
        }
        found
    }

    /// The least norm that can be expected.
    fn target(&self, node: ScalarId) -> f64 {
        let norm = |id: ScalarId| self.known.get(&id).map_or(0.0, |g| g.norm);
        match self.scalars.get(node) {
            ScalarForm::Sum(terms, _) => {
                let all = terms.iter().map(|(term, by)| norm(*term) * by.get().abs());
                all.filter(|norm| norm.is_finite()).fold(0.0, f64::max)
            }
            ScalarForm::Product(_) => 0.0,
            ScalarForm::Of(ScalarFunction::Sqrt, of) => {
                let rows = self.squares(*of).unwrap_or_default();
                let all = rows.into_iter().map(|(by, id)| by * norm(id));
                all.filter(|norm| norm.is_finite()).fold(0.0, f64::max)
            }
            _ => f64::INFINITY,
        }
    }

    /// The least slope of the terms of a sum: a folded coordinate, `x - 2.0 * min(dot(p, k), 0.0) * k.x`,
    /// is as steep as `x`, however long `k` is.
    fn least_term(&self, node: ScalarId) -> f64 {
        let ScalarForm::Sum(terms, _) = self.scalars.get(node) else {
            return f64::INFINITY;
        };
        let norms = terms.iter().filter_map(|(term, by)| {
            let norm = self.known.get(term)?.norm * by.get().abs();
            (norm > 0.0).then_some(norm)
        });
        norms.fold(f64::INFINITY, f64::min)
    }

    /// The gradient of a node under assumptions.
    pub fn gradient(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        if !self.scalars.varies(id) {
            return FieldGradient::ZERO;
        }
        if (depth > CASE_DEPTH || given.is_empty() || self.left == 0)
            && let Some(known) = self.known.get(&id)
        {
            return known.clone();
        }
        if let Some(known) = memo.gradients.get(&id) {
            return known.clone();
        }
        if depth > MAX_NESTING {
            return FieldGradient::unknown();
        }
        self.left = self.left.saturating_sub(1);
        let mut made = self.compute(id, given, memo, depth);
        // Fewer cases are known of the operands than when it was computed without assumptions.
        if let Some(known) = self.known.get(&id)
            && (known.norm < made.norm || self.apart.get(&id) == Some(&made))
        {
            made = known.clone();
        }
        memo.gradients.insert(id, made.clone());
        made
    }

    /// The range of a node under assumptions.
    pub fn span(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> RealSpan {
        let base = self.scalars.span(id);
        if given.is_empty() || depth > CASE_DEPTH || self.left == 0 {
            return base;
        }
        if let Some(known) = memo.spans.get(&id) {
            return *known;
        }
        self.left = self.left.saturating_sub(1);
        let mut operands = Vec::new();
        self.scalars.each(id, |operand| operands.push(operand));
        for operand in operands {
            self.span(operand, given, memo, depth + 1);
        }
        let node = self.scalars.get(id).clone();
        let scalars = &*self.scalars;
        let of = |id: ScalarId| memo.spans.get(&id).copied().unwrap_or(scalars.span(id));
        let mut span = super::interval::of_node(&node, of).meet(base);
        let (by, key, constant) = self.key(id);
        if let Some(known) = given.span(key) {
            // What rounding leaves of an end at zero.
            let snap = |end: f64| match end.abs() <= constant.abs() * 1e-12 {
                true => 0.0,
                false => end,
            };
            let known = known.scale(by).add(RealSpan::of(constant));
            span = span.meet(RealSpan::new(snap(known.lo), snap(known.hi)));
        }
        if let Some(known) = given.span(id) {
            span = span.meet(known);
        }
        memo.spans.insert(id, span);
        span
    }

    pub fn key(&mut self, id: ScalarId) -> (f64, ScalarId, f64) {
        if let Some(known) = self.keys.get(&id) {
            return *known;
        }
        let key = self.scalars.key(id);
        self.keys.insert(id, key);
        key
    }

    fn compute(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        if !self.scalars.varies(id) {
            return FieldGradient::ZERO;
        }
        let next = depth + 1;
        match self.scalars.get(id).clone() {
            ScalarForm::Coordinate(_) => FieldGradient {
                parts: vec![(self.generators.axis(id), RealSpan::of(1.0))],
                norm: 1.0,
            },
            ScalarForm::Const(_) | ScalarForm::Fixed(_) => FieldGradient::ZERO,
            ScalarForm::IsNegative(_) | ScalarForm::Not(_) | ScalarForm::And(..) => {
                FieldGradient::ZERO
            }
            ScalarForm::Unknown(_) => FieldGradient::unknown(),
            ScalarForm::Sum(terms, _) => {
                let mut sum = FieldGradient::ZERO;
                for (term, by) in terms {
                    let term = self.gradient(term, given, memo, next);
                    sum = sum.add(&term.scale(RealSpan::of(by.get())));
                }
                sum.norm = sum.norm.min(self.generators.norm(&[&sum]));
                self.improved(id, sum, given, memo, next)
            }
            ScalarForm::Product(factors) => self.product(id, &factors, given, memo, next),
            ScalarForm::Of(function, a) => self.of_function((id, function, a), given, memo, next),
            ScalarForm::Power(a, b) => self.power((a, b), given, memo, next),
            ScalarForm::ArcTangent(y, x) => self.arc_tangent((id, y, x), given, memo, next),
            ScalarForm::Min(a, b) | ScalarForm::Max(a, b) => {
                match self.lesser(id, (a, b), given, memo, next) {
                    Some(side) => self.gradient(side, given, memo, next),
                    None => {
                        let first = self.gradient(a, given, memo, next);
                        first.hull(&self.gradient(b, given, memo, next))
                    }
                }
            }
            ScalarForm::Select(condition, a, b) => match self.truth(condition, given, memo, next) {
                Some(true) => self.gradient(a, given, memo, next),
                Some(false) => self.gradient(b, given, memo, next),
                None => {
                    let first = self.gradient(a, given, memo, next);
                    first.hull(&self.gradient(b, given, memo, next))
                }
            },
        }
    }

    fn product(
        &mut self,
        id: ScalarId,
        factors: &[(ScalarId, i32)],
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        let mut sum = FieldGradient::ZERO;
        for (number, (factor, power)) in factors.iter().enumerate() {
            let mut by = self.span(*factor, given, memo, depth).power(power - 1);
            by = by.scale(f64::from(*power));
            for (other, (factor, power)) in factors.iter().enumerate() {
                if other != number {
                    let own = self.span(*factor, given, memo, depth).power(*power);
                    by = by.multiply(own);
                }
            }
            let factor = self.gradient(*factor, given, memo, depth);
            sum = sum.add(&factor.scale(by));
        }
        sum.norm = sum.norm.min(self.generators.norm(&[&sum]));
        self.improved(id, sum, given, memo, depth)
    }

    fn power(
        &mut self,
        (a, b): (ScalarId, ScalarId),
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        let (base, by) = (
            self.span(a, given, memo, depth),
            self.span(b, given, memo, depth),
        );
        if self.scalars.varies(b) || by.lo != by.hi || base.lo < 0.0 {
            return FieldGradient::unknown();
        }
        let power = |x: f64| by.lo * x.powf(by.lo - 1.0);
        let by = RealSpan::new(power(base.lo), power(base.lo)).hull(RealSpan::of(power(base.hi)));
        self.gradient(a, given, memo, depth).scale(by)
    }

    fn arc_tangent(
        &mut self,
        (id, y, x): (ScalarId, ScalarId, ScalarId),
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        // Angles jump where `y` changes its sign on the left, whatever is assumed of it.
        let (height, side) = (self.scalars.span(y), self.scalars.span(x));
        if side.lo < 0.0 && height.lo <= 0.0 && height.hi >= 0.0 {
            return FieldGradient::unknown();
        }
        let (dy, dx) = (
            self.gradient(y, given, memo, depth),
            self.gradient(x, given, memo, depth),
        );
        let (y, x) = (
            self.span(y, given, memo, depth).abs(),
            self.span(x, given, memo, depth).abs(),
        );
        let radius = y.lo.hypot(x.lo);
        let both = self.norm_of_rows(&[&dy, &dx]);
        self.direction(id, &[&dy, &dx], both / radius)
    }

    /// Whether a condition holds under assumptions, if they decide it.
    pub fn truth(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> Option<bool> {
        if let Some(known) = given.truth(id) {
            return Some(known);
        }
        match *self.scalars.get(id) {
            ScalarForm::Const(value) => Some(value.get() != 0.0),
            ScalarForm::IsNegative(of) => {
                let span = self.span(of, given, memo, depth + 1);
                // Zero over a whole region is not negative.
                match (span.hi < 0.0, span.lo >= 0.0) {
                    (true, _) => Some(true),
                    (_, true) => Some(false),
                    _ => None,
                }
            }
            ScalarForm::Not(of) => self.truth(of, given, memo, depth + 1).map(|is| !is),
            ScalarForm::And(a, b) => {
                let first = self.truth(a, given, memo, depth + 1);
                let second = self.truth(b, given, memo, depth + 1);
                match (first, second) {
                    (Some(false), _) | (_, Some(false)) => Some(false),
                    (Some(true), Some(true)) => Some(true),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// A gradient of this length at most in the span of others.
    pub fn direction(&mut self, id: ScalarId, rows: &[&FieldGradient], norm: f64) -> FieldGradient {
        if !norm.is_finite() {
            return FieldGradient::unknown();
        }
        if norm == 0.0 {
            return FieldGradient::ZERO;
        }
        let mut support: Vec<u32> = rows.iter().flat_map(|r| &r.parts).map(|p| p.0).collect();
        support.sort_unstable();
        support.dedup();
        if let [only] = support.as_slice() {
            return FieldGradient {
                parts: vec![(*only, RealSpan::within(norm))],
                norm,
            };
        }
        let own = self.generators.of(id, 0, support);
        FieldGradient {
            parts: vec![(own, RealSpan::within(norm))],
            norm,
        }
    }

    pub fn norm_of_rows(&self, rows: &[&FieldGradient]) -> f64 {
        let generators = &self.generators;
        generators
            .norm(rows)
            .min(generators.norm_of_directions(rows))
    }

    fn of_function(
        &mut self,
        (id, function, a): (ScalarId, ScalarFunction, ScalarId),
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> FieldGradient {
        let span = self.span(a, given, memo, depth);
        let by = match function {
            ScalarFunction::Same => return self.gradient(a, given, memo, depth),
            ScalarFunction::Floor => return FieldGradient::ZERO,
            ScalarFunction::Sqrt => return self.square_root(id, a, given, memo, depth),
            ScalarFunction::Log => {
                let ratio = self.log_slope(a, given, memo, depth);
                let of = self.gradient(a, given, memo, depth);
                return self.direction(id, &[&of], ratio);
            }
            ScalarFunction::Abs => match (span.lo >= 0.0, span.hi <= 0.0) {
                (true, _) => RealSpan::of(1.0),
                (_, true) => RealSpan::of(-1.0),
                _ => RealSpan::within(1.0),
            },
            ScalarFunction::Sin | ScalarFunction::Cos => RealSpan::within(1.0),
            ScalarFunction::Tan => return FieldGradient::unknown(),
            ScalarFunction::Asin | ScalarFunction::Acos => {
                let most = 1.0 / (1.0 - span.most().min(1.0).powi(2)).sqrt();
                RealSpan::within(most)
            }
            ScalarFunction::Atan | ScalarFunction::Tanh => RealSpan::new(0.0, 1.0),
            ScalarFunction::Exp => span.of_function(ScalarFunction::Exp),
        };
        self.gradient(a, given, memo, depth).scale(by)
    }

    /// A polynomial with the minima, magnitudes and the like in it replaced by what they are under the
    /// assumptions, so that their terms cancel others.
    pub fn resolve(
        &mut self,
        id: ScalarId,
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> ScalarId {
        if given.is_empty() || depth > CASE_DEPTH || !self.scalars.varies(id) {
            return id;
        }
        if let Some(known) = memo.resolved.get(&id) {
            return *known;
        }
        let next = depth + 1;
        let made = match *self.scalars.get(id) {
            ScalarForm::Sum(..) | ScalarForm::Product(_) => {
                let mut operands = Vec::new();
                self.scalars.each(id, |operand| operands.push(operand));
                for operand in &operands {
                    self.resolve(*operand, given, memo, next);
                }
                let of = |id: ScalarId| memo.resolved.get(&id).copied().unwrap_or(id);
                match operands.iter().any(|id| of(*id) != *id) {
                    true => self.scalars.remake(id, of),
                    false => id,
                }
            }
            ScalarForm::Min(a, b) | ScalarForm::Max(a, b) => {
                match self.lesser(id, (a, b), given, memo, next) {
                    Some(side) => self.resolve(side, given, memo, next),
                    None => id,
                }
            }
            ScalarForm::Of(ScalarFunction::Abs, a) => {
                let span = self.span(a, given, memo, next);
                let inner = self.resolve(a, given, memo, next);
                match (span.lo >= 0.0, span.hi <= 0.0) {
                    (true, _) => inner,
                    (_, true) => self.scalars.negate(inner),
                    _ => id,
                }
            }
            ScalarForm::Select(condition, a, b) => match self.truth(condition, given, memo, next) {
                Some(true) => self.resolve(a, given, memo, next),
                Some(false) => self.resolve(b, given, memo, next),
                None => id,
            },
            _ => id,
        };
        memo.resolved.insert(id, made);
        made
    }

    /// The operand that a minimum or maximum is equal to under assumptions, if they decide it.
    fn lesser(
        &mut self,
        id: ScalarId,
        (a, b): (ScalarId, ScalarId),
        given: &SlopeAssumptions,
        memo: &mut CaseMemo,
        depth: u32,
    ) -> Option<ScalarId> {
        let difference = self.scalars.subtract(a, b);
        let sign = self.span(difference, given, memo, depth);
        let is_min = matches!(self.scalars.get(id), ScalarForm::Min(..));
        match (sign.hi <= 0.0, sign.lo >= 0.0) {
            (true, _) => Some(if is_min { a } else { b }),
            (_, true) => Some(if is_min { b } else { a }),
            _ => None,
        }
    }
}
