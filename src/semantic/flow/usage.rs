//! What becomes of each variable: whether its value is ever used, and where it is only written.

use super::Structure;
use crate::semantic::{Program, VariableId};
use crate::syntax::ast::*;

/// How the variables of a shader are used.
#[derive(Default, Debug)]
pub struct Usage {
    /// By variable.
    read: Vec<bool>,
    /// Each assignment whose value goes nowhere but into its variable, in the order of the tree.
    writes: Vec<(VariableId, ExprId)>,
}

impl Usage {
    /// Looks at every name in a shader.
    pub fn of(program: &Program, structure: &Structure) -> Usage {
        let mut usage = Usage {
            read: vec![false; program.variables.len()],
            writes: Vec::new(),
        };
        for (i, expr) in program.tree.exprs.iter().enumerate() {
            let id = ExprId(i as u32);
            let ExprKind::Name(_) = expr.kind else {
                continue;
            };
            let Some(variable) = program.variable_of(id) else {
                continue;
            };
            match written_by(program, structure, id) {
                Some(assignment) => usage.writes.push((variable, assignment)),
                None => {
                    if let Some(slot) = usage.read.get_mut(variable.0 as usize) {
                        *slot = true;
                    }
                }
            }
        }
        usage.writes.sort_by_key(|w| w.0);
        usage
    }

    /// Whether anything makes use of a variable's value.
    pub fn is_read(&self, variable: VariableId) -> bool {
        self.read.get(variable.0 as usize).is_none_or(|r| *r)
    }

    /// The assignments to a variable that do nothing but write to it.
    pub fn writes(&self, variable: VariableId) -> impl Iterator<Item = ExprId> {
        let from = self.writes.partition_point(|w| w.0 < variable);
        let rest = self.writes.get(from..).unwrap_or(&[]);
        rest.iter()
            .take_while(move |w| w.0 == variable)
            .map(|w| w.1)
    }
}

/// The assignment that writes to the variable at a name and does no more with it; `None` where the
/// value is used.
fn written_by(program: &Program, structure: &Structure, name: ExprId) -> Option<ExprId> {
    let mut at = name;
    loop {
        let parent = structure.parent(at)?;
        match program.tree.expr(parent).kind {
            ExprKind::Paren(_) | ExprKind::Member(..) => at = parent,
            ExprKind::Index(object, _) if object == at => at = parent,
            ExprKind::Assign(_, target, _) if target == at => {
                return is_dropped(program, structure, parent).then_some(parent);
            }
            ExprKind::Postfix(..) => {
                return is_dropped(program, structure, parent).then_some(parent);
            }
            ExprKind::Unary(op, _) if op.assigns() => {
                return is_dropped(program, structure, parent).then_some(parent);
            }
            _ => return None,
        }
    }
}

/// Whether nothing makes use of the value of an expression.
pub fn is_dropped(program: &Program, structure: &Structure, expr: ExprId) -> bool {
    let tree = &program.tree;
    let mut at = expr;
    while let Some(parent) = structure.parent(at) {
        match tree.expr(parent).kind {
            ExprKind::Paren(_) => at = parent,
            ExprKind::Comma(left, _) if left == at => return true,
            ExprKind::Comma(..) => at = parent,
            _ => return false,
        }
    }
    let Some(stmt) = structure.stmt_of(at) else {
        return false;
    };
    match tree.stmt(stmt).kind {
        StmtKind::For { step, .. } => step == Some(at),
        StmtKind::Expr(_) => {
            let outer = structure.outer(stmt).map(|s| tree.stmt(s).kind);
            !matches!(outer,
                Some(StmtKind::For { condition: Some(c), .. }) if c == stmt)
                && !matches!(outer,
                Some(StmtKind::While { condition, .. }) if condition == stmt)
        }
        _ => false,
    }
}
