//! Loop invariance.

use shaderlint_flow::{LoopFacts, Writes};
use shaderlint_semantic::{Program, Resolution, Storage, VariableId, each_operand};
use shaderlint_syntax::ast::*;
use std::collections::BTreeSet;

/// Whether an expression is evaluated in each iteration, not only in the initializer of the loop.
pub fn runs_each_iteration(program: &Program, looped: StmtId, expr: ExprId) -> bool {
    let tree = &program.tree;
    let at = tree.expr(expr).extent.first;
    match tree.stmt(looped).kind {
        StmtKind::For { init, .. } => tree.stmt(init).extent.last < at,
        _ => true,
    }
}

/// Most loops around an expression that are compared.
const MAX_LOOPS: usize = 4;

/// The loops that a computation can be moved out of.
#[derive(Clone, Copy, Debug)]
pub struct InvariantLoops {
    /// The outermost of them.
    pub outermost: LoopFacts,
    /// Their number.
    pub count: usize,
    /// How often the computation runs in them; `None` if that is not known.
    pub runs: Option<u64>,
}

impl InvariantLoops {
    /// The loops, from the innermost one outwards, as long as the computation is invariant in them;
    /// `None` if it is not in the innermost one.
    pub fn of(
        around: impl Iterator<Item = LoopFacts>,
        mut is_invariant: impl FnMut(&LoopFacts) -> bool,
    ) -> Option<InvariantLoops> {
        let mut found: Option<InvariantLoops> = None;
        for looped in around.take(MAX_LOOPS) {
            if !is_invariant(&looped) {
                break;
            }
            let (count, runs) = found.map_or((0, Some(1)), |known| (known.count, known.runs));
            let iterations = looped.bound.iterations();
            found = Some(InvariantLoops {
                outermost: looped,
                count: count + 1,
                runs: runs.zip(iterations).map(|(a, b)| a.saturating_mul(b)),
            });
        }
        found
    }

    /// What to do about the computation.
    pub const fn before(&self) -> &'static str {
        match self.count {
            1 => "before the loop",
            _ => "before the outer loop",
        }
    }
}

/// The first tokens of all writes and declarations, sorted by variable and position.
#[derive(Debug)]
pub struct Places(Vec<(VariableId, TokenId)>);

impl Places {
    /// Collects all writes of a shader.
    pub fn of(program: &Program, writes: &Writes) -> Places {
        let written = writes.all.iter();
        let written = written.map(|(expr, v)| (*v, program.tree.expr(*expr).extent.first));
        let mut all: Vec<(VariableId, TokenId)> = written.collect();
        let variables = program.variables.iter().zip(0..);
        all.extend(variables.filter_map(|(v, i)| Some((VariableId(i), v.token?))));
        all.sort_unstable();
        Places(all)
    }

    fn is_written_in(&self, variable: VariableId, extent: Extent) -> bool {
        let next = self.0.partition_point(|w| *w < (variable, extent.first));
        let next = self.0.get(next);
        next.is_some_and(|(v, token)| *v == variable && *token <= extent.last)
    }
}

/// Whether an expression has no side effects and uses no variable that the extent of the loop writes to.
pub fn is_loop_invariant(
    program: &Program,
    writes: &Writes,
    places: &Places,
    expr: ExprId,
    extent: Extent,
) -> bool {
    let mut todo = vec![expr];
    let mut seen = BTreeSet::new();
    while let Some(e) = todo.pop() {
        if !writes.by(e).is_empty() {
            return false;
        }
        if let Resolution::Variable(v) = program.expr(e).resolution
            && seen.insert(v)
        {
            let storage = program.variable(v).map(|v| (v.storage, v.written));
            // A function called in the loop may write to a global variable.
            let is_shared = matches!(storage, Some((Storage::Global | Storage::Output, true)));
            if is_shared || places.is_written_in(v, extent) {
                return false;
            }
        }
        each_operand(&program.tree, program.tree.expr(e), |child| {
            todo.push(child)
        });
    }
    true
}
