//! The `#version` that the host of a complete shader requires, where it accepts it, and what the host
//! of a shader does not accept.

use super::stage::ShaderCheck;
use crate::shader::shader_input::ShaderInput;
use shaderlint_diagnostic::{Diagnostic, Severity, error};
use shaderlint_host::{Preset, RequiredVersion, presets};
use shaderlint_port::limits;
use shaderlint_semantic::{Completeness, Program, Stage, Storage, Variable};
use shaderlint_syntax::Version;
use shaderlint_text::{Role, Sources, Span};

/// Adds a finding about a version that the current releases of the host do not accept, and drops
/// those about a position of `#version` that they do.
pub fn apply_version(shader: &mut ShaderCheck) {
    let (sources, part, checked) = (shader.sources, shader.part, &mut shader.checked);
    let is_own = part.host.is_none() && part.readings.hosts.is_empty();
    let is_complete = checked.completeness == Completeness::Complete;
    if !is_own || !is_complete || !draws_image(&checked.program) {
        return;
    }
    let mut all = presets().filter(|h| h.required.is_some() || h.takes_late_version);
    let Some(host) = all.find(|host| is_written_for(host, &checked.program)) else {
        return;
    };
    if host.takes_late_version {
        checked
            .diagnostics
            .retain(|d| !d.is(error::VERSION_PLACEMENT) || !is_late(sources, d));
    }
    let Some(required) = &host.required else {
        return;
    };
    if checked.program.version == Version::Es100 && required.version == "300 es" {
        let found = outdated(sources, part, host, required);
        checked.diagnostics.extend(found);
    }
}

/// Adds findings about what the host of a shader does not accept.
pub fn add_limits(shader: &mut ShaderCheck) {
    let Some(host) = shader.part.host else {
        return;
    };
    let checked = &mut shader.checked;
    let found = limits(&checked.program, host).into_iter().map(|beyond| {
        let note = format!(
            "{} does not accept {}",
            host.title,
            beyond.limit.description()
        );
        Diagnostic::of(
            error::HOST_LIMIT,
            Severity::Warning,
            beyond.span,
            beyond.message,
        )
        .note(note)
    });
    checked.diagnostics.extend(found);
}

/// The uniforms and varyings that a shader declares.
fn inputs(program: &Program) -> impl Iterator<Item = &Variable> {
    let is_input = |v: &&Variable| matches!(v.storage, Storage::Uniform | Storage::Input);
    let declared = |v: &&Variable| program.declared_at(v).is_some_and(|s| program.is_user(s));
    program.variables.iter().filter(is_input).filter(declared)
}

/// Whether a fragment shader has a varying and a sampler, as those that draw an image have. Others
/// need no look at the hosts.
fn draws_image(program: &Program) -> bool {
    program.stage == Stage::Fragment
        && inputs(program).any(|v| v.storage == Storage::Input)
        && inputs(program).any(|v| v.ty.as_sampler().is_some())
}

/// Whether all inputs of a shader are names that a host sets.
fn is_written_for(host: &Preset, program: &Program) -> bool {
    inputs(program).all(|variable| {
        let name = program.names.text(variable.name);
        host.sets(name, &program.type_name(variable.ty))
    })
}

/// Whether a finding is about a `#version` after comments and blank lines alone.
fn is_late(sources: &Sources, finding: &Diagnostic) -> bool {
    let code = sources.code_at(finding.span.start);
    let before = code.and_then(|c| c.text.get(..(finding.span.start - c.base) as usize));
    let mut rest = before.unwrap_or("#").trim_start();
    loop {
        let after = match (rest.strip_prefix("//"), rest.strip_prefix("/*")) {
            (Some(line), _) => line.split_once('\n'),
            (_, Some(block)) => block.split_once("*/"),
            _ => return rest.is_empty(),
        };
        rest = after.map_or("", |(_, after)| after).trim_start();
    }
}

fn outdated(
    sources: &Sources,
    part: &ShaderInput,
    host: &Preset,
    required: &RequiredVersion,
) -> Option<Diagnostic> {
    let own = |id: &&_| sources.code(**id).is_some_and(|c| c.role == Role::User);
    let first = sources.code(*part.reading()?.files.iter().find(own)?)?;
    let start = first.base + (first.text.len() - first.text.trim_start().len()) as u32;
    let message = format!(
        "{} requires `#version {}`",
        required.since, required.version
    );
    let note = format!(
        "{} links it with a vertex shader of that version; this shader is GLSL ES 1.00",
        host.read_as()
    );
    Some(
        Diagnostic::of(error::UNSUPPORTED_VERSION, Severity::Warning, Span::at(start), message)
            .note(note)
            .help("start it with `#version 300 es`, and use `in`, an `out vec4` and `texture` instead of `varying`, `gl_FragColor` and `texture2D`"),
    )
}
