//! The tool `port`.

use super::super::answer::{MAX_TEXT, ToolAnswer};
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites, in_parameters, one_of};
use crate::cli::command::FAILED;
use crate::port::{MainChoice, Target};
use schemars::JsonSchema;
use serde::Deserialize;
use std::fs;
use std::io;
use std::path::Path;

/// The arguments of `port`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PortTool {
    /// Shader file, ShaderToy export (.json), or folder with files named after passes
    /// (image.glsl, buffer_a.glsl, common.glsl)
    path: Option<String>,
    /// Text of a shader or an export, instead of `path`
    code: Option<String>,
    /// Output format; default: chosen by the extension of `output`, or plain WebGL2 shaders
    #[schemars(schema_with = "one_of::<Target>")]
    #[serde(default)]
    target: Option<String>,
    /// File or folder to write; without it the answer contains the files, but pages are too large
    /// for that
    output: Option<String>,
    /// Overwrite existing files
    #[serde(default)]
    force: bool,
    /// Site or library that the shader is written for, such as `shadertoy`, `glsl-sandbox` or
    /// `isf`; usually detected
    #[serde(alias = "from")]
    host: Option<String>,
    /// Inputs of channels, such as `0=keyboard`, `image.1=photo.jpg` or `buffer_a.0=buffer_a`
    #[serde(default)]
    channels: Vec<String>,
    /// Folder with a copy of ShaderToy's media files, such as media/a/x.jpg
    media: Option<String>,
    /// How plain shaders get a `main` function
    #[schemars(schema_with = "one_of::<MainChoice>")]
    #[serde(default)]
    main: Option<String>,
    /// Repair code that does not compile where only one fix is possible
    #[serde(default)]
    repair: bool,
    /// Verify with sample runs that the output draws the same as the input
    #[serde(default)]
    verify: bool,
}

impl Tool for PortTool {
    const NAME: &str = "port";
    const TITLE: &str = "Port to WebGL2";
    const ABOUT: &str = "Ports shaders from ShaderToy and similar sites to WebGL2: a page (`output` \
        such as `page.html`), a JavaScript module, or plain shaders.";
    const WRITES: ToolWrites = ToolWrites::Files;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let made = folder.path().join("made");
        let mut args = self.args();
        // The trailing separator makes it a folder.
        let inside = format!("{}/", made.display());
        args.option("--output", Some(self.output.as_ref().unwrap_or(&inside)));
        args.0.extend(input.args());
        let mut done = program.run(args.0, input.text()).await?;
        done.err = in_parameters::<PortTool>(&done.err);
        let mut answer = match &self.output {
            _ if done.code == i32::from(FAILED) => return Err(done.message()),
            Some(output) if Path::new(output).exists() => {
                ToolAnswer::of(&format!("written: {output}"), "")
            }
            Some(_) => return Err(done.message()),
            None => match files(&made).map_err(|e| e.to_string())? {
                files if files.is_empty() => return Err(done.message()),
                files => shown(&files)?,
            },
        };
        answer.push_any(&done.err);
        Ok(answer)
    }
}

impl PortTool {
    fn args(&self) -> Args {
        let mut args = Args::of(&["port"]);
        let plain = self.output.is_none().then_some("glsl");
        args.option("--target", self.target.as_deref().or(plain));
        args.option("--host", self.host.as_ref());
        args.options("--channel", &self.channels);
        args.option("--media", self.media.as_ref());
        args.option("--main", self.main.as_ref());
        args.switch("--force", self.force);
        args.switch("--repair", self.repair);
        args.switch("--verify", self.verify);
        args
    }
}

/// The files in a folder, sorted by name.
fn files(folder: &Path) -> io::Result<Vec<(String, Vec<u8>)>> {
    let mut files = Vec::new();
    if folder.is_dir() {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let name = entry.file_name().to_string_lossy().into_owned();
            files.push((name, fs::read(entry.path())?));
        }
    }
    files.sort();
    Ok(files)
}

/// All files as texts. They are never truncated, because the client would save them.
fn shown(files: &[(String, Vec<u8>)]) -> Result<ToolAnswer, String> {
    let size: usize = files.iter().map(|(_, content)| content.len()).sum();
    let mut texts = Vec::new();
    for (name, content) in files {
        match std::str::from_utf8(content) {
            Ok(text) if size <= MAX_TEXT => texts.push(format!("{name}:\n{text}")),
            Ok(_) => {
                return Err(format!(
                    "the output has {size} bytes, the limit is {MAX_TEXT}; pass `output` to write files"
                ));
            }
            Err(_) => return Err(format!("{name} is not text; pass `output` to write files")),
        }
    }
    let mut texts = texts.iter();
    let mut answer = ToolAnswer::of(texts.next().map_or("", String::as_str), "no output");
    texts.for_each(|text| answer.push(text));
    Ok(answer)
}
