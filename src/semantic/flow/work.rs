//! How much the functions of a shader do: operations, and turns of loops.

use super::lists::Lists;
use super::{CallGraph, Structure, each_inner};
use crate::semantic::{BuiltinId, FunctionRef, Program, Resolution};
use crate::syntax::ast::*;
use rustc_hash::FxHashMap;

/// The loops of a shader, and how often each turns at most, where that is known.
pub type LoopTurns = FxHashMap<StmtId, Option<u64>>;

/// How often a loop is taken to turn where the text does not tell.
const UNKNOWN_TURNS: f64 = 8.0;

/// Work of a shader's functions. All figures are of the worst case: no early exit, the longer side
/// of each `if`.
#[derive(Default, Debug)]
pub struct Work {
    /// By function: operations of one call, the functions that it calls included.
    operations: Vec<f64>,
    /// By function: operations in its text when every call is replaced by the callee's text.
    size: Vec<f64>,
    /// By function: turns of innermost loops in one call.
    turns: Vec<f64>,
    /// By statement: turns of innermost loops each time that it runs.
    stmt_turns: Vec<f64>,
    /// By statement: the call in it that turns most, if any does.
    stmt_call: Vec<Option<FunctionRef>>,
}

/// A loop on the way to where a shader spends its time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Nest {
    /// The loop.
    pub stmt: StmtId,
    /// How often it turns each time that it is reached.
    pub turns: u64,
}

impl Work {
    /// Adds up the work of a shader.
    pub fn of(
        program: &Program,
        structure: &Structure,
        calls: &CallGraph,
        loops: &LoopTurns,
    ) -> Work {
        let tree = &program.tree;
        let functions = program.functions.len();
        let mut work = Work {
            operations: vec![0.0; functions],
            size: vec![0.0; functions],
            turns: vec![0.0; functions],
            stmt_turns: vec![0.0; tree.stmts.len()],
            stmt_call: vec![None; tree.stmts.len()],
        };
        let often = often(tree, loops);
        for (i, expr) in tree.exprs.iter().enumerate() {
            let id = ExprId(i as u32);
            let cost = own_cost(program, id, expr);
            if cost == 0.0 {
                continue;
            }
            let Some(stmt) = structure.stmt_of(id) else {
                continue;
            };
            let Some(function) = structure.function_of(stmt) else {
                continue;
            };
            let times = often.get(stmt.0 as usize).copied().unwrap_or(1.0);
            add(&mut work.operations, function.0, cost * times);
            add(&mut work.size, function.0, cost);
        }
        let by_function = by_function(tree, structure, functions);
        for function in calls.bottom_up() {
            for call in calls.calls_by(function) {
                let callee = call.callee.0 as usize;
                let get = |all: &[f64]| all.get(callee).copied().unwrap_or(0.0);
                let (operations, size, turns) =
                    (get(&work.operations), get(&work.size), get(&work.turns));
                let stmt = structure.stmt_of(call.expr).unwrap_or(StmtId(u32::MAX));
                let times = often.get(stmt.0 as usize).copied().unwrap_or(1.0);
                add(&mut work.operations, function.0, operations * times);
                add(&mut work.size, function.0, size);
                add(&mut work.stmt_turns, stmt.0, turns);
                work.note_call(stmt, call.callee, turns);
            }
            // Children stand before their parents.
            for &stmt in by_function.get(function.0) {
                work.close(tree, loops, stmt);
            }
            let decl = program
                .function(function)
                .and_then(|f| tree.function(f.definition?));
            if let Some(body) = decl.and_then(|d| d.body) {
                let turns = work.turns_of_stmt(body);
                add(&mut work.turns, function.0, turns);
            }
        }
        work
    }

    /// Operations of one call of a function.
    pub fn operations(&self, function: FunctionRef) -> f64 {
        self.operations
            .get(function.0 as usize)
            .copied()
            .unwrap_or(0.0)
    }

    /// Operations in the text of a function once all calls are replaced by what they call.
    pub fn size(&self, function: FunctionRef) -> f64 {
        self.size.get(function.0 as usize).copied().unwrap_or(0.0)
    }

    /// Turns of innermost loops in one call of a function. A loop whose turns are not known counts
    /// as one.
    pub fn turns(&self, function: FunctionRef) -> f64 {
        self.turns.get(function.0 as usize).copied().unwrap_or(0.0)
    }

