//! Checks the text of one file: splits it into shaders, and runs the stages over them.

use crate::check_context::{CheckContext, Keep};
use crate::findings::chunks::library;
use crate::findings::report::Report;
use crate::findings::stage::{FileCheck, FindingStage, ShaderCheck, Unresolved};
use crate::findings::{STAGES, partner};
use crate::hosts::host::{Handed, Hosts};
use crate::hosts::webgl::context;
use crate::hosts::{hosted, joined};
use crate::options::{DialectChoice, Options};
use crate::shader::analysis::Analysis;
use crate::shader::reading::lacking;
use crate::shader::shader_input::{Shader, ShaderInput};
use crate::text::split::{Unread, split};
use shaderlint_detect::embed::{DocumentLanguage, Embedded};
use shaderlint_detect::kind::{Evidence, FileKind, decide};
use shaderlint_diagnostic::{Diagnostic, Facet, Severity, error};
use shaderlint_explain::Checked;
use shaderlint_host::Preset;
use shaderlint_lint::{Allows, CheckedSpans, SkippedRules};
use shaderlint_project::{Files, Hushed};
use shaderlint_semantic::Completeness;
use shaderlint_text::{Content, Encoding, FileId, Role, Sources, Span};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Checks a text. `name` is its path: the extension selects the kind of file, and includes are
/// resolved in its folder.
///
/// ```
/// use shaderlint_engine::{Options, check};
/// use shaderlint_project::NoFiles;
///
/// let text = "void mainImage(out vec4 color, in vec2 place) {\n    color = vec3(1.0);\n}\n";
/// let report = check("image.glsl", text, &Options::default(), &NoFiles);
/// let [finding] = &report.diagnostics[..] else {
///     panic!("one finding")
/// };
/// assert_eq!(finding.rule, "vector-size");
/// let file = report.sources.file_at(finding.span.start).unwrap();
/// assert_eq!(file.position(finding.span.start).line, 2);
/// ```
pub fn check(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let context = CheckContext::new(options, files);
    check_text(name, text, Encoding::Utf8, context)
}

/// Checks the decoded bytes of a file. The encoding may be a finding.
pub fn check_content(
    name: &str,
    content: &Content,
    options: &Options,
    files: &dyn Files,
) -> Report {
    let context = CheckContext::new(options, files);
    check_text(name, &content.text, content.encoding, context)
}

/// Checks a text and keeps the analyses of its shaders in [`Report::analyses`].
pub fn analyze(name: &str, text: &str, options: &Options, files: &dyn Files) -> Report {
    let context = CheckContext::keeping(options, files);
    check_text(name, text, Encoding::Utf8, context)
}

/// Checks a text that was decoded from an encoding.
pub fn check_text(name: &str, text: &str, encoding: Encoding, context: CheckContext) -> Report {
    let report = try_check(name, text, encoding, context);
    report.unwrap_or_else(|unread| Report {
        unread: Some(unread),
        ..Report::default()
    })
}

fn try_check(
    name: &str,
    text: &str,
    encoding: Encoding,
    context: CheckContext,
) -> Result<Report, Unread> {
    let decision = decide(name, text, context.options.claimed());
    let kind = decision.kind;
    let is_shader = matches!(kind, FileKind::Shader | FileKind::Foreign(_));
    if let Some(diagnostic) = unreadable(text, encoding).filter(|_| is_shader) {
        let mut sources = Sources::new();
        let file = sources.add(name, None, Role::User, text);
        return Ok(Report {
            sources: Arc::new(sources),
            diagnostics: vec![diagnostic],
            file: Some(file.ok_or(Unread::TooLarge)?),
            ..Report::default()
        });
    }
    let mut input = split(name, text, context, decision)?;
    let partner = partner::load(&mut input, name, context);
    let may_link = partner.is_some() || input.parts.len() > 1;
    let language = match kind {
        FileKind::Foreign(language) if input.parts.is_empty() => Some(language),
        _ => None,
    };
    let mut file = FileCheck {
        name,
        kind,
        encoding,
        context,
        parts: input.parts,
        partner,
        problems: input.problems,
        hushed: input.hushed,
        allows: Allows::default(),
        unresolved: Unresolved::default(),
        report: Report {
            sources: input.sources,
            file: input.file,
            embedded: input.embedded,
            holds_others: matches!(kind, FileKind::Holds(_)),
            export: input.export,
            language,
            ..Report::default()
        },
    };
    check_shaders(&mut file, kept(kind, may_link, context));
    if kind == FileKind::Shader && file.report.diagnostics.is_empty() {
        expect_glsl(name, text, &file.report.shaders, context)?;
    }
    for stage in STAGES {
        if let FindingStage::File(look) = stage {
            look(&mut file);
        }
    }
    if context.keep == Keep::Programs {
        let analyses = file.parts.into_iter().filter_map(|p| p.analysis);
        file.report.analyses = analyses.collect();
    }
    Ok(file.report)
}

