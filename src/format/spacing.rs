//! Whether there is a space between two items of a line.

use super::item::{FormatItem, ItemKind};
use super::structure::ItemRole;
use shaderlint_syntax::TokenKind as T;
use shaderlint_syntax::ast::BinaryOp;
use shaderlint_syntax::set::{ASSIGNMENTS, TokenSet};

/// Tokens without a space before them.
const STICKS: TokenSet = TokenSet::of(&[
    T::Semicolon,
    T::Comma,
    T::RightParen,
    T::RightBracket,
    T::Dot,
    T::LeftBracket,
]);
/// Tokens without a space after them.
const HOLDS: TokenSet = TokenSet::of(&[T::LeftParen, T::LeftBracket, T::Dot]);
/// Keywords with a space before the parenthesis that follows.
const BEFORE_BLANK: TokenSet = TokenSet::of(&[
    T::If,
    T::For,
    T::While,
    T::Switch,
    T::Return,
    T::Case,
    T::Else,
    T::Do,
    T::In,
    T::Out,
    T::Inout,
    T::Const,
]);

/// The precedence of `? :`, below that of all binary operators.
const TERNARY: u32 = 3;

/// By item: whether there is a space before it if it is on the same line.
pub fn blanks(text: &str, items: &[FormatItem], roles: &[ItemRole]) -> Vec<bool> {
    let pairs = items.iter().zip(items.iter().skip(1));
    let pairs = pairs.zip(roles.iter().skip(1));
    let blank = pairs.map(|((before, item), role)| has_blank(text, before, item, role));
    let mut blanks = Vec::with_capacity(items.len());
    blanks.extend(std::iter::once(false).chain(blank));
    blanks
}

/// Whether there is a space between an item and the one before it. `text` is the source text.
fn has_blank(text: &str, before: &FormatItem, item: &FormatItem, role: &ItemRole) -> bool {
    let fuses = || item.breaks + item.blanks > 0 && may_fuse(text, before, item);
    match (before.kind, item.kind) {
        (ItemKind::Token(before_kind), ItemKind::Token(kind)) => {
            if kind == T::Bad || before_kind == T::Bad {
                return item.breaks + item.blanks > 0;
            }
            between(before, before_kind, item, kind, role) || fuses()
        }
        (ItemKind::Token(kind), _) => !HOLDS.contains(kind),
        (ItemKind::BlockComment, ItemKind::Token(kind)) => {
            !STICKS.contains(kind) || kind == T::LeftBracket
        }
        _ => true,
    }
}

fn between(
    before: &FormatItem,
    before_kind: T,
    item: &FormatItem,
    kind: T,
    role: &ItemRole,
) -> bool {
    if before.is_prefix || HOLDS.contains(before_kind) {
        return false;
    }
    match kind {
        // `for (;;)`
        T::Semicolon | T::RightParen if before_kind == T::Semicolon => false,
        _ if STICKS.contains(kind) => false,
        T::LeftParen => !is_called(before_kind),
        T::Colon => !role.is_label,
        T::Increment | T::Decrement => item.is_prefix,
        T::RightBrace => before_kind != T::LeftBrace,
        _ => true,
    }
}

/// Whether a parenthesis after this token has no space before it, as in a call.
fn is_called(before: T) -> bool {
    let is_operator = before.is_binary_operator()
        || is_assignment(before)
        || matches!(before, T::Question | T::Colon | T::Comma | T::Semicolon);
    let is_brace = matches!(before, T::LeftBrace | T::RightBrace);
    !is_operator && !is_brace && !BEFORE_BLANK.contains(before)
}

/// Whether a token is an assignment operator.
pub fn is_assignment(kind: T) -> bool {
    ASSIGNMENTS.contains(kind)
        || matches!(
            kind,
            T::PercentEqual
                | T::ShiftLeftEqual
                | T::ShiftRightEqual
                | T::AndEqual
                | T::OrEqual
                | T::XorEqual
        )
}

/// Whether two adjacent items would be lexed as a different token.
fn may_fuse(text: &str, before: &FormatItem, item: &FormatItem) -> bool {
    let bytes = text.as_bytes();
    let last = before.span.end.checked_sub(1);
    let last = last.and_then(|i| bytes.get(i as usize));
    let (Some(&a), Some(&b)) = (last, bytes.get(item.span.start as usize)) else {
        return false;
    };
    let is_word = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.' | 0x80..);
    let is_operator = |b: u8| b"+-*/%<>=!&|^~?:#".contains(&b);
    (is_word(a) && is_word(b)) || (is_operator(a) && is_operator(b))
}

/// The precedence of a binary operator or of `? :`, lowest first.
pub fn precedence(kind: T) -> Option<u32> {
    match kind {
        T::Question | T::Colon => Some(TERNARY),
        _ => BinaryOp::of(kind).map(|operator| u32::from(operator.precedence())),
    }
}
