//! A run over all files, which may continue an earlier one.

use super::super::command::{CLEAN, FAILED, FINDINGS, complain};
use super::super::config::configs;
use super::super::disk::Disk;
use super::super::input::{InputFile, collect};
use super::super::parallel::{in_order, threads};
use super::super::watch::Stamp;
use super::args::{TestArgs, TestFormat};
use super::coverage;
use super::file::{Done, test_file};
use super::inputs::with_neighbours;
use super::junit::junit;
use super::outcome::{Tally, TestRow};
use super::shared::TestRun;
use super::textures::Textures;
use crate::engine::config::{ConfigArgs, Configs};
use crate::play::Coverage;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::Arc;

/// The results so far, by file, with the state of the files on which they depend.
#[derive(Default)]
pub struct TestSession {
    known: BTreeMap<String, (Done, Stamp)>,
}

/// The files that the arguments name.
struct Inputs {
    configs: Configs,
    files: Vec<InputFile>,
    problems: Vec<String>,
}

fn inputs(args: &TestArgs) -> Inputs {
    let configs = configs(ConfigArgs {
        paths: args.paths.clone(),
        ..ConfigArgs::default()
    });
    let collected = collect(&args.paths, None, &configs);
    Inputs {
        files: with_neighbours(collected.inputs),
        problems: collected.problems,
        configs,
    }
}

/// The state of all files on which the results depend, and of the files that the arguments name.
pub fn stamp(args: &TestArgs, session: &TestSession) -> Stamp {
    let files = inputs(args)
        .files
        .into_iter()
        .filter_map(|input| input.path);
    let read = session
        .known
        .values()
        .flat_map(|(done, _)| done.read.iter());
    Stamp::of(files.chain(read.cloned()))
}

impl TestSession {
    /// Tests the files whose results are not known or have changed. Gives the exit code.
    pub fn run(&mut self, args: &TestArgs) -> io::Result<u8> {
        let inputs = inputs(args);
        let mut problems = inputs.problems;
        problems.iter().for_each(|problem| complain(problem));
        let is_known = |input: &InputFile| {
            let known = self.known.get(&input.name);
            known.is_some_and(|(done, stamp)| Stamp::of(done.read.iter().cloned()) == *stamp)
        };
        let names = inputs.files.iter().map(|i| i.name.clone());
        let run = TestRun {
            args,
            configs: &inputs.configs,
            checked: Arc::new(names.collect()),
            disk: Disk::new(),
            textures: Textures::default(),
            threads: if inputs.files.len() > 1 { 1 } else { threads() },
        };
        let test = |number: usize| {
            let input = inputs.files.get(number)?;
            if is_known(input) {
                return Some((input.name.clone(), None));
            }
            Some((input.name.clone(), Some(test_file(input, &run))))
        };
        let mut tally = Tally {
            schema: 1,
            ..Tally::default()
        };
        let mut all = Coverage::default();
        let mut renewed = BTreeMap::new();
        in_order(inputs.files.len(), &test, &mut |tested| {
            let Some((name, tested)) = tested else {
                return Ok(());
            };
            let is_new = tested.is_some();
            let earlier = || self.known.get(&name).map(|(done, _)| done.clone());
            let Some(done) = tested.or_else(earlier) else {
                return Ok(());
            };
            if args.format == TestFormat::Human && is_new {
                print(&done)?;
            }
            done.problem.iter().for_each(|problem| complain(problem));
            problems.extend(done.problem.clone());
            tally.without_golden.extend(done.unblessed.clone());
            tally.notes.extend(done.notes.clone());
            tally.add(done.rows.clone());
            all.join(&done.coverage);
            let stamp = Stamp::of(done.read.iter().cloned());
            renewed.insert(name, (done, stamp));
            Ok(())
        })?;
        self.known = renewed;
        finish(args, &tally, &all, problems)
    }
}

/// Prints the results of all files and writes what was asked for. Gives the exit code.
fn finish(
    args: &TestArgs,
    tally: &Tally,
    all: &Coverage,
    mut problems: Vec<String>,
) -> io::Result<u8> {
    let text = match args.format {
        TestFormat::Human => tally.text(),
        TestFormat::Json => tally.json(),
        TestFormat::Junit => junit(tally),
    };
    io::stdout().lock().write_all(text.as_bytes())?;
    problems.extend(save(args, all));
    if tally.tests.is_empty() && problems.is_empty() {
        complain("no tests found: expected `bool test_*()` or a golden image");
    }
    Ok(match () {
        () if !problems.is_empty() || tally.tests.is_empty() => FAILED,
        () if tally.failed > 0 => FINDINGS,
        () => CLEAN,
    })
}

/// Prints a line on standard error.
pub fn print_message(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// Prints the results of a file for people.
fn print(done: &Done) -> io::Result<()> {
    let lines: String = done.rows.iter().map(TestRow::line).collect();
    io::stdout().lock().write_all(lines.as_bytes())?;
    done.notes
        .iter()
        .for_each(|note| print_message(&format!("note: {note}")));
    Ok(())
}

/// Writes the coverage. Returns what went wrong.
fn save(args: &TestArgs, all: &Coverage) -> Option<String> {
    let path = args.coverage.as_ref()?;
    let saved = coverage::save(all, path, args.coverage_format);
    if args.format == TestFormat::Human {
        print_message(&coverage::summary(all));
    }
    let problem = saved.err()?;
    complain(&problem);
    Some(problem)
}
