//! Converts positions of items to edits of the white space between them.

use super::item::FormatItem;
use super::place::ItemPlace;
use super::request::TextExtent;
use super::style::{Indentation, Style};
use shaderlint_text::{Edit, Span};

/// The edits that move every item to its position.
pub fn edits(
    text: &str,
    items: &[FormatItem],
    places: &[ItemPlace],
    style: &Style,
    extent: TextExtent,
) -> Vec<Edit> {
    let line_break = line_break(text);
    let (mut edits, mut expected) = (Vec::new(), String::new());
    let mut end = 0;
    let mut column = 0;
    for (item, place) in items.iter().zip(places) {
        let gap = Span::new(end, item.span.start);
        if !place.keeps {
            let (tabs, blanks) = match place.breaks {
                0 => (0, place.column.saturating_sub(column)),
                _ => indentation(place, style),
            };
            expected.clear();
            (0..place.breaks).for_each(|_| expected.push_str(line_break));
            expected.extend(std::iter::repeat_n('\t', tabs as usize));
            expected.extend(std::iter::repeat_n(' ', blanks as usize));
            replace(text, gap, &expected, &mut edits);
        }
        end = item.span.end;
        column = match item.is_tall {
            true => item.width,
            false => place.column + item.width,
        };
    }
    // A line break after a backslash would be a line continuation.
    let is_open = text.get(..end as usize).is_some_and(|t| t.ends_with('\\'));
    if extent == TextExtent::File && !items.is_empty() && !is_open {
        replace(
            text,
            Span::new(end, text.len() as u32),
            line_break,
            &mut edits,
        );
    }
    edits
}

/// The most frequent line ending of a text.
fn line_break(text: &str) -> &'static str {
    let count = |of: char| text.bytes().filter(|b| *b == of as u8).count();
    let both = text.matches("\r\n").count();
    let (feeds, returns) = (count('\n') - both, count('\r') - both);
    match () {
        () if both > feeds && both >= returns => "\r\n",
        () if returns > feeds => "\r",
        () => "\n",
    }
}

/// The tabs and spaces at the start of a line. With tabs, levels are tabs and alignment is spaces.
fn indentation(place: &ItemPlace, style: &Style) -> (u32, u32) {
    match style.indent {
        Indentation::Spaces(_) => (0, place.column),
        Indentation::Tab(width) => {
            let tabs = place.level.min(place.column / width.max(1));
            (tabs, place.column - tabs * width)
        }
    }
}

fn replace(text: &str, gap: Span, expected: &str, edits: &mut Vec<Edit>) {
    let found = text.get(gap.start as usize..gap.end as usize).unwrap_or("");
    if found != expected {
        edits.push(Edit::replace(gap, expected));
    }
}
