//! Plain shaders as text.

use super::{Composed, Project, Wrapper, credits};
use shaderlint_semantic::Stage;
use shaderlint_text::{FileId, Role};

/// The vertex shader of every pass: one triangle that covers the image.
pub const VERTEX: &str = include_str!("triangle.vert");

/// A pass as the two shaders of a WebGL2 program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct GlslPass {
    /// The name shown to the user.
    pub name: String,
    /// The file name without extension.
    pub slug: &'static str,
    /// The stage of the pass's own code; vertex if it draws vertices itself.
    pub stage: Stage,
    /// The shader of that stage.
    pub text: String,
    /// The shader of the other stage.
    pub partner: String,
}

/// The shaders of each pass, in project order.
pub fn glsl(project: &Project, composed: &Composed) -> Vec<GlslPass> {
    let pass = |unit: &super::PassUnit| {
        let pass = project.passes.get(unit.pass)?;
        let text = joined(composed, &unit.files);
        let bound = Some(pass.bound.vertex.as_str()).filter(|v| !v.is_empty());
        let partner = pass.draw.partner.as_deref().or(bound);
        Some(GlslPass {
            name: pass.title(unit.pass),
            slug: pass.slug(),
            stage: unit.stage,
            text: match unit.wrapper {
                Wrapper::Player => signed(project, text),
                Wrapper::Own => headed(project, text),
            },
            partner: partner.unwrap_or(VERTEX).to_string(),
        })
    };
    composed.units.iter().filter_map(pass).collect()
}

/// Puts the credits before a complete shader, but after a `#version`, which must come first.
fn headed(project: &Project, shader: String) -> String {
    let lines = credits::lines(project);
    let credits: String = lines.iter().map(|line| format!("// {line}\n")).collect();
    match shader.split_once('\n') {
        Some((version, rest)) if version.starts_with("#version") => {
            format!("{version}\n{credits}{rest}")
        }
        _ => credits + &shader,
    }
}

/// Puts the credits after the `#version`, which must come first. To keep the line numbers of the
/// user's code, and so the value of `__LINE__`, as many lines of uniforms are joined.
pub(super) fn signed(project: &Project, shader: String) -> String {
    let credits = credits::lines(project);
    let Some((version, mut rest)) = shader.split_once('\n') else {
        return shader;
    };
    let mut text = format!("{version}\n");
    for line in &credits {
        text.push_str(&format!("// {line}\n"));
    }
    let mut surplus = credits.len();
    while surplus > 0
        && let Some((line, after)) = rest.split_once('\n')
    {
        let is_joined = line.starts_with("uniform ") && after.starts_with("uniform ");
        surplus -= usize::from(is_joined);
        text.push_str(line);
        text.push(if is_joined { ' ' } else { '\n' });
        rest = after;
    }
    text + rest
}

/// Concatenates the texts as the player does: with a line break after every text of the user except
/// the last.
fn joined(composed: &Composed, files: &[FileId]) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn credits_do_not_move_lines_of_the_shader() {
        let json = r#"{"info":{"id":"abcdef","name":"n","username":"u"},"renderpass":[
            {"type":"image","code":"int image;"},{"type":"buffer","code":"int buffer;"},
            {"type":"cubemap","code":"int cubemap;"},{"type":"sound","code":"int sound;"},
            {"type":"common","code":"int a;\nint b;"}]}"#;
        let mut project = Project::from_json(json).unwrap();
        let composed = project.resolve("").unwrap();
        let lines = glsl(&project, &composed).into_iter().map(|pass| {
            let at = |text: &str| pass.text.lines().position(|l| l == text).unwrap() + 1;
            assert!(pass.text.contains("\n// by u\n"));
            (
                at("int a;"),
                at(&format!("int {};", pass.slug.trim_end_matches("_a"))),
            )
        });
        let lines: Vec<_> = lines.collect();
        assert_eq!(lines, [(54, 56), (28, 30), (31, 33), (21, 23)]);
    }
}
