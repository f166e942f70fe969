//! A shader as a page that plays it.

use super::buffers::TextBuffer;
use super::new_file::new_file;
use super::snapshot::{Answer, Failure, Snapshot};
use super::uri::path_of;
use gen_lsp_types::{Position, Range, Uri, WorkspaceEdit};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use shaderlint_diagnostic::Severity;
use shaderlint_engine::{scripted, set_from_scripts};
use shaderlint_ide::{self as ide, Document, ShownValue};
use shaderlint_port::html;
use shaderlint_project::{
    Composed, FileType, Files, OpenedProject, Project, add_stand_ins, channel_file, open_file,
};
use std::path::Path;

/// Which shader of a document is shown.
#[derive(Clone, Copy, Default, Deserialize)]
pub struct ShownShader {
    /// A position in it.
    pub position: Option<Position>,
    /// Its number, which an earlier page had.
    pub shader: Option<usize>,
    /// The range of an expression, or a position of a variable, whose value is shown instead.
    pub value: Option<Range>,
}

impl ShownShader {
    /// The argument of a command: the number of the shader, a position in it, the range of a value,
    /// or null.
    pub fn read(argument: Value) -> ShownShader {
        let number = argument.as_u64();
        ShownShader {
            shader: number.and_then(|number| usize::try_from(number).ok()),
            value: serde_json::from_value(argument.clone()).ok(),
            position: serde_json::from_value(argument).ok(),
        }
    }
}

/// A page that plays a shader.
#[derive(Serialize)]
pub struct ShaderPage {
    /// The page.
    pub html: String,
    /// Number of the shader in its document.
    pub shader: usize,
    /// The shown value, unless it is the colour of the shader.
    pub value: Option<ValueText>,
    /// The channels that nothing gives an input.
    pub assumed: Vec<AssumedChannel>,
    /// The file that gives inputs to channels, if there can be one.
    pub channels: Option<ChannelFile>,
}

/// A shown value.
#[derive(Serialize)]
pub struct ValueText {
    /// The text of the expression.
    pub text: String,
    /// The numbers that are shown as 0 and as 1.
    pub limits: [f32; 2],
}

/// A channel that nothing gives an input.
#[derive(Serialize)]
pub struct AssumedChannel {
    /// The pass, such as `image`.
    pub pass: &'static str,
    /// The sampler, such as `iChannel0`.
    pub channel: String,
    /// What it shows, such as `generated texture`.
    pub shows: String,
}

/// The file that gives inputs to channels.
#[derive(Serialize)]
pub struct ChannelFile {
    /// Its URI.
    pub uri: Uri,
    /// Whether it exists. If not, `shaderlint.writeChannels` writes it.
    pub exists: bool,
}

/// A shader that is shown.
struct ShownProject {
    project: Project,
    composed: Composed,
    /// Number of the shader in its document.
    shader: usize,
    value: Option<ValueText>,
    channels: Option<ChannelFile>,
}

/// The page of a shader of a document, with the passes in the same folder.
pub fn page(snapshot: &Snapshot, buffer: &TextBuffer, shown: ShownShader) -> Answer<ShaderPage> {
    let shown = shown_project(snapshot, buffer, shown)?;
    let assumed = shown.project.assumed().into_iter();
    let assumed = assumed.map(|input| AssumedChannel {
        pass: input.pass,
        channel: input.channel,
        shows: input.shows,
    });
    Ok(ShaderPage {
        html: html(&shown.project, &shown.composed, None, None).whole(),
        shader: shown.shader,
        value: shown.value,
        assumed: assumed.collect(),
        channels: shown.channels,
    })
}

/// The edit that writes the file of inputs that the page of a shader assumes.
pub fn write_channels(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    shown: ShownShader,
) -> Answer<WorkspaceEdit> {
    let shown = shown_project(snapshot, buffer, shown)?;
    let uri = match shown.channels {
        Some(file) if !file.exists => file.uri,
        Some(file) => return Err(Failure::refused(format!("{} exists", file.uri.0))),
        None => return Err(Failure::refused("the shader is not a file of its own")),
    };
    if shown.project.assumed().is_empty() {
        return Err(Failure::refused("all channels have an input"));
    }
    if !snapshot.client.creates_files {
        return Err(Failure::refused("the editor cannot create files"));
    }
    Ok(WorkspaceEdit {
        document_changes: Some(new_file(uri, shown.project.assumed_file())),
        ..WorkspaceEdit::default()
    })
}

