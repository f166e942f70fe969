//! Which node stands in which.

use crate::semantic::{FunctionRef, Program};
use crate::syntax::ast::*;

/// The way up from every expression and statement.
///
/// The tree stores children before parents, so one pass in reverse order hands everything down.
#[derive(Default, Debug)]
pub struct Structure {
    expr_parent: Vec<Option<ExprId>>,
    expr_stmt: Vec<Option<StmtId>>,
    stmt_parent: Vec<Option<StmtId>>,
    stmt_function: Vec<Option<FunctionRef>>,
}

fn set<T: Copy>(all: &mut [Option<T>], index: u32, value: T) {
    if let Some(slot) = all.get_mut(index as usize) {
        *slot = Some(value);
    }
}

fn at<T: Copy>(all: &[Option<T>], index: u32) -> Option<T> {
    all.get(index as usize).copied().flatten()
}

impl Structure {
    /// Finds the parents of everything in a shader.
    pub fn of(program: &Program) -> Structure {
        let tree = &program.tree;
        let mut structure = Structure {
            expr_parent: vec![None; tree.exprs.len()],
            expr_stmt: vec![None; tree.exprs.len()],
            stmt_parent: vec![None; tree.stmts.len()],
            stmt_function: vec![None; tree.stmts.len()],
        };
        for (i, expr) in tree.exprs.iter().enumerate() {
            each_operand(tree, expr, |child| {
                set(&mut structure.expr_parent, child.0, ExprId(i as u32));
            });
        }
        for (i, stmt) in tree.stmts.iter().enumerate() {
            let id = StmtId(i as u32);
            each_inner(tree, stmt, |child| {
                set(&mut structure.stmt_parent, child.0, id);
            });
            each_expr(tree, stmt, |root| set(&mut structure.expr_stmt, root.0, id));
        }
        structure.hand_down(program);
        structure
    }

    fn hand_down(&mut self, program: &Program) {
        for (i, function) in program.functions.iter().enumerate() {
            let decl = function.definition.and_then(|d| program.tree.function(d));
            if let Some(body) = decl.and_then(|d| d.body) {
                set(&mut self.stmt_function, body.0, FunctionRef(i as u32));
            }
        }
        for i in (0..self.stmt_parent.len() as u32).rev() {
            if let Some(function) =
                at(&self.stmt_parent, i).and_then(|p| at(&self.stmt_function, p.0))
            {
                set(&mut self.stmt_function, i, function);
            }
        }
        for i in (0..self.expr_parent.len() as u32).rev() {
            if let Some(stmt) = at(&self.expr_parent, i).and_then(|p| at(&self.expr_stmt, p.0)) {
                set(&mut self.expr_stmt, i, stmt);
            }
        }
    }

    /// The expression that an expression is an operand of.
    pub fn parent(&self, expr: ExprId) -> Option<ExprId> {
        at(&self.expr_parent, expr.0)
    }

    /// The innermost statement around an expression; `None` at global scope.
    pub fn stmt_of(&self, expr: ExprId) -> Option<StmtId> {
        at(&self.expr_stmt, expr.0)
    }

    /// The statement around a statement; `None` for a function's body.
    pub fn outer(&self, stmt: StmtId) -> Option<StmtId> {
        at(&self.stmt_parent, stmt.0)
    }

    /// A statement and those around it, innermost first.
    pub fn outwards(&self, stmt: StmtId) -> impl Iterator<Item = StmtId> {
        std::iter::successors(Some(stmt), |s| self.outer(*s))
    }

    /// The function that a statement belongs to.
    pub fn function_of(&self, stmt: StmtId) -> Option<FunctionRef> {
        at(&self.stmt_function, stmt.0)
    }

    /// The function that an expression belongs to.
    pub fn function_of_expr(&self, expr: ExprId) -> Option<FunctionRef> {
        self.function_of(self.stmt_of(expr)?)
    }
}

/// Calls `visit` with every direct operand of an expression, in the order of evaluation.
pub fn each_operand(tree: &Tree, expr: &Expr, mut visit: impl FnMut(ExprId)) {
    match expr.kind {
        ExprKind::Paren(a)
        | ExprKind::Unary(_, a)
        | ExprKind::Postfix(_, a)
        | ExprKind::Member(a, _) => visit(a),
        ExprKind::Binary(_, a, b)
        | ExprKind::Assign(_, a, b)
        | ExprKind::Comma(a, b)
        | ExprKind::Index(a, b) => {
            visit(a);
            visit(b);
        }
        ExprKind::Ternary(a, b, c) => {
            visit(a);
            visit(b);
            visit(c);
        }
        ExprKind::Call(_, args) | ExprKind::Construct(_, args) => {
            tree.args(args).iter().for_each(|&a| visit(a));
        }
        ExprKind::Method(object, _, args) => {
            visit(object);
            tree.args(args).iter().for_each(|&a| visit(a));
        }
        ExprKind::Error
        | ExprKind::Name(_)
        | ExprKind::Int(_)
        | ExprKind::Uint(_)
        | ExprKind::Float(_)
        | ExprKind::Bool(_) => {}
    }
}

/// Calls `visit` with every statement that stands directly in a statement.
pub fn each_inner(tree: &Tree, stmt: &Stmt, mut visit: impl FnMut(StmtId)) {
    match stmt.kind {
        StmtKind::Block(body) | StmtKind::Switch { body, .. } => {
            tree.block(body).iter().for_each(|&s| visit(s));
        }
        StmtKind::If {
            then, otherwise, ..
        } => {
            visit(then);
            otherwise.into_iter().for_each(visit);
        }
        StmtKind::For {
            init,
            condition,
            body,
            ..
        } => {
            visit(init);
            condition.into_iter().for_each(&mut visit);
            visit(body);
        }
        StmtKind::While { condition, body } => {
            visit(condition);
            visit(body);
        }
        StmtKind::Do { body, .. } => visit(body),
        _ => {}
    }
}

/// Calls `visit` with every expression that stands directly in a statement, not as an operand of
/// another expression.
pub fn each_expr(tree: &Tree, stmt: &Stmt, mut visit: impl FnMut(ExprId)) {
    match stmt.kind {
        StmtKind::Expr(e) | StmtKind::Case(e) | StmtKind::Return(Some(e)) => visit(e),
        StmtKind::If { condition, .. } | StmtKind::Do { condition, .. } => visit(condition),
        StmtKind::Switch { selector, .. } => visit(selector),
        StmtKind::For { step, .. } => step.into_iter().for_each(visit),
        StmtKind::Decl(id) => {
            let Some(decl) = tree.decl(id) else { return };
            if let DeclKind::Variables {
                ty, declarators, ..
            } = decl.kind
            {
                let sizes = tree.arrays(tree.ty(ty).arrays);
                sizes.iter().filter_map(|a| a.size).for_each(&mut visit);
                for d in tree.declarators(declarators) {
                    let sizes = tree.arrays(d.arrays);
                    sizes.iter().filter_map(|a| a.size).for_each(&mut visit);
                    d.init.into_iter().for_each(&mut visit);
                }
            }
        }
        _ => {}
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
