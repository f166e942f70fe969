//! `shaderlint test`: runs tests written in GLSL, and compares shaders with their golden images.

mod args;
mod difference;
mod functions;
mod golden;
mod outcome;

pub use args::TestArgs;

use super::command::{CLEAN, FAILED, FINDINGS};
use super::config::{ConfigArgs, ConfigSource, Configs, Exclusion};
use super::disk::Disk;
use super::input::{InputFile, collect, read};
use super::parallel::{in_order, threads};
use super::port::in_folder;
use crate::diagnostic::Severity;
use crate::engine::config::Selection;
use crate::engine::{Analysis, Completeness, Options, Report, analyze};
use crate::port::PassRole;
use crate::semantic::{Dialect, Pass, Stage};
use crate::text::kind::{Claim, FileKind, decide};
use args::TestFormat;
use functions::TestFile;
use golden::{GoldenImages, GoldenSubject};
use outcome::{Tally, TestRow};
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Suffix of the name of a file that tests another: `NAME.test.glsl`.
const TESTS: &str = ".test";

/// Runs the command and gives the exit code.
pub fn run(args: &TestArgs) -> io::Result<u8> {
    let paths = match args.paths.as_slice() {
        [] => vec![PathBuf::from(".")],
        paths => paths.to_vec(),
    };
    let configs = Configs::new(ConfigArgs {
        given: Selection::default(),
        source: ConfigSource::Nearest,
        exclusion: Exclusion::Found,
        paths: paths.clone(),
    });
    let collected = collect(&paths, None, &configs);
    let mut problems = collected.problems;
    problems.iter().for_each(|problem| complain(problem));
    let inputs = with_neighbours(collected.inputs);
    let run = TestRun {
        args,
        configs: &configs,
        checked: Arc::new(inputs.iter().map(|i| i.name.clone()).collect()),
        disk: Disk::new(),
        threads: if inputs.len() > 1 { 1 } else { threads() },
    };
    let mut tally = Tally {
        schema: 1,
        ..Tally::default()
    };
    let test = |number: usize| inputs.get(number).map(|input| test_file(input, &run));
    in_order(inputs.len(), &test, &mut |done| {
        let Some(done) = done else {
            return Ok(());
        };
        if args.format == TestFormat::Human {
            let lines: String = done.rows.iter().map(TestRow::line).collect();
            io::stdout().lock().write_all(lines.as_bytes())?;
            done.notes
                .iter()
                .for_each(|note| print_message(&format!("note: {note}")));
        }
        done.problem.iter().for_each(|problem| complain(problem));
        problems.extend(done.problem);
        tally.without_golden.extend(done.unblessed);
        tally.notes.extend(done.notes);
        tally.add(done.rows);
        Ok(())
    })?;
    io::stdout()
        .lock()
        .write_all(tally.text(args.format).as_bytes())?;
    if tally.tests.is_empty() && problems.is_empty() {
        complain("no tests found: expected `bool test_*()` or a golden image");
    }
    Ok(match () {
        () if !problems.is_empty() || tally.tests.is_empty() => FAILED,
        () if tally.failed > 0 => FINDINGS,
        () => CLEAN,
    })
}

fn complain(message: &str) {
    print_message(&format!("shaderlint: {message}"));
}

fn print_message(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// The inputs, and the test files that belong to files named on the command line.
fn with_neighbours(inputs: Vec<InputFile>) -> Vec<InputFile> {
    let mut known: BTreeSet<String> = inputs.iter().map(|i| i.name.clone()).collect();
    let mut all = Vec::new();
    for input in inputs {
        let neighbours = input.path.as_deref().filter(|_| input.is_explicit);
        let neighbours = neighbours.map_or(Vec::new(), |path| sibling_tests(path, &input.name));
        all.push(input);
        for neighbour in neighbours {
            if known.insert(neighbour.name.clone()) {
                all.push(neighbour);
            }
        }
    }
    all
}

/// The test files of a file.
fn sibling_tests(path: &Path, name: &str) -> Vec<InputFile> {
    let (Some(stem), Some(extension)) = (path.file_stem(), path.extension()) else {
        return Vec::new();
    };
    let (stem, extension) = (stem.to_string_lossy(), extension.to_string_lossy());
    let mut names = vec![
        format!("{stem}{TESTS}.{extension}"),
        format!("{stem}{TESTS}.glsl"),
    ];
    names.dedup();
    let folder = name.rsplit_once('/').map(|(folder, _)| folder);
    let found = names.into_iter().filter_map(|own| {
        let path = path.with_file_name(&own);
        path.is_file().then(|| InputFile {
            name: folder.map_or(own.clone(), |folder| format!("{folder}/{own}")),
            path: Some(path),
            is_explicit: true,
            claim: Claim::None,
        })
    });
    found.collect()
}

/// What all files of a run share.
struct TestRun<'a> {
    args: &'a TestArgs,
    configs: &'a Configs,
    /// The names of all inputs.
    checked: Arc<BTreeSet<String>>,
    disk: Disk,
    /// Number of threads that draw one image.
    threads: usize,
}

