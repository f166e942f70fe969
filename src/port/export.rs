//! The JSON that ShaderToy projects are exported as.
//!
//! Three shapes occur: the REST API's `{"Shader": {...}}` with numeric ids and `ctype`, the site's
//! own endpoint and export, an array or object with string ids and `type`, and the bare object that
//! the site's editor saves. All carry `info` and `renderpass`.

use super::{Info, Input, InputKind, OutputId, Project, ProjectPass, SamplerSettings};
use crate::semantic::Pass;
use serde_json::Value;
use std::fmt;

/// Most passes a project may have; ShaderToy itself loads 8, and the largest seen has 11.
const MAX_PASSES: usize = 16;
/// Largest export that is read, in bytes.
pub const MAX_EXPORT: usize = 8 * 1024 * 1024;

/// Why a text is no project.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ProjectError {
    /// It is no JSON.
    Json {
        /// 1-based.
        line: usize,
        /// 1-based.
        column: usize,
        /// What the JSON parser says.
        message: String,
    },
    /// It is JSON, but no ShaderToy export.
    NotAnExport,
    /// It is larger than [`MAX_EXPORT`].
    TooLarge(usize),
    /// Something in it is not as it should be.
    Field {
        /// Where, like `renderpass[1].type`.
        path: String,
        /// What is wrong.
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
                write!(f, "this is no ShaderToy export: it has no `renderpass`")
            }
            ProjectError::TooLarge(size) => {
                write!(f, "this export has {size} bytes; {MAX_EXPORT} are allowed")
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
    /// Reads an export of any of the three shapes.
    pub fn from_json(text: &str) -> Result<Project, ProjectError> {
        if text.len() > MAX_EXPORT {
            return Err(ProjectError::TooLarge(text.len()));
        }
        let json: Value =
            serde_json::from_str(text.trim_start_matches('\u{feff}')).map_err(|e| {
                ProjectError::Json {
                    line: e.line(),
                    column: e.column(),
                    message: e
                        .to_string()
                        .split(" at line ")
                        .next()
                        .unwrap_or("")
                        .to_string(),
                }
            })?;
        let shader = match &json {
            Value::Array(all) if all.len() == 1 => all.first().unwrap_or(&json),
            Value::Array(all)
                if all.len() > 1 && all.iter().all(|s| s.get("renderpass").is_some()) =>
            {
                return Err(field(
                    "[1]",
                    "there are several shaders in this file; give one at a time",
                ));
            }
            Value::Object(map) => map.get("Shader").unwrap_or(&json),
            _ => return Err(ProjectError::NotAnExport),
        };
        let Some(Value::Array(passes)) = shader.get("renderpass") else {
            return Err(ProjectError::NotAnExport);
        };
        if passes.is_empty() || passes.len() > MAX_PASSES {
            let message = format!("{} passes; 1 to {MAX_PASSES} are allowed", passes.len());
            return Err(field("renderpass", message));
        }
        let passes = passes
            .iter()
            .enumerate()
            .map(|(i, p)| read_pass(p, &format!("renderpass[{i}]")))
            .collect::<Result<Vec<_>, _>>()?;
        let mut project = Project {
            info: read_info(shader.get("info").unwrap_or(&Value::Null)),
            passes,
            is_export: true,
        };
        check_passes(&project)?;
        name_buffers(&mut project);
        Ok(project)
    }

    /// The code that is put before every other pass.
    pub fn commons(&self) -> impl Iterator<Item = &ProjectPass> {
        self.passes.iter().filter(|p| p.kind == Pass::Common)
    }
}

/// There is at most one Image, one cube map and one sound.
fn check_passes(project: &Project) -> Result<(), ProjectError> {
    for (kind, word) in [
        (Pass::Image, "image"),
        (Pass::Cubemap, "cubemap"),
        (Pass::Sound, "sound"),
    ] {
        let count = project.passes.iter().filter(|p| p.kind == kind).count();
        if count > 1 {
            let message = format!("{count} passes of type `{word}`; only one is allowed");
            return Err(field("renderpass", message));
        }
    }
    Ok(())
}

