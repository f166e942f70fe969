//! What differs from pixel to pixel, and where control flow parts because of it.
//!
//! The GPU takes derivatives between neighbouring pixels, which must run the same code for it
//! (GLSL ES 3.00 sections 8.8 and 8.9). This finds the code that only some of them may run. The
//! answer is of the whole shader at once, whatever the order of assignments and whoever calls: it
//! may call too much different, never too little.

use super::calls::arguments;
use super::purity::each_written;
use super::{CallGraph, Mentions, Structure, each_expr, each_inner, each_operand};
use crate::semantic::{Direction, FunctionRef, Program, Resolution, Storage, VariableId};
use crate::syntax::ast::*;

/// Something that may differ from pixel to pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Varying {
    /// A variable.
    Variable(VariableId),
    /// The value of an expression.
    Expr(ExprId),
    /// What a function gives back.
    Returned(FunctionRef),
    /// Whether a statement runs.
    Stmt(StmtId),
    /// Whether what follows a statement in its function runs.
    Behind(StmtId),
    /// Whether what follows a statement in its loop's body or `switch` runs.
    Skipped(StmtId),
}

/// Nodes are numbered: expressions, variables, functions, then three times the statements.
#[derive(Clone, Copy, Default, Debug)]
struct Layout {
    variables: u32,
    functions: u32,
    stmts: u32,
    behind: u32,
    skipped: u32,
    end: u32,
}

/// What differs from pixel to pixel.
#[derive(Default, Debug)]
pub struct Uniformity {
    layout: Layout,
    /// By node: what made it differ; itself for a source.
    from: Vec<Option<u32>>,
}

impl Uniformity {
    /// Follows what differs through a shader whose pixels start at `entry`.
    pub fn of(
        program: &Program,
        structure: &Structure,
        calls: &CallGraph,
        mentions: &Mentions,
        entry: FunctionRef,
    ) -> Uniformity {
        let tree = &program.tree;
        let variables = tree.exprs.len() as u32;
        let functions = variables + program.variables.len() as u32;
        let stmts = functions + program.functions.len() as u32;
        let count = tree.stmts.len() as u32;
        let layout = Layout {
            variables,
            functions,
            stmts,
            behind: stmts + count,
            skipped: stmts + 2 * count,
            end: stmts + 3 * count,
        };
        let mut uniformity = Uniformity {
            layout,
            from: vec![None; layout.end as usize],
        };
        let spread = Spread {
            program,
            structure,
            calls,
            mentions,
        };
        let mut todo: Vec<u32> = Vec::new();
        for (i, variable) in program.variables.iter().enumerate() {
            let is_place = variable.function == Some(entry)
                && matches!(
                    variable.storage,
                    Storage::Param(Direction::In | Direction::ConstIn)
                );
            if is_place || (variable.storage == Storage::Input && !is_flat(program, i)) {
                let node = layout.variables + i as u32;
                uniformity.mark(node, node, &mut todo);
            }
        }
        // First come, first served: the ways back are the shortest.
        let mut done = 0;
        while let Some(&node) = todo.get(done) {
            done += 1;
            spread.next(&uniformity.varying(node), |next| {
                let next = uniformity.node(next);
                uniformity.mark(next, node, &mut todo);
            });
        }
        uniformity
    }

    /// Whether something may differ from pixel to pixel.
    pub fn varies(&self, what: Varying) -> bool {
        self.from
            .get(self.node(what) as usize)
            .is_some_and(Option::is_some)
    }

    /// Why something differs: itself, then each time what made it so, down to the source.
    pub fn why(&self, what: Varying) -> impl Iterator<Item = Varying> {
        let first = Some(self.node(what)).filter(|n| self.origin_of(*n).is_some());
        let way = std::iter::successors(first, |n| self.origin_of(*n).filter(|f| f != n));
        way.map(|n| self.varying(n))
    }

    fn origin_of(&self, node: u32) -> Option<u32> {
        self.from.get(node as usize).copied().flatten()
    }

    fn mark(&mut self, node: u32, from: u32, todo: &mut Vec<u32>) {
        if let Some(slot @ None) = self.from.get_mut(node as usize) {
            *slot = Some(from);
            todo.push(node);
        }
    }

    fn node(&self, what: Varying) -> u32 {
        let layout = self.layout;
        match what {
            Varying::Expr(e) => e.0,
            Varying::Variable(v) => layout.variables + v.0,
            Varying::Returned(f) => layout.functions + f.0,
            Varying::Stmt(s) => layout.stmts + s.0,
            Varying::Behind(s) => layout.behind + s.0,
            Varying::Skipped(s) => layout.skipped + s.0,
        }
    }

