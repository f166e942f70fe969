//! A shader in a file of its own.

use crate::check_context::CheckContext;
use crate::options::{DialectChoice, Options};
use crate::shader::input::SplitInput;
use crate::shader::reading::{InputText, Readings, Surroundings};
use crate::shader::shader_input::ShaderInput;
use shaderlint_detect::embed::mask;
use shaderlint_detect::kind::file_extension;
use shaderlint_project::{JoinedFiles, is_common, spread};
use shaderlint_semantic::{Guess, GuessedKind, Stage, guess};
use shaderlint_text::FileId;
use std::sync::Arc;

/// Reads the shader of a shader file. `None` if it is too large.
pub fn shader_part(
    input: &mut SplitInput,
    name: &str,
    file: FileId,
    text: &str,
    context: CheckContext,
) -> Option<()> {
    let options = context.options;
    let extension = file_extension(name);
    let stage = match extension.as_str() {
        "vert" | "vs" | "vsh" => Some(Stage::Vertex),
        "frag" | "fs" | "fsh" => Some(Stage::Fragment),
        _ => None,
    };
    let guessed = guess(text);
    let masked = match may_be_template(text, &guessed, options) {
        true => mask(text),
        false => None,
    };
    let has_holes = masked.is_some();
    let (files, is_open, missing) = match masked {
        Some(code) => (
            vec![Arc::make_mut(&mut input.sources).embed(file, 0, code)?],
            true,
            Vec::new(),
        ),
        None => {
            let joined = JoinedFiles::default();
            let access = context.file_access();
            let own = spread(&mut input.sources, (name, file, text), &joined, access)?;
            input.problems.extend(own.problems);
            input.hushed.extend(own.hushed);
            (own.files, own.is_open, own.missing)
        }
    };
    let about = InputText {
        files,
        stage,
        surroundings: match stage {
            _ if is_common(name, text, context.file_access()) => Surroundings::CommonFile,
            Some(_) => Surroundings::StageFile,
            None => Surroundings::File,
        },
        is_open,
        is_compiled: false,
        is_300: false,
        has_holes,
    };
    let readings = Readings::of(
        Arc::make_mut(&mut input.sources),
        (text, guessed),
        about,
        options,
    )?;
    let first = readings.all.first()?;
    input.parts.push(ShaderInput {
        infer_channels: first.dialect.is_shadertoy(),
        missing,
        ..ShaderInput::new(readings)
    });
    Some(())
}

/// Whether a program may fill holes in a shader file. If the text is evidently complete, only holes
/// that are not valid GLSL and have both delimiters count.
fn may_be_template(text: &str, guessed: &Guess, options: &Options) -> bool {
    let is_complete = guessed.kind.is_some_and(GuessedKind::is_complete);
    let has_ends = ["${", "{{", "<%", "{%", "%%", "##", "$("]
        .iter()
        .any(|s| text.contains(s));
    options.dialect == DialectChoice::Auto && (has_ends || !is_complete)
}
