//! The tests and golden images of one file.

use super::super::evidence;
use super::super::input::{InputFile, read};
use super::functions::TestFile;
use super::golden::{self, GoldenImages, GoldenSubject};
use super::inputs::TESTS;
use super::outcome::TestRow;
use super::shared::TestRun;
use crate::detect::kind::{FileKind, decide};
use crate::diagnostic::Severity;
use crate::engine::{Analysis, Completeness, Options, Report, analyze};
use crate::play::Coverage;
use crate::project::{Family, PassRole, family};
use crate::semantic::{Dialect, Pass, Stage};
use crate::text::Role;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

/// The results of one file.
#[derive(Clone, Default)]
pub struct Done {
    pub rows: Vec<TestRow>,
    /// The file, if it is drawable but has no golden image.
    pub unblessed: Option<String>,
    pub notes: Vec<String>,
    /// Why the file could not be tested.
    pub problem: Option<String>,
    /// What ran, if `--coverage` is given.
    pub coverage: Coverage,
    /// The files on which the results depend.
    pub read: Vec<PathBuf>,
}

pub fn test_file(input: &InputFile, run: &TestRun) -> Done {
    // A panic loses the result of one file only.
    let done = catch_unwind(AssertUnwindSafe(|| judge(input, run)));
    let why = match done {
        Ok(Ok(done)) => return done,
        Ok(Err(why)) => why,
        Err(_) => "internal error: shaderlint crashed on this file; please report it".to_string(),
    };
    Done {
        problem: Some(format!("{}: {why}", input.name)),
        read: input.path.iter().cloned().collect(),
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
    let unread = Done {
        read: input.path.iter().cloned().collect(),
        ..Done::default()
    };
    let kind = decide(name, &text, input.claim).kind;
    if !matches!(kind, FileKind::Shader | FileKind::Export) {
        return Ok(unread);
    }
    let report = analyze(name, &text, &options, &run.disk);
    if report.unread.is_some() {
        return Ok(unread);
    }
    evidence::file(name, &text, run.configs);
    let family = family(name, &text, options.file_access(&run.disk));
    let filter = run.args.filter.as_deref().unwrap_or("");
    let is_requested = |name: &str| name.contains(filter);
    let mut done = Done {
        read: files_of(input, &report, family.as_ref()),
        ..Done::default()
    };
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
                    path: input.path.as_deref(),
                    run,
                };
                let found = tests.run(&is_requested);
                (done.rows, done.notes) = (found.rows, found.notes);
                (done.coverage, done.read) = (found.coverage, [done.read, found.read].concat());
            }
        }
    }
    // The image of a project in several files is that of its Image.
    let is_shown = family.is_none_or(|family| {
        let has_image = family.file(PassRole::Image).is_some();
        !has_image || family.role(Path::new(name)) == Some(PassRole::Image)
    });
    golden_images(
        input,
        &text,
        (&report, is_shown),
        run,
        &is_requested,
        &mut done,
    );
    Ok(done)
}

/// The files on which the results of a file depend: the file, what it includes, and golden images.
fn files_of(input: &InputFile, report: &Report, family: Option<&Family>) -> Vec<PathBuf> {
    let texts = report.sources.files().iter();
    let texts = texts.filter(|f| f.role == Role::User);
    let mut files: Vec<PathBuf> = texts.map(|f| PathBuf::from(&*f.path)).collect();
    files.extend(input.path.clone());
    if let Some(path) = &input.path {
        files.extend(golden::existing(path));
        let family = family.map_or(&[][..], |family| &family.passes);
        files.extend(family.iter().map(|(_, path)| path.clone()));
    }
    files
}

/// Compares the images of a file with its golden images.
fn golden_images(
    input: &InputFile,
    text: &str,
    (report, is_shown): (&Report, bool),
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
        project: (is_complete && is_shown).then(|| path.to_path_buf()),
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
