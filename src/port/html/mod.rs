//! A single HTML page that plays a project, without external resources; pages for frames of other
//! pages, and pages that list many.
//!
//! Untrusted data is embedded as JSON in an element that is not executed, with every character
//! escaped that could end the element. The content security policy allows only the page's own
//! script and style.

pub(super) mod embed;
pub(super) mod gallery;

use super::payload::payload;
use super::payload::pieces::PlayerParts;
use super::script::MOUNT;
use super::{Composed, Project, Wrapper, credits};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};
use shaderlint_semantic::Stage;
use shaderlint_text::Role;
use shaderlint_text::markup::{escape, escape_json, in_address};

const PAGE: &str = include_str!("../player/page/page.html");
/// The colours of all pages.
pub(super) const COLORS: &str = include_str!("../player/min/page/colors.css");
const STYLE: &str = include_str!("../player/min/page/page.css");
const PANEL_STYLE: &str = include_str!("../player/min/page/panel/panel.css");
const EXTRAS: &str = include_str!("../player/page/extras.html");
const DEBUG: &str = include_str!("../player/page/debug.html");
const MORE: &str = include_str!("../player/page/panel/more.html");
const PANEL: &str = include_str!("../player/page/panel/panel.html");

/// Separates the player from the page's own code in the script: a module exported by the page ends
/// here.
const BORDER: &str = "// The page begins here.\n";

/// Script of a served page, which reads what the page keeps during a reload.
const LIVE: [&str; 2] = [
    include_str!("../player/min/page/state.js"),
    include_str!("../player/min/live.js"),
];

/// Script of a page that offers the debugger of a playground.
const DEBUGGER: &str = include_str!("../player/min/page/debug.js");

/// Script of a page inside another one, which sends the project.
const RECEIVE: [&str; 2] = [
    include_str!("../player/min/page/state.js"),
    include_str!("../player/min/page/receive.js"),
];

/// The page. A served page has a version and reloads itself when there is a newer one. With the address
/// of a playground the page opens its debugger.
pub fn html(
    project: &Project,
    composed: &Composed,
    version: Option<&str>,
    playground: Option<&str>,
) -> PlayerPage {
    let playground = playground.filter(|_| is_debugged(project, composed));
    let mut start = match version {
        Some(version) => format!(
            "{}const player = openPage();\nfollowChanges('{version}', player);\n",
            LIVE.concat()
        ),
        None => "openPage();\n".to_string(),
    };
    if playground.is_some() {
        start.insert_str(0, DEBUGGER);
    }
    let title = match project.info.name.as_str() {
        "" => "shader",
        name => name,
    };
    let credits = credits::lines(project).join("\n");
    PlayerPage::new(&PageParts {
        title,
        description: &credits,
        project: &escape_json(&payload(project, composed)),
        needs: PlayerParts::of(project, composed, true),
        start: &start,
        version,
        playground,
        ..PageParts::default()
    })
}

/// Whether the playground can open the project: the passes of a ShaderToy project, or a text that is
/// complete. It does not debug vertex shaders.
fn is_debugged(project: &Project, composed: &Composed) -> bool {
    let files = composed.sources.files().iter();
    let own = files.filter(|file| file.role != Role::Prelude).count();
    let mut passes = project.passes.iter();
    passes
        .all(|pass| pass.stage == Stage::Fragment && (pass.wrapper == Wrapper::Player || own == 1))
}

/// A page without a shader: the page around it sends [`player_data`] in a message.
pub fn receiving_page() -> String {
    let start = format!("{}receiveProject();\n", RECEIVE.concat());
    let page = PlayerPage::new(&PageParts {
        title: "Shader",
        project: "null",
        needs: PlayerParts::all(),
        start: &start,
        ..PageParts::default()
    });
    page.whole()
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
    /// For pages in frames: what is over the image. Other pages have a panel.
    pub(super) poster: Option<&'a str>,
    /// The project as JSON in an element.
    pub(super) project: &'a str,
    /// What the project needs of the player.
    pub(super) needs: PlayerParts,
    /// The end of the script.
    pub(super) start: &'a str,
    /// The version of a served page.
    pub(super) version: Option<&'a str>,
    /// The address of the playground whose debugger the page offers.
    pub(super) playground: Option<&'a str>,
}

/// A page with the player, in its parts.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PlayerPage {
    before_style: String,
    style: String,
    before_script: String,
    /// The end of a module that the page exports.
    mount: Option<&'static str>,
    script: String,
    is_served: bool,
}

