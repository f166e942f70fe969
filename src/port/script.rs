//! The player's code, and modules made of it.

use super::payload::payload;
use super::{Composed, Project, credits};

/// The player, in the order in which its files use each other.
pub(super) const PLAYER: [&str; 16] = [
    include_str!("player/types.js"),
    include_str!("player/gl.js"),
    include_str!("player/log.js"),
    include_str!("player/tunable.js"),
    include_str!("player/mouse.js"),
    include_str!("player/keyboard.js"),
    include_str!("player/targets.js"),
    include_str!("player/devices.js"),
    include_str!("player/media.js"),
    include_str!("player/inputs.js"),
    include_str!("player/program.js"),
    include_str!("player/programs.js"),
    include_str!("player/sound.js"),
    include_str!("player/clock.js"),
    include_str!("player/player.js"),
    include_str!("player/listen.js"),
];

/// The end of a module, which puts the player on a canvas.
pub(super) const MOUNT: &str = include_str!("player/mount.js");
const THREE: &str = include_str!("player/three.js");
const REACT: &str = include_str!("player/react.js");
const MOUNT_TYPES: &str = include_str!("player/mount.d.ts");
const THREE_TYPES: &str = include_str!("player/three.d.ts");
const REACT_TYPES: &str = include_str!("player/react.d.ts");

/// A JavaScript module and its TypeScript types.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScriptModule {
    /// The code.
    pub code: String,
    /// The types, as a `.d.ts` file.
    pub types: String,
}

/// An ES module without dependencies, which exports `mount(canvas, options)`.
pub fn module(project: &Project, composed: &Composed) -> ScriptModule {
    let code = format!(
        "{}{}{}{}",
        comment(project),
        project_constant(project, composed),
        PLAYER.concat(),
        MOUNT
    );
    ScriptModule {
        code,
        types: MOUNT_TYPES.to_string(),
    }
}

/// A module for three.js, which exports a `RawShaderMaterial` and its update function.
pub fn three(project: &Project, composed: &Composed) -> ScriptModule {
    let code = format!(
        "{}{}{}",
        comment(project),
        project_constant(project, composed),
        THREE
    );
    ScriptModule {
        code,
        types: THREE_TYPES.to_string(),
    }
}

/// A React component over [`module`], which it imports under this name.
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

fn project_constant(project: &Project, composed: &Composed) -> String {
    let data = escape(&payload(project, composed));
    format!("/** @type {{ProjectData}} */\nconst PROJECT = {data};\n\n")
}

/// Who made the shader, as a comment that its words cannot end.
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

/// Escapes JSON so that it can stand in an HTML element and in JavaScript.
pub(super) fn escape(json: &str) -> String {
    let mut out = String::with_capacity(json.len() + json.len() / 16);
    let mut from = 0;
    for (i, c) in json.char_indices() {
        if matches!(c, '<' | '>' | '&' | '\u{2028}' | '\u{2029}') {
            out.push_str(json.get(from..i).unwrap_or(""));
            out.push_str(&format!("\\u{:04x}", c as u32));
            from = i + c.len_utf8();
        }
    }
    out.push_str(json.get(from..).unwrap_or(""));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_stays_inside_its_element() {
        let escaped = escape("\"</script><!--&\u{2028}é\"");
        assert_eq!(
            escaped,
            "\"\\u003c/script\\u003e\\u003c!--\\u0026\\u2028é\""
        );
    }

    #[test]
    fn the_player_cannot_end_its_element() {
        for text in PLAYER {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn credits_stay_in_their_comment() {
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
