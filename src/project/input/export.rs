//! The JSON of ShaderToy exports.
//!
//! There are three forms: the REST API's `{"Shader": {...}}` with numeric ids and `ctype`; the
//! website's own endpoint and export, an array or object with string ids and `type`; and the bare
//! object that the website's editor saves. All contain `info` and `renderpass`.

use crate::{Info, Input, InputKind, OutputId, PassRole, Project, ProjectPass, SamplerSettings};
use serde_json::Value;
use shaderlint_semantic::{GuessedKind, Pass, guess};
use shaderlint_text::json::repair_escapes;
use std::fmt;

/// Maximum number of passes; ShaderToy itself loads 8, and the largest known export has 11.
const MAX_PASSES: usize = 16;
/// Maximum size of an export in bytes; it may contain its media.
pub const MAX_EXPORT: usize = 128 * 1024 * 1024;

/// Why a text is not a project.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ProjectError {
    /// Invalid JSON.
    Json {
        /// 1-based.
        line: usize,
        /// 1-based.
        column: usize,
        /// The message of the JSON parser.
        message: String,
    },
    /// Valid JSON, but not a ShaderToy export.
    NotAnExport,
    /// An error response of ShaderToy's API, with its message.
    Answer(String),
    /// Larger than [`MAX_EXPORT`]: the size in bytes.
    TooLarge(usize),
    /// A missing or invalid field.
    Field {
        /// JSON path, such as `renderpass[1].type`.
        path: String,
        /// The error message.
        message: String,
    },
}

impl fmt::Display for ProjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ProjectError::Json {
                line,
                column,
                message,
            } => {
                write!(f, "line {line}, column {column}: {message}")
            }
            ProjectError::NotAnExport => {
                write!(f, "not a ShaderToy export: `renderpass` is missing")
            }
            ProjectError::Answer(answer) => {
                write!(
                    f,
                    "expected a shader, found an error from ShaderToy: {answer}"
                )
            }
            ProjectError::TooLarge(size) => {
                write!(
                    f,
                    "the export has {size} bytes, but the limit is {MAX_EXPORT}"
                )
            }
            ProjectError::Field { path, message } => write!(f, "`{path}`: {message}"),
        }
    }
}

impl std::error::Error for ProjectError {}

fn field(path: impl Into<String>, message: impl Into<String>) -> ProjectError {
    ProjectError::Field {
        path: path.into(),
        message: message.into(),
    }
}

impl Project {
    /// Parses an export in any of the three forms.
    pub fn from_json(text: &str) -> Result<Project, ProjectError> {
        if text.len() > MAX_EXPORT {
            return Err(ProjectError::TooLarge(text.len()));
        }
        let text = repair_escapes(text.trim_start_matches('\u{feff}'));
        let json: Value = serde_json::from_str(&text).map_err(|e| ProjectError::Json {
            line: e.line(),
            column: e.column(),
            message: e
                .to_string()
                .split(" at line ")
                .next()
                .unwrap_or("")
                .to_string(),
        })?;
        let shader = the_shader(&json)?;
        let passes = list(shader.get("renderpass"));
        if passes.is_empty() || passes.len() > MAX_PASSES {
            let message = format!("expected 1 to {MAX_PASSES} passes, found {}", passes.len());
            return Err(field("renderpass", message));
        }
        let passes = passes
            .into_iter()
            .enumerate()
            .filter(|(_, p)| !p.is_null())
            .map(|(i, p)| read_pass(p, &format!("renderpass[{i}]")))
            .collect::<Result<Vec<_>, _>>()?;
        let mut project = Project {
            info: read_info(shader.get("info").unwrap_or(&Value::Null)),
            passes,
            is_export: true,
            ..Project::default()
        };
        check_passes(&project)?;
        name_buffers(&mut project);
        Ok(project)
    }

    /// The Common passes, which are put before every other pass.
    pub fn commons(&self) -> impl Iterator<Item = &ProjectPass> {
        self.passes.iter().filter(|p| p.kind == Pass::Common)
    }
}

/// The shaders of an export, each with its title and as an export of its own. Empty if the text is
/// none.
pub fn exports_in(text: &str) -> Vec<(String, String)> {
    let json: Value = serde_json::from_str(text).unwrap_or_default();
    let named = shaders(&json)
        .into_iter()
        .filter(|shader| is_export(shader))
        .map(|shader| {
            let info = unwrapped(shader).get("info");
            let name = info.and_then(|info| info.get("name")?.as_str());
            (name.unwrap_or_default().to_string(), shader.to_string())
        });
    named.collect()
}

