//! Test functions of a file.

use super::outcome::{ConditionRow, TestRow, ValueRow};
use crate::commands::run::{percent, position, seconds};
use crate::engine::playback::{SeenCondition, TestFailure, TestVerdict, run_test, tests};
use crate::engine::{Analysis, Report};
use crate::text::{FileId, Sources};

/// Runs the tests of a file that the filter accepts.
pub fn run(
    report: &Report,
    file: FileId,
    name: &str,
    is_requested: &dyn Fn(&str) -> bool,
) -> Vec<TestRow> {
    let mut rows = Vec::new();
    for analysis in &report.analyses {
        let sources = analysis.sources();
        for (test, span) in tests(analysis, file) {
            let own = sources.text(span);
            if !is_requested(own) {
                continue;
            }
            let verdict = run_test(analysis, test);
            let mut row = row(sources, name, own, &verdict);
            row.at = position(sources, span);
            rows.push(row);
        }
    }
    rows
}

/// Notes about functions that are named like tests but are not.
pub fn unusable_tests(analysis: &Analysis, file: FileId) -> Vec<String> {
    let program = &analysis.program;
    let own = program.sources.file(file).map(|f| f.span());
    let others = program.functions.iter().filter(|f| {
        let is_called_so = program.names.text(f.name).starts_with("test_");
        is_called_so && !f.is_test(&program.names)
    });
    let notes = others.filter_map(|function| {
        let definition = program.tree.function(function.definition?)?;
        let span = program.token(definition.ident.token)?.span;
        let at =
            position(&program.sources, span).filter(|_| own.is_some_and(|o| o.contains(span)))?;
        let name = program.names.text(function.name);
        Some(format!(
            "{at}: `{name}` is not a test; expected `bool {name}()`"
        ))
    });
    notes.collect()
}

fn row(sources: &Sources, file: &str, name: &str, verdict: &TestVerdict) -> TestRow {
    match verdict {
        TestVerdict::Passed => TestRow::passed(file, name),
        TestVerdict::Failed(failure) => {
            let conditions = failure.conditions.iter();
            TestRow {
                conditions: conditions.map(|c| condition(sources, c)).collect(),
                ..TestRow::failed(file, name, describe(failure))
            }
        }
        TestVerdict::TooLong => TestRow::failed(file, name, "exceeded the operation limit"),
        TestVerdict::Refused { what, at } => {
            let at = at.and_then(|at| Some((sources.text(at), position(sources, at)?)));
            let message = match at {
                Some((text, at)) => format!("cannot run: `{}` at {at} is {what}", line(text)),
                None => format!("cannot run: {what}"),
            };
            TestRow::failed(file, name, message)
        }
    }
}

fn describe(failure: &TestFailure) -> String {
    let at = failure
        .time
        .map_or(String::new(), |time| format!(" at {}", seconds(time)));
    let Some([x, y]) = failure.pixel else {
        return format!("returned false{at}");
    };
    let [width, height] = failure.size;
    let share = percent(failure.failed as f64 / failure.pixels.max(1) as f64);
    format!(
        "returned false{at} for {share} of {} pixels, first at ({x}, {y}) of {width}x{height}",
        failure.pixels
    )
}

fn condition(sources: &Sources, condition: &SeenCondition) -> ConditionRow {
    let values = condition.values.iter();
    let values = values.map(|v| ValueRow {
        text: line(sources.text(v.at)),
        value: v.value.clone(),
    });
    ConditionRow {
        at: position(sources, condition.at),
        text: line(sources.text(condition.at)),
        answer: condition.answer.clone(),
        values: values.collect(),
    }
}

/// Joins the lines of a text.
fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
