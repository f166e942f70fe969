//! How often loops turn.

use super::estimate::Estimate;
use super::{CallGraph, Structure};
use crate::semantic::{FunctionRef, Program, VariableId};
use crate::syntax::ast::*;

/// A loop.
#[derive(Clone, Copy, Debug)]
pub struct Loop {
    /// The statement.
    pub stmt: StmtId,
    /// The function around it.
    pub function: FunctionRef,
    /// The variable that counts the turns.
    pub counter: Option<VariableId>,
    /// What the counter is compared with.
    pub limit: Option<ExprId>,
    /// The most turns that it takes, where the text tells.
    pub turns: Option<u64>,
    /// Whether something besides the counter may end it: `break`, `return`, a second condition.
    pub ends_early: bool,
}

/// All loops of a shader, in the order of the tree.
#[derive(Default, Debug)]
pub struct Loops {
    /// The loops.
    pub all: Vec<Loop>,
}

impl Loops {
    /// Finds the loops of a shader.
    pub fn of(program: &Program, structure: &Structure, calls: &CallGraph) -> Loops {
        let tree = &program.tree;
        let is_loop = |s: &Stmt| {
            matches!(
                s.kind,
                StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. }
            )
        };
        if !tree.stmts.iter().any(is_loop) {
            return Loops::default();
        }
        let estimate = Estimate::new(program, calls);
        let mut early = early_exits(program, structure);
        let mut all = Vec::new();
        for (i, stmt) in tree.stmts.iter().enumerate() {
            let id = StmtId(i as u32);
            let Some(function) = structure.function_of(id).filter(|_| is_loop(stmt)) else {
                continue;
            };
            let mut found = Loop {
                stmt: id,
                function,
                counter: None,
                limit: None,
                turns: None,
                ends_early: early.get_mut(i).is_some_and(|e| *e),
            };
            match stmt.kind {
                StmtKind::For {
                    init,
                    condition: Some(condition),
                    step: Some(step),
                    ..
                } => count(&estimate, program, init, condition, step, &mut found),
                StmtKind::While { .. } | StmtKind::Do { .. } => found.ends_early = true,
                _ => {}
            }
            all.push(found);
        }
        Loops { all }
    }

    /// The loop that a statement is.
    pub fn get(&self, stmt: StmtId) -> Option<&Loop> {
        let at = self.all.binary_search_by_key(&stmt, |l| l.stmt).ok()?;
        self.all.get(at)
    }
}

/// By statement: whether a `break` or `return` inside ends it as a loop.
fn early_exits(program: &Program, structure: &Structure) -> Vec<bool> {
    let tree = &program.tree;
    let mut early = vec![false; tree.stmts.len()];
    for (i, stmt) in tree.stmts.iter().enumerate() {
        let leaves_function = match stmt.kind {
            StmtKind::Return(_) | StmtKind::Discard => true,
            StmtKind::Break => false,
            _ => continue,
        };
        for outer in structure.outwards(StmtId(i as u32)) {
            let kind = tree.stmt(outer).kind;
            let is_loop = matches!(
                kind,
                StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. }
            );
            match early.get_mut(outer.0 as usize) {
                // What is around it is marked already.
                Some(true) if leaves_function => break,
                Some(mark) if is_loop => *mark = true,
                _ => {}
            }
            if !leaves_function && (is_loop || matches!(kind, StmtKind::Switch { .. })) {
                break;
            }
        }
    }
    early
}

/// Finds the counter of a `for` loop, what it is compared with, and the number of turns.
fn count(
    estimate: &Estimate,
    program: &Program,
    init: StmtId,
    condition: StmtId,
    step: ExprId,
    found: &mut Loop,
) {
    let StmtKind::Expr(condition) = program.tree.stmt(condition).kind else {
        return;
    };
    let Some((counter, by)) = estimate.step(step) else {
        return;
    };
    found.counter = Some(counter);
    let mut conditions = Vec::new();
    conjuncts(program, condition, &mut conditions);
    found.ends_early |= conditions.len() > 1;
    let compared = conditions
        .iter()
        .find_map(|&c| compared(program, c, counter));
    let Some((op, limit)) = compared else {
        return;
    };
    found.limit = Some(limit);
    let start = first_value(program, init, counter).and_then(|e| estimate.value(e));
    if let (Some(start), Some(end)) = (start, estimate.value(limit)) {
        found.turns = turns(start, op, end, by);
    }
}

/// The operands of `&&`, taken apart.
fn conjuncts(program: &Program, expr: ExprId, out: &mut Vec<ExprId>) {
    let mut todo = vec![expr];
    while let Some(e) = todo.pop() {
        match program.tree.expr(program.tree.unparen(e)).kind {
            ExprKind::Binary(BinaryOp::And, a, b) => todo.extend([b, a]),
            _ => out.push(e),
        }
    }
}

/// `counter op limit`, turned round where it is written the other way.
fn compared(program: &Program, expr: ExprId, counter: VariableId) -> Option<(BinaryOp, ExprId)> {
    let tree = &program.tree;
    let ExprKind::Binary(op, a, b) = tree.expr(tree.unparen(expr)).kind else {
        return None;
    };
    if !op.compares() {
        return None;
    }
    if program.variable_of(a) == Some(counter) {
        return Some((op, b));
    }
    if program.variable_of(b) != Some(counter) {
        return None;
    }
    let turned = match op {
        BinaryOp::Less => BinaryOp::Greater,
        BinaryOp::Greater => BinaryOp::Less,
        BinaryOp::LessEqual => BinaryOp::GreaterEqual,
        BinaryOp::GreaterEqual => BinaryOp::LessEqual,
        op => op,
    };
    Some((turned, a))
}

/// The expression that gives the counter its first value.
fn first_value(program: &Program, init: StmtId, counter: VariableId) -> Option<ExprId> {
    let tree = &program.tree;
    match tree.stmt(init).kind {
        StmtKind::Decl(id) => match tree.decl(id)?.kind {
            DeclKind::Variables { declarators, .. } => {
                let from = declarators.start as usize;
                let declared = program
                    .declared
                    .get(from..from + declarators.len as usize)?;
                let at = declared.iter().position(|v| *v == Some(counter))?;
                tree.declarators(declarators).get(at)?.init
            }
            _ => None,
        },
        StmtKind::Expr(e) => match tree.expr(e).kind {
            ExprKind::Assign(None, target, value) => {
                (program.variable_of(target) == Some(counter)).then_some(value)
            }
            _ => None,
        },
        _ => None,
    }
}

/// How often a counter from `start` by `by` passes `op end`.
fn turns(start: f64, op: BinaryOp, end: f64, by: f64) -> Option<u64> {
    let way = end - start;
    let count = match op {
        BinaryOp::Less if by > 0.0 => (way / by).ceil(),
        BinaryOp::Greater if by < 0.0 => (way / by).ceil(),
        BinaryOp::LessEqual if by > 0.0 => (way / by).floor() + 1.0,
        BinaryOp::GreaterEqual if by < 0.0 => (way / by).floor() + 1.0,
        BinaryOp::NotEqual if by != 0.0 && way / by >= 0.0 => (way / by).ceil(),
        _ => return None,
    };
    Some(count.max(0.0) as u64)
}