fn is_export(shader: &Value) -> bool {
    unwrapped(shader).get("renderpass").is_some()
}

/// The shaders of a download: one, an array, or all shaders of a user, which the site exports
/// together with the user's name.
fn shaders(json: &Value) -> Vec<&Value> {
    let all = json.get("shaders").or(json.get("shader")).unwrap_or(json);
    match all {
        Value::Array(all) => all.iter().collect(),
        _ => vec![json],
    }
}

/// A shader without the object around it that some downloads have.
fn unwrapped(json: &Value) -> &Value {
    json.get("Shader").unwrap_or(json)
}

/// The object that contains the passes.
fn the_shader(json: &Value) -> Result<&Value, ProjectError> {
    let all = shaders(json);
    if all.iter().filter(|shader| is_export(shader)).count() > 1 {
        return Err(field(
            "[1]",
            "the file contains several shaders; `shaderport FILE -o FOLDER` writes a page for each",
        ));
    }
    let shader = all.first().copied().unwrap_or(json);
    let shader = unwrapped(shader);
    match (shader.get("renderpass"), shader.get("Error")) {
        (Some(Value::Array(_) | Value::Object(_)), _) => Ok(shader),
        (_, Some(Value::String(answer))) => Err(ProjectError::Answer(plain(answer))),
        _ => Err(ProjectError::NotAnExport),
    }
}

/// The values of an array or of an object; empty for anything else.
fn list(value: Option<&Value>) -> Vec<&Value> {
    match value {
        Some(Value::Array(all)) => all.iter().collect(),
        Some(Value::Object(map)) => map.values().collect(),
        _ => Vec::new(),
    }
}

/// Checks that there is at most one Image, one cube map and one sound pass.
fn check_passes(project: &Project) -> Result<(), ProjectError> {
    for (kind, word) in [
        (Pass::Image, "image"),
        (Pass::Cubemap, "cubemap"),
        (Pass::Sound, "sound"),
    ] {
        let count = project.passes.iter().filter(|p| p.kind == kind).count();
        if count > 1 {
            let message = format!("expected one pass of type `{word}`, found {count}");
            return Err(field("renderpass", message));
        }
    }
    Ok(())
}

/// Assigns the free buffer letters, in order, to buffers without an output id.
fn name_buffers(project: &mut Project) {
    let mut free: Vec<OutputId> = (0..4).rev().filter_map(OutputId::buffer).collect();
    free.retain(|id| !project.draws(Pass::Buffer, &id.0));
    for pass in &mut project.passes {
        let is_nameless = pass.output.as_ref().is_none_or(|o| o.0.is_empty());
        if pass.kind == Pass::Buffer && is_nameless {
            pass.output = free.pop();
        }
    }
}

fn text(value: Option<&Value>) -> String {
    match value {
        Some(Value::String(s)) => s.clone(),
        Some(Value::Number(n)) => n.to_string(),
        _ => String::new(),
    }
}

/// The first of several fields that is not empty.
fn first_text(of: &Value, names: &[&str]) -> String {
    let mut all = names.iter().map(|name| text(of.get(name)));
    all.find(|t| !t.is_empty()).unwrap_or_default()
}

fn read_info(info: &Value) -> Info {
    let tags = list(info.get("tags"));
    Info {
        id: text(info.get("id")),
        name: text(info.get("name")),
        author: text(info.get("username")),
        description: text(info.get("description")),
        tags: tags.into_iter().map(|t| text(Some(t))).collect(),
    }
}

fn read_pass(pass: &Value, path: &str) -> Result<ProjectPass, ProjectError> {
    let Some(Value::String(code)) = pass.get("code") else {
        return Err(field(
            format!("{path}.code"),
            "the code of the pass is missing",
        ));
    };
    let name = text(pass.get("name"));
    let outputs = list(pass.get("outputs"));
    let output = outputs.first().map(|o| OutputId::new(&text(o.get("id"))));
    let kind = match text(pass.get("type")).as_str() {
        "image" => Pass::Image,
        "buffer" => Pass::Buffer,
        "common" => Pass::Common,
        "sound" => Pass::Sound,
        "cubemap" => Pass::Cubemap,
        "" => guessed_kind(output.as_ref(), &name, code).ok_or_else(|| {
            field(
                format!("{path}.type"),
                "the pass type is missing and cannot be inferred from the name or the code",
            )
        })?,
        other => {
            return Err(field(
                format!("{path}.type"),
                format!("unknown pass type `{}`", plain(other)),
            ));
        }
    };
    let mut inputs = Vec::new();
    for (i, input) in list(pass.get("inputs")).into_iter().enumerate() {
        inputs.extend(read_input(input, i, &format!("{path}.inputs[{i}]"))?);
    }
    Ok(ProjectPass {
        name,
        inputs,
        output,
        ..ProjectPass::new(kind, code.as_str())
    })
}

