//! Statements that never complete normally, so that code after them is unreachable.

use crate::Program;
use shaderlint_syntax::ast::*;

/// By statement: whether the code after it is unreachable.
#[derive(Default, Debug)]
pub struct Reachability {
    ends: Vec<bool>,
}

impl Reachability {
    /// Analyses every statement of a shader.
    pub fn of(program: &Program) -> Reachability {
        let tree = &program.tree;
        let mut reach = Reachability {
            ends: Vec::with_capacity(tree.stmts.len()),
        };
        // Inner statements come before outer ones.
        for stmt in &tree.stmts {
            let ends = match stmt.kind {
                StmtKind::Return(_) | StmtKind::Discard | StmtKind::Break | StmtKind::Continue => {
                    true
                }
                StmtKind::Block(body) => tree.block(body).iter().any(|&s| reach.ends(s)),
                StmtKind::If {
                    then,
                    otherwise: Some(otherwise),
                    ..
                } => reach.ends(then) && reach.ends(otherwise),
                _ => false,
            };
            reach.ends.push(ends);
        }
        reach
    }

    /// Whether the code after a statement is unreachable.
    pub fn ends(&self, stmt: StmtId) -> bool {
        self.ends.get(stmt.0 as usize).copied().unwrap_or(false)
    }
}
