//! Shaders and exports as projects.

use serde::Deserialize;
use shaderlint_commands::run::Loaded;
use shaderlint_detect::kind::{Claim, FileKind, decide};
use shaderlint_project::{ChannelOrder, Composed, PassFile, PassRole, Project, add_stand_ins};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

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
    /// The inputs of channels, as after `--channel`: `buffer_a.0=keyboard`.
    #[serde(default)]
    pub channels: Vec<String>,
}

/// The passes of a shader, with stand-ins for media that only ShaderToy has.
pub fn load(shader: &ShaderText) -> Result<(Project, Composed), String> {
    let name = &shader.name;
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let mut project = draft(shader)?;
    let composed = project.resolve(name).map_err(|e| wrong(&e))?;
    for text in &shader.channels {
        let order = ChannelOrder::read(text).map_err(|e| format!("{text}: {e}"))?;
        let put = project.put(&order, None);
        put.map_err(|e| format!("{text}: {e}"))?;
    }
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

/// The project of a shader, an export or a folder of passes, as the command line reads them.
fn draft(shader: &ShaderText) -> Result<Project, String> {
    let ShaderText { name, text, .. } = shader;
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let title = Path::new(name).file_stem().unwrap_or_default();
    let title = title.to_string_lossy();
    if !shader.passes.is_empty() {
        let files = shader.passes.iter().map(pass_file);
        let files = files.collect::<Result<Vec<_>, _>>()?;
        return Project::from_parts(&title, files).map_err(|e| e.to_string());
    }
    let is_export = decide(name, text, Claim::None).kind == FileKind::Export;
    match is_export {
        true => Project::from_json(text).map_err(|e| wrong(&e)),
        false => Project::from_shader(&title, text).map_err(|e| wrong(&e)),
    }
}

/// A file whose name says which pass it is.
fn pass_file((path, code): (&PathBuf, &String)) -> Result<PassFile, String> {
    let stem = path.file_stem().unwrap_or_default();
    let role = PassRole::of_name(&stem.to_string_lossy());
    let file = path.to_string_lossy().into_owned();
    Ok(PassFile {
        role: role.ok_or_else(|| format!("{file}: the file name does not match a pass"))?,
        file,
        code: code.as_str().into(),
    })
}
