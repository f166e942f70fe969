//! The player's code, and the modules made from it.

use super::payload::payload;
use super::payload::pieces::PlayerParts;
#[cfg(feature = "naga")]
use super::webgpu::WebGpuPass;
use super::{Composed, ControlKind, Project, UniformControl, credits};
use shaderlint_text::markup::escape_json;

/// What the module for three.js shares with the player: values of uniforms, sizes and sound.
const SHARED: [&str; 4] = [
    include_str!("player/draw/frame.js"),
    include_str!("player/draw/sources.js"),
    include_str!("player/draw/sizes.js"),
    include_str!("player/channels/spectrum.js"),
];

/// The end of a module, which exports `mount`.
pub(super) const MOUNT: &str = include_str!("player/min/modules/mount.js");
const MATERIALS: &str = include_str!("player/modules/materials.js");
const THREE: &str = include_str!("player/modules/three.js");
#[cfg(feature = "naga")]
const WEBGPU: &str = include_str!("player/modules/webgpu.js");
/// What both modules for three.js do in a frame.
const FRAMES: &str = include_str!("player/modules/frames.js");
const REACT: &str = include_str!("player/modules/react.js");
const MOUNT_TYPES: &str = include_str!("player/modules/mount.d.ts");
const THREE_TYPES: &str = include_str!("player/modules/three.d.ts");
const REACT_TYPES: &str = include_str!("player/modules/react.d.ts");

/// A JavaScript module and its TypeScript types.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScriptModule {
    /// The content of the `.js` file.
    pub code: String,
    /// The content of the `.d.ts` file.
    pub types: String,
}

/// An ES module without dependencies, which exports `mount(canvas, options)`.
pub fn module(project: &Project, composed: &Composed) -> ScriptModule {
    let code = format!(
        "{}{}{}{}",
        comment(project),
        project_constant(project, composed),
        PlayerParts::of(project, composed, false).player(),
        MOUNT
    );
    ScriptModule {
        code,
        types: with_uniforms(MOUNT_TYPES, project, number_type),
    }
}

/// A module for three.js, which exports a `RawShaderMaterial` and its update function.
pub fn three(project: &Project, composed: &Composed) -> ScriptModule {
    let code = format!(
        "{}{}{}{FRAMES}{MATERIALS}{THREE}",
        comment(project),
        project_constant(project, composed),
        SHARED.concat(),
    );
    ScriptModule {
        code,
        types: with_uniforms(THREE_TYPES, project, three_type),
    }
}

/// A module for three.js' WebGPURenderer, which exports a `MeshBasicNodeMaterial` and its update
/// function.
#[cfg(feature = "naga")]
pub(super) fn three_webgpu(project: &Project, passes: &[WebGpuPass]) -> ScriptModule {
    // Serialisation fails only for maps with keys that are not strings, and for failing writers.
    let data = escape_json(&serde_json::to_string(passes).unwrap_or_default());
    let controls = escape_json(&serde_json::to_string(&project.controls).unwrap_or_default());
    let code = format!(
        "{}const PASSES = {data};\n\nconst CONTROLS = {controls};\n\n{}{FRAMES}{WEBGPU}",
        comment(project),
        SHARED.concat(),
    );
    let types = THREE_TYPES
        .replace("WebGLRenderer", "WebGPURenderer")
        .replace("RawShaderMaterial", "MeshBasicNodeMaterial")
        .replace("IUniform, ", "")
        .replace("'three'", "'three/webgpu'");
    ScriptModule {
        code,
        types: with_uniforms(&types, project, webgpu_type),
    }
}

/// The TypeScript type of a uniform in a module for WebGPURenderer.
#[cfg(feature = "naga")]
fn webgpu_type(control: &UniformControl) -> String {
    let of_three = three_type(control);
    let inner = of_three
        .trim_start_matches("IUniform<")
        .trim_end_matches('>');
    // WGSL has no uniforms of type `bool`.
    format!("{{ value: {} }}", inner.replace("boolean", "number"))
}

/// A React component that imports [`module`] under this name.
pub fn react(project: &Project, module_name: &str) -> ScriptModule {
    let import = serde_json::to_string(&format!("./{module_name}")).unwrap_or_default();
    ScriptModule {
        code: format!(
            "{}import {{ mount }} from {import};\n\n{REACT}",
            comment(project)
        ),
        types: REACT_TYPES.replace("'./module.js'", &import),
    }
}

