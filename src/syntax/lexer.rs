//! Splits source text into raw tokens (GLSL ES 3.00 sections 3.1 to 3.10).
//!
//! The lexer is lossless: whitespace, line breaks and comments are tokens too. Backslash-newline
//! pairs are removed before tokens are formed (section 3.1), so a token may span lines; such a
//! token is marked `spliced`.

use super::token::{RawKind, RawToken, TokenKind};
use memchr::{memchr, memchr3};
use shaderlint_text::Span;
use std::ops::Range;

/// Lexer over one file; returns one raw token per call.
pub struct Lexer<'a> {
    bytes: &'a [u8],
    base: u32,
    at: usize,
    /// Whether the text contains a backslash; otherwise no token can be spliced.
    splices: bool,
}

/// All raw tokens of `text`, whose first byte has the address `base`, without the final `End`.
pub fn tokenize(text: &str, base: u32) -> Vec<RawToken> {
    Lexer::new(text, base).collect()
}

/// The tokens of a text with their ranges and what is written there, without the final `End`.
pub fn written_tokens(text: &str) -> impl Iterator<Item = (RawKind, Range<usize>, &str)> {
    Lexer::new(text, 0).map(|token| {
        let range = token.span.start as usize..token.span.end as usize;
        (token.kind, range.clone(), text.get(range).unwrap_or(""))
    })
}

impl Iterator for Lexer<'_> {
    type Item = RawToken;

    fn next(&mut self) -> Option<RawToken> {
        Some(self.next_token()).filter(|token| token.kind != RawKind::End)
    }
}

/// The text of a spliced token, without the backslash-newline pairs.
pub fn unsplice(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut out = String::with_capacity(text.len());
    let mut from = 0;
    let mut at = 0;
    while at < bytes.len() {
        match splice_len(bytes, at) {
            Some(len) => {
                out.push_str(text.get(from..at).unwrap_or(""));
                at += len;
                from = at;
            }
            None => at += 1,
        }
    }
    out.push_str(text.get(from..).unwrap_or(""));
    out
}

impl<'a> Lexer<'a> {
    /// A lexer at the start of `text`, whose first byte has the address `base`.
    pub fn new(text: &'a str, base: u32) -> Lexer<'a> {
        Lexer {
            bytes: text.as_bytes(),
            base,
            at: 0,
            splices: memchr(b'\\', text.as_bytes()).is_some(),
        }
    }

    /// Skips spaces and tells whether there were any. Most whitespace is a single space that need
    /// not become a token.
    #[inline]
    pub fn skip_blanks(&mut self) -> bool {
        let rest = self.bytes.get(self.at..).unwrap_or(&[]);
        let len = count(rest, |b| b == b' ' || b == b'\t');
        self.at += len;
        len > 0
    }

    /// The next token; at the end of the text, an empty `End` on every call.
    #[inline(always)]
    pub fn next_token(&mut self) -> RawToken {
        let start = self.at;
        let (kind, len) = scan(self.bytes.get(start..).unwrap_or(&[]));
        self.at = start + len;
        let mut spliced = false;
        let mut kind = kind;
        if self.splices && splice_len(self.bytes, self.at).is_some() {
            (kind, spliced) = self.continue_after_splice(start, kind);
        }
        let span = Span::new(self.base + start as u32, self.base + self.at as u32);
        RawToken {
            kind,
            spliced,
            span,
        }
    }

    /// Called when the token that started at `start` ends at a backslash-newline: continues it on
    /// the next line if possible. Returns the combined token and whether it grew.
    #[cold]
    fn continue_after_splice(&mut self, start: usize, kind: RawKind) -> (RawKind, bool) {
        match kind {
            RawKind::LineComment => {
                self.at = line_comment_end(self.bytes, self.at);
                (kind, true)
            }
            RawKind::Word | RawKind::Integer | RawKind::Float | RawKind::BadNumber => {
                self.rescan(start, kind, usize::MAX)
            }
            RawKind::Operator(_) => self.rescan(start, kind, 3),
            _ => (kind, false),
        }
    }

    /// Lexes the token at `start` again from the text without backslash-newline pairs, at most
    /// `limit` characters.
    fn rescan(&mut self, start: usize, kind: RawKind, limit: usize) -> (RawKind, bool) {
        let mut joined = Vec::new();
        let mut ends = Vec::new();
        let mut at = start;
        while joined.len() < limit {
            if let Some(len) = splice_len(self.bytes, at) {
                at += len;
                continue;
            }
            match self.bytes.get(at) {
                Some(&b) if limit != usize::MAX || goes_on(joined.last(), b) => joined.push(b),
                _ => break,
            }
            at += 1;
            ends.push(at);
        }
        let (whole, len) = match joined.as_slice() {
            [b'/', b'/', ..] => (RawKind::LineComment, 2),
            [b'/', b'*', ..] => (RawKind::BlockComment, 2),
            _ => scan(&joined),
        };
        let end = len
            .checked_sub(1)
            .and_then(|i| ends.get(i))
            .copied()
            .unwrap_or(self.at);
        if end <= self.at && whole == kind {
            return (kind, false);
        }
        self.at = end;
        match whole {
            RawKind::LineComment => self.at = line_comment_end(self.bytes, end),
            RawKind::BlockComment => match block_comment_end(self.bytes, end) {
                Some(close) => self.at = close,
                None => {
                    self.at = self.bytes.len();
                    return (RawKind::OpenComment, true);
                }
            },
            _ => {}
        }
        (whole, true)
    }
}

/// Whether `b` can continue a word or number whose last character so far is `last`.
fn goes_on(last: Option<&u8>, b: u8) -> bool {
    is_word(b) || b == b'.' || (matches!(b, b'+' | b'-') && matches!(last, Some(b'e' | b'E')))
}

/// Whether each byte can be part of a word. A table, because lexing words dominates the run time.
const WORD_BYTES: [bool; 256] = {
    let mut all = [false; 256];
    let mut b = 0;
    #[expect(
        clippy::indexing_slicing,
        reason = "evaluated at compile time, where a wrong index does not compile"
    )]
    while b < all.len() {
        all[b] = (b as u8).is_ascii_alphanumeric() || b as u8 == b'_';
        b += 1;
    }
    all
};

