//! One page that plays a project, with everything in it and nothing fetched.
//!
//! What comes from outside travels as JSON in an element that no browser runs, with every character
//! escaped that could end the element; the policy lets only the page's own script and style in.

use super::payload::payload;
use super::script::{PLAYER, escape};
use super::{Composed, Project, credits};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};

const PAGE: &str = include_str!("player/page/page.html");
const STYLE: &str = include_str!("player/page/page.css");
const PAGE_SCRIPTS: [&str; 4] = [
    include_str!("player/page/capture.js"),
    include_str!("player/page/channels.js"),
    include_str!("player/page/panel.js"),
    include_str!("player/page/page.js"),
];

/// The page.
pub fn html(project: &Project, composed: &Composed) -> String {
    let script = format!(
        "(() => {{\n'use strict';\n{}{}openPage();\n}})();\n",
        PLAYER.concat(),
        PAGE_SCRIPTS.concat()
    );
    let title = match project.info.name.as_str() {
        "" => "shader",
        name => name,
    };
    let credits = credits::lines(project).join("\n");
    let project = escape(&payload(project, composed));
    fill(
        PAGE,
        &[
            ("title", &attribute(title)),
            ("credits", &attribute(&credits)),
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

/// Escapes text so that it can stand in an element or in a quoted attribute.
fn attribute(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\0' | '\u{2028}' | '\u{2029}' => {}
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_cannot_end_its_elements() {
        for text in PAGE_SCRIPTS.iter().chain([&STYLE]) {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn text_stays_inside_its_attribute() {
        assert_eq!(attribute("\"><b&"), "&quot;&gt;&lt;b&amp;");
    }

    #[test]
    fn values_are_not_looked_at() {
        let page = fill("a{{x}}b{{y}}c", &[("x", "{{y}}"), ("y", "1")]);
        assert_eq!(page, "a{{y}}b1c");
    }
}
