//! The pages of the compile errors, `errors/NAME.md`. They are in this crate, so that a change of a page
//! does not recompile the front end.

macro_rules! pages {
    ($($name:literal,)*) => {
        const PAGES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("errors/", $name, ".md")))),*];
    };
}

/// The text of the page of a compile error, in Markdown.
pub fn error_page(name: &str) -> Option<&'static str> {
    let found = PAGES.iter().find(|(n, _)| *n == name);
    found.map(|(_, page)| *page)
}

shaderlint_diagnostic::for_error_names!(pages);
