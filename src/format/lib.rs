//! The formatter: changes only the white space between tokens.
//!
//! The input is split into items: tokens, comments and whole directives. Items are never changed,
//! so that formatting cannot change a shader; the result is a list of edits of the gaps between
//! items. Macros are not expanded and there is no full parse: inactive branches of the preprocessor
//! are formatted, too, and so is code with errors, as long as its brackets match.
//!
//! The author's line breaks within statements are kept. Lines that are too long are broken at the
//! outermost level, and their parts at the next (after D. Oppen, "Prettyprinting", 1980).

mod branches;
mod columns;
mod gaps;
mod grid;
mod hang;
mod item;
mod layout;
mod lines;
mod lists;
mod operators;
mod overflow;
mod place;
mod request;
mod rows;
mod spacing;
mod structure;
mod style;

use item::items;
use layout::LayoutSettings;
pub use request::{FormattedText, Lines, TextExtent, Unformatted};
pub use style::{Brace, Indentation, Style, StyleChoice};

/// The macro that expands to the current line number.
const LINE_MACRO: &str = "__LINE__";

/// Whether a text uses `__LINE__`, so that its line numbers must not change.
pub fn counts_lines(text: &str) -> bool {
    text.contains(LINE_MACRO)
}

/// Formats a text.
pub fn format(text: &str, style: &Style, extent: TextExtent, lines: Lines) -> FormattedText {
    let mut items = match items(text, style.indent.width()) {
        Ok(items) => items,
        Err(why) => {
            return FormattedText {
                edits: Vec::new(),
                left: vec![why],
            };
        }
    };
    let lines = match counts_lines(text) {
        true => Lines::Kept,
        false => lines,
    };
    let (mut roles, left) = structure::read(&mut items);
    if items.iter().all(|item| item.keeps) {
        return FormattedText {
            edits: Vec::new(),
            left,
        };
    }
    let base = layout::base(&items, &roles, extent);
    branches::indent(&items, &mut roles, base);
    let blanks = spacing::blanks(text, &items, &roles);
    grid::keep(text, &mut items, &roles, &blanks, style);
    let settings = LayoutSettings {
        style,
        extent,
        lines,
        base,
    };
    let places = layout::place(text, &mut items, &roles, blanks, &settings);
    FormattedText {
        edits: gaps::edits(text, &items, &places, style, extent),
        left,
    }
}