#[inline]
fn is_word(b: u8) -> bool {
    WORD_BYTES.get(b as usize).copied().unwrap_or(false)
}

/// Length of the backslash-newline pair at `at`, if there is one.
fn splice_len(bytes: &[u8], at: usize) -> Option<usize> {
    if bytes.get(at) != Some(&b'\\') {
        return None;
    }
    match (bytes.get(at + 1), bytes.get(at + 2)) {
        (Some(b'\r'), Some(b'\n')) => Some(3),
        (Some(b'\n' | b'\r'), _) => Some(2),
        _ => None,
    }
}

/// Kind and length of the token at the start of `bytes`.
#[inline(always)]
fn scan(bytes: &[u8]) -> (RawKind, usize) {
    let Some(&first) = bytes.first() else {
        return (RawKind::End, 0);
    };
    match first {
        b'a'..=b'z' | b'A'..=b'Z' | b'_' => word(bytes),
        b' ' | b'\t' | b'\x0b' | b'\x0c' => (RawKind::Whitespace, blanks(bytes)),
        b'\n' => (RawKind::Newline, 1),
        b'\r' => (
            RawKind::Newline,
            if bytes.get(1) == Some(&b'\n') { 2 } else { 1 },
        ),
        b'0'..=b'9' => number(bytes),
        b'.' if bytes.get(1).is_some_and(u8::is_ascii_digit) => number(bytes),
        b'/' => match bytes.get(1) {
            Some(b'/') => (RawKind::LineComment, line_comment_end(bytes, 2)),
            Some(b'*') => match block_comment_end(bytes, 2) {
                Some(end) => (RawKind::BlockComment, end),
                None => (RawKind::OpenComment, bytes.len()),
            },
            _ => operator(bytes),
        },
        b'#' => (RawKind::Hash, 1),
        b'"' | b'\'' => (RawKind::Other, quoted_len(bytes)),
        b'\\' if splice_len(bytes, 0).is_some() => (RawKind::Whitespace, blanks(bytes)),
        0x80.. if is_foreign_letter(bytes) => word(bytes),
        0x80.. => (RawKind::Other, character_len(bytes)),
        _ => operator(bytes),
    }
}

#[inline]
fn count(bytes: &[u8], class: impl Fn(u8) -> bool) -> usize {
    bytes.iter().position(|&b| !class(b)).unwrap_or(bytes.len())
}

