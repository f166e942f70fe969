//! Who calls whom.

use super::lists::Lists;
use crate::semantic::{Call, FunctionRef, Program, Resolution};
use crate::syntax::ast::{ExprId, ExprKind};

/// The calls of a shader's functions, by who is called and by who calls.
#[derive(Default, Debug)]
pub struct CallGraph {
    calls: Vec<Call>,
    /// Indexes of `calls`, by callee.
    of: Lists<u32>,
    /// Indexes of `calls`, by caller.
    by: Lists<u32>,
    functions: usize,
}

impl CallGraph {
    /// The calls in a shader.
    pub fn of(program: &Program) -> CallGraph {
        let count = program.functions.len();
        let calls = || program.calls.iter().zip(0..);
        CallGraph {
            calls: program.calls.clone(),
            of: Lists::of(count, calls().map(|(c, i)| (c.callee.0, i))),
            by: Lists::of(count, calls().filter_map(|(c, i)| Some((c.caller?.0, i)))),
            functions: count,
        }
    }

    fn pick<'a>(&'a self, lists: &'a Lists<u32>, f: FunctionRef) -> impl Iterator<Item = &'a Call> {
        let list = lists.get(f.0).iter();
        list.filter_map(|&i| self.calls.get(i as usize))
    }

    /// The calls of a function.
    pub fn calls_of(&self, callee: FunctionRef) -> impl Iterator<Item = &Call> {
        self.pick(&self.of, callee)
    }

    /// The calls in a function.
    pub fn calls_by(&self, caller: FunctionRef) -> impl Iterator<Item = &Call> {
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
        let mut todo = std::collections::VecDeque::from([entry]);
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

/// The arguments of a call of one of the shader's functions.
pub fn arguments(program: &Program, call: ExprId) -> &[ExprId] {
    match (program.tree.expr(call).kind, program.expr(call).resolution) {
        (ExprKind::Call(_, args), Resolution::Function(_)) => program.tree.args(args),
        _ => &[],
    }
}
