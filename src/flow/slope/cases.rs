//! Cases: bounds of a node under assumptions on the signs that its operands depend on.
//!
//! `length(max(d, 0.0)) + min(max(d.x, d.y), 0.0)` is a sum of two numbers with slope 1, but where one
//! changes, the other is constant.

use super::assumptions::SlopeAssumptions;
use super::bound::{CaseMemo, GradientBounds};
use super::form::{ScalarForm, ScalarFunction, ScalarId};
use super::gradient::FieldGradient;
use super::interval::RealSpan;
use rustc_hash::FxHashSet;

/// Most assumptions at a time.
const MAX_DEPTH: u32 = 6;
/// Most cases of a node.
const MAX_CASES: u32 = 64;
/// Most signs that are tried per assumption.
const MAX_SIGNS: usize = 8;

/// A sign on which a gradient may depend.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct OpenSign {
    of: ScalarId,
    /// The condition that asks for it.
    condition: Option<ScalarId>,
}

impl GradientBounds<'_> {
    /// The gradient of a node, as the worst of some cases.
    pub fn by_cases(
        &mut self,
        node: ScalarId,
        plain: &FieldGradient,
        target: f64,
    ) -> FieldGradient {
        let mut left = MAX_CASES;
        let none = SlopeAssumptions::default();
        self.split((node, plain.clone()), &none, target, MAX_DEPTH, &mut left)
    }

    fn split(
        &mut self,
        (node, plain): (ScalarId, FieldGradient),
        given: &SlopeAssumptions,
        target: f64,
        depth: u32,
        left: &mut u32,
    ) -> FieldGradient {
        if depth == 0 || plain.norm <= target * (1.0 + 1e-6) || self.left == 0 {
            return plain;
        }
        let mut best: Option<(f64, Vec<(SlopeAssumptions, FieldGradient)>)> = None;
        for sign in self.signs(node, given) {
            let mut sides = Vec::new();
            for is_negative in [true, false] {
                let Some(assumed) = self.assume(given, sign, is_negative) else {
                    continue;
                };
                *left = left.saturating_sub(1);
                let mut memo = CaseMemo::default();
                let gradient = self.gradient(node, &assumed, &mut memo, 0);
                sides.push((assumed, gradient));
            }
            let norms = sides.iter().map(|(_, gradient)| gradient.norm);
            let most = norms.fold(0.0, f64::max);
            let least = sides.iter().fold(f64::INFINITY, |a, (_, g)| a.min(g.norm));
            // A side that is better counts, even if the other one is not.
            let score = match most.is_finite() {
                true => most + least,
                false => f64::MAX.min(least + 1e100),
            };
            if best.as_ref().is_none_or(|(known, _)| score < *known) {
                best = Some((score, sides));
            }
            if most <= target * (1.0 + 1e-6) || *left == 0 {
                break;
            }
        }
        let Some((_, sides)) = best else {
            return plain;
        };
        let is_useful = sides.iter().any(|(_, g)| g.norm < plain.norm);
        if !is_useful {
            return plain;
        }
        let mut made: Option<FieldGradient> = None;
        for (assumed, gradient) in sides {
            let gradient = match *left {
                0 => gradient,
                _ => self.split((node, gradient), &assumed, target, depth - 1, left),
            };
            made = Some(match made {
                Some(other) => other.hull(&gradient),
                None => gradient,
            });
        }
        made.unwrap_or(plain)
    }

    /// The signs that a node depends on and that are open, those of the nearest operands first.
    fn signs(&mut self, node: ScalarId, given: &SlopeAssumptions) -> Vec<OpenSign> {
        let mut found: Vec<OpenSign> = Vec::new();
        let mut memo = CaseMemo::default();
        let mut seen = FxHashSet::default();
        let mut level = vec![node];
        for _ in 0..10 {
            let mut next = Vec::new();
            for id in level {
                if !seen.insert(id) || !self.scalars.varies(id) || found.len() >= MAX_SIGNS {
                    continue;
                }
                let sign = match *self.scalars.get(id) {
                    ScalarForm::Min(a, b) | ScalarForm::Max(a, b) => Some(OpenSign {
                        of: self.scalars.subtract(a, b),
                        condition: None,
                    }),
                    ScalarForm::Of(ScalarFunction::Abs, of) => Some(OpenSign {
                        of,
                        condition: None,
                    }),
                    ScalarForm::IsNegative(of) => Some(OpenSign {
                        of,
                        condition: Some(id),
                    }),
                    _ => None,
                };
                if let Some(sign) = sign
                    && !found.iter().any(|known| known.of == sign.of)
                {
                    let span = self.span(sign.of, given, &mut memo, 0);
                    let is_open = match sign.condition {
                        Some(condition) => given.truth(condition).is_none() && span.lo < 0.0,
                        None => span.lo < 0.0 && span.hi > 0.0,
                    };
                    if is_open {
                        found.push(sign);
                    }
                }
                self.scalars.each(id, |operand| next.push(operand));
            }
            level = next;
        }
        found
    }

    /// Adds an assumption; `None` if it contradicts the others.
    fn assume(
        &mut self,
        given: &SlopeAssumptions,
        sign: OpenSign,
        is_negative: bool,
    ) -> Option<SlopeAssumptions> {
        let mut assumed = given.clone();
        if let Some(condition) = sign.condition {
            assumed.truths.insert(condition, is_negative);
        }
        let side = match is_negative {
            true => RealSpan::new(f64::NEG_INFINITY, 0.0),
            false => RealSpan::new(0.0, f64::INFINITY),
        };
        self.narrow(&mut assumed, sign.of, side, 24)
            .then_some(assumed)
    }

    /// Narrows the range of a node and of what follows for its operands; whether it is possible.
    fn narrow(
        &mut self,
        given: &mut SlopeAssumptions,
        id: ScalarId,
        span: RealSpan,
        depth: u32,
    ) -> bool {
        let (by, key, constant) = self.key(id);
        let span = match by == 0.0 {
            true => return span.lo <= constant && constant <= span.hi,
            false => span.add(RealSpan::of(-constant)).scale(1.0 / by),
        };
        let before = given.span(key).unwrap_or(self.scalars.span(key));
        let narrowed = before.meet(span);
        if narrowed.is_empty() {
            return false;
        }
        given.spans.insert(key, narrowed);
        if depth == 0 {
            return true;
        }
        let any = f64::INFINITY;
        match *self.scalars.get(key) {
            ScalarForm::Max(a, b) if narrowed.hi < any => {
                let below = RealSpan::new(-any, narrowed.hi);
                self.narrow(given, a, below, depth - 1) && self.narrow(given, b, below, depth - 1)
            }
            ScalarForm::Min(a, b) if narrowed.lo > -any => {
                let above = RealSpan::new(narrowed.lo, any);
                self.narrow(given, a, above, depth - 1) && self.narrow(given, b, above, depth - 1)
            }
            ScalarForm::Of(ScalarFunction::Abs, a) if narrowed.hi < any => {
                self.narrow(given, a, RealSpan::within(narrowed.hi), depth - 1)
            }
            ScalarForm::Of(ScalarFunction::Same, a) => self.narrow(given, a, narrowed, depth - 1),
            ScalarForm::Of(ScalarFunction::Sqrt, a) if narrowed.hi < any => {
                let below = RealSpan::new(-any, narrowed.hi * narrowed.hi);
                self.narrow(given, a, below, depth - 1)
            }
            _ => true,
        }
    }
}
