//! The fuzz targets. A target panics if something is wrong.

use crate::metamorphic::{CHANGES, keeps_every_bit};
use crate::mutate::{Random, split};
use crate::{pairs, run};
use shaderlint::diagnostic::{Diagnostic, Severity};
use shaderlint::engine::{
    Analysis, Completeness, DialectChoice, Options, Report, analyze, check, fix_text,
};
use shaderlint::format::{Brace, Indentation, Lines, Style, TextExtent, format};
use shaderlint::ir::{print, verify};
use shaderlint::lint::{Allow, Settings};
use shaderlint::port::{glsl, html};
use shaderlint::project::NoFiles;
use shaderlint::project::{Project, compose};
use shaderlint::report::{Format, Reporter};
use shaderlint::rules::RULES;
use shaderlint::semantic::Stage;
use shaderlint::syntax::{GlContext, ParseOptions, Search, parse, preprocess, tokenize};
use shaderlint::text::{FileId, Role, Sources, apply_edits};

/// A fuzz target.
pub struct Target {
    /// Name on the command line.
    pub name: &'static str,
    /// Source of its texts.
    pub texts: Texts,
    /// Number of texts in a round.
    pub round: u64,
    /// Checks one text; panics on a failure.
    pub run: fn(&str),
}

/// Where texts come from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Texts {
    /// Mutated shaders of the corpus and the rules' pages.
    Broken,
    /// Generated programs.
    Programs,
    /// Generated programs with exactly known results.
    Computing,
}

pub const TARGETS: [Target; 12] = [
    Target {
        name: "lex",
        texts: Texts::Broken,
        round: 20_000,
        run: lex,
    },
    Target {
        name: "parse",
        texts: Texts::Broken,
        round: 10_000,
        run: parse_only,
    },
    Target {
        name: "format",
        texts: Texts::Broken,
        round: 5_000,
        run: format_twice,
    },
    Target {
        name: "check",
        texts: Texts::Broken,
        round: 1_000,
        run: check_all,
    },
    Target {
        name: "edit",
        texts: Texts::Broken,
        round: 150,
        run: crate::edit::answers,
    },
    Target {
        name: "link",
        texts: Texts::Broken,
        round: 1_500,
        run: link_both,
    },
    Target {
        name: "fix",
        texts: Texts::Broken,
        round: 250,
        run: fix,
    },
    Target {
        name: "port",
        texts: Texts::Broken,
        round: 500,
        run: port,
    },
    Target {
        name: "programs",
        texts: Texts::Programs,
        round: 400,
        run: programs,
    },
    Target {
        name: "run",
        texts: Texts::Programs,
        round: 1_000,
        run: run::agrees_with_itself,
    },
    Target {
        name: "draw",
        texts: Texts::Broken,
        round: 800,
        run: run::agrees_with_itself,
    },
    Target {
        name: "metamorphic",
        texts: Texts::Computing,
        round: 20,
        run: metamorphic,
    },
];

fn sources(text: &str) -> (Sources, Vec<FileId>) {
    let mut sources = Sources::new();
    let header = sources.add("", None, Role::Prelude, "#version 300 es\n");
    let file = sources.add("a.glsl", None, Role::User, text);
    let files = header.into_iter().chain(file).collect();
    (sources, files)
}

/// Lexer and preprocessor: the raw tokens concatenate to the text, and all tokens are inside the
/// files.
fn lex(text: &str) {
    let mut at = 0;
    for token in tokenize(text, 0) {
        assert_eq!(token.span.start, at, "a gap between tokens");
        at = token.span.end;
    }
    assert_eq!(at as usize, text.len(), "the tokens end early");
    let (sources, files) = sources(text);
    let read = preprocess(&sources, &files, true, GlContext::WEBGL2);
    for token in &read.tokens.tokens {
        assert!(
            sources.file_at(token.span.start).is_some(),
            "a token outside the files"
        );
    }
}

/// The formatter: the formatted text compiles to the same result and is stable.
fn format_twice(text: &str) {
    let styles = [
        Style::default(),
        Style {
            indent: Indentation::Tab(3),
            width: 40,
            brace: Brace::Next,
        },
    ];
    for style in styles {
        let formatted = |text: &str| {
            let edits = format(text, &style, TextExtent::File, Lines::Free).edits;
            apply_edits(text, 0, &edits).expect("edits that overlap")
        };
        let once = formatted(text);
        let read = |text: &str| {
            let (sources, files) = sources(text);
            let read = preprocess(&sources, &files, true, GlContext::WEBGL2);
            let tokens = read.tokens.tokens.iter();
            let tokens = tokens.map(|t| (t.kind, t.value));
            tokens.collect::<Vec<_>>()
        };
        assert!(read(text) == read(&once), "other tokens");
        assert_eq!(formatted(&once), once, "not stable");
    }
}

/// The parser: children are stored before their parents.
fn parse_only(text: &str) {
    let (sources, files) = sources(text);
    let mut read = preprocess(&sources, &files, true, GlContext::WEBGL2);
    let language = ParseOptions {
        version: read.version,
        is_fragment: true,
    };
    let search = &mut Search::for_text();
    let tree = parse(&sources, &mut read.tokens, &read.names, language, search).tree;
    for (i, expr) in tree.exprs.iter().enumerate() {
        assert!(
            expr.extent.first <= expr.extent.last,
            "expression {i} ends before it starts"
        );
        assert!(
            (expr.extent.last as usize) < read.tokens.tokens.len(),
            "expression {i} has no end"
        );
    }
}

