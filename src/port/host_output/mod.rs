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
use super::{Composed, Input, PassUnit, Project, ProjectPass, credits};
use shaderlint_diagnostic::Severity;
use shaderlint_host::{Preset, Template, is_named};
use shaderlint_semantic::{Pass, Program, channel};
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
    let image = composed.units.iter().find(|unit| unit.kind == Pass::Image);
    let Some(unit) = image else {
        return Ok(Build::default());
    };
    let mut remarks = left_out(project, composed, host);
    let text = match write(project, composed, unit, (host, template)) {
        Ok((text, found)) => {
            remarks.extend(found);
            text
        }
        Err(found) => {
            remarks.extend(found);
            let files = Vec::new();
            return Ok(Build { files, remarks });
        }
    };
    let output = match order.output {
        Destination::Folder(folder) => folder.join("image.glsl"),
        other => other.path().to_path_buf(),
    };
    let mut files = vec![file(&output, text.text.as_str())];
    if host.setters == "dart" && order.output != Destination::Standard {
        files.push(dart::setters(&output, &text.uniforms));
    }
    Ok(Build { files, remarks })
}

/// Warnings about what is heard and not drawn. Other passes that the host does not have are errors
/// where the image reads them.
fn left_out(project: &Project, composed: &Composed, host: &Preset) -> Vec<Remark> {
    let sounds = composed.units.iter().filter(|u| u.kind == Pass::Sound);
    let remarks = sounds.map(|unit| {
        let pass = project.passes.get(unit.pass);
        let title = pass.map_or(String::new(), |p| p.title(unit.pass));
        let message = format!("left out: host `{}` has no sound", host.name);
        Remark::differs(title, Span::default(), message)
    });
    remarks.collect()
}

/// Warnings about images that a host reads in another way.
fn sampling(
    pass: &ProjectPass,
    title: &str,
    inputs: &[(UsedInput, Supplied)],
    host: &Preset,
) -> Vec<Remark> {
    let is_read = |input: &&Input| {
        inputs.iter().any(|(used, _)| {
            used.is_live
                && used.value != UsedValue::Screen
                && channel(&used.name) == Some(input.channel)
        })
    };
    let rows = &host.meanings.textures;
    let mut remarks = Vec::new();
    for input in pass.inputs.iter().filter(is_read) {
        let name = format!("iChannel{}", input.channel);
        let Some(row) = rows.iter().find(|r| is_named(&r.name, &name)) else {
            continue;
        };
        let mut differs = |what: &str| {
            let message = format!("host `{}` {what} `{name}`", host.name);
            remarks.push(Remark::differs(title.to_string(), Span::default(), message));
        };
        match (row.filter, input.sampler.filter.as_str()) {
            ("nearest", "linear" | "mipmap") => differs("does not filter"),
            (_, "mipmap") => differs("has no mipmaps for"),
            _ => {}
        }
        if row.wrap == "clamp" && input.sampler.wrap != "clamp" {
            differs("does not repeat");
        }
    }
    remarks
}

/// The texts of the user in a pass.
fn user_files<'c>(composed: &'c Composed, unit: &PassUnit) -> Vec<(FileId, &'c SourceFile)> {
    let files = unit.files.iter().filter_map(|id| {
        let file = composed.sources.file(*id)?;
        (file.role == Role::User).then_some((*id, file))
    });
    files.collect()
}

/// The shader of a pass and warnings about it, or what prevents it.
fn write(
    project: &Project,
    composed: &Composed,
    unit: &PassUnit,
    (host, template): (&'static Preset, &Template),
) -> Result<(HostText, Vec<Remark>), Vec<Remark>> {
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
        true => Ok((text, sampling(pass, &title, &inputs, host))),
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
                let message = format!("host `{}` does not provide `{}`: {what}", host.name, input.name);
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