/// A word, and whether it is entirely ASCII.
#[inline]
fn word(bytes: &[u8]) -> (RawKind, usize) {
    let mut len = count(bytes, is_word);
    let mut kind = RawKind::Word;
    while bytes.get(len).is_some_and(|&b| b >= 0x80) {
        let rest = bytes.get(len..).unwrap_or(&[]);
        if !is_foreign_letter(rest) {
            break;
        }
        kind = RawKind::ForeignWord;
        len += character_len(rest);
        len += count(bytes.get(len..).unwrap_or(&[]), is_word);
    }
    (kind, len)
}

/// Whether `bytes` starts with a non-ASCII letter.
fn is_foreign_letter(bytes: &[u8]) -> bool {
    let character = bytes
        .get(..character_len(bytes))
        .and_then(|b| std::str::from_utf8(b).ok());
    character
        .and_then(|s| s.chars().next())
        .is_some_and(char::is_alphanumeric)
}

/// Length of whitespace and backslash-newline pairs.
fn blanks(bytes: &[u8]) -> usize {
    let mut at = 0;
    loop {
        match bytes.get(at) {
            Some(b' ' | b'\t' | b'\x0b' | b'\x0c') => at += 1,
            Some(b'\\') => match splice_len(bytes, at) {
                Some(len) => at += len,
                None => return at,
            },
            _ => return at,
        }
    }
}

/// End of the line comment that continues at `at`; a backslash-newline does not end it.
fn line_comment_end(bytes: &[u8], mut at: usize) -> usize {
    loop {
        let rest = bytes.get(at..).unwrap_or(&[]);
        let Some(len) = memchr3(b'\n', b'\r', b'\\', rest) else {
            return bytes.len();
        };
        at += len;
        match splice_len(bytes, at) {
            Some(len) => at += len,
            None if bytes.get(at) == Some(&b'\\') => at += 1,
            None => return at,
        }
    }
}

/// End of the block comment that continues at `at`; `None` if it is unterminated.
fn block_comment_end(bytes: &[u8], mut at: usize) -> Option<usize> {
    loop {
        at += memchr(b'*', bytes.get(at..)?)? + 1;
        if bytes.get(at) == Some(&b'/') {
            return Some(at + 1);
        }
    }
}

/// Length in bytes of the character at the start of `bytes`.
fn character_len(bytes: &[u8]) -> usize {
    1 + count(bytes.get(1..).unwrap_or(&[]), |b| b & 0xc0 == 0x80)
}

/// A number, or text that starts like one. As in the browser, if the shortest match is not a
/// number, the token extends over everything that could be part of one: `1f`, `08`, `1.0.0`.
fn number(bytes: &[u8]) -> (RawKind, usize) {
    let all = count(bytes, |b| is_word(b) || b == b'.');
    let (kind, len) = valid_number(bytes);
    // A float can be longer than `all`, because the sign of its exponent is not a word character.
    if len >= all {
        (kind, len)
    } else {
        (RawKind::BadNumber, all)
    }
}

/// The longest valid number at the start of `bytes`; length 0 if there is none.
fn valid_number(bytes: &[u8]) -> (RawKind, usize) {
    let get = |i: usize| bytes.get(i).copied().unwrap_or(0);
    let digits = |from: usize| count(bytes.get(from..).unwrap_or(&[]), |b| b.is_ascii_digit());
    if get(0) == b'0' && matches!(get(1), b'x' | b'X') {
        let hex = count(bytes.get(2..).unwrap_or(&[]), |b| b.is_ascii_hexdigit());
        return if hex == 0 {
            (RawKind::BadNumber, 0)
        } else {
            integer(bytes, 2 + hex)
        };
    }
    let whole = digits(0);
    let mut at = whole;
    let mut is_float = false;
    if get(at) == b'.' {
        at += 1 + digits(at + 1);
        is_float = at > 1;
    }
    if matches!(get(at), b'e' | b'E') {
        let sign = matches!(get(at + 1), b'+' | b'-') as usize;
        let exponent = digits(at + 1 + sign);
        if exponent > 0 {
            at += 1 + sign + exponent;
            is_float = true;
        }
    }
    if is_float {
        return (RawKind::Float, at + matches!(get(at), b'f' | b'F') as usize);
    }
    let is_octal = get(0) == b'0' && whole > 1;
    if is_octal && !bytes.iter().take(whole).all(|b| (b'0'..=b'7').contains(b)) {
        return (RawKind::BadNumber, 0);
    }
    integer(bytes, whole)
}

