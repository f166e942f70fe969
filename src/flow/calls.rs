//! Who calls whom.

use crate::ir::{Module, OpId, OpKind, Origin};
use crate::semantic::FunctionRef;
use crate::semantic::lists::Lists;
use crate::syntax::ast::ExprId;
use std::collections::VecDeque;

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
    /// In the order of the text.
    all: Vec<CallSite>,
    /// Indexes of `all`, by callee.
    of: Lists<u32>,
    /// Indexes of `all`, by caller.
    by: Lists<u32>,
    functions: usize,
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
                && let Origin::Expr(expr) = module.origin(op)
            {
                all.push(CallSite {
                    caller: caller(op),
                    callee,
                    op,
                    expr,
                });
            }
        }
        let functions = module.functions.len();
        let numbered = || all.iter().zip(0..);
        Calls {
            of: Lists::of(functions, numbered().map(|(c, i)| (c.callee.0, i))),
            by: Lists::of(
                functions,
                numbered().filter_map(|(c, i)| Some((c.caller?.0, i))),
            ),
            functions,
            all,
        }
    }

    /// All calls, in the order of evaluation.
    pub fn all(&self) -> &[CallSite] {
        &self.all
    }

    fn pick<'a>(
        &'a self,
        lists: &'a Lists<u32>,
        f: FunctionRef,
    ) -> impl Iterator<Item = &'a CallSite> {
        let list = lists.get(f.0).iter();
        list.filter_map(|&i| self.all.get(i as usize))
    }

    /// The calls of a function.
    pub fn calls_of(&self, callee: FunctionRef) -> impl Iterator<Item = &CallSite> {
        self.pick(&self.of, callee)
    }

    /// The calls in a function.
    pub fn calls_by(&self, caller: FunctionRef) -> impl Iterator<Item = &CallSite> {
        self.pick(&self.by, caller)
    }

    /// Whether each function is reached from `entry`, by number. `entry` itself is.
    pub fn reached_from(&self, entry: FunctionRef) -> Vec<bool> {
        let mut reached = vec![false; self.functions];
        let mut todo = vec![entry];
        while let Some(next) = todo.pop() {
            match reached.get_mut(next.0 as usize) {
                Some(seen) if !*seen => *seen = true,
                _ => continue,
            }
            todo.extend(self.calls_by(next).map(|c| c.callee));
        }
        reached
    }

    /// All functions, each behind those that it calls.
    pub fn bottom_up(&self) -> Vec<FunctionRef> {
        let mut order = Vec::with_capacity(self.functions);
        let mut open = vec![false; self.functions];
        for root in 0..self.functions as u32 {
            // A function comes a second time when all that it calls is done.
            let mut todo = vec![(FunctionRef(root), false)];
            while let Some((next, is_done)) = todo.pop() {
                if is_done {
                    order.push(next);
                    continue;
                }
                match open.get_mut(next.0 as usize) {
                    Some(seen) if !*seen => *seen = true,
                    _ => continue,
                }
                todo.push((next, true));
                todo.extend(self.calls_by(next).map(|c| (c.callee, false)));
            }
        }
        order
    }

    /// A shortest chain of functions from `entry` to `to`, both included.
    pub fn chain(&self, entry: FunctionRef, to: FunctionRef) -> Option<Vec<FunctionRef>> {
        let mut from: Vec<Option<FunctionRef>> = vec![None; self.functions];
        let mut todo = VecDeque::from([entry]);
        while let Some(next) = todo.pop_front() {
            if next == to {
                let way = std::iter::successors(Some(to), |f| {
                    (*f != entry).then(|| from.get(f.0 as usize).copied().flatten())?
                });
                let mut chain: Vec<FunctionRef> = way.collect();
                chain.reverse();
                return Some(chain);
            }
            for call in self.calls_by(next) {
                let slot = from.get_mut(call.callee.0 as usize);
                if let Some(slot) = slot.filter(|s| s.is_none())
                    && call.callee != entry
                {
                    *slot = Some(next);
                    todo.push_back(call.callee);
                }
            }
        }
        None
    }
}
