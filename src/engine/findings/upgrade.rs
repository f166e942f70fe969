//! Shaders in GLSL ES 1.00 in a project that converts them to GLSL ES 3.00.

use crate::shader::shader_input::ShaderInput;
use shaderlint_diagnostic::{Applicability, Diagnostic, Fix, Origin, Severity, error};
use shaderlint_explain::{Checked, ObstacleKind, UpgradeObstacle, upgrade};
use shaderlint_lint::Settings;
use shaderlint_rules::rule;
use shaderlint_semantic::{Completeness, Dialect, Program, Stage};
use shaderlint_syntax::{Version, WebGl};
use shaderlint_text::{Role, Span};

const NAME: &str = "old-version";

/// Reports a complete shader in GLSL ES 1.00, with its conversion.
pub fn report(part: &ShaderInput, checked: &Checked, settings: &Settings) -> Option<Diagnostic> {
    let program = &checked.program;
    let severity = settings.level(rule(NAME)?)?;
    let is_complete = checked.completeness == Completeness::Complete && part.host.is_none();
    if !is_converted(program, settings) || !is_complete || !is_alone(program) {
        return None;
    }
    let first = program.tokens.tokens.first().map(|t| t.span);
    let span = program.tokens.version_span.or(first)?;
    let (own, other) = match program.stage {
        Stage::Vertex => ("vertex", "fragment"),
        Stage::Fragment => ("fragment", "vertex"),
    };
    let message = format!("{own} shader is GLSL ES 1.00, but `target-version` is `300 es`");
    let found = Diagnostic::new(NAME, Origin::Rule, severity, span, message).note(format!(
        "its {other} shader must have the same version (section 3.3)"
    ));
    let context = program.context;
    if context.webgl == WebGl::One {
        let found = refuse(found, "a WebGL1 context compiles it");
        return Some(found.help("use `getContext(\"webgl2\")`"));
    }
    if !takes_lines(program, span) {
        return Some(refuse(found, "it is a string in one line"));
    }
    Some(match upgrade(program) {
        Err(obstacle) => explain(found, obstacle),
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

/// The finding about a shader that is not converted. The reason is in the message, because findings with
/// the same message are reported together.
fn refuse(found: Diagnostic, why: &str) -> Diagnostic {
    Diagnostic {
        message: format!("cannot convert to GLSL ES 3.00 because {why}"),
        ..found
    }
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

/// Why a shader is not converted, in words.
pub struct UpgradeReason {
    /// Names the place.
    label: &'static str,
    /// Follows "because".
    pub why: String,
    note: Option<&'static str>,
}

/// Why a shader is not converted.
pub fn reason(kind: &ObstacleKind) -> UpgradeReason {
    let (label, why, note) = match kind {
        ObstacleKind::Included => ("other file", "some code is in another file", None),
        ObstacleKind::VersionTest => ("depends on the version", "it tests `__VERSION__`", None),
        ObstacleKind::ExtensionTest(name) => {
            return UpgradeReason {
                label: "depends on an extension",
                why: format!("it tests `{name}`"),
                note: Some("WebGL2 defines no macros of extensions that are part of GLSL ES 3.00"),
            };
        }
        ObstacleKind::Broadcast => (
            "several outputs",
            "`gl_FragColor` is several outputs",
            Some("with `GL_EXT_draw_buffers`, it is written to all draw buffers"),
        ),
        ObstacleKind::OutputIndex => ("index", "an index of `gl_FragData` is unknown", None),
        ObstacleKind::UnknownCall => (
            "unknown overload",
            "a call cannot be resolved",
            Some("the call may be of the built-in function or of the shader's own"),
        ),
        ObstacleKind::InitialValue => (
            "not constant",
            "an initial value is not constant",
            Some("the initial value cannot be moved to `main`"),
        ),
        ObstacleKind::Error(error) => {
            return UpgradeReason {
                label: "error in GLSL ES 3.00",
                why: format!("the result has an error ({})", error.message),
                note: None,
            };
        }
    };
    UpgradeReason {
        label,
        why: why.to_string(),
        note,
    }
}

/// Says why a shader is not converted.
fn explain(found: Diagnostic, obstacle: UpgradeObstacle) -> Diagnostic {
    let UpgradeReason { label, why, note } = reason(&obstacle.kind);
    let found = refuse(found, &why);
    let found = match note {
        Some(note) => found.note(note),
        None => found,
    };
    match obstacle.span.is_empty() {
        true => found,
        false => found.label(obstacle.span, label),
    }
}

/// How the other stage of a program can be converted.
#[derive(Clone, Copy, PartialEq, Eq)]
enum OtherStage {
    Converts,
    /// After a person has looked at it.
    Asks,
    Refuses,
}

impl OtherStage {
    fn of(own: &Program, other: &Program) -> OtherStage {
        let start = other
            .tokens
            .tokens
            .first()
            .map_or(Span::default(), |t| t.span);
        let Some(done) = upgrade(other).ok().filter(|_| takes_lines(other, start)) else {
            return OtherStage::Refuses;
        };
        // A name that both declare must be renamed in both.
        let renamed = upgrade(own).map_or(Vec::new(), |own| own.renamed);
        let declares = |program: &Program, name: &str| {
            let mut variables = program.variables.iter();
            variables.any(|v| v.token.is_some() && program.names.text(v.name) == name)
        };
        let only = |these: &[(String, String)], those: &[(String, String)], other: &Program| {
            let mut only = these.iter().filter(|name| !those.contains(name));
            only.any(|(old, _)| declares(other, old))
        };
        if only(&done.renamed, &renamed, own) || only(&renamed, &done.renamed, other) {
            return OtherStage::Refuses;
        }
        match done.renamed.is_empty() {
            true => OtherStage::Converts,
            false => OtherStage::Asks,
        }
    }
}

/// Keeps both stages of a program in one version: if one cannot be converted, the other is not either.
/// If one was converted and the other can be, the difference is a warning.
pub fn keep_pair(
    (vertex, fragment): (&Program, &Program),
    settings: &Settings,
    diagnostics: &mut [Diagnostic],
) {
    let is_old = |program: &Program| is_converted(program, settings);
    for (own, other, stage) in [(vertex, fragment, "fragment"), (fragment, vertex, "vertex")] {
        if !is_old(other) {
            continue;
        }
        let state = OtherStage::of(own, other);
        if is_old(own) {
            follow(own, (state, stage), diagnostics);
        } else if state != OtherStage::Refuses {
            let versions = diagnostics.iter_mut();
            for d in versions.filter(|d| d.is(error::LINK_VERSION)) {
                d.severity = Severity::Warning;
                d.help = vec![format!("convert the {stage} shader too, with `--fix`")];
            }
        }
    }
}

/// Adapts the conversion of a shader to that of the other stage.
fn follow(own: &Program, (state, other): (OtherStage, &str), diagnostics: &mut [Diagnostic]) {
    let first = own.tokens.tokens.first().map_or(0, |t| t.span.start);
    let base = |address| own.sources.code_at(address).map(|c| c.base);
    for d in diagnostics.iter_mut().filter(|d| d.rule == NAME) {
        if base(d.span.start) != base(first) {
            continue;
        }
        match state {
            OtherStage::Converts => {}
            OtherStage::Asks => {
                if let Some(fix) = &mut d.fix {
                    fix.applicability = Applicability::Unsafe;
                }
            }
            OtherStage::Refuses => {
                if d.fix.take().is_some() {
                    let why = format!("the {other} shader cannot be");
                    *d = refuse(d.clone(), &why);
                }
            }
        }
    }
}
