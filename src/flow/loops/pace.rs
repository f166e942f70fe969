//! Induction variables: how a loop counter changes per iteration.

use crate::ranges::{Interval, Query};
use crate::reaching_definitions::{Def, DefId};
use crate::same::is_same;
use shaderlint_ir::{Binary, LoopId, OpId, OpKind, Root};

/// Upper bound of the factor by which Euclid's algorithm shrinks a number per iteration: 1 / golden
/// ratio.
const EUCLID: f64 = 0.618;
/// Maximum number of steps per query.
const BUDGET: u32 = 64;

/// How a value changes relative to its value at the start of an iteration.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Pace {
    /// A value in this range is added; `is_invariant` if it is loop-invariant.
    By {
        lo: f64,
        hi: f64,
        is_invariant: bool,
    },
    /// It is multiplied by a factor, which is not zero.
    Times(f64),
}

/// A value derived from a loop head.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Moved {
    /// The definition at the loop head.
    pub head: DefId,
    /// The change relative to it.
    pub pace: Pace,
}

impl Pace {
    const NONE: Pace = Pace::By {
        lo: 0.0,
        hi: 0.0,
        is_invariant: true,
    };

    fn then(self, next: Pace) -> Option<Pace> {
        match (self, next) {
            (same, Pace::NONE) | (Pace::NONE, same) => Some(same),
            (
                Pace::By {
                    lo,
                    hi,
                    is_invariant,
                },
                Pace::By {
                    lo: a,
                    hi: b,
                    is_invariant: other,
                },
            ) => Some(Pace::By {
                lo: lo + a,
                hi: hi + b,
                is_invariant: is_invariant && other,
            }),
            _ => None,
        }
    }

    fn or(self, other: Pace) -> Option<Pace> {
        match (self, other) {
            (a, b) if a == b => Some(a),
            (Pace::By { lo, hi, .. }, Pace::By { lo: a, hi: b, .. }) => Some(Pace::By {
                lo: lo.min(a),
                hi: hi.max(b),
                is_invariant: false,
            }),
            _ => None,
        }
    }
}

/// Traces values back to a loop head.
pub(super) struct Tracer<'x> {
    pub query: Query<'x>,
    pub looped: LoopId,
    /// The loop head to trace to; any if `None`.
    pub target: Option<DefId>,
    /// Constants that some iterations assign to the counter, regardless of its value.
    pub jumps: Vec<f64>,
    left: u32,
}

impl<'x> Tracer<'x> {
    pub(super) fn new(query: Query<'x>, looped: LoopId) -> Tracer<'x> {
        Tracer {
            query,
            looped,
            target: None,
            jumps: Vec::new(),
            left: BUDGET,
        }
    }

    /// Expresses a value as a loop head and a change.
    pub(super) fn value(&mut self, op: OpId, lane: u32) -> Option<Moved> {
        self.left = self.left.checked_sub(1)?;
        let (module, defs) = (self.query.module, self.query.defs);
        match module.op(op).kind {
            OpKind::Load(_) => self.def(defs.seen(op, lane)),
            OpKind::Convert(a) => self.value(a, lane),
            OpKind::Select {
                then, otherwise, ..
            } => {
                let (a, b) = (self.value(then, lane)?, self.value(otherwise, lane)?);
                a.or(b)
            }
            OpKind::Binary(kind, a, b) => self.binary(kind, a, b, lane),
            _ => {
                let (op, lane) = defs.part_of(module, op, lane)?;
                self.value(op, lane)
            }
        }
    }

    fn binary(&mut self, kind: Binary, a: OpId, b: OpId, lane: u32) -> Option<Moved> {
        let factor = |op| slowest(self.query.lane(op, lane));
        let times = match kind {
            Binary::Add => return self.sum(a, b, lane),
            Binary::Subtract => {
                let moved = self.value(a, lane)?;
                let by = self.by(b, lane, -1.0);
                return moved.then(by);
            }
            Binary::Multiply => match factor(b) {
                Some(by) => by,
                None => {
                    let by = factor(a)?;
                    return self.value(b, lane)?.then(Pace::Times(by));
                }
            },
            Binary::Divide => 1.0 / factor(b)?,
            Binary::ShiftLeft => factor(b)?.exp2(),
            Binary::ShiftRight => (-factor(b)?).exp2(),
            // A remainder is smaller than the divisor, as in Euclid's algorithm.
            Binary::Remainder => {
                let moved = self.value(b, lane)?;
                let is_own = moved.pace == Pace::NONE;
                return is_own.then_some(moved)?.then(Pace::Times(EUCLID));
            }
            _ => return None,
        };
        self.value(a, lane)?.then(Pace::Times(times))
    }

    fn sum(&mut self, a: OpId, b: OpId, lane: u32) -> Option<Moved> {
        let (left, right) = (self.value(a, lane), self.value(b, lane));
        match (left, right) {
            // `i += i`
            (Some(x), Some(y)) if x == y && x.pace == Pace::NONE => x.then(Pace::Times(2.0)),
            // `t += 0.1 * t`
            (Some(x), Some(y)) if x.head == y.head && x.pace == Pace::NONE => match y.pace {
                Pace::Times(by) => x.then(Pace::Times(1.0 + by)),
                Pace::By { .. } => None,
            },
            (Some(moved), None) => moved.then(self.by(b, lane, 1.0)),
            (None, Some(moved)) => moved.then(self.by(a, lane, 1.0)),
            _ => None,
        }
    }

    fn by(&mut self, op: OpId, lane: u32, sign: f64) -> Pace {
        let range = self.query.lane(op, lane);
        let (lo, hi) = (range.lo.value * sign, range.hi.value * sign);
        Pace::By {
            lo: lo.min(hi),
            hi: lo.max(hi),
            is_invariant: is_invariant(self.query, self.looped, op),
        }
    }

    /// Expresses a definition as a loop head and a change.
    pub(super) fn def(&mut self, def: DefId) -> Option<Moved> {
        self.left = self.left.checked_sub(1)?;
        let defs = self.query.defs;
        let def = defs.unrefined(def);
        match defs.get(def) {
            Def::Head { of, .. } if of == self.looped => {
                let is_target = self.target.is_none_or(|target| target == def);
                is_target.then_some(Moved {
                    head: def,
                    pace: Pace::NONE,
                })
            }
            // An inner loop that moves the value in one direction.
            Def::Head { of, init, back, .. } if self.is_inside(def) => {
                let moved = self.def(init)?;
                let mut inner = Tracer {
                    looped: of,
                    ..Tracer::new(self.query, of)
                };
                inner.left = self.left / 2;
                let iteration = inner.def(back).filter(|iteration| iteration.head == def)?;
                let Pace::By { lo, hi, .. } = iteration.pace else {
                    return None;
                };
                let any = |by: f64| if by == 0.0 { 0.0 } else { by * f64::INFINITY };
                moved.then(Pace::By {
                    lo: any(lo.min(0.0)),
                    hi: any(hi.max(0.0)),
                    is_invariant: false,
                })
            }
            Def::Stored { value, lane } => self.value(value, lane),
            Def::Merge { sides, .. } => {
                let mut joined: Option<Moved> = None;
                for side in defs.list(sides) {
                    if let Some(number) = self.jump(*side) {
                        self.jumps.push(number);
                        continue;
                    }
                    let moved = self.def(*side)?;
                    joined = Some(match joined {
                        Some(known) => known.or(moved)?,
                        None => moved,
                    });
                }
                joined
            }
            _ => None,
        }
    }

    /// The constant that a definition assigns, if there is one.
    fn jump(&self, def: DefId) -> Option<f64> {
        let (module, defs) = (self.query.module, self.query.defs);
        let Def::Stored { value, lane } = defs.get(defs.unrefined(def)) else {
            return None;
        };
        if let OpKind::Binary(Binary::Subtract, a, b) = module.op(value).kind
            && is_same(module, defs, a, b)
        {
            return Some(0.0);
        }
        self.query.lane(value, lane).single()
    }

    fn is_inside(&self, def: DefId) -> bool {
        self.query.defs.made_in(self.looped).contains(&def)
    }
}

impl Moved {
    fn then(self, next: Pace) -> Option<Moved> {
        let pace = self.pace.then(next)?;
        Some(Moved { pace, ..self })
    }

