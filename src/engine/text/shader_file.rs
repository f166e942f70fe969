//! A shader in a file of its own.

use super::stage_name::StageName;
use crate::check_context::CheckContext;
use crate::options::{DialectChoice, Options};
use crate::shader::assumption::{SelectedShader, selected_shaders};
use crate::shader::input::SplitInput;
use crate::shader::reading::{InputText, Readings, Surroundings};
use crate::shader::shader_input::ShaderInput;
use shaderlint_detect::embed::mask;
use shaderlint_detect::kind::file_extension;
use shaderlint_project::{JoinedFiles, MissingInclude, is_common, spread};
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
    let by_extension = match extension.as_str() {
        "vert" | "vs" | "vsh" => Some(Stage::Vertex),
        "frag" | "fs" | "fsh" => Some(Stage::Fragment),
        _ => None,
    };
    let guessed = guess(text);
    let is_likely = |stage: &Stage| guessed.stage.is_none_or(|own| own == *stage);
    let by_name = || StageName::of(name).map(|named| named.stage);
    let stage = by_extension.or_else(|| by_name().filter(is_likely));
    let masked = match may_be_template(text, &guessed, options) {
        true => mask(text),
        false => None,
    };
    let has_holes = masked.is_some();
    let mut is_composed = false;
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
            is_composed = own.is_composed;
            (own.files, own.is_open, own.missing)
        }
    };
    let about = InputText {
        files,
        stage,
        surroundings: match by_extension {
            _ if is_common(name, text, context.file_access()) => Surroundings::CommonFile,
            Some(_) => Surroundings::StageFile,
            None => Surroundings::File,
        },
        is_open,
        is_composed,
        is_compiled: false,
        is_300: false,
        has_holes,
        macros: String::new(),
    };
    let shaders = shaders(input, (text, guessed), (about, missing), options)?;
    input.parts.extend(shaders);
    Some(())
}

/// The shaders of a text: macros may select one of several.
pub fn shaders(
    input: &mut SplitInput,
    (code, guessed): (&str, Guess),
    (about, missing): (InputText, Vec<MissingInclude>),
    options: &Options,
) -> Option<Vec<ShaderInput>> {
    let sources = Arc::make_mut(&mut input.sources);
    let with = |readings, missing| ShaderInput {
        missing,
        ..ShaderInput::new(readings)
    };
    let selected = selected_shaders(code);
    if selected.is_empty() {
        let readings = Readings::of(sources, (code, guessed), about, options)?;
        return Some(vec![with(readings, missing)]);
    }
    let shader = |shader: &SelectedShader| {
        let about = InputText {
            stage: Some(shader.stage),
            macros: shader.macros.definitions(),
            ..about.clone()
        };
        let readings = Readings::of(sources, (code, guessed), about, options)?;
        Some(with(readings, missing.clone()))
    };
    selected.iter().map(shader).collect()
}

/// Whether a program may fill holes in a shader file. If the text is evidently complete, only holes
/// that are not valid GLSL and have both delimiters count.
fn may_be_template(text: &str, guessed: &Guess, options: &Options) -> bool {
    let is_complete = guessed.kind.is_some_and(GuessedKind::is_complete);
    let has_ends = ["${", "{{", "<%", "{%", "%%", "##", "$(", "#{"]
        .iter()
        .any(|s| text.contains(s));
    options.dialect == DialectChoice::Auto && (has_ends || !is_complete)
}
