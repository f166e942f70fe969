//! Shaders for the hosts that have a template: the inverse of reading them.
//!
//! The code of the user is kept, apart from names that the host declares too. Inputs that the host
//! names differently become global variables, which the entry function sets. What the host does not
//! have is an error at its first use.

mod dart;
mod programs;
mod read_back;
mod renamed;
mod supplied;
mod text;
mod used;

pub use read_back::HostedShader;

use super::limits::limits;
use super::order::{Destination, Order};
use super::output::{Build, BuildError, Remark, file};
use super::{Composed, PassUnit, Project, ProjectPass, credits};
use shaderlint_diagnostic::Severity;
use shaderlint_host::{Preset, Template};
use shaderlint_semantic::{Pass, Program};
use shaderlint_text::{FileId, Role, SourceFile, Span};
use supplied::{Supplied, supplied};
use text::{HostText, HostWriter};
use used::{UsedInput, UsedValue, used_inputs};

/// The files of a project for a host.
///
/// # Errors
/// If the host cannot run a project like this.
pub(super) fn for_host(
    order: Order,
    project: &Project,
    composed: &Composed,
    host: &'static Preset,
) -> Result<Build, BuildError> {
    let Some(template) = &host.template else {
        return Ok(Build::default());
    };
    if composed.has_errors() {
        return Ok(Build::default());
    }
    if host.programs > 0 {
        return programs::programs(order, project, composed, (host, template));
    }
    let mut remarks = Vec::new();
    let mut image = None;
    for unit in &composed.units {
        match unit.kind {
            Pass::Image => image = Some(unit),
            Pass::Common => {}
            _ => remarks.push(no_pass(project, unit, host)),
        }
    }
    let Some(unit) = image else {
        return Ok(Build {
            files: Vec::new(),
            remarks,
        });
    };
    let written = write(project, composed, unit, (host, template));
    let text = match written {
        Ok(text) if remarks.is_empty() => text,
        Ok(_) => {
            return Ok(Build {
                files: Vec::new(),
                remarks,
            });
        }
        Err(more) => {
            remarks.extend(more);
            return Ok(Build {
                files: Vec::new(),
                remarks,
            });
        }
    };
    let output = order.output.path();
    let output = match order.output {
        Destination::Folder(folder) => folder.join("image.glsl"),
        _ => output.to_path_buf(),
    };
    let mut files = vec![file(&output, text.text.as_str())];
    if host.setters == "dart" && order.output != Destination::Standard {
        files.push(dart::setters(&output, &text.uniforms));
    }
    Ok(Build { files, remarks })
}

/// A pass of a kind that the host does not have.
fn no_pass(project: &Project, unit: &PassUnit, host: &Preset) -> Remark {
    let title = project
        .passes
        .get(unit.pass)
        .map_or(String::new(), |p| p.title(unit.pass));
    let kind = match unit.kind {
        Pass::Cubemap => "cube map",
        Pass::Sound => "sound",
        _ => "buffer",
    };
    let message = format!("host `{}` has no {kind} passes", host.name);
    Remark::missing(title, Span::default(), message)
}

/// The texts of the user in a pass.
fn user_files<'c>(composed: &'c Composed, unit: &PassUnit) -> Vec<(FileId, &'c SourceFile)> {
    let files = unit.files.iter().filter_map(|id| {
        let file = composed.sources.file(*id)?;
        (file.role == Role::User).then_some((*id, file))
    });
    files.collect()
}

/// The shader of a pass, or what prevents it.
fn write(
    project: &Project,
    composed: &Composed,
    unit: &PassUnit,
    (host, template): (&'static Preset, &Template),
) -> Result<HostText, Vec<Remark>> {
    let Some(pass) = project.passes.get(unit.pass) else {
        return Err(Vec::new());
    };
    let program = &composed.analysis(unit).program;
    let title = pass.title(unit.pass);
    if !defines_image(program) {
        let message = "only shaders with a `mainImage` can be written for hosts";
        return Err(vec![Remark::missing(
            title,
            Span::default(),
            message.to_string(),
        )]);
    }
    let inputs = supplied_inputs(program, pass, host)?;
    let files = user_files(composed, unit);
    let mut writer = HostWriter::new(host, template, &files);
    writer.supply(&inputs);
    let text = writer.write(program, &credits::lines(project));
    let found = problems(composed, &text.text, &title, host, |offset| {
        text.place(offset)
    });
    match found.is_empty() {
        true => Ok(text),
        false => Err(found),
    }
}

/// Whether the user's code defines `mainImage`.
fn defines_image(program: &Program) -> bool {
    let name = program.names.get("mainImage");
    let mut all = program.tree.functions.iter();
    all.any(|f| {
        let is_own = program.is_user(program.span(f.header));
        Some(f.ident.name) == name && f.body.is_some() && is_own
    })
}

/// The inputs of a pass with what supplies them; the ones that the host does not have as errors.
fn supplied_inputs(
    program: &Program,
    pass: &ProjectPass,
    host: &Preset,
) -> Result<Vec<(UsedInput, Supplied)>, Vec<Remark>> {
    let mut missing = Vec::new();
    let mut all = Vec::new();
    for input in used_inputs(program, pass) {
        match supplied(host, &input) {
            Some(how) => all.push((input, how)),
            None => {
                let what = match &input.value {
                    UsedValue::Known(feed) => feed.description(),
                    UsedValue::Output(_) => "the output of a pass",
                    UsedValue::Screen | UsedValue::Image => "an image",
                    UsedValue::Other => "an input of another kind",
                };
                let message = format!("host `{}` has no `{}`: {what}", host.name, input.name);
                missing.push(Remark::missing(String::new(), input.span, message));
            }
        }
    }
    match missing.is_empty() {
        true => Ok(all),
        false => Err(missing),
    }
}

/// What the host does not accept in a shader. `place` finds the text of the user for an offset.
fn problems(
    composed: &Composed,
    text: &str,
    title: &str,
    host: &'static Preset,
    place: impl Fn(usize) -> Option<(FileId, usize)>,
) -> Vec<Remark> {
    let Some(read) = HostedShader::of(host, text) else {
        let message = "the shader is too large".to_string();
        return vec![Remark::missing(title.to_string(), Span::default(), message)];
    };
    let remark = |span: Span, message: &str| {
        let length = span.end.saturating_sub(span.start);
        let own = read
            .offset(span.start)
            .and_then(&place)
            .and_then(|(file, offset)| {
                let start = composed.sources.file(file)?.base + offset as u32;
                Some(Span::new(start, start + length))
            });
        let message = format!("host `{}` does not accept this: {message}", host.name);
        Remark::missing(title.to_string(), own.unwrap_or_default(), message)
    };
    let errors = read.checked.diagnostics.iter();
    let errors = errors.filter(|d| d.severity == Severity::Error);
    let mut found: Vec<Remark> = errors.map(|d| remark(d.span, &d.message)).collect();
    let limits = limits(&read.checked.program, host);
    found.extend(
        limits
            .iter()
            .map(|beyond| remark(beyond.span, &beyond.message)),
    );
    found
}
