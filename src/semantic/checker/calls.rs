//! Checks of the call graph, once all functions are known (GLSL ES 3.00 section 6.1).

use super::*;
use shaderlint_text::SetAt;

/// Deepest call chain that the browser accepts.
const MAX_CALL_DEPTH: u32 = 256;

/// An error in the call graph of the shader.
#[derive(Clone, Debug)]
pub enum CallError {
    /// A call of a function that has no body.
    Undefined(FunctionRef),
    /// A cycle: each function calls the next, and the last is the first again.
    Recursion(Vec<FunctionRef>),
}

impl Checker<'_> {
    /// Reports recursion, calls of undefined functions and call chains that are too deep.
    pub(super) fn check_calls(&mut self) {
        let mut callees: Vec<Vec<(FunctionRef, ExprId)>> = vec![Vec::new(); self.functions.len()];
        let mut undefined: Vec<FunctionRef> = Vec::new();
        for call in std::mem::take(&mut self.calls) {
            self.calls.push(call);
            if let Some(list) = call.caller.and_then(|c| callees.get_mut(c.0 as usize))
                && !list.iter().rev().take(8).any(|(f, _)| *f == call.callee)
            {
                list.push((call.callee, call.expr));
            }
            let is_defined = self
                .functions
                .get(call.callee.0 as usize)
                .is_some_and(|f| f.definition.is_some());
            if !is_defined && !undefined.contains(&call.callee) {
                undefined.push(call.callee);
                self.report_undefined(call);
            }
        }
        self.walk_calls(&callees);
    }

    fn report_undefined(&mut self, call: Call) {
        let token = self.tree.expr(call.expr).extent.first;
        // The host's call of a missing entry point has already been reported.
        if self.is_prelude(token) || self.syntax_errors {
            return;
        }
        let Some(function) = self.functions.get(call.callee.0 as usize) else {
            return;
        };
        let declared = self.tree.function(function.declaration);
        // A function that a host declares is also defined by it.
        if declared.is_some_and(|f| self.is_prelude(f.ident.token)) {
            return;
        }
        self.reject(Extent::token(token), CallError::Undefined(call.callee));
    }

    /// Walks the call graph, callees first, without recursion.
    fn walk_calls(&mut self, callees: &[Vec<(FunctionRef, ExprId)>]) {
        #[derive(Clone, Copy, PartialEq)]
        enum VisitMark {
            New,
            Open,
            Done(u32),
        }
        let mut marks = vec![VisitMark::New; callees.len()];
        let mut reported_depth = false;
        for root in 0..callees.len() {
            let mut stack: Vec<(usize, usize)> = vec![(root, 0)];
            if marks.get(root) != Some(&VisitMark::New) {
                continue;
            }
            while let Some((function, next)) = stack.pop() {
                marks.set_at(function, VisitMark::Open);
                let list = callees.get(function).map_or(&[][..], Vec::as_slice);
                if let Some(&(callee, _)) = list.get(next) {
                    stack.push((function, next + 1));
                    match marks.get(callee.0 as usize) {
                        Some(VisitMark::New) => stack.push((callee.0 as usize, 0)),
                        Some(VisitMark::Open) => {
                            let start = stack.iter().position(|(f, _)| *f == callee.0 as usize);
                            let cycle = stack.get(start.unwrap_or(0)..).unwrap_or(&[]);
                            let calls = cycle.iter().filter_map(|&(caller, next)| {
                                callees.get(caller)?.get(next.checked_sub(1)?)
                            });
                            let calls: Vec<_> = calls.copied().collect();
                            self.recursion(callee, &calls);
                        }
                        _ => {}
                    }
                    continue;
                }
                let depth = list
                    .iter()
                    .map(|(f, _)| match marks.get(f.0 as usize) {
                        Some(VisitMark::Done(depth)) => *depth,
                        _ => 0,
                    })
                    .max()
                    .unwrap_or(0)
                    + 1;
                marks.set_at(function, VisitMark::Done(depth));
                if depth > MAX_CALL_DEPTH && !reported_depth {
                    reported_depth = true;
                    self.call_too_deep(function);
                }
            }
        }
    }

    /// Reports that `function` calls itself through `calls`, the last of which calls `function`.
    /// The position is that of the last call in the user's text.
    fn recursion(&mut self, function: FunctionRef, calls: &[(FunctionRef, ExprId)]) {
        let is_user =
            |call: &&(FunctionRef, ExprId)| !self.is_prelude(self.tree.expr(call.1).extent.first);
        let place = calls.iter().rev().find(is_user).or(calls.last());
        let Some(&(_, expr)) = place else {
            return;
        };
        let callees = calls.iter().map(|(callee, _)| *callee);
        let cycle = std::iter::once(function).chain(callees).collect();
        self.reject(self.tree.expr(expr).extent, CallError::Recursion(cycle));
    }

    fn call_too_deep(&mut self, function: usize) {
        let decl = self
            .functions
            .get(function)
            .and_then(|f| self.tree.function(f.definition?));
        if let Some(decl) = decl {
            self.reject(decl.header, LimitError::CallDepth);
        }
    }
}