/// Declares the uniforms that the user sets, with documentation, in the type declarations.
fn with_uniforms(types: &str, project: &Project, type_of: fn(&UniformControl) -> String) -> String {
    let lines = project.controls.iter().map(|control| {
        let (about, ty) = (about(control), type_of(control));
        format!("\n  /** {about} */\n  {}: {ty};", control.name)
    });
    let lines: String = lines.collect();
    match lines.as_str() {
        "" => types.to_string(),
        lines => types.replacen(
            "interface Uniforms {}",
            &format!("interface Uniforms {{{lines}\n}}"),
            1,
        ),
    }
}

/// The documentation of a uniform, escaped for use in a comment.
fn about(control: &UniformControl) -> String {
    let numbers = |values: &[f64]| match values {
        [first, rest @ ..] if rest.iter().all(|v| v == first) => first.to_string(),
        _ => format!("{values:?}"),
    };
    let mut parts = Vec::new();
    if control.label != control.name {
        parts.push(control.label.clone());
    }
    if !control.choices.is_empty() {
        let choices = control.choices.iter();
        let choices = choices.map(|c| format!("{} is {}", c.value, c.label));
        parts.extend(choices);
    } else if !control.min.is_empty() && control.kind != ControlKind::Color {
        let (min, max) = (numbers(&control.min), numbers(&control.max));
        parts.push(format!("from {min} to {max}"));
    }
    parts.push(format!("default {}", numbers(&control.value)));
    let line = parts.join("; ").replace("*/", "* /");
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The TypeScript type of a uniform in a module without dependencies.
fn number_type(control: &UniformControl) -> String {
    match (control.kind, control.value.len()) {
        (ControlKind::Bool | ControlKind::Event, 1) => "boolean".to_string(),
        (_, 1) => "number".to_string(),
        (_, lanes) => format!("[{}]", vec!["number"; lanes].join(", ")),
    }
}

/// The TypeScript type of a uniform in a module for three.js.
fn three_type(control: &UniformControl) -> String {
    let inner = match (control.kind, control.value.len()) {
        (ControlKind::Bool, 1) => "boolean".to_string(),
        (_, 1) => "number".to_string(),
        (ControlKind::Color, 3) => "Color".to_string(),
        (_, lanes) => format!("Vector{lanes}"),
    };
    format!("IUniform<{inner}>")
}

fn project_constant(project: &Project, composed: &Composed) -> String {
    let data = escape_json(&payload(project, composed));
    format!("/** @type {{ProjectData}} */\nconst PROJECT = {data};\n\n")
}

/// The credits as a comment, escaped for use in scripts.
fn comment(project: &Project) -> String {
    let lines = credits::lines(project);
    let lines: String = lines
        .iter()
        .map(|line| {
            format!(
                "// {}\n",
                line.replace("</", "< /").replace("<!--", "< !--")
            )
        })
        .collect();
    if lines.is_empty() {
        lines
    } else {
        lines + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn user_uniforms_have_types_and_ranges() {
        let code = "precision highp float;\nuniform float gain; // (0.5~4.5)\nuniform bool on;\n\
            uniform vec3 tint;\nvoid main() { gl_FragColor = vec4(on ? tint * gain : tint, 1.0); }\n";
        let mut project = Project::from_shader("", code).unwrap();
        project.controls[0].label = "a */ b".to_string();
        let module = with_uniforms(MOUNT_TYPES, &project, number_type);
        let requested = "export interface Uniforms {\n  /** a * / b; from 0.5 to 4.5; default 2.5 */\n  \
            gain: number;\n  /** default 0 */\n  on: boolean;\n  \
            /** default [0.95, 0.55, 0.2] */\n  tint: [number, number, number];\n}\n";
        assert!(module.contains(requested), "{module}");
        let three = with_uniforms(THREE_TYPES, &project, three_type);
        assert!(three.contains("  tint: IUniform<Color>;\n"), "{three}");
        let plain = Project::from_shader("", "void mainImage(out vec4 o, vec2 u) {}").unwrap();
        assert_eq!(with_uniforms(MOUNT_TYPES, &plain, number_type), MOUNT_TYPES);
    }

    #[test]
    fn credits_cannot_end_their_comment() {
        let json = r#"{"info":{"name":"a\n*/ alert(1) //\u2028x</script>","username":"b\\"},
            "renderpass":[{"type":"image","code":"void mainImage(out vec4 c, in vec2 f) {}"}]}"#;
        let project = Project::from_json(json).unwrap();
        let text = comment(&project);
        assert!(
            text.lines().all(|l| l.is_empty() || l.starts_with("// ")),
            "{text}"
        );
        assert!(
            !text.contains(['\u{2028}', '\\']) && !text.contains("</"),
            "{text}"
        );
    }
}
