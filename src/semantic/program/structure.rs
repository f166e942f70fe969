//! Parent links of the syntax tree.

use crate::{FunctionRef, Program};
use shaderlint_syntax::ast::*;
use shaderlint_text::SetAt;

/// The parents of all expressions and statements.
///
/// The tree stores children before parents, so one pass in reverse order propagates everything
/// down.
#[derive(Default, Debug)]
pub struct Structure {
    expr_parent: Ups,
    expr_stmt: Ups,
    stmt_parent: Ups,
    stmt_function: Ups,
}

/// Parent index by node index. Stored as plain `u32` to keep it small.
#[derive(Default, Debug)]
struct Ups(Vec<u32>);

impl Ups {
    /// Marks a missing parent.
    const NONE: u32 = u32::MAX;

    fn new(count: usize) -> Ups {
        Ups(vec![Ups::NONE; count])
    }

    fn set(&mut self, index: u32, above: u32) {
        self.0.set_at(index as usize, above);
    }

    fn at(&self, index: u32) -> Option<u32> {
        self.0
            .get(index as usize)
            .copied()
            .filter(|a| *a != Ups::NONE)
    }
}

impl Structure {
    /// Computes the parents of all nodes of a shader.
    pub fn of(program: &Program) -> Structure {
        let tree = &program.tree;
        let mut structure = Structure {
            expr_parent: Ups::new(tree.exprs.len()),
            expr_stmt: Ups::new(tree.exprs.len()),
            stmt_parent: Ups::new(tree.stmts.len()),
            stmt_function: Ups::new(tree.stmts.len()),
        };
        for (i, expr) in (0..).zip(&tree.exprs) {
            each_operand(tree, expr, |child| structure.expr_parent.set(child.0, i));
        }
        for (i, stmt) in (0..).zip(&tree.stmts) {
            each_inner(tree, stmt, |child| structure.stmt_parent.set(child.0, i));
            each_expr(tree, stmt, |root| structure.expr_stmt.set(root.0, i));
        }
        structure.hand_down(program);
        structure
    }

    fn hand_down(&mut self, program: &Program) {
        for (i, function) in (0..).zip(&program.functions) {
            let decl = function.definition.and_then(|d| program.tree.function(d));
            if let Some(body) = decl.and_then(|d| d.body) {
                self.stmt_function.set(body.0, i);
            }
        }
        for i in (0..self.stmt_parent.0.len() as u32).rev() {
            let above = self.stmt_parent.at(i);
            if let Some(function) = above.and_then(|p| self.stmt_function.at(p)) {
                self.stmt_function.set(i, function);
            }
        }
        for i in (0..self.expr_parent.0.len() as u32).rev() {
            let above = self.expr_parent.at(i);
            if let Some(stmt) = above.and_then(|p| self.expr_stmt.at(p)) {
                self.expr_stmt.set(i, stmt);
            }
        }
    }

    /// The expression of which this one is an operand.
    pub fn parent(&self, expr: ExprId) -> Option<ExprId> {
        self.expr_parent.at(expr.0).map(ExprId)
    }

    /// The innermost statement around an expression; `None` at global scope.
    pub fn stmt_of(&self, expr: ExprId) -> Option<StmtId> {
        self.expr_stmt.at(expr.0).map(StmtId)
    }

    /// The statement around a statement; `None` for a function's body.
    pub fn outer(&self, stmt: StmtId) -> Option<StmtId> {
        self.stmt_parent.at(stmt.0).map(StmtId)
    }

    /// A statement and its enclosing statements, innermost first.
    pub fn outwards(&self, stmt: StmtId) -> impl Iterator<Item = StmtId> {
        std::iter::successors(Some(stmt), |s| self.outer(*s))
    }

    /// The function that contains a statement.
    pub fn function_of(&self, stmt: StmtId) -> Option<FunctionRef> {
        self.stmt_function.at(stmt.0).map(FunctionRef)
    }

    /// The function that contains an expression.
    pub fn function_of_expr(&self, expr: ExprId) -> Option<FunctionRef> {
        self.function_of(self.stmt_of(expr)?)
    }
}

/// Calls `visit` with every direct operand of an expression, in evaluation order.
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

/// Calls `visit` with every direct child statement of a statement.
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

/// Calls `visit` with every expression directly in a statement, excluding operands of other
/// expressions.
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

/// Whether the value of an expression is unused.
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
