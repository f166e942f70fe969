//! Who calls whom.

use shaderlint_ir::{Module, OpId, OpKind, Provenance};
use shaderlint_semantic::{CallGraph, FunctionRef};
use shaderlint_syntax::ast::ExprId;

/// A call of one of the shader's functions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CallSite {
    /// The function that calls; `None` at global scope.
    pub caller: Option<FunctionRef>,
    /// The function that is called.
    pub callee: FunctionRef,
    /// The call.
    pub op: OpId,
    /// The expression that it comes from.
    pub expr: ExprId,
}

/// The calls of a shader's functions, by who is called and by who calls.
#[derive(Default, Debug)]
pub struct Calls {
    /// In the order of evaluation.
    all: Vec<CallSite>,
    /// Its calls have the indexes of `all`.
    graph: CallGraph,
}

impl Calls {
    /// The calls in a shader.
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

    /// Who calls whom, whichever call it is.
    pub fn graph(&self) -> &CallGraph {
        &self.graph
    }

    /// All calls, in the order of evaluation.
    pub fn all(&self) -> &[CallSite] {
        &self.all
    }

    fn pick<'a>(&'a self, numbers: &'a [u32]) -> impl Iterator<Item = &'a CallSite> {
        numbers.iter().filter_map(|&i| self.all.get(i as usize))
    }

    /// The calls of a function.
    pub fn calls_of(&self, callee: FunctionRef) -> impl Iterator<Item = &CallSite> {
        self.pick(self.graph.calls_of(callee))
    }

    /// The calls in a function.
    pub fn calls_by(&self, caller: FunctionRef) -> impl Iterator<Item = &CallSite> {
        self.pick(self.graph.calls_by(caller))
    }
}