/// Infers the kind of a pass without a type from its output, its name or its code.
fn guessed_kind(output: Option<&OutputId>, name: &str, code: &str) -> Option<Pass> {
    let by_output = output.and_then(|o| match o.0.as_str() {
        OutputId::IMAGE => Some(Pass::Image),
        OutputId::CUBE => Some(Pass::Cubemap),
        OutputId::SOUND => Some(Pass::Sound),
        _ => o.number().map(|_| Pass::Buffer),
    });
    let by_name = || PassRole::of_name(name).map(PassRole::kind);
    let by_code = || match guess(code).kind {
        Some(GuessedKind::ShaderToy(kind)) => Some(kind),
        _ => None,
    };
    by_output.or_else(by_name).or_else(by_code)
}

/// Parses the input of a channel; `None` if it is empty. An input without a channel number gets the
/// number of its position.
fn read_input(input: &Value, place: usize, path: &str) -> Result<Option<Input>, ProjectError> {
    let word = first_text(input, &["type", "ctype"]);
    let channel = match text(input.get("channel")).as_str() {
        "" => Some(place),
        number => number.parse().ok(),
    };
    let Some(channel) = channel.filter(|c| *c < 4) else {
        return Err(field(
            format!("{path}.channel"),
            "expected a channel from 0 to 3",
        ));
    };
    if word.is_empty() {
        return Ok(None);
    }
    // Unknown kinds become an empty texture.
    let kind = InputKind::of(&word).unwrap_or(InputKind::Texture);
    let src = first_text(input, &["filepath", "src"]);
    let urls = data_addresses(input, &src, path)?;
    if urls.is_empty() && climbs(&src) {
        let message = format!("`{}` is outside of the shader's folder", plain(&src));
        let field_name = match text(input.get("filepath")) == src {
            true => "filepath",
            false => "src",
        };
        return Err(field(format!("{path}.{field_name}"), message));
    }
    Ok(Some(Input {
        id: source_id(kind, &text(input.get("id")), &src),
        sampler: read_sampler(kind, input.get("sampler").unwrap_or(&Value::Null)),
        name: text(input.get("name")),
        src: if urls.is_empty() { src } else { String::new() },
        urls,
        ..Input::empty(channel as u8, kind)
    }))
}

/// A missing sampler has the default settings.
fn read_sampler(kind: InputKind, sampler: &Value) -> SamplerSettings {
    if sampler.is_null() {
        return SamplerSettings::usual(kind);
    }
    SamplerSettings {
        filter: text(sampler.get("filter")),
        wrap: text(sampler.get("wrap")),
        vflip: matches!(sampler.get("vflip"), Some(Value::String(s)) if s == "true")
            || matches!(sampler.get("vflip"), Some(Value::Bool(true))),
    }
}

/// The embedded files of an input, as `--target json` writes them.
fn data_addresses(input: &Value, src: &str, path: &str) -> Result<Vec<String>, ProjectError> {
    let data = list(input.get("data"));
    let given: Vec<String> = match data.is_empty() {
        false => data.into_iter().map(|v| text(Some(v))).collect(),
        _ if src.starts_with("data:") => vec![src.to_string()],
        _ => Vec::new(),
    };
    match given.iter().all(|url| url.starts_with("data:")) {
        true => Ok(given),
        false => Err(field(format!("{path}.data"), "expected a `data:` URL")),
    }
}

/// Untrusted text, shortened and without control characters.
pub(crate) fn plain(text: &str) -> String {
    let kept = text.chars().filter(|c| !c.is_control());
    kept.take(80).collect()
}

/// Whether a path contains `..`.
fn climbs(path: &str) -> bool {
    path.split(['/', '\\']).any(|part| part == "..")
}

