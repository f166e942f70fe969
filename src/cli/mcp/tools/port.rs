//! `port`.

use super::super::answer::{MAX_TEXT, ToolAnswer};
use super::super::command::OwnProgram;
use super::super::input::ToolInput;
use super::tool::{Args, Tool, ToolWrites, one_of};
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
    /// A shader file, an export of ShaderToy (.json), or a folder whose files are named by their
    /// passes (image.glsl, buffer_a.glsl, common.glsl)
    path: Option<String>,
    /// The text of a shader or an export, instead of `path`
    code: Option<String>,
    /// What to make; without it the ending of `output` tells, else plain WebGL2
    #[schemars(schema_with = "one_of::<Target>")]
    #[serde(default)]
    target: Option<String>,
    /// File or folder to write; without it the answer holds the files, which pages are too large for
    output: Option<String>,
    /// Write over a file that is there already
    #[serde(default)]
    force: bool,
    /// What the code is written in, like `shadertoy`, `glsl-sandbox` or `isf`; the code tells mostly
    from: Option<String>,
    /// What channels read, like `0=keyboard`, `image.1=photo.jpg` or `buffer_a.0=buffer_a`
    #[serde(default)]
    channels: Vec<String>,
    /// Folder with the site's files, such as media/a/x.jpg
    media: Option<String>,
    /// How plain shaders get their `main`
    #[schemars(schema_with = "one_of::<MainChoice>")]
    #[serde(default)]
    main: Option<String>,
    /// Mend code that does not compile, where there is one answer
    #[serde(default)]
    repair: bool,
    /// Compare what is written with the original, by runs
    #[serde(default)]
    verify: bool,
}

impl Tool for PortTool {
    const NAME: &str = "port";
    const TITLE: &str = "Port to WebGL2";
    const ABOUT: &str = "Turns ShaderToy code, and what other players take, into WebGL2: a page \
        that plays (`output` like `page.html`), a module, or plain shaders.";
    const WRITES: ToolWrites = ToolWrites::Files;

    async fn answer(self, program: &OwnProgram) -> Result<ToolAnswer, String> {
        let input = ToolInput::of(self.path.as_ref(), self.code.as_ref())?;
        let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
        let made = folder.path().join("made");
        let mut args = self.args();
        // The last separator makes it a folder.
        let inside = format!("{}/", made.display());
        args.option("--output", Some(self.output.as_ref().unwrap_or(&inside)));
        args.0.extend(input.args());
        let done = program.run(args.0, input.text()).await?;
        let mut answer = match &self.output {
            _ if done.code == i32::from(FAILED) => return Err(done.said()),
            Some(output) if Path::new(output).exists() => {
                ToolAnswer::of(&format!("written: {output}"), "")
            }
            Some(_) => return Err(done.said()),
            None => match files(&made).map_err(|e| e.to_string())? {
                files if files.is_empty() => return Err(done.said()),
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
        args.option("--from", self.from.as_ref());
        args.options("--channel", &self.channels);
        args.option("--media", self.media.as_ref());
        args.option("--main", self.main.as_ref());
        args.switch("--force", self.force);
        args.switch("--repair", self.repair);
        args.switch("--verify", self.verify);
        args
    }
}

/// The files of a folder by name.
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

/// All files as texts. Half of a file would be taken for the whole.
fn shown(files: &[(String, Vec<u8>)]) -> Result<ToolAnswer, String> {
    let size: usize = files.iter().map(|(_, content)| content.len()).sum();
    let mut texts = Vec::new();
    for (name, content) in files {
        match std::str::from_utf8(content) {
            Ok(text) if size <= MAX_TEXT => texts.push(format!("{name}:\n{text}")),
            Ok(_) => {
                return Err(format!(
                    "{size} bytes were made, {MAX_TEXT} can be answered: name an `output`"
                ));
            }
            Err(_) => return Err(format!("{name} is no text: name an `output`")),
        }
    }
    let mut texts = texts.iter();
    let mut answer = ToolAnswer::of(texts.next().map_or("", String::as_str), "nothing was made");
    texts.for_each(|text| answer.push(text));
    Ok(answer)
}