fn integer(bytes: &[u8], len: usize) -> (RawKind, usize) {
    let suffix = matches!(bytes.get(len), Some(b'u' | b'U')) as usize;
    (RawKind::Integer, len + suffix)
}

/// Longest quoted text that is treated as a string of another language.
const MAX_QUOTED: usize = 200;

/// Length of a quoted text, which GLSL does not have; only the quote itself if it is not closed on
/// the same line or contains what the browser treats as a comment.
fn quoted_len(bytes: &[u8]) -> usize {
    let quote = bytes.first();
    let rest = bytes.iter().zip(bytes.iter().skip(1)).take(MAX_QUOTED);
    for (i, (before, byte)) in rest.enumerate() {
        match byte {
            b'\n' | b'\r' | b'\\' => break,
            b'/' | b'*' if *before == b'/' => break,
            byte if Some(byte) == quote => return i + 2,
            _ => {}
        }
    }
    1
}

/// An operator, by longest match, or an invalid character.
fn operator(bytes: &[u8]) -> (RawKind, usize) {
    use TokenKind::*;
    let at = |i: usize| bytes.get(i).copied().unwrap_or(0);
    let (kind, len) = match (at(0), at(1), at(2)) {
        (b'(', ..) => (LeftParen, 1),
        (b')', ..) => (RightParen, 1),
        (b',', ..) => (Comma, 1),
        (b';', ..) => (Semicolon, 1),
        (b'.', ..) => (Dot, 1),
        (b'{', ..) => (LeftBrace, 1),
        (b'}', ..) => (RightBrace, 1),
        (b'[', ..) => (LeftBracket, 1),
        (b']', ..) => (RightBracket, 1),
        (b'*', b'=', _) => (StarEqual, 2),
        (b'*', ..) => (Star, 1),
        (b'+', b'+', _) => (Increment, 2),
        (b'+', b'=', _) => (PlusEqual, 2),
        (b'+', ..) => (Plus, 1),
        (b'-', b'-', _) => (Decrement, 2),
        (b'-', b'=', _) => (MinusEqual, 2),
        (b'-', ..) => (Minus, 1),
        (b'/', b'=', _) => (SlashEqual, 2),
        (b'/', ..) => (Slash, 1),
        (b'%', b'=', _) => (PercentEqual, 2),
        (b'%', ..) => (Percent, 1),
        (b'=', b'=', _) => (EqualEqual, 2),
        (b'=', ..) => (Equal, 1),
        (b'<', b'<', b'=') => (ShiftLeftEqual, 3),
        (b'<', b'<', _) => (ShiftLeft, 2),
        (b'<', b'=', _) => (LessEqual, 2),
        (b'<', ..) => (Less, 1),
        (b'>', b'>', b'=') => (ShiftRightEqual, 3),
        (b'>', b'>', _) => (ShiftRight, 2),
        (b'>', b'=', _) => (GreaterEqual, 2),
        (b'>', ..) => (Greater, 1),
        (b'!', b'=', _) => (NotEqual, 2),
        (b'!', ..) => (Not, 1),
        (b'&', b'&', _) => (AndAnd, 2),
        (b'&', b'=', _) => (AndEqual, 2),
        (b'&', ..) => (And, 1),
        (b'|', b'|', _) => (OrOr, 2),
        (b'|', b'=', _) => (OrEqual, 2),
        (b'|', ..) => (Or, 1),
        (b'^', b'^', _) => (XorXor, 2),
        (b'^', b'=', _) => (XorEqual, 2),
        (b'^', ..) => (Xor, 1),
        (b'?', ..) => (Question, 1),
        (b':', ..) => (Colon, 1),
        (b'~', ..) => (Tilde, 1),
        _ => return (RawKind::Other, 1),
    };
    (RawKind::Operator(kind), len)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each case is a text, with `↵` and `␍` for line breaks, and its tokens.
    #[test]
    fn texts_have_the_expected_tokens() {
        let cases = include_str!("tokens.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let case = case.replace('↵', "\n").replace('␍', "\r");
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            let found = tokenize(text, 0).into_iter().map(|t| {
                let token = &text[t.span.start as usize..t.span.end as usize];
                format!("{:?} `{token}`", t.kind)
            });
            let found = found.collect::<Vec<_>>().join(" ");
            assert_eq!(found, expected, "{text}");
        }
        assert_eq!(unsplice("a\\\nb\\\r\nc\\d"), "abc\\d");
    }
}
