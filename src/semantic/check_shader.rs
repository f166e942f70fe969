//! Checks one shader from its files to the problems in it, as data.

use super::builtins::Stage;
use super::checker::{ParsedShader, check};
use super::corrections::{Corrected, Recheck};
use super::dialect::{Dialect, Pass};
use super::problem::MAX_ERRORS;
use super::problem::Problems;
use super::program::Program;
use super::unit::Unit;
use shaderlint_diagnostic::Diagnostic;
use shaderlint_syntax::{
    EXTENSIONS, GlContext, ParseOptions, Preprocessed, Search, parse, preprocess,
};
use shaderlint_text::{FileId, Role, Sources};
use std::sync::Arc;

/// A checked shader with all that is wrong in it.
pub struct CheckedShader {
    /// The checked program.
    pub program: Program,
    /// What the preprocessor reports.
    pub preprocessing: Vec<Diagnostic>,
    /// What the parser reports, with the best corrections.
    pub syntax: Vec<Diagnostic>,
    /// Forms of other languages, which were read as what they mean.
    pub translated: Vec<Diagnostic>,
    /// What the checker found.
    pub problems: Problems,
    /// Whether preprocessing stopped early, so that only what it reports is certain.
    pub gave_up: bool,
}

impl CheckedShader {
    /// Whether nothing is wrong.
    pub fn is_valid(&self) -> bool {
        let reported = [&self.preprocessing, &self.syntax, &self.translated];
        self.problems.is_empty() && reported.iter().all(|list| list.is_empty())
    }
}

/// Checks a shader. Of several ways to read broken code, the one with the fewest problems is used.
pub fn check_shader(unit: &Unit, search: &mut Search) -> CheckedShader {
    let is_fragment = unit.stage == Stage::Fragment;
    let Preprocessed {
        mut tokens,
        names,
        version,
        diagnostics,
        gave_up,
    } = preprocess(unit.sources, unit.files, is_fragment, unit.context);
    if gave_up {
        tokens.tokens.drain(..tokens.tokens.len().saturating_sub(1));
    }
    let language = ParseOptions {
        version,
        is_fragment,
    };
    let parse = parse(unit.sources, &mut tokens, &names, language, search);
    let translated = parse.translated;
    let has_errors = !diagnostics.is_empty()
        || !parse.diagnostics.is_empty()
        || !translated.diagnostics.is_empty();
    let parsed = ParsedShader {
        sources: Arc::clone(unit.sources),
        tokens,
        names,
        tree: parse.tree,
        version,
        context: unit.context,
        has_errors,
        enough: MAX_ERRORS,
    };
    let corrected = Corrected {
        options: language,
        choices: parse.choices,
        original: parse.original,
        lost: translated.lost,
    };
    let looked = match gave_up {
        true => {
            let (program, problems) = check(parsed, unit.stage, unit.dialect, [None; 4], search);
            Recheck::new(program, Vec::new(), problems)
        }
        false => corrected.choose(parsed, parse.diagnostics, unit, search),
    };
    CheckedShader {
        program: looked.program,
        preprocessing: diagnostics,
        syntax: looked.syntax,
        translated: translated.diagnostics,
        problems: looked.problems,
        gave_up,
    }
}

/// Checks a complete fragment shader without a host, for tests of higher layers.
pub fn check_fragment(code: &str) -> CheckedShader {
    let mut sources = Sources::new();
    let file = sources.add("test", None, Role::User, code);
    let sources = Arc::new(sources);
    let unit = Unit::complete(&sources, file.as_slice(), Stage::Fragment);
    check_shader(&unit, &mut Search::for_text())
}

/// The code of a shader after what its host inserts, for tests of several layers.
pub fn with_prelude(dialect: Dialect, code: impl Into<String>) -> (Arc<Sources>, Vec<FileId>) {
    let mut sources = Sources::new();
    let prelude = dialect.host().prelude([None; 4]);
    let prelude = sources.add("prelude", None, Role::Prelude, prelude);
    let code = sources.add("test", None, Role::User, code.into());
    (Arc::new(sources), prelude.into_iter().chain(code).collect())
}

/// Checks the code in a row of the checker's table of tests, `code => first problem`, for its tests and those of
/// the messages.
///
/// The code is a fragment shader of GLSL ES 3.00, unless it starts with another stage: `vertex:`,
/// `fragment 100:`, `vertex 100:`, or `image:` for a pass of ShaderToy. `extended:` and `extended vertex:` turn on
/// all extensions of WebGL2.
pub fn check_row(row: &str) -> (CheckedShader, &str) {
    const HEAD: &str = "#version 300 es\n";
    const PRECISION: &str = "precision highp float;\n";
    const ALL: &str = "#extension all : warn\n";
    let (written, expected) = row.rsplit_once(" => ").unwrap_or((row, ""));
    let (stage, code) = written.split_once(": ").unwrap_or(("", written));
    let (stage, dialect, text) = match stage {
        "vertex" => (Stage::Vertex, Dialect::WebGl, format!("{HEAD}{code}")),
        "extended vertex" => (Stage::Vertex, Dialect::WebGl, format!("{HEAD}{ALL}{code}")),
        "extended" => (
            Stage::Fragment,
            Dialect::WebGl,
            format!("{HEAD}{ALL}{PRECISION}{code}"),
        ),
        "vertex 100" => (Stage::Vertex, Dialect::WebGl, code.to_string()),
        "fragment 100" => (
            Stage::Fragment,
            Dialect::WebGl,
            format!("{PRECISION}{code}"),
        ),
        "image" => (
            Stage::Fragment,
            Dialect::ShaderToy(Pass::Image),
            code.to_string(),
        ),
        _ => (
            Stage::Fragment,
            Dialect::WebGl,
            format!("{HEAD}{PRECISION}{written}"),
        ),
    };
    let is_extended = text.contains(ALL);
    let all = EXTENSIONS.iter().map(|facts| facts.extension);
    let context = GlContext {
        enabled: all.filter(|_| is_extended).collect(),
        ..GlContext::WEBGL2
    };
    let (sources, files) = with_prelude(dialect, text);
    let unit = Unit {
        dialect,
        context,
        ..Unit::complete(&sources, &files, stage)
    };
    (check_shader(&unit, &mut Search::for_text()), expected)
}
