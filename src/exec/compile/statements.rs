//! The statements at which a debugger can stop.

use shaderlint_ir::{Module, OpId, OpKind, Provenance, Step};
use shaderlint_semantic::FunctionRef;
use shaderlint_syntax::ast::{Extent, StmtKind, TokenId, Tree};

/// What a debugger stops at: simple statements, conditions, and steps of loops.
#[derive(Default)]
pub(super) struct Statements {
    /// Disjoint, in source order.
    extents: Vec<Extent>,
}

impl Statements {
    pub fn of(tree: &Tree) -> Statements {
        let statements = tree.stmts.iter().filter_map(|stmt| match stmt.kind {
            StmtKind::Expr(_) | StmtKind::Decl(_) | StmtKind::Return(_) => Some(stmt.extent),
            StmtKind::Break | StmtKind::Continue | StmtKind::Discard => Some(stmt.extent),
            StmtKind::If { condition, .. } | StmtKind::Do { condition, .. } => {
                Some(tree.expr(condition).extent)
            }
            StmtKind::Switch { selector, .. } => Some(tree.expr(selector).extent),
            StmtKind::For { step, .. } => step.map(|step| tree.expr(step).extent),
            _ => None,
        });
        // Local declarations are inside statements.
        let declarations = tree.decls.iter().map(|decl| decl.extent);
        let mut extents: Vec<Extent> = statements.chain(declarations).collect();
        extents.sort_by_key(|e| (e.first, std::cmp::Reverse(e.last)));
        let mut end = None;
        extents.retain(|extent| {
            let is_outer = end.is_none_or(|end| extent.first > end);
            if is_outer {
                end = Some(extent.last);
            }
            is_outer
        });
        Statements { extents }
    }

    pub fn at(&self, token: TokenId) -> Option<Extent> {
        let after = self.extents.partition_point(|e| e.first <= token);
        let extent = self.extents.get(after.checked_sub(1)?)?;
        (token <= extent.last).then_some(*extent)
    }
}

/// The statements of a function at which code with [`CompileOptions::steps`] can stop, in source
/// order.
///
/// [`CompileOptions::steps`]: crate::CompileOptions::steps
pub fn statements(tree: &Tree, module: &Module, function: FunctionRef) -> Vec<Extent> {
    let all = Statements::of(tree);
    let Some(found) = module.function(function) else {
        return Vec::new();
    };
    let body = found.body.map_or(&[][..], |body| module.steps(body));
    let jumps = module.steps_in(body).filter_map(|step| match step {
        Step::Break(stmt) | Step::Continue(stmt) | Step::Discard(stmt) => Some(*stmt),
        Step::Return(_, stmt) => Some(*stmt),
        _ => None,
    });
    let ops = found.ops.ops().filter(|op| !computes_nothing(module, *op));
    let origins = ops.map(|op| module.provenance(op));
    let origins = origins.chain(jumps.map(Provenance::Stmt));
    let mut extents: Vec<Extent> = origins
        .filter_map(|origin| all.at(origin.extent(tree)?.first))
        .collect();
    extents.sort_by_key(|extent| extent.first);
    extents.dedup();
    extents
}

/// Whether an operation belongs to a declaration without initial value.
pub(super) fn computes_nothing(module: &Module, op: OpId) -> bool {
    let is_undefined = |op: OpId| module.op(op).kind == OpKind::Undef;
    match module.op(op).kind {
        OpKind::Store(_, value) => is_undefined(value),
        _ => is_undefined(op),
    }
}
