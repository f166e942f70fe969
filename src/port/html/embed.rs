//! A page for frames of other pages: it shows a still image and plays after a click.

use super::{PageParts, PlayerPage};
use crate::credits;
use crate::payload::payload;
use crate::payload::pieces::PlayerParts;
use crate::{Composed, Project};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use shaderlint_text::markup::{decode, escape, escape_json, in_address};
use std::path::Path;

/// Starts the page.
pub(super) const START: &str = "startFrame();\n";

/// Maximum length of a description, in characters.
const MAX_DESCRIPTION: usize = 200;

/// A still image of a shader.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Still {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The PNG file.
    pub png: Vec<u8>,
}

/// What a page shows until its shader plays.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Poster {
    /// The still image; without one, the page shows a plain background.
    pub still: Option<Still>,
    /// Where the page will be published.
    pub address: Option<PageAddress>,
    /// Whether the shader waits for a click, instead of playing when it is seen.
    pub click: bool,
    /// Whether the script is the same for all shaders, so that pages share it.
    pub shared: bool,
}

/// The absolute address of a page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PageAddress(String);

impl PageAddress {
    /// Parses an address such as `https://example.org/water.html`.
    ///
    /// # Errors
    /// A message if it is not an absolute address of the web.
    pub fn read(text: &str) -> Result<PageAddress, String> {
        let rest = ["https://", "http://"]
            .iter()
            .find_map(|scheme| text.strip_prefix(scheme));
        let is_plain = |c: char| c.is_ascii_graphic() && !"\"'<>\\^`{|}?#".contains(c);
        match rest {
            Some(rest) if !rest.starts_with('/') && !rest.is_empty() => {}
            _ => return Err(ABSOLUTE.to_string()),
        }
        match text.chars().find(|c| !is_plain(*c)) {
            None => Ok(PageAddress(text.to_string())),
            Some(c) => Err(format!("unexpected character `{}`", c.escape_default())),
        }
    }

    /// Parses the address of a folder such as `https://example.org/shaders/`.
    ///
    /// # Errors
    /// A message if it is not an absolute address of the web.
    pub fn read_folder(text: &str) -> Result<PageAddress, String> {
        PageAddress::read(text).map(|address| address.folder())
    }

    /// The address as text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0
    }

    /// The address as that of a folder, whose files are inside of it.
    #[must_use]
    pub fn folder(&self) -> PageAddress {
        PageAddress(format!("{}/", self.0.trim_end_matches('/')))
    }

    /// The address of a file in the same folder.
    #[must_use]
    pub fn beside(&self, name: &str) -> PageAddress {
        let host = self.0.find("://").map_or(0, |at| at + 3);
        let folder = match self.0.rfind('/') {
            Some(end) if end >= host => self.0.get(..end).unwrap_or_default(),
            _ => &self.0,
        };
        PageAddress(format!("{folder}/{}", in_address(name)))
    }
}

const ABSOLUTE: &str = "expected an absolute address such as https://example.org/water.html";

/// The file name of the still image beside a page.
pub(crate) fn still_name(page: &Path) -> String {
    let name = page.with_extension("png");
    let name = name.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// What the Open Graph and Twitter say about a page.
pub(super) struct Card<'a> {
    pub(crate) title: &'a str,
    pub(crate) description: &'a str,
    pub(crate) address: Option<&'a PageAddress>,
    /// The address of the image, its size, and its description.
    pub(crate) image: Option<(PageAddress, [u32; 2], String)>,
}

impl Card<'_> {
    /// The elements of the head.
    pub(super) fn meta(&self) -> String {
        let (title, description) = (self.title, self.description);
        let mut rows = vec![
            ("property", "og:type", "website".to_string()),
            ("property", "og:title", title.to_string()),
            ("property", "og:description", description.to_string()),
        ];
        if let Some(PageAddress(address)) = self.address {
            rows.push(("property", "og:url", address.clone()));
        }
        let mut card = "summary";
        if let Some((PageAddress(address), [width, height], alt)) = &self.image {
            card = "summary_large_image";
            rows.extend([
                ("property", "og:image", address.clone()),
                ("property", "og:image:type", "image/png".to_string()),
                ("property", "og:image:width", width.to_string()),
                ("property", "og:image:height", height.to_string()),
                ("property", "og:image:alt", alt.clone()),
            ]);
        }
        rows.push(("name", "twitter:card", card.to_string()));
        let row = |(kind, name, value): &(&str, &str, String)| {
            let value = escape(value);
            format!("<meta {kind}=\"{name}\" content=\"{value}\">\n")
        };
        rows.iter().map(row).collect()
    }
}

