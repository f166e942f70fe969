//! The call graph.

use crate::lists::Lists;
use crate::{FunctionRef, Program};
use shaderlint_text::SetAt;
use std::collections::VecDeque;

/// Calls between a shader's functions, indexed by callee and by caller.
#[derive(Default, Debug)]
pub struct CallGraph {
    /// By call: the caller (`None` at global scope) and the callee.
    calls: Vec<(Option<FunctionRef>, FunctionRef)>,
    /// Indices of calls, by callee.
    of: Lists<u32>,
    /// Indices of calls, by caller.
    by: Lists<u32>,
    functions: usize,
}

impl CallGraph {
    /// The calls of a shader, in source order.
    pub fn of(program: &Program) -> CallGraph {
        let calls = program.calls.iter().map(|c| (c.caller, c.callee));
        CallGraph::new(program.functions.len(), calls.collect())
    }

    /// A graph over `functions` functions, with the caller and callee of each call.
    pub fn new(functions: usize, calls: Vec<(Option<FunctionRef>, FunctionRef)>) -> CallGraph {
        let numbered = || calls.iter().zip(0..);
        let by = |((caller, _), i): (&(Option<FunctionRef>, _), u32)| Some(((*caller)?.0, i));
        CallGraph {
            of: Lists::of(functions, numbered().map(|((_, callee), i)| (callee.0, i))),
            by: Lists::of(functions, numbered().filter_map(by)),
            functions,
            calls,
        }
    }

    /// Indices of the calls to a function.
    pub fn calls_of(&self, callee: FunctionRef) -> &[u32] {
        self.of.get(callee.0)
    }

    /// Indices of the calls inside a function.
    pub fn calls_by(&self, caller: FunctionRef) -> &[u32] {
        self.by.get(caller.0)
    }

    /// The functions that call a function, once for each call.
    pub fn callers(&self, callee: FunctionRef) -> impl Iterator<Item = FunctionRef> {
        let calls = self.calls_of(callee).iter();
        calls.filter_map(|&i| self.calls.get(i as usize)?.0)
    }

    /// The functions that a function calls, once for each call.
    pub fn callees(&self, caller: FunctionRef) -> impl Iterator<Item = FunctionRef> {
        let calls = self.calls_by(caller).iter();
        calls.filter_map(|&i| Some(self.calls.get(i as usize)?.1))
    }

    /// By function: whether it is reachable from `entry`, which itself is.
    pub fn reached_from(&self, entry: FunctionRef) -> Vec<bool> {
        let mut reached = vec![false; self.functions];
        let mut todo = vec![entry];
        while let Some(next) = todo.pop() {
            match reached.get_mut(next.0 as usize) {
                Some(seen) if !*seen => *seen = true,
                _ => continue,
            }
            todo.extend(self.callees(next));
        }
        reached
    }

    /// By function: whether it satisfies `is_goal` or calls, directly or indirectly, one that does.
    pub fn reaching(&self, is_goal: impl Fn(FunctionRef) -> bool) -> Vec<bool> {
        let mut reaching = vec![false; self.functions];
        for function in self.bottom_up() {
            let reaches = |callee: FunctionRef| reaching.get(callee.0 as usize) == Some(&true);
            let is_one = is_goal(function) || self.callees(function).any(reaches);
            reaching.set_at(function.0 as usize, is_one);
        }
        reaching
    }

    /// All functions, each after those that it calls.
    pub fn bottom_up(&self) -> Vec<FunctionRef> {
        let mut order = Vec::with_capacity(self.functions);
        let mut open = vec![false; self.functions];
        for root in 0..self.functions as u32 {
            // A function is visited a second time when all its callees are done.
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
                todo.extend(self.callees(next).map(|f| (f, false)));
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
            for callee in self.callees(next) {
                let slot = from.get_mut(callee.0 as usize);
                if let Some(slot) = slot.filter(|s| s.is_none())
                    && callee != entry
                {
                    *slot = Some(next);
                    todo.push_back(callee);
                }
            }
        }
        None
    }
}
