//! What is known of a variable at one place: by the last write before it, and by the conditions
//! around it.

use super::evaluate::{Evaluator, LENGTH};
use super::guards::Guard;
use super::interval::{Range, above, below};
use super::is_same;
use super::places::{ChangeKind, PlaceId};
use crate::semantic::{Base, BuiltinId, Scalar, Storage, VariableId};
use crate::syntax::ast::*;

/// How many conditions around an expression are looked at.
const MAX_GUARDS: usize = 24;

/// What a condition may speak of.
#[derive(Clone, Copy)]
enum Subject {
    /// A component of a variable.
    Variable(VariableId, u8),
    /// An expression, written alike.
    Written(ExprId),
}

impl Evaluator<'_> {
    /// Narrows by the conditions around that speak of the same expression: `f(x) > 0.0 ? log(f(x))`.
    pub(super) fn narrow_written(&self, expr: ExprId, range: &mut Range) {
        let tree = &self.program.tree;
        if self.ranges.places.named(self.program, expr).is_some() {
            return;
        }
        let mut conditions = Vec::new();
        let mut inner = expr;
        for _ in 0..MAX_GUARDS {
            let Some(outer) = self.structure.parent(inner) else {
                break;
            };
            if let ExprKind::Ternary(c, a, _) = tree.expr(outer).kind
                && inner != c
            {
                conditions.push((c, inner == a));
            }
            inner = outer;
        }
        let around = self.structure.stmt_of(expr).into_iter();
        let around = around.flat_map(|s| self.ranges.guards.around(s).take(MAX_GUARDS));
        conditions.extend(around.filter_map(|g| match g {
            Guard::Holds {
                condition, truth, ..
            } => Some((condition, truth)),
            Guard::Loop(_) => None,
        }));
        let before = *range;
        for (condition, truth) in conditions {
            self.apply(condition, truth, Subject::Written(expr), range, 0);
        }
        if range.lo.value > range.hi.value {
            *range = Range::ANY.like(&before);
        }
    }

    /// The value that a variable has at a place because the last write before it, in the order of
    /// the text, always runs just before it.
    pub(super) fn last_written(
        &self,
        at: ExprId,
        id: VariableId,
        component: u8,
        depth: u32,
    ) -> Option<Range> {
        let program = self.program;
        let tree = &program.tree;
        self.narrowable(PlaceId(id.0))?;
        if component == LENGTH || !program.variable(id)?.written {
            return None;
        }
        let here = tree.expr(at).extent.first;
        let places = &self.ranges.places;
        let change = places.last_change(id, component, here)?;
        let by = match change.kind {
            ChangeKind::First(init) => init,
            ChangeKind::Assigned(assign) => assign,
            ChangeKind::Other => return None,
        };
        let written = self.structure.stmt_of(by)?;
        let is_alone = match tree.stmt(written).kind {
            StmtKind::Expr(e) => e == by,
            StmtKind::Decl(_) => matches!(change.kind, ChangeKind::First(_)),
            _ => false,
        };
        let block = self.structure.outer(written)?;
        if !is_alone || !matches!(tree.stmt(block).kind, StmtKind::Block(_)) {
            return None;
        }
        let ways = self.structure.outwards(self.structure.stmt_of(at)?);
        let mut is_inside = false;
        for outer in ways.take(MAX_GUARDS) {
            if outer == block {
                is_inside = true;
                break;
            }
            let stmt = tree.stmt(outer);
            let is_loop = matches!(
                stmt.kind,
                StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. }
            );
            // What a turn writes, the next one reads.
            if is_loop && places.is_written_in(id, stmt.extent.first, stmt.extent.last + 1) {
                return None;
            }
        }
        if !is_inside {
            return None;
        }
        match change.kind {
            ChangeKind::First(init) => Some(self.part(init, component, depth + 1)),
            _ => self.assigned(by, component, depth + 1),
        }
    }

    /// The value of a component of a variable once an assignment has run.
    fn assigned(&self, assign: ExprId, component: u8, depth: u32) -> Option<Range> {
        let ExprKind::Assign(op, target, value) = self.program.tree.expr(assign).kind else {
            return None;
        };
        let (_, to) = self.ranges.places.named(self.program, target)?;
        let at = match to {
            Some(to) => to.position(component)?,
            None => component,
        };
        Some(match op {
            None => self.part(value, at, depth),
            Some(op) => self.binary(op, target, value, at, depth),
        })
    }

    /// The variable whose value conditions can tell something of: nobody else writes to it.
    pub(super) fn narrowable(&self, place: PlaceId) -> Option<VariableId> {
        let id = VariableId(place.0);
        let variable = self.program.variable(id)?;
        let is_own = matches!(variable.storage, Storage::Local | Storage::Param(_));
        let is_plain = !variable.ty.is_array() && !matches!(variable.ty.base, Base::Struct(_));
        ((is_own || !variable.written) && is_plain).then_some(id)
    }

    /// Narrows a variable's range at a place by the conditions around it.
    pub(super) fn narrow(
        &self,
        at: ExprId,
        variable: VariableId,
        component: u8,
        range: &mut Range,
        depth: u32,
    ) {
        let tree = &self.program.tree;
        let subject = Subject::Variable(variable, component);
        let mut inner = at;
        for _ in 0..MAX_GUARDS {
            let Some(outer) = self.structure.parent(inner) else {
                break;
            };
            match tree.expr(outer).kind {
                ExprKind::Ternary(c, a, _) if inner != c => {
                    self.apply(c, inner == a, subject, range, depth);
                }
                ExprKind::Binary(BinaryOp::And, a, b) if inner == b => {
                    self.apply(a, true, subject, range, depth);
                }
                ExprKind::Binary(BinaryOp::Or, a, b) if inner == b => {
                    self.apply(a, false, subject, range, depth);
                }
                _ => {}
            }
            inner = outer;
        }
        let Some(stmt) = self.structure.stmt_of(at) else {
            return;
        };
        // The step of a `for` and the condition of a `do` run after the body.
        if matches!(
            tree.stmt(stmt).kind,
            StmtKind::For { .. } | StmtKind::Do { .. }
        ) {
            return;
        }
        let here = tree.expr(at).extent.first;
        let places = &self.ranges.places;
        for guard in self.ranges.guards.around(stmt).take(MAX_GUARDS) {
            match guard {
                Guard::Loop(extent)
                    if places.is_written_in(variable, extent.first, extent.last + 1) =>
                {
                    return;
                }
                Guard::Loop(_) => {}
                Guard::Holds { from, .. } if places.is_written_in(variable, from, here) => return,
                Guard::Holds {
                    condition,
                    truth,
                    turns,
                    ..
                } => {
                    self.apply(condition, truth, subject, range, depth);
                    if turns && self.ranges.counters.contains(&variable) {
                        range.touch_ends();
                    }
                }
            }
        }
    }

    /// Narrows by one condition that is true or false.
    fn apply(
        &self,
        condition: ExprId,
        truth: bool,
        subject: Subject,
        range: &mut Range,
        depth: u32,
    ) {
        let tree = &self.program.tree;
        let mut todo = vec![(condition, truth)];
        for _ in 0..MAX_GUARDS {
            let Some((condition, truth)) = todo.pop() else {
                return;
            };
            match tree.expr(tree.unparen(condition)).kind {
                ExprKind::Unary(UnaryOp::Not, inner) => todo.push((inner, !truth)),
                ExprKind::Binary(BinaryOp::And, a, b) if truth => {
                    todo.extend([(a, true), (b, true)])
                }
                ExprKind::Binary(BinaryOp::Or, a, b) if !truth => {
                    todo.extend([(a, false), (b, false)])
                }
                ExprKind::Binary(op, a, b) if op.compares() => {
                    let op = if truth { op } else { negated(op) };
                    if self.is_subject(a, subject) {
                        let is_float = self.program.ty(a).scalar_kind() == Some(Scalar::Float);
                        compare(range, op, self.part(b, 0, depth + 1), is_float);
                    } else if self.is_subject(b, subject) {
                        let is_float = self.program.ty(a).scalar_kind() == Some(Scalar::Float);
                        compare(range, turned(op), self.part(a, 0, depth + 1), is_float);
                    } else if self.is_abs_of(a, subject)
                        && matches!(op, BinaryOp::Less | BinaryOp::LessEqual)
                    {
                        let most = self.part(b, 0, depth + 1).hi.value;
                        range.lower(most);
                        range.raise(-most);
                    }
                }
                _ => {}
            }
        }
    }

    fn is_subject(&self, expr: ExprId, subject: Subject) -> bool {
        if !self.program.ty(expr).is_scalar() {
            return false;
        }
        let (variable, component) = match subject {
            Subject::Variable(variable, component) => (variable, component),
            Subject::Written(written) => return is_same(self.program, expr, written),
        };
        match self.ranges.places.named(self.program, expr) {
            Some((place, named)) => {
                place.0 == variable.0 && named.map_or(Some(0), |n| n.at(0)) == Some(component)
            }
            None => false,
        }
    }

    fn is_abs_of(&self, expr: ExprId, subject: Subject) -> bool {
        let tree = &self.program.tree;
        let expr = tree.unparen(expr);
        match tree.expr(expr).kind {
            ExprKind::Call(_, args) => {
                self.program.builtin_called(expr) == Some(BuiltinId::Abs)
                    && matches!(tree.args(args), &[x] if self.is_subject(x, subject))
            }
            _ => false,
        }
    }
}

