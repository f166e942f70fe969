//! Tests of definite assignment.

use super::{DefiniteAssignment, UnassignedVariable};
use crate::test_shader::{TestShader, cases, checked};
use shaderlint_semantic::problem::{CallError, ProblemKind};
use shaderlint_semantic::{Completeness, Mentions};

/// Compares the findings in the last function of `code`; `?` marks a variable that is guarded by a
/// condition.
#[track_caller]
fn check(code: &str, expected: &str) {
    let analysis = checked(code, Completeness::Chunk);
    // A host adds the entry function and the bodies of prototypes.
    let is_added = |what: &ProblemKind| {
        matches!(
            what,
            ProblemKind::Entry(_) | ProblemKind::Calls(CallError::Undefined(_))
        )
    };
    assert!(
        analysis.problems.all.iter().all(|p| is_added(&p.what)),
        "{code}"
    );
    let reported = [analysis.preprocessing, analysis.syntax, analysis.translated];
    assert_eq!(reported.concat(), [], "{code}");
    let shader = TestShader::lowered(analysis.program);
    let (program, mentions) = (&shader.program, Mentions::of(&shader.program));
    let lowered = (program, &shader.module);
    let query = || shader.query();
    let paths = DefiniteAssignment::of(lowered, &shader.calls, &mentions, &query);
    let mut functions = program.functions.iter();
    let tested = functions.rposition(|f| f.definition.is_some());
    let tested = shaderlint_semantic::FunctionRef(tested.unwrap() as u32);
    let found = paths.get(tested).unwrap();
    let shown = |word: &str, unset: &UnassignedVariable| {
        let name = program
            .names
            .text(program.variables[unset.variable.0 as usize].name);
        let word = if unset.always { "never" } else { word };
        let guard = if unset.guarded { "?" } else { "" };
        format!("{name} {word}{guard}")
    };
    let reads = found.reads.iter().map(|u| shown("read", u));
    let in_loops = found.loop_reads.iter().map(|u| shown("loop", u));
    let reads = reads.chain(in_loops);
    let outputs = found.outputs.iter().map(|u| shown("left", u));
    let end = found.reaches_end.then(|| "end".to_string());
    let messages: Vec<String> = reads.chain(outputs).chain(end).collect();
    assert_eq!(messages.join(", "), expected, "{code}");
}

/// Each line of the table is `code => findings`.
#[test]
fn unassigned_values_are_found_on_every_path() {
    for (code, expected) in cases(include_str!("cases.txt")) {
        check(code, expected);
    }
}
