//! Test functions of a file.

use super::args::TestArgs;
use super::outcome::{ConditionRow, CounterexampleRow, ParameterRow, TestRow, ValueRow};
use crate::commands::run::{percent, position, seconds};
use crate::engine::playback::{
    SeenCondition, Test, TestCase, TestFailure, TestProblem, TestSettings, TestSuite, TestVerdict,
    run_test, unusable_tests,
};
use crate::engine::{Analysis, Report};
use crate::text::{FileId, Sources};

/// A file with tests.
pub struct TestFile<'a> {
    pub report: &'a Report,
    pub file: FileId,
    pub name: &'a str,
    /// Whether the file only contains tests of another: `NAME.test.glsl`.
    pub is_for_tests: bool,
    pub args: &'a TestArgs,
}

/// The results of the functions of a file.
#[derive(Default)]
pub struct FunctionRows {
    pub rows: Vec<TestRow>,
    pub notes: Vec<String>,
}

impl TestFile<'_> {
    /// Runs the tests of the file that the filter accepts.
    pub fn run(&self, is_requested: &dyn Fn(&str) -> bool) -> FunctionRows {
        let mut found = FunctionRows::default();
        for analysis in &self.report.analyses {
            let suite = TestSuite::of(analysis, self.file);
            let analysis = suite.analysis(analysis);
            for problem in &suite.problems {
                found.rows.push(self.invalid(analysis, "", problem));
            }
            let is_wanted = |test: &&Test| self.args.bench || !test.is_bench;
            for test in suite.tests.iter().filter(is_wanted) {
                self.test(analysis, test, is_requested, &mut found);
            }
            found.notes.extend(self.unusable(analysis));
        }
        found
    }

    fn test(
        &self,
        analysis: &Analysis,
        test: &Test,
        is_requested: &dyn Fn(&str) -> bool,
        found: &mut FunctionRows,
    ) {
        if let Some(problem) = test.problems.first() {
            if test.may_be_other && !self.is_for_tests {
                let at = position(analysis.sources(), problem.at).unwrap_or_default();
                let (name, message) = (&test.name, &problem.message);
                found
                    .notes
                    .push(format!("{at}: `{name}` is not a test: {message}"));
            } else if is_requested(&test.name) {
                let rows = test.problems.iter();
                found
                    .rows
                    .extend(rows.map(|problem| self.invalid(analysis, &test.name, problem)));
            }
            return;
        }
        for case in &test.cases {
            let name = case_name(test, case);
            if is_requested(&name) {
                found.rows.push(self.case(analysis, test, case, &name));
            }
        }
    }

    /// Runs a case of a test.
    fn case(&self, analysis: &Analysis, test: &Test, case: &TestCase, name: &str) -> TestRow {
        let settings = TestSettings {
            cases: self.args.cases,
            seed: self.args.seed,
            cost: self.args.bench,
            coverage: false,
        };
        let sources = analysis.sources();
        let result = run_test(analysis, case, &[], &settings);
        let mut row = self.row(sources, name, case, &result.verdict);
        if let Some(reason) = &test.fails {
            row = row.expected_to_fail(reason);
        }
        row.at = row.at.or_else(|| position(sources, test.at));
        row.parameters = case.values.iter().map(ParameterRow::of).collect();
        row.operations = result.operations;
        row
    }

    /// A mistake in the comments of a test.
    fn invalid(&self, analysis: &Analysis, name: &str, problem: &TestProblem) -> TestRow {
        TestRow {
            at: position(analysis.sources(), problem.at),
            ..TestRow::failed(self.name, name, &problem.message)
        }
    }

    fn row(
        &self,
        sources: &Sources,
        name: &str,
        case: &TestCase,
        verdict: &TestVerdict,
    ) -> TestRow {
        let file = self.name;
        match verdict {
            TestVerdict::Passed => TestRow::passed(file, name),
            TestVerdict::Failed(failure) => {
                let conditions = failure.conditions.iter();
                TestRow {
                    conditions: conditions.map(|c| condition(sources, c)).collect(),
                    counterexample: counterexample(case, failure),
                    ..TestRow::failed(file, name, describe(failure))
                }
            }
            TestVerdict::Invalid(problem) => TestRow {
                at: position(sources, problem.at),
                ..TestRow::failed(file, name, &problem.message)
            },
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

    /// Notes about functions that are named like tests but are not.
    fn unusable(&self, analysis: &Analysis) -> Vec<String> {
        let found = unusable_tests(analysis, self.file).into_iter();
        let notes = found.filter_map(|(name, span)| {
            let at = position(analysis.sources(), span)?;
            Some(format!(
                "{at}: `{name}` is not a test; expected `bool {name}()`"
            ))
        });
        notes.collect()
    }
}

/// Name of a case: that of the test, with the values that are its own.
fn case_name(test: &Test, case: &TestCase) -> String {
    let values = case
        .values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"));
    match case.values.is_empty() {
        true => test.name.clone(),
        false => format!("{}({})", test.name, values.collect::<Vec<_>>().join(", ")),
    }
}

fn counterexample(case: &TestCase, failure: &TestFailure) -> Option<CounterexampleRow> {
    let found = failure.found.as_ref()?;
    let all = case.values.iter().chain(&found.simplest);
    let each = all.map(|(name, value)| format!("{name} = {value}"));
    Some(CounterexampleRow {
        case: found.case,
        values: found.simplest.iter().map(ParameterRow::of).collect(),
        first: found.first.iter().map(ParameterRow::of).collect(),
        each: format!("// each: {}", each.collect::<Vec<_>>().join("; ")),
    })
}

fn describe(failure: &TestFailure) -> String {
    let at = failure
        .time
        .map_or(String::new(), |time| format!(" at {}", seconds(time)));
    let share = percent(failure.failed as f64 / failure.pixels.max(1) as f64);
    let [width, height] = failure.size;
    let pixel = failure
        .pixel
        .map(|[x, y]| format!("({x}, {y}) of {width}x{height}"));
    match (&failure.found, pixel) {
        (Some(found), pixel) => {
            let values = found
                .simplest
                .iter()
                .map(|(name, value)| format!("{name} = {value}"));
            let values = values.collect::<Vec<_>>().join(", ");
            let pixel = pixel.map_or(String::new(), |pixel| format!(" at pixel {pixel}"));
            let total = failure.pixels;
            format!("returned false{at} for {values}{pixel}; {share} of {total} cases fail")
        }
        (None, None) => format!("returned false{at}"),
        (None, Some(pixel)) => {
            let pixels = failure.pixels;
            format!("returned false{at} for {share} of {pixels} pixels, first at {pixel}")
        }
    }
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
        difference: condition.difference.clone(),
    }
}

/// Joins the lines of a text.
fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