/// What is kept of the shaders of a file. Programs are kept for linking, so that they are not
/// checked again.
fn kept(kind: FileKind, may_link: bool, context: CheckContext) -> Keep {
    match kind {
        FileKind::Holds(DocumentLanguage::Markdown) => context.keep,
        _ if may_link => Keep::Programs,
        _ => context.keep,
    }
}

/// Rejects a text that could not be read as a part of a shader and shows no GLSL at all: nothing
/// that only GLSL has, and no statements of a function.
fn expect_glsl(
    name: &str,
    text: &str,
    shaders: &[Shader],
    context: CheckContext,
) -> Result<(), Unread> {
    let is_lost = |shader: &Shader| {
        let is_everywhere = matches!(shader.skipped, SkippedRules::Everywhere);
        is_everywhere && shader.completeness != Completeness::Complete
    };
    if shaders.is_empty()
        || !shaders.iter().all(is_lost)
        || text.contains('#')
        || Evidence::of(text).has_glsl()
    {
        return Ok(());
    }
    let body = format!("void statements() {{\n{text}\n}}\n");
    let report = try_check(name, &body, Encoding::Utf8, context)?;
    let breaks = |d: &Diagnostic| d.has(Facet::Grammar) || d.is(error::BROWSER_LIMIT);
    let is_broken = report.diagnostics.iter().any(breaks);
    match is_broken || report.shaders.iter().all(is_lost) {
        true => Err(Unread::NotGlsl),
        false => Ok(()),
    }
}

fn check_shaders(file: &mut FileCheck, keep: Keep) {
    let report = &mut file.report;
    let script = report.file.and_then(|id| report.sources.file(id));
    let script = script.filter(|_| !report.embedded.is_empty());
    let script = script.map(|f| f.text.clone());
    let hosts = Hosts::new(file.name, script, file.context);
    for part in &mut file.parts {
        let options = file.context.options;
        let embedded = part.embedded.and_then(|at| report.embedded.get(at));
        let hushed = &mut file.hushed;
        let Some(checked) = understand(&mut report.sources, part, embedded, &hosts, hushed) else {
            continue;
        };
        let mut shader = ShaderCheck {
            sources: &report.sources,
            part,
            hosts: &hosts,
            options,
            checked,
            known: Arc::default(),
            has_errors: false,
            skipped: SkippedRules::default(),
            left_out: 0,
            allows: &mut file.allows,
            unresolved: &mut file.unresolved,
        };
        for stage in STAGES {
            if let FindingStage::Shader(look) = stage {
                look(&mut shader);
            }
        }
        report.diagnostics.append(&mut shader.checked.diagnostics);
        report.left_out += shader.left_out;
        if shader.has_errors {
            let seen = CheckedSpans::of(&shader.checked.program);
            report.checked_spans.get_or_insert_default().join(seen);
        }
        report.shaders.extend(summary(&mut shader));
        if keep == Keep::Programs {
            let files = part.reading().map_or(&[][..], |reading| &reading.files);
            let host = shader.host();
            let ShaderCheck {
                checked,
                has_errors,
                known,
                ..
            } = shader;
            part.analysis = Some(Analysis::new(checked, has_errors, host, files, known));
        }
    }
}

