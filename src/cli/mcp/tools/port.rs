//! The tool `port`.

use super::super::answer::{MAX_TEXT, ToolAnswer};
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Tool, ToolWrites, asked, in_parameters};
use crate::cli::command::FAILED;
use crate::commands::PortRequest;
use crate::commands::run::InputRequest;
use crate::port::Target;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::path::Path;

/// The arguments of `port`. The answer contains the files without `output`; pages are too large for that.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PortTool {
    /// Shader file, ShaderToy export (.json), or folder with files named after passes
    /// (image.glsl, buffer_a.glsl, common.glsl)
    path: Option<String>,
    /// Text of a shader or an export, instead of `path`
    code: Option<String>,
    #[serde(flatten)]
    source: InputRequest,
    #[serde(flatten)]
    request: PortRequest,
    /// Overwrite existing files
    #[serde(default)]
    force: bool,
    /// Folder with a copy of ShaderToy's media files, such as media/a/x.jpg
    media: Option<String>,
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

    async fn answer(mut self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        // The trailing separator makes it a folder.
        let made = folder.path().join("made").join("");
        let output = self.request.output.clone();
        if output.is_none() {
            self.request.output = Some(made.clone());
            self.request
                .target
                .get_or_insert_with(|| "glsl".to_string());
        }
        self.request.target(Target::Glsl)?;
        let mut args = asked(&self, "port", folder.path())?;
        args.option("--media", self.media.as_ref());
        args.switch("--force", self.force);
        args.switch("--repair", self.repair);
        args.switch("--verify", self.verify);
        args.0.extend(input.args());
        let mut done = program.run(args.0, input.text()).await?;
        done.err = in_parameters::<PortTool>(&done.err);
        let mut answer = match &output {
            _ if done.code == i32::from(FAILED) => return Err(done.message()),
            Some(output) if output.exists() => {
                ToolAnswer::of(&format!("written: {}", output.display()), "")
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
