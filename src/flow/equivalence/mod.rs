//! Proves that two versions of a shader compute the same: their IR is equal after inlining the
//! functions that only one has, and after value numbering.
//!
//! Functions that both have are compared one by one, with calls of each other as they are. A
//! function is evaluated symbolically: variables become values, so that names, temporaries and the
//! order of independent operations do not matter. What remains is compared: results, `discard`,
//! loops, jumps, calls with side effects, and where derivatives are taken.

mod control;
mod evaluate;
mod nodes;
mod version;

use evaluate::Evaluation;
use nodes::{NodeId, Nodes};
use rustc_hash::{FxHashMap, FxHashSet};
use shaderlint_semantic::FunctionRef;
pub use version::ShaderVersion;

/// Whether two versions of a shader compute the same. `false` means that no proof was found.
pub fn is_equivalent(before: ShaderVersion, after: ShaderVersion) -> bool {
    let (ours, theirs) = (before.functions(), after.functions());
    let common: FxHashSet<&str> = ours
        .keys()
        .filter(|s| theirs.contains_key(*s))
        .map(String::as_str)
        .collect();
    let entry = |side: &ShaderVersion, of: &FxHashMap<String, FunctionRef>| {
        let entry = side.module.entry?;
        let found = of.iter().find(|(_, id)| **id == entry)?;
        Some(found.0.clone())
    };
    if entry(&before, &ours) != entry(&after, &theirs) {
        return false;
    }
    let names = |side: &ShaderVersion| {
        let all = side.shared().into_iter();
        all.map(|g| g.name.to_string()).collect::<Vec<_>>()
    };
    if names(&before) != names(&after) {
        return false;
    }
    let compare = |is_inlined: &dyn Fn(&str) -> bool| {
        let mut nodes = Nodes::default();
        let of = |functions: &FxHashMap<String, FunctionRef>| {
            let mut all: Vec<(String, FunctionRef)> = functions
                .iter()
                .filter(|(s, _)| common.contains(s.as_str()))
                .map(|(s, id)| (s.clone(), *id))
                .collect();
            all.sort_unstable();
            all
        };
        let first = results(&mut nodes, before, of(&ours), is_inlined);
        let second = results(&mut nodes, after, of(&theirs), is_inlined);
        first.is_some() && first == second
    };
    // A call that only one version has may be written as the body of its function.
    let calls = |side: &ShaderVersion, id| {
        let all = side.program.calls.iter();
        all.filter(|call| Some(&call.callee) == id).count()
    };
    let differs = |s: &str| calls(&before, ours.get(s)) != calls(&after, theirs.get(s));
    compare(&|_| false) || common.iter().any(|s| differs(s)) && compare(&differs)
}

/// By function: what it computes, after the initial values of global variables. `None` if there is
/// no answer.
fn results(
    nodes: &mut Nodes,
    side: ShaderVersion,
    functions: Vec<(String, FunctionRef)>,
    is_inlined: &dyn Fn(&str) -> bool,
) -> Option<Vec<NodeId>> {
    let called = functions.iter().filter(|(s, _)| !is_inlined(s));
    let called = called.map(|(s, id)| (*id, s.clone())).collect();
    let mut evaluation = Evaluation::new(nodes, side, called);
    let mut results = evaluation.globals()?;
    for (_, id) in functions {
        results.push(evaluation.function(id)?);
    }
    Some(results)
}

#[cfg(test)]
mod tests;