    fn or(self, other: Moved) -> Option<Moved> {
        let pace = self.pace.or(other.pace)?;
        (self.head == other.head).then_some(Moved { pace, ..self })
    }
}

/// The factor that changes a value least: the smallest if all are at least 1, the largest if all
/// are in 0..1; the only one if it is negative.
fn slowest(range: Interval) -> Option<f64> {
    let (lo, hi) = (range.lo.value, range.hi.value);
    match range.single() {
        Some(one) => Some(one).filter(|v| *v != 0.0),
        None if lo >= 1.0 => Some(lo),
        None => Some(hi).filter(|_| lo > 0.0 && hi <= 1.0),
    }
}

/// Whether a value is loop-invariant.
pub(crate) fn is_invariant(query: Query, looped: LoopId, op: OpId) -> bool {
    let (module, defs) = (query.module, query.defs);
    let made = defs.made_in(looped);
    let mut todo = vec![op];
    for _ in 0..BUDGET {
        let Some(op) = todo.pop() else {
            return true;
        };
        match module.op(op).kind {
            OpKind::Undef | OpKind::Unknown => return false,
            OpKind::Load(_) => {
                let lanes = 0..defs.lanes_of(op).max(1);
                let mut seen = lanes.map(|lane| defs.unrefined(defs.seen(op, lane)));
                let is_own = |def: DefId| made.contains(&def) && !is_entry(query, looped, def);
                if seen.any(is_own) {
                    return false;
                }
            }
            _ => {}
        }
        module.each_operand(op, |operand| todo.push(operand));
    }
    false
}

/// Whether a definition made inside the loop is an unchanged value from before it.
fn is_entry(query: Query, looped: LoopId, def: DefId) -> bool {
    let defs = query.defs;
    match defs.get(def) {
        Def::Measured(parts) => {
            let made = defs.made_in(looped);
            let mut parts = defs.list(parts).iter().map(|part| defs.unrefined(*part));
            parts.all(|part| !made.contains(&part) || is_entry(query, looped, part))
        }
        Def::Entry(slot) => {
            let (id, _) = defs.variable_at(slot);
            let root = query.module.variable(id).map(|v| v.root);
            let is_local = matches!(root, Some(Root::Local | Root::Temporary));
            let mut heads = defs.heads(looped);
            let is_written = heads.any(
                |head| matches!(defs.get(head), Def::Head { slot: written, .. } if written == slot),
            );
            !is_local && !is_written
        }
        _ => false,
    }
}
