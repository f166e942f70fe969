//! One page that plays a project, with everything in it and nothing fetched.
//!
//! What comes from outside travels as JSON in an element that no browser runs, with every character
//! escaped that could end the element; the policy lets only the page's own script and style in.

use super::payload::payload;
use super::{Composed, Project};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};

const PAGE: &str = include_str!("player/page.html");
const STYLE: &str = include_str!("player/page.css");

/// The player, in the order in which its files use each other.
const PLAYER: [&str; 11] = [
    include_str!("player/types.js"),
    include_str!("player/gl.js"),
    include_str!("player/mouse.js"),
    include_str!("player/keyboard.js"),
    include_str!("player/targets.js"),
    include_str!("player/devices.js"),
    include_str!("player/inputs.js"),
    include_str!("player/program.js"),
    include_str!("player/sound.js"),
    include_str!("player/clock.js"),
    include_str!("player/player.js"),
];
const PAGE_SCRIPT: &str = include_str!("player/page.js");

/// The page.
pub fn html(project: &Project, composed: &Composed) -> String {
    let script = format!(
        "(() => {{\n'use strict';\n{}{PAGE_SCRIPT}openPage();\n}})();\n",
        PLAYER.concat()
    );
    let project = escape(&payload(project, composed));
    fill(
        PAGE,
        &[
            ("policy", &policy(&script, STYLE)),
            ("style", STYLE),
            ("project", &project),
            ("script", &script),
        ],
    )
}

/// Puts values into the places `{{name}}` of a template; what a value holds is never looked at.
fn fill(template: &str, values: &[(&str, &str)]) -> String {
    let room: usize = values.iter().map(|(_, v)| v.len()).sum();
    let mut out = String::with_capacity(template.len() + room);
    let mut rest = template;
    while let Some((before, behind)) = rest.split_once("{{") {
        out.push_str(before);
        let (name, behind) = behind.split_once("}}").unwrap_or((behind, ""));
        let value = values.iter().find(|(n, _)| *n == name);
        out.push_str(value.map_or("", |(_, v)| v));
        rest = behind;
    }
    out.push_str(rest);
    out
}

/// The content security policy: nothing but this script and this style, no request to any host.
fn policy(script: &str, style: &str) -> String {
    let hash = |text: &str| BASE64_STANDARD.encode(Sha256::digest(text));
    format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; img-src data: blob:; \
         media-src data: blob:; connect-src 'none'; base-uri 'none'; form-action 'none'",
        hash(script),
        hash(style)
    )
}

/// Escapes JSON so that it can stand in an HTML element and in JavaScript.
fn escape(json: &str) -> String {
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
        for text in PLAYER.iter().chain([&PAGE_SCRIPT, &STYLE]) {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn values_are_not_looked_at() {
        let page = fill("a{{x}}b{{y}}c", &[("x", "{{y}}"), ("y", "1")]);
        assert_eq!(page, "a{{y}}b1c");
    }
}