    fn varying(&self, node: u32) -> Varying {
        let layout = self.layout;
        if node >= layout.skipped {
            Varying::Skipped(StmtId(node - layout.skipped))
        } else if node >= layout.behind {
            Varying::Behind(StmtId(node - layout.behind))
        } else if node >= layout.stmts {
            Varying::Stmt(StmtId(node - layout.stmts))
        } else if node >= layout.functions {
            Varying::Returned(FunctionRef(node - layout.functions))
        } else if node >= layout.variables {
            Varying::Variable(VariableId(node - layout.variables))
        } else {
            Varying::Expr(ExprId(node))
        }
    }
}

/// Whether an input is `flat`: the same for all pixels of a triangle.
fn is_flat(program: &Program, variable: usize) -> bool {
    let Some(token) = program.variables.get(variable).and_then(|v| v.token) else {
        return false;
    };
    let decls = &program.tree.decls;
    let behind = decls.partition_point(|d| d.extent.first <= token);
    let around = behind.checked_sub(1).and_then(|i| decls.get(i));
    around.is_some_and(|d| match d.kind {
        DeclKind::Variables { qualifiers, .. } => {
            let mut all = program.tree.qualifiers(qualifiers).iter();
            all.any(|q| q.kind == QualifierKind::Flat)
        }
        _ => false,
    })
}

/// The variables of a function's parameters.
fn params(program: &Program, function: FunctionRef) -> &[Option<VariableId>] {
    let definition = program.function(function).and_then(|f| f.definition);
    let Some(decl) = definition.and_then(|d| program.tree.function(d)) else {
        return &[];
    };
    let from = decl.params.start as usize;
    let params = from..from + decl.params.len as usize;
    program.declared_params.get(params).unwrap_or(&[])
}

/// Where difference goes from a place.
struct Spread<'a> {
    program: &'a Program,
    structure: &'a Structure,
    calls: &'a CallGraph,
    mentions: &'a Mentions,
}

