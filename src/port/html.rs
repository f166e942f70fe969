//! A single HTML page that plays a project, without external resources.
//!
//! Untrusted data is embedded as JSON in an element that is not executed, with every character
//! escaped that could end the element. The content security policy allows only the page's own
//! script and style.

use super::payload::payload;
use super::script::{MOUNT, PLAYER, escape};
use super::{Composed, Project, credits};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};

const PAGE: &str = include_str!("player/page/page.html");
/// The colours of all pages.
pub(super) const COLORS: &str = include_str!("player/page/colors.css");
const STYLE: &str = include_str!("player/page/page.css");
const PAGE_SCRIPTS: [&str; 19] = [
    include_str!("player/page/dom.js"),
    include_str!("player/page/address.js"),
    include_str!("player/page/prose.js"),
    include_str!("player/page/notices.js"),
    include_str!("player/page/excerpt.js"),
    include_str!("player/page/errors.js"),
    include_str!("player/page/highlight.js"),
    include_str!("player/page/editor.js"),
    include_str!("player/page/code.js"),
    include_str!("player/page/controls.js"),
    include_str!("player/page/channels.js"),
    include_str!("player/page/webm.js"),
    include_str!("player/page/film.js"),
    include_str!("player/page/export.js"),
    include_str!("player/page/panel.js"),
    include_str!("player/page/bar.js"),
    include_str!("player/page/keys.js"),
    include_str!("player/page/state.js"),
    include_str!("player/page/page.js"),
];

/// Separates the player from the page's own code in the script: a module exported by the page ends
/// here.
const BORDER: &str = "// The page begins here.\n";

/// Script of a served page.
const LIVE: &str = include_str!("player/live.js");

/// Script of a page inside another one, which sends the project.
const RECEIVE: &str = include_str!("player/page/receive.js");

/// The page. A served page has a version and reloads itself when there is a newer one.
pub fn html(project: &Project, composed: &Composed, version: Option<&str>) -> String {
    let start = match version {
        Some(version) => {
            format!("{LIVE}const player = openPage();\nfollowChanges('{version}', player);\n")
        }
        None => "const player = openPage();\n".to_string(),
    };
    let title = match project.info.name.as_str() {
        "" => "shader",
        name => name,
    };
    let credits = credits::lines(project).join("\n");
    page(&PageParts {
        title,
        description: &credits,
        project: &escape(&payload(project, composed)),
        start: &start,
        version,
        ..PageParts::default()
    })
}

/// A page without a shader: the page around it sends [`player_data`] in a message.
pub fn receiving_page() -> String {
    let start = format!("{}receiveProject();\n", without_comments(RECEIVE));
    page(&PageParts {
        title: "Shader",
        project: "null",
        start: &start,
        ..PageParts::default()
    })
}

/// The project as JSON for [`receiving_page`].
pub fn player_data(project: &Project, composed: &Composed) -> String {
    payload(project, composed)
}

/// What distinguishes the pages that play shaders.
#[derive(Default)]
pub(super) struct PageParts<'a> {
    pub(super) title: &'a str,
    pub(super) description: &'a str,
    /// Further elements of the head.
    pub(super) meta: &'a str,
    /// Attributes of the body.
    pub(super) classes: &'a str,
    /// Elements over the image.
    pub(super) poster: &'a str,
    /// The project as JSON in an element.
    pub(super) project: &'a str,
    /// The end of the script.
    pub(super) start: &'a str,
    /// The version of a served page.
    pub(super) version: Option<&'a str>,
}

/// A page with the player.
pub(super) fn page(parts: &PageParts<'_>) -> String {
    let script = format!(
        "(() => {{\n'use strict';\n{}{BORDER}{}{}}})();\n",
        without_comments(&PLAYER.concat()),
        without_indentation(&without_comments(&PAGE_SCRIPTS.concat())),
        parts.start
    );
    let style = [COLORS, STYLE].concat();
    fill(
        PAGE,
        &[
            ("title", &attribute(parts.title)),
            ("credits", &attribute(parts.description)),
            ("policy", &policy(&script, &style, parts.version)),
            ("meta", parts.meta),
            ("style", &style),
            ("classes", parts.classes),
            ("poster", parts.poster),
            ("project", parts.project),
            ("mount", &without_comments(MOUNT)),
            ("script", &script),
        ],
    )
}