    /// The loops, outermost first, in which a call of a function spends most turns.
    pub fn heaviest(&self, program: &Program, loops: &LoopTurns, entry: FunctionRef) -> Vec<Nest> {
        let mut nests = Vec::new();
        let body_of = |f: FunctionRef| {
            let decl = program.function(f)?.definition?;
            program.tree.function(decl)?.body
        };
        let mut at = body_of(entry);
        while let Some(stmt) = at {
            if let Some(turns) = loops.get(&stmt) {
                nests.push(Nest {
                    stmt,
                    turns: turns.unwrap_or(1),
                });
            }
            let mut inner: Option<(f64, StmtId)> = None;
            each_inner(&program.tree, program.tree.stmt(stmt), |s| {
                let turns = self.turns_of_stmt(s);
                if turns > inner.map_or(0.0, |(most, _)| most) {
                    inner = Some((turns, s));
                }
            });
            let called = self.stmt_call.get(stmt.0 as usize).copied().flatten();
            let called = called.filter(|c| self.turns(*c) > inner.map_or(0.0, |(most, _)| most));
            at = match called {
                Some(callee) => body_of(callee),
                None => inner.map(|(_, s)| s),
            };
        }
        nests
    }

    fn turns_of_stmt(&self, stmt: StmtId) -> f64 {
        self.stmt_turns.get(stmt.0 as usize).copied().unwrap_or(0.0)
    }

    /// Finishes a statement whose calls have been counted and whose inner statements are finished.
    fn close(&mut self, tree: &Tree, loops: &LoopTurns, id: StmtId) {
        let stmt = tree.stmt(id);
        let mut inside = 0.0;
        if let StmtKind::If {
            then, otherwise, ..
        } = stmt.kind
        {
            let otherwise = otherwise.map_or(0.0, |s| self.turns_of_stmt(s));
            inside = self.turns_of_stmt(then).max(otherwise);
        } else {
            each_inner(tree, stmt, |s| inside += self.turns_of_stmt(s));
        }
        let Some(slot) = self.stmt_turns.get_mut(id.0 as usize) else {
            return;
        };
        *slot += inside;
        if let Some(turns) = loops.get(&id) {
            *slot = slot.max(1.0) * turns.unwrap_or(1) as f64;
        }
    }

    fn note_call(&mut self, stmt: StmtId, callee: FunctionRef, turns: f64) {
        let Some(slot) = self.stmt_call.get(stmt.0 as usize).copied() else {
            return;
        };
        if turns > slot.map_or(0.0, |c| self.turns(c))
            && let Some(slot) = self.stmt_call.get_mut(stmt.0 as usize)
        {
            *slot = Some(callee);
        }
    }
}

fn add(all: &mut [f64], at: u32, value: f64) {
    if let Some(slot) = all.get_mut(at as usize) {
        // Nests of loops multiply; a figure past all measure must not become infinite.
        *slot = (*slot + value).min(1e30);
    }
}

/// How often each statement runs in one call of its function.
fn often(tree: &Tree, loops: &LoopTurns) -> Vec<f64> {
    let mut often = vec![1.0; tree.stmts.len()];
    // Parents stand behind their children, so the way down is the way back.
    for (i, stmt) in tree.stmts.iter().enumerate().rev() {
        let own = often.get(i).copied().unwrap_or(1.0);
        let turns = loops.get(&StmtId(i as u32));
        let turns = turns.map_or(1.0, |t| t.map_or(UNKNOWN_TURNS, |t| t as f64));
        let inside = f64::min(own * turns, 1e15);
        each_inner(tree, stmt, |s| {
            if let Some(slot) = often.get_mut(s.0 as usize) {
                *slot = inside;
            }
        });
    }
    often
}

/// The statements of each function, children before parents.
fn by_function(tree: &Tree, structure: &Structure, functions: usize) -> Lists<StmtId> {
    let stmts = (0..tree.stmts.len() as u32).map(StmtId);
    let owned = stmts.filter_map(|s| Some((structure.function_of(s)?.0, s)));
    Lists::of(functions, owned)
}

/// Operations of one expression, its operands and callees left out.
fn own_cost(program: &Program, id: ExprId, expr: &Expr) -> f64 {
    if program.expr(id).is_const {
        return 0.0;
    }
    match expr.kind {
        ExprKind::Binary(..) | ExprKind::Unary(..) | ExprKind::Postfix(..) => 1.0,
        ExprKind::Ternary(..) => 1.0,
        ExprKind::Assign(op, ..) => op.is_some() as u8 as f64,
        ExprKind::Call(..) => match program.expr(id).resolution {
            Resolution::Builtin(_) => program.builtin_called(id).map_or(1.0, BuiltinId::cost),
            _ => 0.0,
        },
        _ => 0.0,
    }
}