/// The page. `output` is its path, if it is written to a file.
pub fn embed(project: &Project, composed: &Composed, poster: &Poster, output: &Path) -> PlayerPage {
    let info = &project.info;
    let title = title(project);
    let author = match info.author.as_str() {
        "" => String::new(),
        author => format!("by {}", decode(author)),
    };
    let alt = format!("Still image of {title}");
    let description = description(project);
    let beside = |address: &PageAddress| address.beside(&still_name(output));
    let card = Card {
        title: &title,
        description: &description,
        address: poster.address.as_ref(),
        image: match (&poster.still, &poster.address) {
            (Some(still), Some(address)) => Some((beside(address), still.size, alt.clone())),
            _ => None,
        },
    };
    let image = poster.still.as_ref().map(|Still { size, png }| {
        let [width, height] = size;
        let (alt, data) = (escape(&alt), BASE64_STANDARD.encode(png));
        format!(
            "<img alt=\"{alt}\" width=\"{width}\" height=\"{height}\" \
             src=\"data:image/png;base64,{data}\">"
        )
    });
    let credits = credits::lines(project).join("\n");
    let poster_element = format!(
        "<div id=\"poster\"{}>{}<p>{} <small>{}</small></p></div>\n",
        if poster.click { " data-click" } else { "" },
        image.unwrap_or_default(),
        escape(&title),
        escape(&author)
    );
    PlayerPage::new(&PageParts {
        title: &title,
        description: match credits.as_str() {
            "" => &description,
            credits => credits,
        },
        meta: &card.meta(),
        poster: Some(&poster_element),
        project: &escape_json(&payload(project, composed)),
        needs: match poster.shared {
            true => PlayerParts::all(),
            false => PlayerParts::of(project, composed, false),
        },
        start: START,
        version: None,
        playground: None,
    })
}

/// The title of a project.
pub(crate) fn title(project: &Project) -> String {
    match project.info.name.trim() {
        "" => "Shader".to_string(),
        name => decode(name),
    }
}

/// One line about a project: the start of its description, or its author.
fn description(project: &Project) -> String {
    let info = &project.info;
    let text = decode(&info.description);
    let words: Vec<&str> = text.split_whitespace().collect();
    let text: String = words.join(" ").chars().take(MAX_DESCRIPTION).collect();
    match (text.is_empty(), info.author.as_str()) {
        (false, _) => text,
        (true, "") => "A shader that plays in the browser".to_string(),
        (true, author) => format!("A shader by {}", decode(author)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_addresses_must_be_absolute() {
        let beside = |text: &str| PageAddress::read(text).map(|a| a.beside("a b.png").0);
        let is = |text: &str| Ok(format!("https://e.org{text}/a%20b.png"));
        assert_eq!(beside("https://e.org/x/water.html"), is("/x"));
        assert_eq!(beside("https://e.org/x/"), is("/x"));
        assert_eq!(beside("https://e.org"), is(""));
        for wrong in [
            "water.html",
            "//e.org/x",
            "file:///x",
            "https://",
            "https:///x",
        ] {
            assert_eq!(beside(wrong), Err(ABSOLUTE.to_string()), "{wrong}");
        }
        for wrong in ["https://e.org/\"x", "https://e.org/ x", "https://e.org/x#y"] {
            assert!(beside(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn texts_are_escaped_in_elements() {
        let address = PageAddress::read("https://e.org/x.html").ok();
        let card = Card {
            title: "a \"b\" <c>",
            description: "",
            address: address.as_ref(),
            image: None,
        };
        let meta = card.meta();
        assert!(
            meta.contains("content=\"a &quot;b&quot; &lt;c&gt;\""),
            "{meta}"
        );
        assert!(
            meta.contains("og:url\" content=\"https://e.org/x.html\""),
            "{meta}"
        );
        assert!(!meta.contains("og:image"), "{meta}");
    }
}