/// The operator that is true where `op` is false.
fn negated(op: BinaryOp) -> BinaryOp {
    match op {
        BinaryOp::Less => BinaryOp::GreaterEqual,
        BinaryOp::LessEqual => BinaryOp::Greater,
        BinaryOp::Greater => BinaryOp::LessEqual,
        BinaryOp::GreaterEqual => BinaryOp::Less,
        BinaryOp::Equal => BinaryOp::NotEqual,
        _ => BinaryOp::Equal,
    }
}

/// The operator with its sides changed.
fn turned(op: BinaryOp) -> BinaryOp {
    match op {
        BinaryOp::Less => BinaryOp::Greater,
        BinaryOp::LessEqual => BinaryOp::GreaterEqual,
        BinaryOp::Greater => BinaryOp::Less,
        BinaryOp::GreaterEqual => BinaryOp::LessEqual,
        op => op,
    }
}

/// Narrows a range by what it is compared with.
fn compare(range: &mut Range, op: BinaryOp, with: Range, is_float: bool) {
    let less = |v: f64| if is_float { below(v) } else { v - 1.0 };
    let more = |v: f64| if is_float { above(v) } else { v + 1.0 };
    match op {
        BinaryOp::Less => range.lower(less(with.hi.value)),
        BinaryOp::LessEqual => range.lower(with.hi.value),
        BinaryOp::Greater => range.raise(more(with.lo.value)),
        BinaryOp::GreaterEqual => range.raise(with.lo.value),
        BinaryOp::Equal => {
            range.raise(with.lo.value);
            range.lower(with.hi.value);
        }
        BinaryOp::NotEqual => {
            if let Some(value) = with.single() {
                if range.lo.value == value {
                    range.raise(more(value));
                }
                if range.hi.value == value {
                    range.lower(less(value));
                }
            }
        }
        _ => {}
    }
}
