//! Shaders and exports as projects.

use crate::files::{MemoryFiles, options_of};
use serde::Deserialize;
use shaderlint_commands::run::{InputRequest, Loaded};
use shaderlint_engine::config::Selection;
use shaderlint_host::host_named;
use shaderlint_project::{
    Composed, NoMedia, OpenedProject, Project, add_stand_ins, open_file, open_passes,
};
use shaderlint_text::path::slashed;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A shader or export, or the passes of a project.
#[derive(Clone, Deserialize)]
pub struct ShaderText {
    /// Name of the file, or of the project.
    pub name: String,
    /// Contents of the file.
    #[serde(default)]
    pub text: String,
    /// The passes of a project by file name, such as `buffer_a.glsl`, instead of a text.
    #[serde(default)]
    pub passes: BTreeMap<PathBuf, String>,
    /// Other files, by path, for includes.
    #[serde(default)]
    pub files: BTreeMap<PathBuf, String>,
    /// Who completes it, and the inputs of channels.
    #[serde(flatten)]
    pub input: InputRequest,
}

impl ShaderText {
    /// The passes, and the other files.
    pub fn all_files(&self) -> Arc<MemoryFiles> {
        Arc::new(MemoryFiles::new(self.passes.iter().chain(&self.files)))
    }
}

/// The passes of a shader, with stand-ins for media that only ShaderToy has.
pub fn load(shader: &ShaderText) -> Result<(Project, Composed), String> {
    let name = &shader.name;
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let mut draft = draft(shader)?;
    draft.order(&shader.input.channels)?;
    let mut project = draft.project;
    let composed = project.resolve(name).map_err(|e| wrong(&e))?;
    project.put_all(&draft.orders, &mut NoMedia)?;
    add_stand_ins(&mut project);
    let composed = project.renew(composed, name).map_err(|e| wrong(&e))?;
    Ok((project, composed))
}

/// A shader without errors, to run it.
pub fn valid(shader: &ShaderText) -> Result<Loaded, String> {
    let (project, composed) = load(shader)?;
    let name = shader.name.clone();
    match composed.has_errors() {
        true => Err(format!("{name}: the shader has errors")),
        false => Ok(Loaded {
            name,
            project,
            composed,
        }),
    }
}

/// Opens a shader, an export or passes, as the command line does.
fn draft(shader: &ShaderText) -> Result<OpenedProject, String> {
    let files = shader.all_files();
    let first = shader.passes.keys().next().map(slashed);
    let place = first.as_deref().unwrap_or(&shader.name);
    let options = options_of(&files, place, Selection::default())?;
    let access = options.file_access(&*files);
    if shader.passes.is_empty() {
        let host = shader.input.host.as_deref().map(host_named).transpose()?;
        return open_file(&shader.name, &shader.text, host, access);
    }
    let passes: Vec<PathBuf> = shader.passes.keys().cloned().collect();
    let mut draft = open_passes(&passes, &[], access)?;
    let title = Path::new(&shader.name).file_stem().unwrap_or_default();
    draft.project.info.name = title.to_string_lossy().into_owned();
    Ok(draft)
}
