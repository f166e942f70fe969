//! Shaders in GLSL ES 1.00 in a project that converts them to GLSL ES 3.00.

use super::shader_input::ShaderInput;
use shaderlint_diagnostic::{Diagnostic, Fix, Origin, Severity, error};
use shaderlint_lint::Settings;
use shaderlint_rules::rule;
use shaderlint_semantic::{
    Checked, Completeness, Dialect, ObstacleKind, Program, Stage, UpgradeObstacle, upgrade,
};
use shaderlint_syntax::Version;
use shaderlint_text::{Role, Span};

const NAME: &str = "old-version";

/// Reports a complete shader in GLSL ES 1.00, with its conversion.
pub(super) fn report(
    part: &ShaderInput,
    checked: &Checked,
    settings: &Settings,
) -> Option<Diagnostic> {
    let program = &checked.program;
    let severity = settings.level(rule(NAME)?)?;
    let is_complete = checked.completeness == Completeness::Complete && part.host.is_none();
    if !is_converted(program, settings) || !is_complete || !is_alone(program) {
        return None;
    }
    let first = program.tokens.tokens.first().map(|t| t.span);
    let span = program.tokens.version_span.or(first)?;
    let message = "shader is written in GLSL ES 1.00, but `target-version` is `300 es`";
    let found = Diagnostic::new(NAME, Origin::Rule, severity, span, message);
    let found = match program.stage {
        Stage::Vertex => found.note("its fragment shader must have the same version (section 3.3)"),
        Stage::Fragment => found.note("its vertex shader must have the same version (section 3.3)"),
    };
    if part.embedder.is_webgl1 {
        return Some(
            found
                .note("not converted: the page requests a WebGL1 context")
                .help("use `getContext(\"webgl2\")`"),
        );
    }
    if !takes_lines(program, span) {
        return Some(found.note("not converted: the shader is a string in one line"));
    }
    Some(match upgrade(program) {
        Err(obstacle) => refuse(found, obstacle),
        Ok(done) => {
            let title = "convert it to GLSL ES 3.00";
            match done.renamed.first() {
                None => found.fix(Fix::safe(title, done.edits)),
                Some((old, new)) => found
                    .note(format!(
                        "renames `{old}` to `{new}`, which the code that sets it must use"
                    ))
                    .fix(Fix::suggestion(title, done.edits)),
            }
        }
    })
}

/// Whether a shader is in an older version than the project's.
fn is_converted(program: &Program, settings: &Settings) -> bool {
    settings.target_version() == Some(Version::Es300)
        && program.version == Version::Es100
        && program.dialect == Dialect::WebGl
}

/// Whether no host adds text.
fn is_alone(program: &Program) -> bool {
    let files = program.sources.files().iter();
    let added = files.filter(|f| f.role == Role::Prelude);
    let tokens = &program.tokens.tokens;
    added.map(|f| f.span()).all(|host| {
        !tokens
            .iter()
            .any(|t| !t.span.is_empty() && host.contains(t.span))
    })
}

/// Whether line breaks may be added to the code: not in a string of one line in a script.
fn takes_lines(program: &Program, at: Span) -> bool {
    let sources = &program.sources;
    let (Some(code), Some(file)) = (sources.code_at(at.start), sources.file_at(at.start)) else {
        return false;
    };
    let before = file.text.get(..(code.base - file.base) as usize);
    let before = before.unwrap_or("");
    let is_quoted = before.ends_with(['"', '\'']);
    !is_quoted || before.ends_with("\"\"\"") || before.ends_with("'''")
}

/// Says why a shader is not converted.
fn refuse(found: Diagnostic, obstacle: UpgradeObstacle) -> Diagnostic {
    let (label, note) = match obstacle.kind {
        ObstacleKind::Included => (
            "other file",
            "part of the code is in another file".to_string(),
        ),
        ObstacleKind::VersionTest => (
            "depends on the version",
            "the code depends on `__VERSION__`".to_string(),
        ),
        ObstacleKind::ExtensionTest(name) => (
            "not defined in WebGL2",
            format!("the code depends on `{name}`, which WebGL2 does not define"),
        ),
        ObstacleKind::Broadcast => (
            "all draw buffers",
            "with `GL_EXT_draw_buffers`, `gl_FragColor` is written to all draw buffers".to_string(),
        ),
        ObstacleKind::OutputIndex => (
            "not a literal constant",
            "the index of `gl_FragData` is not known".to_string(),
        ),
        ObstacleKind::UnknownCall => (
            "unknown overload",
            "the call may be of the built-in function or of the shader's own".to_string(),
        ),
        ObstacleKind::InitialValue => (
            "not constant",
            "the initial value is not constant and cannot be moved to `main`".to_string(),
        ),
        ObstacleKind::Error(error) => (
            "error in GLSL ES 3.00",
            format!("GLSL ES 3.00 rejects the result: {}", error.message),
        ),
    };
    let span = obstacle.span;
    let found = found.note(format!("not converted: {note}"));
    match span.is_empty() {
        true => found,
        false => found.label(span, label),
    }
}

/// Keeps both stages of a program in one version: if one cannot be converted, the other is not either.
/// If one was converted and the other can be, the difference is a warning.
pub(super) fn keep_pair(
    (vertex, fragment): (&Program, &Program),
    settings: &Settings,
    diagnostics: &mut [Diagnostic],
) {
    let is_old = |program: &Program| is_converted(program, settings);
    let refused = |program: &Program| upgrade(program).is_err();
    for (own, other, stage) in [(vertex, fragment, "fragment"), (fragment, vertex, "vertex")] {
        if !is_old(other) {
            continue;
        }
        let is_refused = refused(other);
        if is_old(own) && is_refused {
            leave(own, stage, diagnostics);
        } else if !is_old(own) && !is_refused {
            let versions = diagnostics.iter_mut().filter(|d| d.is(error::LINK_VERSION));
            for d in versions {
                d.severity = Severity::Warning;
                d.help = vec![format!("convert the {stage} shader too, with `--fix`")];
            }
        }
    }
}

/// Retracts the conversion of a shader.
fn leave(own: &Program, other: &str, diagnostics: &mut [Diagnostic]) {
    let first = own.tokens.tokens.first().map_or(0, |t| t.span.start);
    let base = |address| own.sources.code_at(address).map(|c| c.base);
    for d in diagnostics.iter_mut().filter(|d| d.rule == NAME) {
        if base(d.span.start) == base(first) && d.fix.take().is_some() {
            d.notes.push(format!(
                "not converted: the {other} shader cannot be converted"
            ));
        }
    }
}
