//! What ends a loop for certain, and after how many turns.

use super::estimate::Estimate;
use super::{CallGraph, Loop, each_written};
use crate::semantic::{BuiltinId, Program, VariableId};
use crate::syntax::ast::*;

/// How a counter moves at each turn.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Pace {
    /// By a number.
    By(f64),
    /// To a multiple.
    Times(f64),
    /// Up by at least something.
    Up,
    /// By something that may not change while the loop runs.
    Steady(ExprId),
}

/// A condition that must hold, or must not hold, for a loop to go on.
#[derive(Clone, Copy, Debug)]
enum Goes {
    While(ExprId),
    Unless(ExprId),
}

/// `counter op limit`, for as long as which a loop goes on.
#[derive(Clone, Copy, Debug)]
struct Bound {
    counter: VariableId,
    op: BinaryOp,
    limit: ExprId,
}

/// Finds what ends loops.
pub(super) struct Bounds<'a> {
    program: &'a Program,
    estimate: Estimate<'a>,
    /// By variable: the first tokens of the expressions that write to it, in order.
    writes: Vec<Vec<TokenId>>,
}

impl<'a> Bounds<'a> {
    /// Prepares to look at the loops of a shader.
    pub(super) fn new(program: &'a Program, calls: &'a CallGraph) -> Bounds<'a> {
        let mut writes = vec![Vec::new(); program.variables.len()];
        for (i, expr) in program.tree.exprs.iter().enumerate() {
            each_written(program, ExprId(i as u32), |v| {
                if let Some(list) = writes.get_mut(v.0 as usize) {
                    list.push(expr.extent.first);
                }
            });
        }
        writes.iter_mut().for_each(|list| list.sort_unstable());
        Bounds {
            program,
            estimate: Estimate::new(program, calls),
            writes,
        }
    }

    /// Fills in the counter, the limit and the turns of a loop.
    pub(super) fn find(&self, found: &mut Loop) {
        let tree = &self.program.tree;
        let mut goes = Vec::new();
        let mut paces = Vec::new();
        let (init, body) = match tree.stmt(found.stmt).kind {
            StmtKind::For {
                init,
                condition,
                step,
                body,
            } => {
                condition
                    .into_iter()
                    .for_each(|c| self.condition(c, &mut goes));
                step.into_iter().for_each(|s| self.paces(s, &mut paces));
                (Some(init), body)
            }
            StmtKind::While { condition, body } => {
                self.condition(condition, &mut goes);
                (None, body)
            }
            StmtKind::Do { body, condition } => {
                self.split(Goes::While(condition), &mut goes);
                (None, body)
            }
            _ => return,
        };
        found.ends_early |= goes.len() > 1 || init.is_none();
        self.body(body, &mut goes, &mut paces);
        let extent = tree.stmt(found.stmt).extent;
        for go in goes {
            let Some(bound) = self.bound(go, &mut paces) else {
                continue;
            };
            let Some(&(_, pace)) = paces.iter().find(|(v, _)| *v == bound.counter) else {
                continue;
            };
            self.take(found, bound, pace, init, extent);
        }
    }

    /// Takes a bound over where it says more than what is known.
    fn take(
        &self,
        found: &mut Loop,
        bound: Bound,
        pace: Pace,
        init: Option<StmtId>,
        extent: Extent,
    ) {
        let heads_there = match (bound.op, pace) {
            (BinaryOp::Less | BinaryOp::LessEqual, Pace::By(by)) => by > 0.0,
            (BinaryOp::Greater | BinaryOp::GreaterEqual, Pace::By(by)) => by < 0.0,
            (BinaryOp::Less | BinaryOp::LessEqual, Pace::Times(by)) => by > 1.0,
            (BinaryOp::Greater | BinaryOp::GreaterEqual, Pace::Times(by)) => by < 1.0,
            (BinaryOp::Less | BinaryOp::LessEqual, Pace::Up) => true,
            (BinaryOp::NotEqual, Pace::By(by)) => by != 0.0,
            // Whole numbers that are shifted come to zero.
            (BinaryOp::NotEqual, Pace::Times(by)) => by < 1.0,
            (_, Pace::Steady(by)) => self.is_still(by, extent),
            _ => false,
        };
        let head = init.map_or(0, |i| {
            self.writes_in(bound.counter, self.program.tree.stmt(i).extent)
        });
        if !heads_there || self.writes_in(bound.counter, extent) != 1 + head {
            return;
        }
        if !self.is_still(bound.limit, extent) {
            return;
        }
        found.is_counted = true;
        let start = self.start(init, bound.counter, extent);
        let turns = start
            .zip(self.estimate.value(bound.limit))
            .and_then(|(start, end)| turns(start, bound.op, end, pace));
        let is_less = turns.is_some_and(|t| found.turns.is_none_or(|known| t < known));
        if found.counter.is_none() || is_less {
            found.counter = Some(bound.counter);
            found.limit = Some(bound.limit);
            found.given = Some(self.estimate.source(bound.limit));
            found.turns = turns;
        }
    }

    fn condition(&self, condition: StmtId, goes: &mut Vec<Goes>) {
        if let StmtKind::Expr(e) = self.program.tree.stmt(condition).kind {
            self.split(Goes::While(e), goes);
        }
    }

    /// Takes `a && b` apart, and `a || b` where it ends the loop.
    fn split(&self, whole: Goes, goes: &mut Vec<Goes>) {
        let tree = &self.program.tree;
        let mut todo = vec![whole];
        while let Some(go) = todo.pop() {
            match go {
                Goes::While(e) => match tree.expr(tree.unparen(e)).kind {
                    ExprKind::Binary(BinaryOp::And, a, b) => {
                        todo.extend([Goes::While(b), Goes::While(a)]);
                    }
                    ExprKind::Unary(UnaryOp::Not, a) => todo.push(Goes::Unless(a)),
                    _ => goes.push(go),
                },
                Goes::Unless(e) => match tree.expr(tree.unparen(e)).kind {
                    ExprKind::Binary(BinaryOp::Or, a, b) => {
                        todo.extend([Goes::Unless(b), Goes::Unless(a)]);
                    }
                    ExprKind::Unary(UnaryOp::Not, a) => todo.push(Goes::While(a)),
                    _ => goes.push(go),
                },
            }
        }
    }

    /// What runs at each turn: the statements of the body itself, as if it had no `continue`.
    fn body(&self, body: StmtId, goes: &mut Vec<Goes>, paces: &mut Vec<(VariableId, Pace)>) {
        let tree = &self.program.tree;
        let one = [body];
        let stmts = match tree.stmt(body).kind {
            StmtKind::Block(list) => tree.block(list),
            _ => &one,
        };
        for &stmt in stmts {
            match tree.stmt(stmt).kind {
                StmtKind::Expr(e) => self.paces(e, paces),
                StmtKind::If {
                    condition,
                    then,
                    otherwise: None,
                } if self.leaves(then) => self.split(Goes::Unless(condition), goes),
                _ => {}
            }
        }
    }

    /// Whether a statement is `break;` or `return;`, in a block or not, with anything before it.
    fn leaves(&self, mut stmt: StmtId) -> bool {
        let tree = &self.program.tree;
        loop {
            match tree.stmt(stmt).kind {
                StmtKind::Break | StmtKind::Return(_) => return true,
                StmtKind::Block(list) => match tree.block(list).last() {
                    Some(&last) => stmt = last,
                    None => return false,
                },
                _ => return false,
            }
        }
    }

    /// The counters that an expression moves.
    fn paces(&self, expr: ExprId, paces: &mut Vec<(VariableId, Pace)>) {
        let tree = &self.program.tree;
        let mut todo = vec![expr];
        while let Some(e) = todo.pop() {
            let e = tree.unparen(e);
            if let ExprKind::Comma(a, b) = tree.expr(e).kind {
                todo.extend([b, a]);
                continue;
            }
            if let Some((variable, by)) = self.estimate.step(e) {
                paces.push((variable, Pace::By(by)));
            } else if let Some(found) = self.other_pace(e) {
                paces.push(found);
            }
        }
    }

    fn other_pace(&self, e: ExprId) -> Option<(VariableId, Pace)> {
        let program = self.program;
        let ExprKind::Assign(Some(op), target, by) = program.tree.expr(e).kind else {
            return None;
        };
        let variable = program.variable_of(target)?;
        let known = || self.estimate.value(by).filter(|v| *v > 0.0);
        let pace = match op {
            BinaryOp::Mul => Pace::Times(known()?),
            BinaryOp::Div => Pace::Times(1.0 / known()?),
            BinaryOp::ShiftLeft => Pace::Times(known()?.exp2()),
            BinaryOp::ShiftRight => Pace::Times((-known()?).exp2()),
            BinaryOp::Add if program.variable_of(by) == Some(variable) => Pace::Times(2.0),
            BinaryOp::Add if self.is_above_zero(by) => Pace::Up,
            BinaryOp::Add | BinaryOp::Sub => Pace::Steady(by),
            _ => return None,
        };
        Some((variable, pace))
    }

    /// Whether an expression is `max(x, 0.02)` or `clamp(x, 0.02, 1.0)`, which are never zero.
    fn is_above_zero(&self, e: ExprId) -> bool {
        let program = self.program;
        let e = program.tree.unparen(e);
        let ExprKind::Call(_, args) = program.tree.expr(e).kind else {
            return false;
        };
        let above = |e: &ExprId| self.estimate.value(*e).is_some_and(|v| v > 0.0);
        match (program.builtin_called(e), program.tree.args(args)) {
            (Some(BuiltinId::Max), [a, b]) => above(a) || above(b),
            (Some(BuiltinId::Clamp), [_, low, _]) => above(low),
            _ => false,
        }
    }

    /// `counter op limit` in a condition, where the counter is a variable that moves; `i++ < 9`
    /// moves it by itself.
    fn bound(&self, go: Goes, paces: &mut Vec<(VariableId, Pace)>) -> Option<Bound> {
        let tree = &self.program.tree;
        let (Goes::While(e) | Goes::Unless(e)) = go;
        let ExprKind::Binary(op, a, b) = tree.expr(tree.unparen(e)).kind else {
            return None;
        };
        if !op.compares() {
            return None;
        }
        let op = match go {
            Goes::While(_) => op,
            Goes::Unless(_) => negated(op),
        };
        for (side, limit, op) in [(a, b, op), (b, a, turned(op))] {
            let side = tree.unparen(side);
            if let Some((counter, by)) = self.estimate.step(side) {
                paces.push((counter, Pace::By(by)));
                return Some(Bound { counter, op, limit });
            }
            if let Some(counter) = self.program.variable_of(side)
                && paces.iter().any(|(v, _)| *v == counter)
            {
                return Some(Bound { counter, op, limit });
            }
        }
        None
    }

    fn writes_in(&self, variable: VariableId, extent: Extent) -> usize {
        let Some(all) = self.writes.get(variable.0 as usize) else {
            return 0;
        };
        let from = all.partition_point(|t| *t < extent.first);
        let to = all.partition_point(|t| *t <= extent.last);
        to - from
    }

    /// Whether nothing in a loop writes to what an expression names.
    fn is_still(&self, expr: ExprId, extent: Extent) -> bool {
        let mut todo = vec![expr];
        while let Some(e) = todo.pop() {
            if let Some(v) = self.program.variable_of(e)
                && self.writes_in(v, extent) > 0
            {
                return false;
            }
            let node = self.program.tree.expr(e);
            super::each_operand(&self.program.tree, node, |child| todo.push(child));
        }
        true
    }

    /// The first value of a counter.
    fn start(&self, init: Option<StmtId>, counter: VariableId, extent: Extent) -> Option<f64> {
        let program = self.program;
        let tree = &program.tree;
        if let Some(StmtKind::Expr(e)) = init.map(|i| tree.stmt(i).kind)
            && let ExprKind::Assign(None, target, value) = tree.expr(tree.unparen(e)).kind
            && program.variable_of(target) == Some(counter)
        {
            return self.estimate.value(value);
        }
        let variable = program.variable(counter)?;
        let all = self.writes.get(counter.0 as usize).map_or(0, Vec::len);
        // Nothing but the loop writes to it, so that it starts as it was declared.
        if variable.function.is_none() || all != self.writes_in(counter, extent) {
            return None;
        }
        match self.estimate.initial(counter) {
            Some(first) => self.estimate.value(first),
            // The browser starts every variable at zero.
            None => matches!(variable.storage, crate::semantic::Storage::Local).then_some(0.0),
        }
    }
}