/// Removes comment lines, which are a quarter of the script, and half of the indentation.
/// Comment-like lines inside template literals would be removed too, but there are none.
pub(super) fn without_comments(script: &str) -> String {
    let mut out = String::with_capacity(script.len());
    let mut in_block = false;
    for line in script.split_inclusive('\n') {
        let text = line.trim();
        in_block |= text.starts_with("/**");
        if !in_block && !text.starts_with("//") {
            let indent = line.len() - line.trim_start_matches(' ').len();
            out.push_str(line.get(indent / 2..).unwrap_or(""));
        }
        in_block &= !text.ends_with("*/");
    }
    out
}

/// Removes the indentation of a script that users do not read.
fn without_indentation(script: &str) -> String {
    let lines = script
        .split_inclusive('\n')
        .map(|l| l.trim_start_matches(' '));
    lines.collect()
}

/// Replaces the placeholders `{{name}}` of a template. Placeholders in the values are not replaced.
pub(super) fn fill(template: &str, values: &[(&str, &str)]) -> String {
    let room: usize = values.iter().map(|(_, v)| v.len()).sum();
    let mut out = String::with_capacity(template.len() + room);
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        out.push_str(before);
        let (name, after) = after.split_once("}}").unwrap_or((after, ""));
        let value = values.iter().find(|(n, _)| *n == name);
        out.push_str(value.map_or("", |(_, v)| v));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// The page that a server shows until the first build succeeds, with the error.
pub fn waiting_page(message: &str, version: &str) -> String {
    let script = format!("{LIVE}followChanges('{version}', null);\n");
    let style =
        "body { font: 16px/1.5 system-ui, sans-serif; margin: 2em; color-scheme: light dark; }";
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
         <title>No page yet</title>\n<style>{style}</style>\n<p>{}</p>\n\
         <p>This page reloads when you save the file.</p>\n<script>{script}</script>\n",
        policy(&script, style, Some(version)),
        attribute(message)
    )
}

/// The content security policy: only this script and this style, and no requests to any host. A
/// served page may connect to its server.
fn policy(script: &str, style: &str, version: Option<&str>) -> String {
    let connect = version.map_or("'none'", |_| "'self'");
    format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; img-src data: blob:; \
         media-src data: blob:; connect-src {connect}; base-uri 'none'; form-action 'none'",
        hash(script),
        hash(style)
    )
}

/// The hash of a script or a style.
pub(super) fn hash(text: &str) -> String {
    BASE64_STANDARD.encode(Sha256::digest(text))
}

/// Escapes text for use in an element or a quoted attribute.
pub(super) fn attribute(text: &str) -> String {
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
        for text in PAGE_SCRIPTS.iter().chain([&COLORS, &STYLE, &LIVE, &MOUNT]) {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn comments_stay_out_of_the_page() {
        let script =
            "// a\n/** b */\nlet x = 1; // c\n  /**\n   * d\n   */\n  x /* e */ = '/** f */';\n";
        let left = "let x = 1; // c\n x /* e */ = '/** f */';\n";
        assert_eq!(without_comments(script), left);
    }

    #[test]
    fn a_line_keeps_what_is_inside_it() {
        assert_eq!(
            without_indentation("a {\n  b('  c');\n}\n"),
            "a {\nb('  c');\n}\n"
        );
    }

    /// A line inside a literal could start like a comment.
    #[test]
    fn no_literal_of_the_page_goes_on_in_the_next_line() {
        for script in PLAYER.iter().chain(&PAGE_SCRIPTS) {
            for line in without_comments(script).lines() {
                let ticks = line.matches('`').count() - line.matches("\\`").count();
                assert!(ticks.is_multiple_of(2), "{line}");
            }
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
