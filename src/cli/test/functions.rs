//! Test functions of a file.

use super::outcome::{ConditionRow, CounterexampleRow, ParameterRow, TestRow, ValueRow};
use super::shared::TestRun;
use super::textures;
use crate::commands::run::position;
use crate::engine::{Analysis, Report};
use crate::exec::Texture;
use crate::play::{
    Coverage, SeenCondition, Test, TestCase, TestFailure, TestProblem, TestSettings, TestSuite,
    TestVerdict, TextureMark, run_test, unusable_tests,
};
use crate::text::number::{percent, seconds};
use crate::text::{FileId, Sources};
use std::path::{Path, PathBuf};

/// A file with tests.
pub struct TestFile<'a> {
    pub report: &'a Report,
    pub file: FileId,
    pub name: &'a str,
    /// Whether the file only contains tests of another: `NAME.test.glsl`.
    pub is_for_tests: bool,
    pub path: Option<&'a Path>,
    pub run: &'a TestRun<'a>,
}

/// The results of the functions of a file.
#[derive(Default)]
pub struct FunctionRows {
    pub rows: Vec<TestRow>,
    pub notes: Vec<String>,
    pub coverage: Coverage,
    /// The files of textures.
    pub read: Vec<PathBuf>,
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
            if self.run.args.coverage.is_some() {
                found.coverage.add_files(analysis);
            }
            let is_selected = |test: &&Test| self.run.args.bench || !test.is_bench;
            for test in suite.tests.iter().filter(is_selected) {
                let is_own = |shared: &&TextureMark| {
                    test.textures
                        .iter()
                        .any(|own| own.sampler == shared.sampler)
                };
                let shared = suite.textures.iter().filter(|shared| !is_own(shared));
                let marks = shared.chain(&test.textures);
                self.test(
                    analysis,
                    test,
                    &marks.collect::<Vec<_>>(),
                    is_requested,
                    &mut found,
                );
            }
            found.notes.extend(self.unusable(analysis));
        }
        found
    }

    fn test(
        &self,
        analysis: &Analysis,
        test: &Test,
        marks: &[&TextureMark],
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
        let named = test.cases.iter().map(|case| (case, case_name(test, case)));
        let named: Vec<_> = named.filter(|(_, name)| is_requested(name)).collect();
        if named.is_empty() {
            return;
        }
        let textures = match self.textures(marks, found) {
            Ok(textures) => textures,
            Err(problem) => {
                found
                    .rows
                    .push(self.invalid(analysis, &test.name, &problem));
                return;
            }
        };
        for (case, name) in named {
            let row = self.case(
                analysis,
                (test, case, &name),
                &textures,
                &mut found.coverage,
            );
            found.rows.push(row);
        }
    }

    /// Loads the textures of a test.
    fn textures(
        &self,
        marks: &[&TextureMark],
        found: &mut FunctionRows,
    ) -> Result<Vec<(String, Texture)>, TestProblem> {
        let path = self.path.unwrap_or(Path::new(""));
        let loaded = marks.iter().map(|mark| {
            found.read.extend(textures::file_of(mark, path));
            match self.run.textures.load(mark, path) {
                Ok(texture) => Ok((mark.sampler.clone(), texture)),
                Err(message) => Err(TestProblem::new(mark.at, message)),
            }
        });
        loaded.collect()
    }

    /// Runs a case of a test.
    fn case(
        &self,
        analysis: &Analysis,
        (test, case, name): (&Test, &TestCase, &str),
        textures: &[(String, Texture)],
        coverage: &mut Coverage,
    ) -> TestRow {
        let args = self.run.args;
        let settings = TestSettings {
            cases: args.cases,
            seed: args.seed,
            cost: args.bench,
            coverage: args.coverage.is_some(),
        };
        let sources = analysis.sources();
        let result = run_test(analysis, case, textures, &settings);
        coverage.add(analysis, &result.counts);
        // The answer of a benchmark does not matter.
        let verdict = match result.verdict {
            TestVerdict::Failed(_) if test.is_bench => TestVerdict::Passed,
            verdict => verdict,
        };
        let mut row = self.row(sources, name, case, &verdict);
        let has_run = matches!(verdict, TestVerdict::Passed | TestVerdict::Failed(_));
        if let Some(reason) = test.fails.as_ref().filter(|_| has_run) {
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
