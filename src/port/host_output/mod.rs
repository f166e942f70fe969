//! Shaders for the hosts that have a template: the inverse of reading them.
//!
//! The code of the user is kept, apart from names that the host declares too. Inputs that the host
//! names differently become global variables, which the entry function sets. What the host does not
//! have is an error at its first use.

mod dart;
mod pass;
mod plain;
mod programs;
mod read_back;
mod renamed;
mod supplied;
mod text;
mod used;

pub use read_back::HostedShader;

use super::limits::{limits, lookups};
use super::order::{Destination, Order};
use super::output::{Build, BuildError, Remark, file};
use super::{Composed, PassUnit, Project, Wrapper, credits};
use pass::{defines, differences, left_out, supplied_inputs, user_files};
use plain::PlainShader;
use shaderlint_diagnostic::Severity;
use shaderlint_host::{Preset, Template, TextureRow};
use shaderlint_semantic::{BuiltinId, Pass, Program};
use shaderlint_text::{FileId, Span};
use supplied::{Supplied, supplied};
use text::{HostText, HostWriter};
use used::UsedInput;

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
    let files = user_files(composed, unit);
    let plain = match files.as_slice() {
        [(_, file)] if unit.wrapper == Wrapper::Own && defines(program, "main") => {
            PlainShader::of(program, pass, &file.text)
        }
        _ => None,
    };
    if plain.is_none() && !defines(program, "mainImage") {
        let message = "only fragment shaders with `mainImage` or `main` and one output are written";
        let message = message.to_string();
        return Err(vec![Remark::missing(title, Span::default(), message)]);
    }
    let mut inputs = supplied_inputs(program, pass, host)?;
    let lookups = lookups_of_screen(program, &inputs, (host, template));
    if !lookups.is_empty() {
        return Err(lookups);
    }
    let mut writer = HostWriter::new(host, template, &files);
    if let Some(shader) = &plain {
        writer.convert(shader);
        for input in &shader.inputs {
            inputs.extend(supplied(host, input).map(|how| (input.clone(), how)));
        }
    }
    writer.supply(&inputs);
    let text = writer.write(program, &credits::lines(project));
    let found = problems(composed, &text.text, &title, host, |offset| {
        text.place(offset)
    });
    match found.is_empty() {
        true => Ok((text, differences(pass, &title, &inputs, host))),
        false => Err(found),
    }
}

/// The lookups for which a template has no counterpart that turns the image of the host upright.
fn lookups_of_screen(
    program: &Program,
    inputs: &[(UsedInput, Supplied)],
    (host, template): (&Preset, &Template),
) -> Vec<Remark> {
    let is_read = |row: &TextureRow| {
        let mut all = inputs.iter();
        all.any(|(_, supplied)| *supplied == Supplied::Sampler(row.name.clone()))
    };
    let mut rows = host.meanings.textures.iter();
    if !rows.any(|row| row.top_first && is_read(row)) {
        return Vec::new();
    }
    let replaced = renamed::words(&template.screen);
    let is_replaced = |name: &str| replaced.iter().any(|(_, word)| *word == name);
    let found = lookups(program, |called, _| {
        called == BuiltinId::TextureSize || is_replaced(called.name())
    });
    let remarks = found.into_iter().map(|beyond| {
        let message = not_accepted(host, &beyond.message);
        Remark::missing(String::new(), beyond.span, message)
    });
    remarks.collect()
}

fn not_accepted(host: &Preset, what: &str) -> String {
    format!("host `{}` does not accept this: {what}", host.name)
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
        let message = not_accepted(host, message);
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