/// The place of the policy in the first part.
const POLICY: &str = "{{policy}}";

impl PlayerPage {
    pub(super) fn new(parts: &PageParts<'_>) -> PlayerPage {
        let has_panel = parts.poster.is_none();
        let own = match has_panel {
            true => parts.needs.panel(),
            false => parts.needs.frame(),
        };
        let script = format!(
            "(() => {{\n'use strict';\n{}{BORDER}{own}{}}})();\n",
            parts.needs.player(),
            parts.start
        );
        let of_panel = |text| if has_panel { text } else { "" };
        let debug = parts.playground.map_or(String::new(), |address| {
            fill(DEBUG, &[("playground", &escape(address))])
        });
        let extras = fill(EXTRAS, &[("debug", &debug)]);
        let body = fill(
            PAGE,
            &[
                ("title", &escape(parts.title)),
                ("credits", &escape(parts.description)),
                ("policy", POLICY),
                ("meta", parts.meta),
                ("style", MARK),
                ("classes", if has_panel { "" } else { " class=\"framed\"" }),
                ("poster", parts.poster.unwrap_or("")),
                ("extras", of_panel(&extras)),
                ("more", of_panel(MORE)),
                ("panel", of_panel(PANEL)),
                ("project", parts.project),
            ],
        );
        // The project is text of a user and follows the style, so that the first mark is the right one.
        let (before_style, before_script) = body.split_once(MARK).unwrap_or((&body, ""));
        PlayerPage {
            before_style: before_style.to_string(),
            style: [COLORS, STYLE, of_panel(PANEL_STYLE)].concat(),
            before_script: before_script.to_string(),
            mount: has_panel.then_some(MOUNT),
            script,
            is_served: parts.version.is_some(),
        }
    }

    /// The page as one file.
    pub fn whole(&self) -> String {
        let mount = self.mount.map_or(String::new(), |mount| {
            format!("<script type=\"text/plain\" id=\"mount\">{mount}</script>\n")
        });
        self.text(
            &policy(&self.script, &self.style, self.is_served),
            &format!("<style>{}</style>\n", self.style),
            &format!("{mount}<script>{}</script>\n", self.script),
        )
    }

    /// The page, and its script and style as files with these names beside it, for sites whose
    /// policy allows only files.
    pub fn split(&self, script: &str, style: &str) -> [String; 3] {
        let page = self.text(
            "default-src 'none'; script-src 'self' file:; style-src 'self' file:; img-src data: blob:; \
             media-src data: blob:; base-uri 'none'; form-action 'none'",
            &format!("<link rel=\"stylesheet\" href=\"{}\">\n", in_address(style)),
            &format!("<script src=\"{}\"></script>\n", in_address(script)),
        );
        [page, self.script.clone(), self.style.clone()]
    }

    fn text(&self, policy: &str, style: &str, script: &str) -> String {
        let head = self.before_style.replacen(POLICY, policy, 1);
        let end = "</body>\n</html>\n";
        [&head, style, &self.before_script, script, end].concat()
    }
}

/// Marks the place of the style. Attributes of the head cannot contain it, because `<` is escaped.
const MARK: &str = "<style>\n";

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
    let [_, live] = LIVE;
    let script = format!("{live}followChanges('{version}', null);\n");
    let style =
        "body { font: 16px/1.5 system-ui, sans-serif; margin: 2em; color-scheme: light dark; }";
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
         <title>No page yet</title>\n<style>{style}</style>\n<p>{}</p>\n\
         <p>This page reloads when you save the file.</p>\n<script>{script}</script>\n",
        policy(&script, style, true),
        escape(message)
    )
}

/// The content security policy: only this script and this style, and no requests to any host. A
/// served page may connect to its server.
fn policy(script: &str, style: &str, is_served: bool) -> String {
    let connect = if is_served { "'self'" } else { "'none'" };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scripts_cannot_end_their_elements() {
        let texts = LIVE.iter().chain(&RECEIVE);
        for text in texts.chain(&[COLORS, STYLE, PANEL_STYLE, MOUNT, DEBUGGER]) {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn substituted_values_are_not_expanded_again() {
        let page = fill("a{{x}}b{{y}}c", &[("x", "{{y}}"), ("y", "1")]);
        assert_eq!(page, "a{{y}}b1c");
    }
}
