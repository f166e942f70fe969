//! The shaders alone, as text.

use super::{Composed, Project, credits};
use crate::text::{FileId, Role};

/// The vertex shader of every pass: one triangle that covers the picture.
pub const VERTEX: &str = "#version 300 es\n\
#ifdef GL_ES\n\
precision highp float;\n\
precision highp int;\n\
precision mediump sampler3D;\n\
#endif\n\
layout(location = 0) in vec2 pos;\n\
void main() {\n    gl_Position = vec4(pos, 0.0, 1.0);\n}\n";

/// A pass as a WebGL2 fragment shader.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct GlslPass {
    /// What the user calls it.
    pub name: String,
    /// What its file is called, without ending.
    pub slug: &'static str,
    /// The fragment shader.
    pub fragment: String,
}

/// The fragment shader of each pass, in the order of the project.
pub fn glsl(project: &Project, composed: &Composed) -> Vec<GlslPass> {
    let pass = |unit: &super::PassUnit| {
        let pass = project.passes.get(unit.pass)?;
        Some(GlslPass {
            name: pass.title(unit.pass),
            slug: pass.slug(),
            fragment: signed(project, fragment(composed, &unit.files)),
        })
    };
    composed.units.iter().filter_map(pass).collect()
}

/// Puts who made it behind the `#version`, which must come first.
pub(super) fn signed(project: &Project, fragment: String) -> String {
    let lines = credits::lines(project);
    let credits: String = lines.iter().map(|line| format!("// {line}\n")).collect();
    match fragment.split_once('\n') {
        Some((version, rest)) if !credits.is_empty() => format!("{version}\n{credits}{rest}"),
        _ => fragment,
    }
}

/// The texts as the player joins them: behind every text of the user but the last comes a line
/// break.
fn fragment(composed: &Composed, files: &[FileId]) -> String {
    let mut text = String::new();
    for (i, file) in files.iter().enumerate() {
        let Some(file) = composed.sources.file(*file) else {
            continue;
        };
        text.push_str(&file.text);
        if file.role == Role::User && i + 1 < files.len() {
            text.push('\n');
        }
    }
    text
}
