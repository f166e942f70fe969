//! Tests of definite assignment.

use super::{DefiniteAssignment, UnassignedVariable};
use crate::calls::Calls;
use crate::ranges::{Query, Ranges};
use crate::reaching_definitions::ReachingDefinitions;
use crate::test_shader::cases;
use shaderlint_ir::lower;
use shaderlint_semantic::problem::{CallError, ProblemKind};
use shaderlint_semantic::{Completeness, Dialect, Mentions, Pass, Stage, Unit, check_shader};
use shaderlint_syntax::{GlContext, Search};
use shaderlint_text::{Role, Sources};
use std::sync::Arc;

/// Compares the findings in the last function of `code`; `?` marks a variable that is guarded by a
/// condition.
#[track_caller]
fn check(code: &str, expected: &str) {
    let mut sources = Sources::new();
    let head = Pass::Image.host().prelude([None; 4]);
    let head = sources.add("", None, Role::Prelude, head).unwrap();
    let user = sources.add("a.glsl", None, Role::User, code).unwrap();
    let sources = Arc::new(sources);
    let unit = Unit {
        sources: &sources,
        files: &[head, user],
        stage: Stage::Fragment,
        dialect: Dialect::ShaderToy(Pass::Image),
        context: GlContext::WEBGL2,
        infer_channels: true,
        completeness: Completeness::Chunk,
    };
    let analysis = check_shader(&unit, &mut Search::for_text());
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
    let program = &analysis.program;
    let module = lower(program);
    let calls = Calls::of(&module);
    let (defs, ranges) = (
        ReachingDefinitions::of(program, &module, &calls),
        Ranges::default(),
    );
    let query = || Query {
        program,
        module: &module,
        defs: &defs,
        ranges: &ranges,
    };
    let mentions = Mentions::of(program);
    let paths = DefiniteAssignment::of((program, &module), &calls, &mentions, &query);
    let tested = program
        .functions
        .iter()
        .rposition(|f| f.definition.is_some());
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
