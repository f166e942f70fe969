//! The call graph and the call sites of user-defined functions.

use shaderlint_ir::{Function, Module, OpId, OpKind, Provenance};
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

/// The functions of a module, in the order of their operations.
pub(crate) struct Bodies<'m>(Vec<(FunctionRef, &'m Function)>);

impl<'m> Bodies<'m> {
    pub fn of(module: &'m Module) -> Bodies<'m> {
        let all = (0..).map(FunctionRef).zip(&module.functions);
        let mut all: Vec<_> = all.filter(|(_, f)| f.ops.len > 0).collect();
        all.sort_by_key(|(_, f)| f.ops.first);
        Bodies(all)
    }

    /// The function that holds an operation; `None` at global scope.
    pub fn around(&self, op: OpId) -> Option<FunctionRef> {
        let next = self.0.partition_point(|(_, f)| f.ops.first <= op);
        let (id, function) = self.0.get(next.checked_sub(1)?)?;
        function.ops.contains(op).then_some(*id)
    }
}

/// All call sites of a shader, indexed by callee and by caller.
#[derive(Default, Debug)]
pub struct Calls {
    /// In evaluation order.
    pub all: Vec<CallSite>,
    /// Call numbers in the graph are indices into `all`.
    pub graph: CallGraph,
}

impl Calls {
    /// Collects the call sites of a module.
    pub fn of(module: &Module) -> Calls {
        let bodies = Bodies::of(module);
        let mut all = Vec::new();
        for (op, made) in (0..).map(OpId).zip(&module.ops) {
            if let OpKind::Call(callee, _) = made.kind
                && let Provenance::Expr(expr) = module.provenance(op)
            {
                all.push(CallSite {
                    caller: bodies.around(op),
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
