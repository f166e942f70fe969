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

use evaluate::{CalledFunction, Evaluation};
use nodes::{NodeId, Nodes};
use rustc_hash::FxHashMap;
use shaderlint_semantic::FunctionRef;
pub use version::{ImageEntry, ShaderVersion};

/// A function that both versions have.
struct CommonFunction {
    signature: String,
    /// Its ids in the versions.
    ids: [FunctionRef; 2],
    /// Whether it is pure. If it is in one version, it is in the other, since they compute the same.
    is_pure: bool,
    /// Whether the versions call it in different places.
    calls_differ: bool,
}

/// Whether two versions of a shader compute the same. `false` means that no proof was found.
pub fn is_equivalent(before: ShaderVersion, after: ShaderVersion) -> bool {
    let (ours, theirs) = (before.functions(), after.functions());
    let entry = |side: &ShaderVersion, of: &FxHashMap<String, FunctionRef>| {
        let entry = side.entry_function()?;
        let found = of.iter().find(|(_, id)| **id == entry)?;
        Some(found.0.clone())
    };
    let names = |side: &ShaderVersion| {
        let all = side.shared().into_iter();
        all.map(|g| g.name.to_string()).collect::<Vec<_>>()
    };
    if entry(&before, &ours) != entry(&after, &theirs) || names(&before) != names(&after) {
        return false;
    }
    let common = ours.into_iter().filter_map(|(signature, ours)| {
        let theirs = *theirs.get(&signature)?;
        Some(CommonFunction {
            is_pure: before.is_pure(ours) || after.is_pure(theirs),
            calls_differ: before.call_count(ours) != after.call_count(theirs),
            signature,
            ids: [ours, theirs],
        })
    });
    let mut common: Vec<CommonFunction> = common.collect();
    common.sort_by(|a, b| a.signature.cmp(&b.signature));
    let is_same = |inlines: bool| {
        let mut nodes = Nodes::default();
        let mut results = |side: ShaderVersion, number: usize| {
            results(&mut nodes, side, &common, number, inlines)
        };
        let first = results(before, 0);
        first.is_some() && first == results(after, 1)
    };
    // A call that only one version has may be written as the body of its function.
    is_same(false) || common.iter().any(|f| f.calls_differ) && is_same(true)
}

/// What each function computes in a version, after the initial values of global variables. `None`
/// if there is no answer.
fn results(
    nodes: &mut Nodes,
    side: ShaderVersion,
    common: &[CommonFunction],
    number: usize,
    inlines: bool,
) -> Option<Vec<NodeId>> {
    let called = common.iter().filter(|f| !(inlines && f.calls_differ));
    let called = called.filter_map(|f| {
        let function = CalledFunction {
            signature: f.signature.clone(),
            is_pure: f.is_pure,
        };
        Some((*f.ids.get(number)?, function))
    });
    let mut evaluation = Evaluation::new(nodes, side, called.collect());
    let mut results = evaluation.globals()?;
    for function in common {
        results.push(evaluation.function(*function.ids.get(number)?)?);
    }
    Some(results)
}

#[cfg(test)]
mod tests;
