//! ShaderToy projects, and the JSON they are exported as.
//!
//! Three shapes occur: the REST API's `{"Shader": {...}}` with numeric ids and `ctype`, the site's
//! own endpoint and export, an array or object with string ids and `type`, and the bare object that
//! the site's editor saves. All carry `info` and `renderpass`.

use crate::semantic::{Channels, Pass, Sampler};
use serde_json::Value;
use std::fmt;
use std::sync::Arc;

/// Most passes a project may have; ShaderToy itself loads 8, and the largest seen has 11.
const MAX_PASSES: usize = 16;
/// Largest export that is read, in bytes.
pub const MAX_EXPORT: usize = 8 * 1024 * 1024;

/// A ShaderToy project.
#[derive(Clone, PartialEq, Debug)]
pub struct Project {
    /// Who made it, and what it is called.
    pub info: Info,
    /// Its passes, in the order of the export.
    pub passes: Vec<ProjectPass>,
    /// Whether it comes from an export, so that ShaderToy's terms hold and passes have names.
    pub is_export: bool,
}

/// Who made a project, and what it is called; all of it is text from outside.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Info {
    /// The id in the address of its page.
    pub id: String,
    /// Its title.
    pub name: String,
    /// Its author.
    pub author: String,
    /// What the author wrote about it.
    pub description: String,
    /// Its tags.
    pub tags: Vec<String>,
}

/// A pass.
#[derive(Clone, PartialEq, Debug)]
pub struct ProjectPass {
    /// What it draws.
    pub kind: Pass,
    /// Its name, which tells nothing certain.
    pub name: String,
    /// Its code.
    pub code: Arc<str>,
    /// What its channels read.
    pub inputs: Vec<Input>,
    /// What it writes to.
    pub output: Option<OutputId>,
}

/// What a pass writes to, as inputs name it.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct OutputId(pub String);

/// What a channel reads.
#[derive(Clone, PartialEq, Debug)]
pub struct Input {
    /// Number of the channel, 0 to 3.
    pub channel: u8,
    /// What kind of thing it is.
    pub kind: InputKind,
    /// Its id; for a buffer the [`OutputId`] of the pass.
    pub id: String,
    /// Where the site keeps it.
    pub src: String,
    /// How it is sampled.
    pub sampler: SamplerSettings,
    /// Name of the file that the user gave for it.
    pub name: String,
    /// That file as `data:` addresses, six for a cube map; none where no file is at hand.
    pub urls: Vec<String>,
}

/// The kinds of input.
#[expect(missing_docs, reason = "the variants are words of the field")]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[rustfmt::skip]
pub enum InputKind {
    Texture, Buffer, Cubemap, Volume, Keyboard, Video, Webcam, Music, MusicStream, Microphone,
}

impl InputKind {
    fn of(word: &str) -> Option<InputKind> {
        Some(match word {
            "texture" => InputKind::Texture,
            "buffer" => InputKind::Buffer,
            "cubemap" => InputKind::Cubemap,
            "volume" => InputKind::Volume,
            "keyboard" => InputKind::Keyboard,
            "video" => InputKind::Video,
            "webcam" => InputKind::Webcam,
            "music" => InputKind::Music,
            "musicstream" => InputKind::MusicStream,
            "mic" => InputKind::Microphone,
            _ => return None,
        })
    }

    /// The type of the channel that reads it.
    pub const fn sampler(self) -> Sampler {
        match self {
            InputKind::Cubemap => Sampler::SamplerCube,
            InputKind::Volume => Sampler::Sampler3D,
            _ => Sampler::Sampler2D,
        }
    }
}

/// How an input is sampled. The words are the export's own; unknown ones mean the same to the player
/// as those named last.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct SamplerSettings {
    /// `linear`, `mipmap`, else nearest.
    pub filter: String,
    /// `clamp`, else repeat.
    pub wrap: String,
    /// Whether the picture is turned upside down.
    pub vflip: bool,
}

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
        let json: Value = serde_json::from_str(text).map_err(|e| ProjectError::Json {
            line: e.line(),
            column: e.column(),
            message: e
                .to_string()
                .split(" at line ")
                .next()
                .unwrap_or("")
                .to_string(),
        })?;
        let shader = match &json {
            Value::Array(all) if all.len() == 1 => &json[0],
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
        let images = passes.iter().filter(|p| p.kind == Pass::Image).count();
        if images > 1 {
            return Err(field(
                "renderpass",
                format!("{images} passes of type `image`; only one is allowed"),
            ));
        }
        Ok(Project {
            info: read_info(shader.get("info").unwrap_or(&Value::Null)),
            passes,
            is_export: true,
        })
    }

    /// The code that is put before every other pass.
    pub fn commons(&self) -> impl Iterator<Item = &ProjectPass> {
        self.passes.iter().filter(|p| p.kind == Pass::Common)
    }
}

impl ProjectPass {
    /// What the user calls it; for a pass without a name, what it draws and its place.
    pub fn title(&self, index: usize) -> String {
        if !self.name.is_empty() {
            return self.name.clone();
        }
        match self.kind {
            Pass::Image => "Image".to_string(),
            Pass::Common => "Common".to_string(),
            _ => format!("pass {index}"),
        }
    }

    /// The type of each channel; a channel without input is a `sampler2D`.
    pub fn channels(&self) -> Channels {
        let mut channels = [Some(Sampler::Sampler2D); 4];
        for input in &self.inputs {
            if let Some(channel) = channels.get_mut(input.channel as usize) {
                *channel = Some(input.kind.sampler());
            }
        }
        channels
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
        Some(Value::Array(outputs)) => outputs.first().map(|o| OutputId(text(o.get("id")))),
        _ => None,
    };
    let name = text(pass.get("name"));
    Ok(ProjectPass {
        kind,
        name,
        code: code.as_str().into(),
        inputs,
        output,
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
    let sampler = input.get("sampler").unwrap_or(&Value::Null);
    Ok(Input {
        channel: channel as u8,
        kind,
        id: text(input.get("id")),
        src: text(input.get("filepath").or_else(|| input.get("src"))),
        sampler: SamplerSettings {
            filter: text(sampler.get("filter")),
            wrap: text(sampler.get("wrap")),
            vflip: matches!(sampler.get("vflip"), Some(Value::String(s)) if s == "true")
                || matches!(sampler.get("vflip"), Some(Value::Bool(true))),
        },
        name: String::new(),
        urls: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(project.passes[0].inputs[0].id, "257");
        assert_eq!(project.passes[0].channels()[0], Some(Sampler::SamplerCube));
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
        let two = r#"{"renderpass":[{"type":"image","code":""},{"type":"image","code":""}]}"#;
        check(
            two,
            "`renderpass`: 2 passes of type `image`; only one is allowed",
        );
    }
}