/// The id of an input. The REST API identifies the output of a pass by its preview image.
fn source_id(kind: InputKind, id: &str, src: &str) -> String {
    let output = OutputId::new(id);
    let preview = src
        .rsplit_once("/media/previz/")
        .map_or("", |(_, name)| name);
    match kind {
        InputKind::Buffer if output.number().is_none() => {
            let number = preview.strip_prefix("buffer0");
            let number = number.and_then(|rest| rest.strip_suffix(".png")?.parse().ok());
            number.and_then(OutputId::buffer).unwrap_or(output).0
        }
        InputKind::Cubemap if preview == "cubemap00.png" => OutputId::CUBE.to_string(),
        _ => output.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_semantic::Sampler;
    use shaderlint_text::each_case;

    const PASS: &str = r#"{"type":"image","code":"x","name":"","outputs":[{"id":"4dfGRr"}],
        "inputs":[{"id":"4dXGR8","type":"buffer","channel":2,"sampler":{"filter":"linear","vflip":"true"}}]}"#;

    #[test]
    fn all_three_json_shapes_give_the_same_project() {
        let shader = format!(
            r#"{{"ver":"0.1","info":{{"name":"n","username":"u"}},"renderpass":[{PASS}]}}"#
        );
        let bare = Project::from_json(&shader).unwrap();
        assert_eq!(bare.info.author, "u");
        assert_eq!(bare.passes[0].inputs[0].channel, 2);
        assert!(bare.passes[0].inputs[0].sampler.vflip);
        for json in [format!("[{shader}]"), format!(r#"{{"Shader":{shader}}}"#)] {
            assert_eq!(Project::from_json(&json).as_ref(), Ok(&bare));
        }
    }

    #[test]
    fn numeric_ids_and_ctype_are_read() {
        let json = r#"{"Shader":{"renderpass":[{"type":"image","code":"","inputs":
            [{"id":257,"ctype":"cubemap","src":"/a.png","channel":0}]}]}}"#;
        let project = Project::from_json(json).unwrap();
        assert_eq!(project.passes[0].inputs[0].id, "4dXGR8");
        assert_eq!(project.passes[0].channels()[0], Some(Sampler::SamplerCube));
    }

    #[test]
    fn buffers_are_identified_by_id_image_or_order() {
        let json = r#"{"Shader":{"renderpass":[
            {"type":"image","code":"","inputs":[
                {"id":999,"ctype":"buffer","src":"/media/previz/buffer01.png","channel":0},
                {"id":9,"ctype":"cubemap","src":"/media/a//media/previz/cubemap00.png","channel":1}]},
            {"type":"buffer","code":"","outputs":[{"id":258}]},
            {"type":"buffer","code":""}]}}"#;
        let project = Project::from_json(json).unwrap();
        assert_eq!(project.passes[0].inputs[0].id, "XsXGR8");
        assert_eq!(project.passes[0].inputs[1].id, OutputId::CUBE);
        assert_eq!(project.passes[1].slug(), "buffer_b");
        assert_eq!(project.passes[2].slug(), "buffer_a");
    }

    /// Exports of other programs and older versions.
    #[test]
    fn missing_and_mistyped_fields_have_defaults() {
        let json = "\u{feff}{\"info\":null,\"renderpass\":[null,{\"name\":\"\\ud800 Image\",\"code\":\"\",
            \"outputs\":null,\"inputs\":{\"0\":{\"type\":null,\"ctype\":null,\"channel\":0},
            \"1\":{\"type\":null,\"ctype\":\"texture\",\"channel\":\"2\",\"filepath\":null,\"src\":\"/a.png\"},
            \"2\":null,\"3\":{\"ctype\":\"hologram\"}}},
            {\"code\":\"vec2 mainSound(int s, float t) { return vec2(0); }\"}]}";
        let project = Project::from_json(json).unwrap();
        let kinds: Vec<_> = project.passes.iter().map(|p| p.kind).collect();
        assert_eq!(kinds, [Pass::Image, Pass::Sound]);
        let image = &project.passes[0];
        assert_eq!(image.name, "\u{fffd} Image");
        let inputs = image.inputs.iter();
        let inputs = inputs.map(|i| format!("{} {:?} {}", i.channel, i.kind, i.src));
        let expected = ["2 Texture /a.png", "3 Texture "];
        assert_eq!(inputs.collect::<Vec<_>>(), expected);
        assert_eq!(image.inputs[0].sampler.filter, "mipmap");
    }

    #[test]
    fn errors_have_a_position_or_path() {
        each_case(include_str!("errors.txt"), |json, expected| {
            let error = Project::from_json(json).unwrap_err();
            assert_eq!(error.to_string(), expected, "{json}");
        });
    }
}