impl Spread<'_> {
    fn next(&self, what: &Varying, mut visit: impl FnMut(Varying)) {
        match *what {
            Varying::Variable(v) => self.variable(v, visit),
            Varying::Expr(e) => self.expr(e, visit),
            Varying::Returned(f) => {
                self.calls
                    .calls_of(f)
                    .for_each(|c| visit(Varying::Expr(c.expr)));
            }
            Varying::Stmt(s) => self.stmt(s, visit),
            Varying::Behind(s) => {
                self.following(s, |next| {
                    visit(Varying::Behind(next));
                    visit(Varying::Stmt(next));
                });
                if let Some(outer) = self.structure.outer(s) {
                    visit(Varying::Behind(outer));
                    // Those that stay in the loop are no longer all.
                    if is_loop(&self.program.tree, outer) {
                        visit(Varying::Stmt(s));
                    }
                }
            }
            Varying::Skipped(s) => {
                self.following(s, |next| {
                    visit(Varying::Skipped(next));
                    visit(Varying::Stmt(next));
                });
                if let Some(outer) = self.structure.outer(s)
                    && !is_loop(&self.program.tree, outer)
                    && !matches!(self.program.tree.stmt(outer).kind, StmtKind::Switch { .. })
                {
                    visit(Varying::Skipped(outer));
                }
            }
        }
    }

    fn variable(&self, v: VariableId, mut visit: impl FnMut(Varying)) {
        let names = self.mentions.all(v).iter();
        names.for_each(|&e| visit(Varying::Expr(e)));
        // An `out` parameter hands it to the callers' variables.
        let Some(variable) = self.program.variable(v) else {
            return;
        };
        let (Storage::Param(direction), Some(function)) = (variable.storage, variable.function)
        else {
            return;
        };
        let mut params = params(self.program, function).iter();
        let position = params.position(|p| *p == Some(v));
        if let Some(position) = position.filter(|_| direction.writes()) {
            for call in self.calls.calls_of(function) {
                let arg = arguments(self.program, call.expr).get(position);
                let root = arg.and_then(|a| super::effects::root(self.program, *a));
                root.into_iter().for_each(|r| visit(Varying::Variable(r)));
            }
        }
    }

    fn expr(&self, e: ExprId, mut visit: impl FnMut(Varying)) {
        let program = self.program;
        let tree = &program.tree;
        if let Some(parent) = self.structure.parent(e) {
            visit(Varying::Expr(parent));
            match tree.expr(parent).kind {
                ExprKind::Assign(_, target, value) if value == e => {
                    let root = super::effects::root(program, target);
                    root.into_iter().for_each(|r| visit(Varying::Variable(r)));
                }
                ExprKind::Call(..) => self.argument(parent, e, visit),
                _ => {}
            }
            return;
        }
        let Some(stmt) = self.structure.stmt_of(e) else {
            return;
        };
        match tree.stmt(stmt).kind {
            StmtKind::Decl(id) => self.initializer(id, e, visit),
            StmtKind::Return(_) => {
                let function = self.structure.function_of(stmt);
                function
                    .into_iter()
                    .for_each(|f| visit(Varying::Returned(f)));
            }
            StmtKind::If {
                then, otherwise, ..
            } => {
                visit(Varying::Stmt(then));
                otherwise.into_iter().for_each(|s| visit(Varying::Stmt(s)));
            }
            StmtKind::Switch { body, .. } => {
                tree.block(body)
                    .iter()
                    .for_each(|&s| visit(Varying::Stmt(s)));
            }
            StmtKind::Do { body, .. } => visit(Varying::Stmt(body)),
            StmtKind::Expr(_) => {
                // The condition of a loop is a statement of its own.
                let Some(outer) = self.structure.outer(stmt) else {
                    return;
                };
                match tree.stmt(outer).kind {
                    StmtKind::For {
                        condition, body, ..
                    } if condition == Some(stmt) => visit(Varying::Stmt(body)),
                    StmtKind::While { condition, body } if condition == stmt => {
                        visit(Varying::Stmt(body));
                    }
                    _ => {}
                }
            }
            _ => {}
        }
    }

    /// An argument makes the parameter differ; of a built-in function, what it writes to.
    fn argument(&self, call: ExprId, arg: ExprId, mut visit: impl FnMut(Varying)) {
        match self.program.expr(call).resolution {
            Resolution::Function(callee) => {
                let args = arguments(self.program, call).iter();
                let params = params(self.program, callee);
                for (_, param) in args.zip(params).filter(|(a, _)| **a == arg) {
                    param.iter().for_each(|p| visit(Varying::Variable(*p)));
                }
            }
            Resolution::Builtin(_) => {
                each_written(self.program, call, |v| visit(Varying::Variable(v)));
            }
            _ => {}
        }
    }

    fn initializer(&self, id: DeclId, e: ExprId, mut visit: impl FnMut(Varying)) {
        let tree = &self.program.tree;
        let Some(DeclKind::Variables { declarators, .. }) = tree.decl(id).map(|d| d.kind) else {
            return;
        };
        // They are in the order of the text.
        let first = tree.expr(e).extent.first;
        let all = tree.declarators(declarators);
        let behind = all.partition_point(|d| d.extent.first <= first);
        let Some(at) = behind.checked_sub(1) else {
            return;
        };
        if all.get(at).is_some_and(|d| d.init == Some(e)) {
            let declared = self.program.declared.get(declarators.start as usize + at);
            declared
                .copied()
                .flatten()
                .into_iter()
                .for_each(|v| visit(Varying::Variable(v)));
        }
    }

    /// A statement that only some pixels run.
    fn stmt(&self, s: StmtId, mut visit: impl FnMut(Varying)) {
        let program = self.program;
        let tree = &program.tree;
        let stmt = tree.stmt(s);
        each_inner(tree, stmt, |inner| visit(Varying::Stmt(inner)));
        // What it assigns and calls, only some pixels assign and call.
        let mut todo = Vec::new();
        each_expr(tree, stmt, |e| todo.push(e));
        while let Some(e) = todo.pop() {
            each_written(program, e, |v| visit(Varying::Variable(v)));
            if let Resolution::Function(f) = program.expr(e).resolution
                && let Some(body) = program
                    .function(f)
                    .and_then(|f| tree.function(f.definition?)?.body)
            {
                visit(Varying::Stmt(body));
            }
            each_operand(tree, tree.expr(e), |child| todo.push(child));
        }
        match stmt.kind {
            StmtKind::Return(value) => {
                visit(Varying::Behind(s));
                if value.is_some() {
                    let function = self.structure.function_of(s);
                    function
                        .into_iter()
                        .for_each(|f| visit(Varying::Returned(f)));
                }
            }
            StmtKind::Continue => visit(Varying::Skipped(s)),
            StmtKind::Break => self.broken(s, visit),
            _ => {}
        }
    }

    /// A `break` that only some pixels reach parts those that stay in the loop from the others.
    fn broken(&self, s: StmtId, mut visit: impl FnMut(Varying)) {
        let tree = &self.program.tree;
        for outer in self.structure.outwards(s) {
            match tree.stmt(outer).kind {
                StmtKind::Switch { .. } => return visit(Varying::Skipped(s)),
                StmtKind::For { body, .. }
                | StmtKind::While { body, .. }
                | StmtKind::Do { body, .. } => return visit(Varying::Stmt(body)),
                _ => {}
            }
        }
    }

    /// The statement that follows one in its block.
    fn following(&self, s: StmtId, mut visit: impl FnMut(StmtId)) {
        let tree = &self.program.tree;
        let Some(outer) = self.structure.outer(s) else {
            return;
        };
        if let StmtKind::Block(body) | StmtKind::Switch { body, .. } = tree.stmt(outer).kind {
            // Children are numbered in the order of the text.
            let all = tree.block(body);
            let at = all.partition_point(|o| *o <= s);
            all.get(at).into_iter().for_each(|&next| visit(next));
        }
    }
}

fn is_loop(tree: &Tree, stmt: StmtId) -> bool {
    matches!(
        tree.stmt(stmt).kind,
        StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. }
    )
}
