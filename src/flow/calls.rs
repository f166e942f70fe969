//! The call graph and the call sites of user-defined functions.

use shaderlint_ir::{Module, OpId, OpKind, Provenance};
use shaderlint_semantic::{CallGraph, FunctionRef};
use shaderlint_syntax::ast::ExprId;

/// A call of a user-defined function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CallSite {
    /// The calling function; `None` at global scope.
    pub caller: Option<FunctionRef>,
    /// The called function.
    pub callee: FunctionRef,
    /// The `Call` operation.
    pub op: OpId,
    /// The call expression in the source.
    pub expr: ExprId,
}

/// All call sites of a shader, indexed by callee and by caller.
#[derive(Default, Debug)]
pub struct Calls {
    /// In evaluation order.
    all: Vec<CallSite>,
    /// Call numbers in the graph are indices into `all`.
    graph: CallGraph,
}

impl Calls {
    /// Collects the call sites of a module.
    pub fn of(module: &Module) -> Calls {
        let mut bodies: Vec<_> = (0..)
            .map(FunctionRef)
            .zip(&module.functions)
            .filter(|(_, f)| f.ops.len > 0)
            .collect();
        bodies.sort_by_key(|(_, f)| f.ops.first);
        let caller = |op: OpId| {
            let next = bodies.partition_point(|(_, f)| f.ops.first <= op);
            let (id, function) = bodies.get(next.checked_sub(1)?)?;
            function.ops.contains(op).then_some(*id)
        };
        let mut all = Vec::new();
        for (op, made) in (0..).map(OpId).zip(&module.ops) {
            if let OpKind::Call(callee, _) = made.kind
                && let Provenance::Expr(expr) = module.provenance(op)
            {
                all.push(CallSite {
                    caller: caller(op),
                    callee,
                    op,
                    expr,
                });
            }
        }
        let pairs = all.iter().map(|c| (c.caller, c.callee));
        Calls {
            graph: CallGraph::new(module.functions.len(), pairs.collect()),
            all,
        }
    }

    /// The call graph, without individual call sites.
    pub fn graph(&self) -> &CallGraph {
        &self.graph
    }

    /// All call sites, in evaluation order.
    pub fn all(&self) -> &[CallSite] {
        &self.all
    }

    fn pick<'a>(&'a self, numbers: &'a [u32]) -> impl Iterator<Item = &'a CallSite> {
        numbers.iter().filter_map(|&i| self.all.get(i as usize))
    }

    /// The call sites that call `callee`.
    pub fn calls_of(&self, callee: FunctionRef) -> impl Iterator<Item = &CallSite> {
        self.pick(self.graph.calls_of(callee))
    }

    /// The call sites inside `caller`.
    pub fn calls_by(&self, caller: FunctionRef) -> impl Iterator<Item = &CallSite> {
        self.pick(self.graph.calls_by(caller))
    }
}
