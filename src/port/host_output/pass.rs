//! What the pass of a project requires of a host.

use super::supplied::{Supplied, rests, supplied};
use super::used::{UsedInput, UsedValue, used_inputs};
use crate::output::Remark;
use crate::{Composed, Input, PassUnit, Project, ProjectPass};
use shaderlint_host::{Preset, is_named};
use shaderlint_semantic::{Pass, Program, channel};
use shaderlint_text::{FileId, Role, SourceFile, Span};

/// Warnings about what is heard and not drawn. Other passes that the host does not have are errors
/// where the image reads them.
pub(super) fn left_out(project: &Project, composed: &Composed, host: &Preset) -> Vec<Remark> {
    let sounds = composed.units.iter().filter(|u| u.kind == Pass::Sound);
    let remarks = sounds.map(|unit| {
        let pass = project.passes.get(unit.pass);
        let title = pass.map_or(String::new(), |p| p.title(unit.pass));
        let message = format!("left out: host `{}` has no sound", host.name);
        Remark::differs(title, Span::default(), message)
    });
    remarks.collect()
}

/// Warnings about inputs that have another value in a host, or are read in another way.
pub(super) fn differences(
    pass: &ProjectPass,
    title: &str,
    inputs: &[(UsedInput, Supplied)],
    host: &Preset,
) -> Vec<Remark> {
    let resting = inputs
        .iter()
        .filter(|(used, _)| used.is_live && rests(host, used));
    let mut remarks: Vec<Remark> = resting
        .map(|(used, _)| {
            let message = format!("host `{}` has no mouse: `{}` stays 0", host.name, used.name);
            Remark::differs(title.to_string(), used.span, message)
        })
        .collect();
    remarks.extend(sampling(pass, title, inputs, host));
    remarks
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
pub(super) fn user_files<'c>(
    composed: &'c Composed,
    unit: &PassUnit,
) -> Vec<(FileId, &'c SourceFile)> {
    let files = unit.files.iter().filter_map(|id| {
        let file = composed.sources.file(*id)?;
        (file.role == Role::User).then_some((*id, file))
    });
    files.collect()
}

/// The inputs of a pass with what supplies them; the ones that the host does not have as errors.
pub(super) fn supplied_inputs(
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
                let message = format!(
                    "host `{}` does not provide `{}`: {what}",
                    host.name, input.name
                );
                missing.push(Remark::missing(String::new(), input.span, message));
            }
        }
    }
    match missing.is_empty() {
        true => Ok(all),
        false => Err(missing),
    }
}

/// Whether the user's code defines a function.
pub(super) fn defines(program: &Program, name: &str) -> bool {
    let name = program.names.get(name);
    let mut all = program.tree.functions.iter();
    all.any(|f| {
        let is_own = program.is_user(program.span(f.header));
        Some(f.ident.name) == name && f.body.is_some() && is_own
    })
}