/// Gives the buffers that do not say what they write to the letters that are free, in order.
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

fn read_info(info: &Value) -> Info {
    let tags = match info.get("tags") {
        Some(Value::Array(tags)) => tags.iter().map(|t| text(Some(t))).collect(),
        _ => Vec::new(),
    };
    Info {
        id: text(info.get("id")),
        name: text(info.get("name")),
        author: text(info.get("username")),
        description: text(info.get("description")),
        tags,
    }
}

fn read_pass(pass: &Value, path: &str) -> Result<ProjectPass, ProjectError> {
    let kind = match pass.get("type") {
        Some(Value::String(kind)) => match kind.as_str() {
            "image" => Pass::Image,
            "buffer" => Pass::Buffer,
            "common" => Pass::Common,
            "sound" => Pass::Sound,
            "cubemap" => Pass::Cubemap,
            other => {
                return Err(field(
                    format!("{path}.type"),
                    format!("`{other}` is no type of pass"),
                ));
            }
        },
        _ => {
            return Err(field(
                format!("{path}.type"),
                "the type of the pass is missing",
            ));
        }
    };
    let Some(Value::String(code)) = pass.get("code") else {
        return Err(field(
            format!("{path}.code"),
            "the code of the pass is missing",
        ));
    };
    let inputs = match pass.get("inputs") {
        None | Some(Value::Null) => Vec::new(),
        Some(Value::Array(inputs)) => inputs
            .iter()
            .enumerate()
            .filter(|(_, i)| !i.is_null())
            .map(|(i, input)| read_input(input, &format!("{path}.inputs[{i}]")))
            .collect::<Result<Vec<_>, _>>()?,
        Some(_) => return Err(field(format!("{path}.inputs"), "this must be a list")),
    };
    let output = match pass.get("outputs") {
        Some(Value::Array(outputs)) => outputs.first().map(|o| OutputId::new(&text(o.get("id")))),
        _ => None,
    };
    Ok(ProjectPass {
        name: text(pass.get("name")),
        inputs,
        output,
        ..ProjectPass::new(kind, code.as_str())
    })
}

fn read_input(input: &Value, path: &str) -> Result<Input, ProjectError> {
    let word = text(input.get("type").or_else(|| input.get("ctype")));
    let kind = InputKind::of(&word).ok_or_else(|| {
        field(
            format!("{path}.type"),
            format!("`{word}` is no type of input"),
        )
    })?;
    let channel = input
        .get("channel")
        .and_then(Value::as_u64)
        .filter(|c| *c < 4);
    let Some(channel) = channel else {
        return Err(field(
            format!("{path}.channel"),
            "a channel is a number from 0 to 3",
        ));
    };
    let place = if input.get("filepath").is_some() {
        "filepath"
    } else {
        "src"
    };
    let src = text(input.get(place));
    let urls = data_addresses(input, &src, path)?;
    if urls.is_empty() && climbs(&src) {
        let message = format!("`{src}` leaves the folder of the shader");
        return Err(field(format!("{path}.{place}"), message));
    }
    Ok(Input {
        channel: channel as u8,
        kind,
        id: source_id(kind, &text(input.get("id")), &src),
        sampler: read_sampler(input.get("sampler").unwrap_or(&Value::Null)),
        name: text(input.get("name")),
        src: if urls.is_empty() { src } else { String::new() },
        urls,
    })
}

fn read_sampler(sampler: &Value) -> SamplerSettings {
    SamplerSettings {
        filter: text(sampler.get("filter")),
        wrap: text(sampler.get("wrap")),
        vflip: matches!(sampler.get("vflip"), Some(Value::String(s)) if s == "true")
            || matches!(sampler.get("vflip"), Some(Value::Bool(true))),
    }
}

