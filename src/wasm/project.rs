//! Shaders and exports as projects.

use serde::Deserialize;
use shaderlint_port::{Composed, Project, add_stand_ins};
use shaderlint_text::kind::{Claim, FileKind, decide};
use std::path::Path;

/// A shader or export.
#[derive(Deserialize)]
pub struct ShaderText {
    /// Name of the file.
    pub name: String,
    /// Contents of the file.
    pub text: String,
}

/// The passes of a shader, with stand-ins for media that only ShaderToy has.
pub fn load(ShaderText { name, text }: &ShaderText) -> Result<(Project, Composed), String> {
    let wrong = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let title = Path::new(name).file_stem().unwrap_or_default();
    let is_export = decide(name, text, Claim::None).kind == FileKind::Export;
    let mut project = match is_export {
        true => Project::from_json(text).map_err(|e| wrong(&e))?,
        false => Project::from_shader(&title.to_string_lossy(), text).map_err(|e| wrong(&e))?,
    };
    let composed = project.resolve(name).map_err(|e| wrong(&e))?;
    add_stand_ins(&mut project);
    let composed = project.renew(composed, name).map_err(|e| wrong(&e))?;
    Ok((project, composed))
}
