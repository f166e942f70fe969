//! What conditions tell of the code behind them: inside `if (x > 0.0)`, and after
//! `if (x <= 0.0) return;`, `x` is positive.

use crate::semantic::Program;
use crate::semantic::flow::each_inner;
use crate::syntax::ast::*;

/// A condition, or a loop that carries values from one turn to the next.
#[derive(Clone, Copy, Debug)]
pub enum Guard {
    /// The condition is true, or false, from a token on.
    Holds {
        /// The condition.
        condition: ExprId,
        /// Whether it is true.
        truth: bool,
        /// The first token behind it.
        from: TokenId,
        /// Whether a loop goes on while it holds, so that its last turn comes near to the limit.
        turns: bool,
    },
    /// A loop begins.
    Loop(Extent),
}

/// The guards around each statement, innermost first, as lists that share their ends.
#[derive(Default, Debug)]
pub struct Guards {
    nodes: Vec<(Guard, Option<u32>)>,
    first: Vec<Option<u32>>,
}

impl Guards {
    /// Finds the guards of a shader.
    pub fn of(program: &Program) -> Guards {
        let tree = &program.tree;
        let leaves = leaves(tree);
        let mut guards = Guards {
            nodes: Vec::new(),
            first: vec![None; tree.stmts.len()],
        };
        // What is around a statement has a higher number.
        for i in (0..tree.stmts.len()).rev() {
            let around = guards.first.get(i).copied().flatten();
            guards.hand_down(tree, tree.stmt(StmtId(i as u32)), around, &leaves);
        }
        guards
    }

    /// The guards of a statement, innermost first.
    pub fn around(&self, stmt: StmtId) -> impl Iterator<Item = Guard> {
        let first = self.first.get(stmt.0 as usize).copied().flatten();
        let node = |i: Option<u32>| self.nodes.get(i? as usize).copied();
        std::iter::successors(node(first), move |(_, next)| node(*next)).map(|(g, _)| g)
    }

    fn push(&mut self, guard: Guard, around: Option<u32>) -> Option<u32> {
        self.nodes.push((guard, around));
        Some(self.nodes.len() as u32 - 1)
    }

    fn set(&mut self, stmt: StmtId, guards: Option<u32>) {
        if let Some(slot) = self.first.get_mut(stmt.0 as usize) {
            *slot = guards;
        }
    }

    fn hand_down(&mut self, tree: &Tree, stmt: &Stmt, around: Option<u32>, leaves: &[bool]) {
        let holds = |condition, truth, from| Guard::Holds {
            condition,
            truth,
            from,
            turns: false,
        };
        match stmt.kind {
            StmtKind::Block(body) => {
                let mut guards = around;
                for &child in tree.block(body) {
                    self.set(child, guards);
                    let inner = tree.stmt(child);
                    let StmtKind::If {
                        condition,
                        then,
                        otherwise,
                    } = inner.kind
                    else {
                        continue;
                    };
                    let is_left = |s: StmtId| leaves.get(s.0 as usize) == Some(&true);
                    let behind = inner.extent.last + 1;
                    match otherwise {
                        None if is_left(then) => {
                            guards = self.push(holds(condition, false, behind), guards);
                        }
                        Some(other) if is_left(other) && !is_left(then) => {
                            guards = self.push(holds(condition, true, behind), guards);
                        }
                        _ => {}
                    }
                }
            }
            StmtKind::If {
                condition,
                then,
                otherwise,
            } => {
                let from = tree.stmt(then).extent.first;
                let guards = self.push(holds(condition, true, from), around);
                self.set(then, guards);
                if let Some(other) = otherwise {
                    let from = tree.stmt(other).extent.first;
                    let guards = self.push(holds(condition, false, from), around);
                    self.set(other, guards);
                }
            }
            StmtKind::For {
                condition, body, ..
            } => {
                each_inner(tree, stmt, |child| self.set(child, around));
                self.turn(tree, stmt, condition, body, around);
            }
            StmtKind::While { condition, body } => {
                self.turn(tree, stmt, Some(condition), body, around);
            }
            StmtKind::Do { body, .. } => self.turn(tree, stmt, None, body, around),
            // A jump to a label passes by what stands before it.
            _ => each_inner(tree, stmt, |child| self.set(child, around)),
        }
    }

    /// The guards of a loop's condition and body.
    fn turn(
        &mut self,
        tree: &Tree,
        stmt: &Stmt,
        condition: Option<StmtId>,
        body: StmtId,
        around: Option<u32>,
    ) {
        let mut guards = self.push(Guard::Loop(stmt.extent), around);
        if let Some(id) = condition {
            self.set(id, guards);
            if let StmtKind::Expr(condition) = tree.stmt(id).kind {
                let guard = Guard::Holds {
                    condition,
                    truth: true,
                    from: tree.stmt(body).extent.first,
                    turns: true,
                };
                guards = self.push(guard, guards);
            }
        }
        self.set(body, guards);
    }
}

/// By statement: whether nothing behind it in its block runs after it.
fn leaves(tree: &Tree) -> Vec<bool> {
    let mut leaves: Vec<bool> = Vec::with_capacity(tree.stmts.len());
    for stmt in &tree.stmts {
        let of = |s: StmtId| leaves.get(s.0 as usize) == Some(&true);
        let is_left = match stmt.kind {
            StmtKind::Return(_) | StmtKind::Discard | StmtKind::Break | StmtKind::Continue => true,
            StmtKind::Block(body) => tree.block(body).iter().any(|&s| of(s)),
            StmtKind::If {
                then,
                otherwise: Some(other),
                ..
            } => of(then) && of(other),
            _ => false,
        };
        leaves.push(is_left);
    }
    leaves
}