/// The results of one file.
#[derive(Default)]
struct Done {
    rows: Vec<TestRow>,
    /// The file, if it is drawable but has no golden image.
    unblessed: Option<String>,
    notes: Vec<String>,
    /// Why the file could not be tested.
    problem: Option<String>,
}

fn test_file(input: &InputFile, run: &TestRun) -> Done {
    // A panic loses the result of one file only.
    let done = catch_unwind(AssertUnwindSafe(|| judge(input, run)));
    let why = match done {
        Ok(Ok(done)) => return done,
        Ok(Err(why)) => why,
        Err(_) => "internal error: shaderlint crashed on this file; please report it".to_string(),
    };
    Done {
        problem: Some(format!("{}: {why}", input.name)),
        ..Done::default()
    }
}

fn judge(input: &InputFile, run: &TestRun) -> Result<Done, String> {
    let name = &input.name;
    let options = run
        .configs
        .options(Path::new(name))
        .map_err(|e| e.to_string())?;
    let options = Options {
        checked: run.checked.clone(),
        claim: input.claim,
        ..Options::clone(&options)
    };
    let text = read(input)?.text;
    let kind = decide(name, &text, input.claim).kind;
    if !matches!(kind, FileKind::Shader | FileKind::Export) {
        return Ok(Done::default());
    }
    let report = analyze(name, &text, &options, &run.disk);
    if report.unread.is_some() {
        return Ok(Done::default());
    }
    let filter = run.args.filter.as_deref().unwrap_or("");
    let is_requested = |name: &str| name.contains(filter);
    let mut done = Done::default();
    let error = first_error(&report);
    if let Some(file) = report.file {
        match &error {
            Some(error) if text.contains("bool test_") => {
                let message = format!("the file has errors: {error}");
                done.rows.push(TestRow::failed(name, "", message));
            }
            Some(_) => {}
            None => {
                let stem = Path::new(name).file_stem().unwrap_or_default();
                let tests = TestFile {
                    report: &report,
                    file,
                    name,
                    is_for_tests: stem.to_string_lossy().ends_with(TESTS),
                    args: run.args,
                };
                let found = tests.run(&is_requested);
                (done.rows, done.notes) = (found.rows, found.notes);
            }
        }
    }
    golden_images(input, &text, &report, run, &is_requested, &mut done);
    Ok(done)
}

/// Compares the images of a file with its golden images.
fn golden_images(
    input: &InputFile,
    text: &str,
    report: &Report,
    run: &TestRun,
    is_requested: &dyn Fn(&str) -> bool,
    done: &mut Done,
) {
    let name = &input.name;
    let Some(path) = input.path.as_deref() else {
        return;
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    if stem.ends_with(TESTS) {
        return;
    }
    let wish = match report.file.map_or(Ok(None), |_| golden::wish(text)) {
        Ok(wish) => wish,
        Err(why) => {
            done.rows.push(TestRow::failed(name, "golden image", why));
            return;
        }
    };
    let is_complete = first_error(report).is_none() && report.analyses.iter().any(is_drawable);
    let subject = GoldenSubject {
        name,
        path,
        project: is_complete.then(|| project_of(path)).flatten(),
        wish,
        threads: run.threads,
    };
    match golden::run(&subject, run.args, is_requested) {
        GoldenImages::None => {}
        GoldenImages::Unblessed => done.unblessed = Some(name.clone()),
        GoldenImages::Compared(rows) => done.rows.extend(rows),
    }
}

/// The position and message of the first error.
fn first_error(report: &Report) -> Option<String> {
    let mut found = report.diagnostics.iter();
    let error = found.find(|d| d.severity == Severity::Error)?;
    let at = crate::commands::run::position(&report.sources, error.span);
    Some(match at {
        Some(at) => format!("{at}: {}", error.message),
        None => error.message.clone(),
    })
}

/// Whether a shader draws an image without other passes.
fn is_drawable(analysis: &Analysis) -> bool {
    let program = &analysis.program;
    let is_complete = analysis.completeness == Completeness::Complete && !analysis.has_errors;
    is_complete
        && program.stage == Stage::Fragment
        && match program.dialect {
            Dialect::ShaderToy(pass) => pass == Pass::Image,
            Dialect::WebGl => analysis.module().entry.is_some(),
        }
}

/// What is drawn for a file: the folder if the file is the image pass of a project, the file itself
/// if it is a shader of its own, `None` for other passes.
fn project_of(path: &Path) -> Option<PathBuf> {
    let alone = Some(path.to_path_buf());
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let Some(role) = PassRole::of_name(&stem) else {
        return alone;
    };
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let passes = in_folder(folder).unwrap_or_default();
    let has_image = passes.iter().any(|(role, _)| *role == PassRole::Image);
    match role {
        PassRole::Image if passes.len() > 1 => Some(folder.to_path_buf()),
        PassRole::Image => alone,
        _ if has_image => None,
        _ => alone,
    }
}