/// What the report says about a shader.
fn summary(shader: &mut ShaderCheck) -> Option<Shader> {
    let (part, sources) = (shader.part, shader.sources);
    let release = library(shader).and_then(|(host, _)| shader.hosts.release(host, &part.readings));
    let program = &shader.checked.program;
    let own = |id: &&FileId| sources.code(**id).is_some_and(|c| c.role == Role::User);
    Some(Shader {
        missing: part.missing.clone(),
        file: part.reading()?.files.iter().rev().find(own).copied(),
        stage: program.stage,
        dialect: program.dialect,
        version: program.version,
        completeness: shader.checked.completeness,
        skipped: std::mem::take(&mut shader.skipped),
        has_errors: shader.has_errors,
        left_out: shader.left_out,
        size: program.size(),
        holes: std::mem::take(&mut shader.checked.open.names),
        hosts: part.readings.hosts.clone(),
        host: part.host,
        release,
    })
}

/// Checks a shader. If something is missing, its host is resolved first.
fn understand(
    sources: &mut Arc<Sources>,
    part: &mut ShaderInput,
    embedded: Option<&Embedded>,
    hosts: &Hosts,
    hushed: &mut Hushed,
) -> Option<Checked> {
    let options = hosts.context().options;
    let is_open = options.dialect == DialectChoice::Auto
        && options.host.preset.is_none()
        && !part.readings.is_shadertoy();
    let given = part.host.or(options.host.preset);
    // The scripts that import a file are read only if they decide.
    let may_be_handed = is_open && part.host.is_none() && part.readings.may_be_handed();
    match may_be_handed.then(|| hosts.handed(embedded)).flatten() {
        Some(handed) if handed.is_bare => {
            let sources = Arc::make_mut(sources);
            part.readings
                .compile_unchanged(sources, (handed.host, handed.is_300), options)?;
        }
        Some(Handed { host, is_300, .. }) => {
            part.readings.has_own_output = (!host.glsl.is_empty()).then_some(is_300);
            return complete(sources, part, hosts, (&[host], true), options);
        }
        None => {}
    }
    let context = context(sources, &part.readings, hosts, options, given.as_slice());
    part.readings.set_context(context);
    let mut checked = part.readings.check(sources, part.infer_channels)?;
    if let Some(joined) = joined::join(sources, part, &checked, hosts, hushed) {
        checked = joined;
    }
    let lacking = lacking(&checked);
    if (lacking.is_some() || hosted::given_composer(options).is_some())
        && part.host.is_none()
        && let Some(composed) = hosted::compose(sources, part, hosts, options)
    {
        return Some(composed);
    }
    // A host inserts the chunks of a text that lacks nothing else.
    let has_chunks = !part.readings.chunks().is_empty();
    let lacking = lacking
        .or(has_chunks.then(BTreeSet::new))
        .filter(|_| is_open && !part.readings.is_unchanged());
    let (presets, is_sure) = lacking.map_or((Vec::new(), true), |lacking| {
        hosts.of(&lacking, &part.readings)
    });
    if presets.is_empty() {
        return Some(checked);
    }
    drop(checked);
    complete(sources, part, hosts, (&presets, is_sure), options)
}

/// Checks a shader as completed by some hosts, which may be sure.
fn complete(
    sources: &mut Arc<Sources>,
    part: &mut ShaderInput,
    hosts: &Hosts,
    (presets, is_sure): (&[&'static Preset], bool),
    options: &Options,
) -> Option<Checked> {
    part.readings
        .host(Arc::make_mut(sources), presets, options)?;
    part.readings.are_hosts_complete = presets.iter().all(|p| hosts.is_complete(p, &part.readings));
    part.readings.is_guessed = !is_sure;
    let context = context(sources, &part.readings, hosts, options, presets);
    part.readings.set_context(context);
    part.readings.check(sources, part.infer_channels)
}

/// The finding about a shader file that has no readable text.
fn unreadable(text: &str, encoding: Encoding) -> Option<Diagnostic> {
    let error = |kind, message| Some(Diagnostic::error(kind, Span::at(0), message));
    match encoding {
        Encoding::Utf16 => error(
            error::INVALID_ENCODING,
            "the file is UTF-16; save it as UTF-8",
        ),
        Encoding::Binary => error(error::INVALID_ENCODING, "the file is not a text file"),
        _ if !text.trim().is_empty() => None,
        // Other files may include an empty file as a placeholder.
        _ => error(error::MISSING_MAIN, "the file is empty").map(|d| Diagnostic {
            severity: Severity::Warning,
            ..d
        }),
    }
}