fn shown_project(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    shown: ShownShader,
) -> Answer<ShownProject> {
    let document = snapshot.document(buffer);
    let offset = shown.position.map(|at| snapshot.offset(buffer, at));
    let value = match shown.value {
        Some(range) => Some(shown_value(snapshot, buffer, range)?),
        None => None,
    };
    let own = value
        .as_ref()
        .map(|(value, _)| value.shader)
        .or(shown.shader);
    let shader = own.or_else(|| ide::previewed(&document, offset));
    let shader = shader.unwrap_or(0);
    let document = value
        .as_ref()
        .map_or(&*document, |(value, _)| &value.document);
    let OpenedProject {
        mut project,
        place,
        orders,
        ..
    } = draft(snapshot, document, shader)?;
    let wrong = |error: shaderlint_project::ShaderError| Failure::refused(error.to_string());
    let composed = project.resolve(&buffer.path).map_err(wrong)?;
    let (options, files) = (&document.options, &snapshot.files);
    let values = scripted(&document.path, &document.text, options, files);
    set_from_scripts(&mut project, &values);
    if !project.is_shown() {
        return Err(Failure::refused(
            "the document contains no shader that can be drawn",
        ));
    }
    // The view keeps the last valid image.
    if let Some(error) = first_error(&composed) {
        return Err(Failure::refused(error));
    }
    let place = place.filter(|_| path_of(&buffer.uri).is_some());
    let orders = place.as_ref().map_or(&[][..], |_| &orders);
    let put = snapshot.workspace().put_channels(&mut project, orders);
    put.map_err(Failure::refused)?;
    add_stand_ins(&mut project);
    let composed = project.renew(composed, &buffer.path).map_err(wrong)?;
    let is_written = !project.is_export;
    let channels = place.filter(|_| is_written);
    Ok(ShownProject {
        project,
        composed,
        shader,
        value: value.map(|(value, limits)| ValueText {
            text: value.text,
            limits,
        }),
        channels: channels.map(|place| orders_file(snapshot, &place)),
    })
}

/// The document whose shader draws the value in a range, and the numbers that are black and white:
/// those of a small image, if they are not between 0 and 1.
fn shown_value(
    snapshot: &Snapshot,
    buffer: &TextBuffer,
    range: Range,
) -> Answer<(ShownValue, [f32; 2])> {
    let (document, span) = (snapshot.document(buffer), snapshot.span(buffer, range));
    let shown = |limits| {
        let value = ide::shown_value(&document, &snapshot.files, span, limits);
        value.ok_or_else(|| Failure::refused("the value of this code cannot be shown"))
    };
    let value = shown(ide::WITHIN)?;
    let analysis = value.document.report.analyses.get(value.shader);
    let limits = analysis.filter(|_| snapshot.settings.run);
    match limits.and_then(ide::limits) {
        Some(limits) if limits != ide::WITHIN => Ok((shown(limits)?, limits)),
        _ => Ok((value, ide::WITHIN)),
    }
}

/// The file that gives inputs to the channels of a shader file, or of a folder of passes.
fn orders_file(snapshot: &Snapshot, place: &Path) -> ChannelFile {
    let file = channel_file(place, &snapshot.files);
    ChannelFile {
        uri: snapshot.uri(&file.to_string_lossy()),
        exists: snapshot.files.entry(&file) == Some(FileType::File),
    }
}

/// The first error in the passes of a project, with its line.
fn first_error(composed: &Composed) -> Option<String> {
    let analyses = composed.units.iter().map(|unit| composed.analysis(unit));
    let mut all = analyses.flat_map(|analysis| &analysis.diagnostics);
    let error = all.find(|d| d.severity == Severity::Error)?;
    let file = composed.sources.file_at(error.span.start)?;
    let line = file.shown_position(error.span.start).line;
    let path = file.shown_path(error.span.start);
    let included = Path::new(path).file_name().filter(|_| path != file.path);
    let part = file
        .part
        .clone()
        .or(included.map(|name| name.to_string_lossy().into_owned()));
    let part = part.map_or(String::new(), |part| format!("{part}, "));
    Some(format!("{part}line {line}: {}", error.message))
}

/// The project of a shader of a document. A document that is one shader is opened as every command
/// opens its file.
fn draft(snapshot: &Snapshot, document: &Document, shader: usize) -> Answer<OpenedProject> {
    let is_part = document.report.holds_shaders() || document.report.analyses.len() > 1;
    let is_export = document.path.ends_with(".json");
    if is_part && !is_export {
        let project = ide::preview_project(document, shader);
        let project = project.map_err(|e| Failure::refused(e.to_string()))?;
        return Ok(OpenedProject::of(project));
    }
    let access = document.options.file_access(&snapshot.files);
    let opened = open_file(&document.path, &document.text, None, access);
    let mut draft = opened.map_err(Failure::refused)?;
    draft.order(&[]).map_err(Failure::refused)?;
    Ok(draft)
}
