//! Who calls whom.

use super::lists::Lists;
use super::{Call, FunctionRef, Program};

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
}