const fn negated(op: BinaryOp) -> BinaryOp {
    match op {
        BinaryOp::Less => BinaryOp::GreaterEqual,
        BinaryOp::Greater => BinaryOp::LessEqual,
        BinaryOp::LessEqual => BinaryOp::Greater,
        BinaryOp::GreaterEqual => BinaryOp::Less,
        BinaryOp::Equal => BinaryOp::NotEqual,
        BinaryOp::NotEqual => BinaryOp::Equal,
        other => other,
    }
}

const fn turned(op: BinaryOp) -> BinaryOp {
    match op {
        BinaryOp::Less => BinaryOp::Greater,
        BinaryOp::Greater => BinaryOp::Less,
        BinaryOp::LessEqual => BinaryOp::GreaterEqual,
        BinaryOp::GreaterEqual => BinaryOp::LessEqual,
        other => other,
    }
}

/// How often a counter from `start` passes `op end`.
fn turns(start: f64, op: BinaryOp, end: f64, pace: Pace) -> Option<u64> {
    let way = match pace {
        Pace::By(by) => (end - start) / by,
        Pace::Times(by) if start > 0.0 && end > 0.0 => (end / start).ln() / by.ln(),
        Pace::Times(_) | Pace::Up | Pace::Steady(_) => return None,
    };
    let count = match op {
        BinaryOp::Less | BinaryOp::Greater => way.ceil(),
        BinaryOp::LessEqual | BinaryOp::GreaterEqual => way.floor() + 1.0,
        BinaryOp::NotEqual if way >= 0.0 => way.ceil(),
        _ => return None,
    };
    Some(count.max(0.0) as u64)
}