/// The files that the input itself carries, as `--target json` writes them.
fn data_addresses(input: &Value, src: &str, path: &str) -> Result<Vec<String>, ProjectError> {
    let given: Vec<String> = match input.get("data") {
        Some(Value::Array(all)) => all.iter().map(|v| text(Some(v))).collect(),
        _ if src.starts_with("data:") => vec![src.to_string()],
        _ => Vec::new(),
    };
    match given.iter().all(|url| url.starts_with("data:")) {
        true => Ok(given),
        false => Err(field(
            format!("{path}.data"),
            "only `data:` addresses are taken",
        )),
    }
}

/// Whether a path names something above the folder that it starts in.
fn climbs(path: &str) -> bool {
    path.split(['/', '\\']).any(|part| part == "..")
}

/// The id of what is read. The REST API names a buffer by the picture that stands for it.
fn source_id(kind: InputKind, id: &str, src: &str) -> String {
    let output = OutputId::new(id);
    if kind != InputKind::Buffer || output.number().is_some() {
        return output.0;
    }
    let picture = src.strip_prefix("/media/previz/buffer0");
    let number = picture.and_then(|rest| rest.strip_suffix(".png")?.parse::<usize>().ok());
    number.and_then(OutputId::buffer).unwrap_or(output).0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::semantic::Sampler;

    const PASS: &str = r#"{"type":"image","code":"x","name":"","outputs":[{"id":"4dfGRr"}],
        "inputs":[{"id":"4dXGR8","type":"buffer","channel":2,"sampler":{"filter":"linear","vflip":"true"}}]}"#;

    #[test]
    fn the_three_shapes_give_the_same_project() {
        let shader = format!(
            r#"{{"ver":"0.1","info":{{"name":"n","username":"u"}},"renderpass":[{PASS}]}}"#
        );
        let bare = Project::from_json(&shader).unwrap();
        assert_eq!(bare.info.author, "u");
        assert_eq!(bare.passes[0].inputs[0].channel, 2);
        assert!(bare.passes[0].inputs[0].sampler.vflip);
        assert_eq!(
            Project::from_json(&format!("[{shader}]")).as_ref(),
            Ok(&bare)
        );
        assert_eq!(
            Project::from_json(&format!(r#"{{"Shader":{shader}}}"#)).as_ref(),
            Ok(&bare)
        );
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
    fn buffers_are_known_by_number_picture_or_order() {
        let json = r#"{"Shader":{"renderpass":[
            {"type":"image","code":"","inputs":[
                {"id":999,"ctype":"buffer","src":"/media/previz/buffer01.png","channel":0}]},
            {"type":"buffer","code":"","outputs":[{"id":258}]},
            {"type":"buffer","code":""}]}}"#;
        let project = Project::from_json(json).unwrap();
        assert_eq!(project.passes[0].inputs[0].id, "XsXGR8");
        assert_eq!(project.passes[1].slug(), "buffer_b");
        assert_eq!(project.passes[2].slug(), "buffer_a");
    }

    #[track_caller]
    fn check(json: &str, expected: &str) {
        assert_eq!(Project::from_json(json).unwrap_err().to_string(), expected);
    }

    #[test]
    fn errors_tell_the_place() {
        check("{", "line 1, column 1: EOF while parsing an object");
        check("{}", "this is no ShaderToy export: it has no `renderpass`");
        check(
            r#"{"renderpass":[{"type":"foo","code":""}]}"#,
            "`renderpass[0].type`: `foo` is no type of pass",
        );
        check(
            r#"{"renderpass":[{"type":"image","code":"","inputs":[{"type":"x","channel":0}]}]}"#,
            "`renderpass[0].inputs[0].type`: `x` is no type of input",
        );
        check(
            r#"{"renderpass":[{"type":"image","code":"","inputs":[{"type":"texture","channel":0,
                "filepath":"/media/../../secret.png"}]}]}"#,
            "`renderpass[0].inputs[0].filepath`: `/media/../../secret.png` leaves the folder of the \
             shader",
        );
        let two = r#"{"renderpass":[{"type":"image","code":""},{"type":"image","code":""}]}"#;
        check(
            two,
            "`renderpass`: 2 passes of type `image`; only one is allowed",
        );
    }
}
