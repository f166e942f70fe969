//! Raw tokens, with each directive as one item.

use crate::token::{RawKind, RawToken};

/// A directive, or a token outside of directives.
pub enum RawItem<'t> {
    /// The `#`, and the other tokens of its line.
    Directive(&'t RawToken, &'t [RawToken]),
    /// A token of code.
    Token(&'t RawToken),
}

/// The directives of a text, and its other tokens except white space and comments.
pub fn raw_items(tokens: &[RawToken]) -> Vec<RawItem<'_>> {
    let mut items = Vec::new();
    let mut at_start = true;
    let mut rest = tokens;
    while let [first, after @ ..] = rest {
        rest = after;
        match first.kind {
            RawKind::Newline => at_start = true,
            RawKind::Hash if at_start => {
                let end = rest.iter().position(|t| t.kind == RawKind::Newline);
                let (line, after) = rest.split_at(end.unwrap_or(rest.len()));
                rest = after;
                items.push(RawItem::Directive(first, line));
            }
            kind if is_blank(kind) => {}
            _ => {
                at_start = false;
                items.push(RawItem::Token(first));
            }
        }
    }
    items
}

/// White space within a line, or a comment.
pub fn is_blank(kind: RawKind) -> bool {
    matches!(
        kind,
        RawKind::Whitespace | RawKind::LineComment | RawKind::BlockComment
    )
}
