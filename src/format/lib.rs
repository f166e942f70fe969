//! The formatter: decides on the white space between tokens, and on nothing else.
//!
//! A text is read as items: tokens, comments, and directives as a whole. Their bytes stay as they
//! are, so that a shader cannot change; what is given back are edits of the gaps between them.
//! Nothing is expanded and nothing is parsed to the end: what stands in branches of the preprocessor
//! that are not taken is formatted as well, and a text with mistakes in it, too, as long as its
//! brackets match.
//!
//! The author's line breaks inside a statement stay where they are; a line that is too long gets
//! more of them, at the outermost place where what stands before it fits (after D. Oppen,
//! "Prettyprinting", 1980, inconsistent breaks).

mod columns;
mod gaps;
mod grid;
mod hang;
mod item;
mod layout;
mod lines;
mod overflow;
mod place;
mod request;
mod spacing;
mod structure;
mod style;

#[cfg(test)]
mod tests;

use item::items;
pub use request::{Lines, TextExtent, Unformatted};
use shaderlint_text::Edit;
pub use style::{Brace, Indentation, Style, StyleChoice};

/// The macro that tells the number of a line.
const LINE_MACRO: &str = "__LINE__";

/// Whether a text asks for the numbers of its lines, so that they may not change.
pub fn counts_lines(text: &str) -> bool {
    text.contains(LINE_MACRO)
}

/// The edits that format a text, in order. Their spans count from the start of the text.
///
/// # Errors
/// Where a bracket has no partner or a comment no end, and where brackets nest too deeply.
pub fn format(
    text: &str,
    style: &Style,
    extent: TextExtent,
    lines: Lines,
) -> Result<Vec<Edit>, Unformatted> {
    let mut items = items(text, style.indent.width())?;
    let lines = match counts_lines(text) {
        true => Lines::Kept,
        false => lines,
    };
    let roles = structure::read(&items)?;
    grid::keep(&mut items, &roles);
    let places = layout::place(text, &items, &roles, style, extent, lines);
    Ok(gaps::edits(text, &items, &places, style, extent))
}