/// Transformations that must preserve every bit, at positions that depend only on the text.
fn metamorphic(text: &str) {
    let seed = text.bytes().fold(1, |seed: u64, byte| {
        seed.wrapping_mul(31).wrapping_add(u64::from(byte))
    });
    keeps_every_bit(text, &CHANGES, &mut Random::new(seed));
}

/// A shader as both stages of a program.
fn link_both(text: &str) {
    let head = "#version 300 es\nprecision highp float;\n";
    let vertex = text.replace("in ", "out ");
    pairs::check_pair(&format!("{head}{vertex}"), &format!("{head}{text}"));
}

fn check_text(text: &str) -> Option<Report> {
    let report = check("a.glsl", text, &all_rules()?, &NoFiles);
    report.unread.is_none().then_some(report)
}

fn all_rules() -> Option<Options> {
    let settings = Settings::new(RULES, &["all".to_string()], &[]).ok()?;
    Some(Options::new(DialectChoice::Auto, settings))
}

fn errors(text: &str) -> usize {
    let found = check_text(text);
    let all = found.iter().flat_map(|f| &f.diagnostics);
    all.filter(|d| d.severity == Severity::Error).count()
}

/// The complete check, with the output of every format.
fn check_all(text: &str) {
    let Some(found) = check_text(text) else {
        return;
    };
    let has_errors = |d: &Diagnostic| d.severity == Severity::Error;
    if !found.diagnostics.iter().any(has_errors) {
        is_well_formed(text);
    }
    for d in &found.diagnostics {
        let file = found.sources.file_at(d.span.start);
        assert!(
            file.is_some_and(|f| f.role == Role::User),
            "outside the user's text: {}",
            d.message
        );
    }
    for format in [Format::Human, Format::Short, Format::Json, Format::Jsonl] {
        let mut out = Vec::new();
        let mut reporter = Reporter::new(format, &mut out, true);
        let written = reporter.file("shader.glsl", &found.sources, &found.diagnostics);
        assert!(
            written.is_ok() && reporter.finish().is_ok(),
            "cannot write {format:?}"
        );
        assert!(
            out.len() <= 1_000_000 + text.len() * 16,
            "{format:?} has {} bytes",
            out.len()
        );
    }
}

/// An accepted shader becomes a well-formed module that can be printed. In a shader fragment,
/// errors may be the host's.
fn is_well_formed(text: &str) {
    let report = analyze("a.glsl", text, &Options::default(), &NoFiles);
    let whole = |a: &&Analysis| a.completeness == Completeness::Complete && !a.has_errors;
    for analysis in report.analyses.iter().filter(whole) {
        let (program, module) = (&analysis.program, analysis.module());
        assert_eq!(verify(program, module), []);
        print(program, module);
    }
}

/// Fixes never introduce errors.
fn fix(text: &str) {
    let Some(options) = all_rules() else { return };
    let before = errors(text);
    for allow in [Allow::Safe, Allow::Unsafe] {
        let fixed = fix_text("a.glsl", text, &options, &NoFiles, allow);
        let after = errors(&fixed.text);
        // Errors that an edit uncovers were there before.
        assert!(
            before > 0 || after == 0,
            "{before} errors became {after}:\n{}",
            fixed.text
        );
    }
}

/// The converter; a text that starts like JSON is treated as an export.
fn port(text: &str) {
    let project = if text.trim_start().starts_with(['{', '[']) {
        Project::from_json(text).ok()
    } else {
        Project::from_shader("a", text).ok()
    };
    let Some(project) = project else { return };
    let Some(composed) = compose(&project, "a.glsl") else {
        return;
    };
    for unit in &composed.units {
        composed.analysis(unit);
    }
    let _ = html(&project, &composed, None, None);
    let _ = glsl(&project, &composed);
}

/// Whether no error is reported for a shader.
pub fn is_accepted(text: &str, stage: Stage) -> bool {
    let name = match stage {
        Stage::Vertex => "a.vert",
        Stage::Fragment => "a.frag",
    };
    // The text is exactly what the browser gets.
    let choice = match text.contains("#version") {
        true => DialectChoice::Webgl2,
        false => DialectChoice::Webgl1,
    };
    let options = Options::new(choice, Settings::of_rules(&[]));
    let report = check(name, text, &options, &NoFiles);
    !report
        .diagnostics
        .iter()
        .any(|d| d.severity == Severity::Error)
}

/// The verdict depends only on the tokens, not on the white space between them, and rules and
/// formats also handle nearly valid code.
fn programs(text: &str) {
    for stage in [Stage::Vertex, Stage::Fragment] {
        let verdict = is_accepted(text, stage);
        let spread = is_accepted(&spread(text), stage);
        assert_eq!(verdict, spread, "with different white space");
    }
    check_all(text);
}

/// A text with different white space between its tokens; directives are unchanged.
fn spread(text: &str) -> String {
    let mut out = String::new();
    for line in text.split_inclusive('\n') {
        if line.starts_with('#') {
            out.push_str(line);
            continue;
        }
        for token in split(line) {
            out.push_str(if token.trim().is_empty() {
                "\n/* */\t"
            } else {
                &token
            });
        }
    }
    out
}
