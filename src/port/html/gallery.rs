//! A page that lists the pages of many shaders, with a still image of each. Its script only searches.

use super::embed::{Card, PageAddress, Poster, START, title};
use super::{COLORS, PageParts, PlayerPage, fill, hash};
use crate::payload::pieces::PlayerParts;
use crate::{Project, credits};
use shaderlint_text::markup::{decode, escape, in_address};

const PAGE: &str = include_str!("../player/page/gallery.html");
const STYLE: &str = include_str!("../player/min/page/gallery.css");
const SEARCH: &str = include_str!("../player/min/page/search.js");

/// A shader of a gallery.
pub struct GalleryEntry {
    /// The name of its page and of its still image, without extension.
    pub name: String,
    /// Its title.
    pub title: String,
    /// Its author; empty if unknown.
    pub author: String,
    /// Its licence in a line; empty if unknown.
    pub license: String,
    /// Width and height of its still image; `None` if it has none.
    pub still: Option<[u32; 2]>,
}

impl GalleryEntry {
    /// The entry of a project.
    pub fn of(name: &str, project: &Project, poster: &Poster) -> GalleryEntry {
        GalleryEntry {
            name: name.to_string(),
            title: title(project),
            author: decode(&project.info.author),
            license: credits::license(project),
            still: poster.still.as_ref().map(|still| still.size),
        }
    }

    fn card(&self) -> String {
        let name = in_address(&self.name);
        let image = match self.still {
            Some([width, height]) => format!(
                "<img src=\"{name}.png\" alt=\"\" width=\"{width}\" height=\"{height}\" \
                 loading=\"lazy\">"
            ),
            None => "<span class=\"plain\"></span>".to_string(),
        };
        let author = match self.author.as_str() {
            "" => String::new(),
            author => format!("<small>by {}</small>", escape(author)),
        };
        let license = match self.license.as_str() {
            "" => String::new(),
            license => format!("<small class=\"license\">{}</small>", escape(license)),
        };
        format!(
            "<li><a href=\"{name}.html#play\"><span class=\"image\">{image}</span>\
             <b>{}</b>{author}</a>{license}</li>\n",
            escape(&self.title)
        )
    }
}

/// What all shaders of a gallery share.
pub struct Gallery {
    /// The page that lists them.
    pub page: String,
    /// The script of their pages.
    pub script: String,
    /// The style of their pages.
    pub style: String,
}

/// The gallery. `address` is where its page will be published.
pub fn gallery(heading: &str, entries: &[&GalleryEntry], address: Option<&PageAddress>) -> Gallery {
    let parts = PageParts {
        poster: Some(""),
        needs: PlayerParts::all(),
        start: START,
        ..PageParts::default()
    };
    let [_, script, style] = PlayerPage::new(&parts).split("", "");
    Gallery {
        page: list(heading, entries, address),
        script,
        style,
    }
}

fn list(heading: &str, entries: &[&GalleryEntry], address: Option<&PageAddress>) -> String {
    let description = match entries.len() {
        1 => "1 shader that plays in the browser".to_string(),
        n => format!("{n} shaders that play in the browser"),
    };
    let image = address.and_then(|address| {
        let first = entries.iter().find(|entry| entry.still.is_some())?;
        let file = address.beside(&format!("{}.png", first.name));
        Some((
            file,
            first.still?,
            format!("Still image of {}", first.title),
        ))
    });
    let card = Card {
        title: heading,
        description: &description,
        address,
        image,
    };
    let style = [COLORS, STYLE].concat();
    // Browsers differ in whether `'self'` includes files on disk.
    let policy = format!(
        "default-src 'none'; style-src 'sha256-{}'; script-src 'sha256-{}'; \
         img-src 'self' file: data:; base-uri 'none'; form-action 'none'",
        hash(&style),
        hash(SEARCH)
    );
    let cards: String = entries.iter().map(|entry| entry.card()).collect();
    fill(
        PAGE,
        &[
            ("policy", &policy),
            ("title", &escape(heading)),
            ("description", &escape(&description)),
            ("meta", &card.meta()),
            ("style", &style),
            ("cards", &cards),
            ("script", SEARCH),
        ],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_titles_are_escaped() {
        let entry = GalleryEntry {
            name: "a\"b".to_string(),
            title: "<c>".to_string(),
            author: "d&e".to_string(),
            license: "f<".to_string(),
            still: None,
        };
        let page = list("<x>", &[&entry], None);
        assert!(page.contains("<h1>&lt;x&gt;</h1>"), "{page}");
        assert!(page.contains("href=\"a%22b.html#play\""), "{page}");
        assert!(
            page.contains(
                "<b>&lt;c&gt;</b><small>by d&amp;e</small></a><small class=\"license\">f&lt;<"
            ),
            "{page}"
        );
        assert!(!page.contains("og:image"), "{page}");
    }
}
