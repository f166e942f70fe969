//! The programs of a host that runs several, which read the outputs of each other.

use super::pass::{defines, differences, left_out, supplied_inputs, user_files};
use super::supplied::Supplied;
use super::text::{HostText, HostWriter};
use super::used::UsedInput;
use crate::order::{Destination, Order};
use crate::output::{Build, BuildError, File, Remark, file};
use crate::{Composed, OutputId, PassUnit, Project, ProjectPass, credits};
use shaderlint_host::{Preset, Template};
use shaderlint_semantic::Pass;
use shaderlint_text::Span;
use std::path::{Path, PathBuf};

/// The programs of a project, in the order in which they are drawn, and the common code.
///
/// # Errors
/// If several programs cannot be written to standard output.
pub(super) fn programs(
    order: Order,
    project: &Project,
    composed: &Composed,
    (host, template): (&'static Preset, &Template),
) -> Result<Build, BuildError> {
    let is_drawn = |unit: &&PassUnit| matches!(unit.kind, Pass::Image | Pass::Buffer);
    let mut units: Vec<&PassUnit> = composed.units.iter().filter(is_drawn).collect();
    // The image is drawn last, and buffers in the order of their letters.
    units.sort_by_key(|unit| unit.program_number(project));
    let outputs: Vec<Option<OutputId>> = units
        .iter()
        .map(|unit| project.passes.get(unit.pass)?.output.clone())
        .collect();
    let mut remarks = left_out(project, composed, host);
    let mut texts = Vec::new();
    for (at, unit) in units.iter().enumerate() {
        match program(project, composed, unit, (at, &outputs), (host, template)) {
            Ok((text, found)) => {
                texts.push(text);
                remarks.extend(found);
            }
            Err(found) => remarks.extend(found),
        }
    }
    if texts.len() < units.len() {
        let files = Vec::new();
        return Ok(Build { files, remarks });
    }
    files(order, project, &texts).map(|files| Build { files, remarks })
}

/// A program, of which `at` is the number, and warnings about it.
fn program(
    project: &Project,
    composed: &Composed,
    unit: &PassUnit,
    (at, outputs): (usize, &[Option<OutputId>]),
    (host, template): (&'static Preset, &Template),
) -> Result<(HostText, Vec<Remark>), Vec<Remark>> {
    let Some(pass) = project.passes.get(unit.pass) else {
        return Err(Vec::new());
    };
    let program = &composed.analysis(unit).program;
    if !defines(program, "mainImage") {
        let message = format!("host `{}` runs only code with `mainImage`", host.name);
        let title = pass.title(unit.pass);
        return Err(vec![Remark::missing(title, Span::default(), message)]);
    }
    let pass = numbered(pass, outputs);
    let inputs = supplied_inputs(program, &pass, host)?;
    let own = format!("iChannel{at}");
    let is_own =
        |(_, supplied): &&(UsedInput, Supplied)| *supplied == Supplied::Sampler(own.clone());
    if let Some((input, _)) = inputs.iter().find(is_own) {
        let message = format!(
            "host `{}` does not provide `{}`: a program cannot read what it drew itself",
            host.name, input.name
        );
        return Err(vec![Remark::missing(String::new(), input.span, message)]);
    }
    let files = user_files(composed, unit);
    let mut writer = HostWriter::new(host, template, &files);
    writer.supply(&inputs);
    let warnings = differences(&pass, &pass.title(unit.pass), &inputs, host);
    Ok((writer.write(program, &credits::lines(project)), warnings))
}

/// A pass whose inputs are the buffers with the numbers of the programs.
fn numbered(pass: &ProjectPass, outputs: &[Option<OutputId>]) -> ProjectPass {
    let mut pass = pass.clone();
    for input in &mut pass.inputs {
        let at = outputs
            .iter()
            .position(|o| o.as_ref().is_some_and(|o| o.0 == input.id));
        if let Some(buffer) = at.and_then(OutputId::buffer) {
            input.id = buffer.0;
        }
    }
    pass
}

/// The files of the programs: `NAME.glsl` for a single one, else `NAME-0.glsl` and so on, and
/// `NAME-c.glsl` for the code before that of each.
fn files(order: Order, project: &Project, texts: &[HostText]) -> Result<Vec<File>, BuildError> {
    let path = match order.output {
        Destination::Standard | Destination::File(_) if texts.len() < 2 => {
            let all = texts
                .iter()
                .map(|t| file(order.output.path(), t.text.as_str()));
            return Ok(all.collect());
        }
        Destination::Standard => {
            let names = (0..texts.len()).map(|at| format!("program {at}"));
            return Err(BuildError::NeedsFolder(names.collect()));
        }
        Destination::File(path) => path.to_path_buf(),
        Destination::Folder(folder) => folder.join(format!("{}.glsl", title(folder, project))),
    };
    let common = texts.first().map_or("", HostText::common);
    let is_shared = texts.len() > 1 && texts.iter().all(|t| t.common() == common);
    let common = if is_shared { common } else { "" };
    let named = texts.iter().enumerate();
    let programs = named.map(|(at, text)| {
        let own = text.text.get(common.len()..).unwrap_or("");
        file(&beside(&path, &at.to_string()), own)
    });
    let mut files: Vec<File> = programs.collect();
    if !common.is_empty() {
        files.push(file(&beside(&path, "c"), common));
    }
    Ok(files)
}

/// The name of a screen saver in a folder.
fn title(folder: &Path, project: &Project) -> String {
    let name = folder.file_name().map(|n| n.to_string_lossy().into_owned());
    name.unwrap_or_else(|| project.info.name.clone())
}

/// The path of a program: `NAME-0.glsl` for `NAME.glsl`.
fn beside(path: &Path, end: &str) -> PathBuf {
    let part = |part: Option<&std::ffi::OsStr>| {
        part.map_or(String::new(), |n| n.to_string_lossy().into_owned())
    };
    let (stem, extension) = (part(path.file_stem()), part(path.extension()));
    path.with_file_name(format!("{stem}-{end}.{extension}"))
}
