//! The loops of a shader.

use super::bounds::Bounds;
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
    /// Where the limit's number stands: the limit itself, or the argument of a call where it is a
    /// parameter.
    pub given: Option<ExprId>,
    /// The most turns that it takes, where the text tells.
    pub turns: Option<u64>,
    /// Whether a counter that goes steadily towards a limit ends it, even where its value is not
    /// known.
    pub is_counted: bool,
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
        let bounds = Bounds::new(program, calls);
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
                given: None,
                turns: None,
                is_counted: false,
                ends_early: early.get_mut(i).is_some_and(|e| *e),
            };
            bounds.find(&mut found);
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
