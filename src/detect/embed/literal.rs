//! Decodes string literals to code of the same length.

use super::chain::Chain;
use super::constants::Constants;
use super::hole::{Hole, HoleContent};
use super::holes::fill;
use super::token::{ScriptToken, ScriptTokenKind};
use std::ops::Range;

/// The code of concatenated literals.
pub struct JoinedLiterals {
    /// Start offset in the file.
    pub start: usize,
    /// Code of the same length as in the file.
    pub text: String,
    /// Whether parts are inserted at run time.
    pub has_holes: bool,
}

/// Decodes concatenated literals.
pub fn read(
    text: &str,
    tokens: &[ScriptToken],
    chain: &Chain,
    constants: &Constants,
) -> Option<JoinedLiterals> {
    let parts: Vec<&ScriptToken> = chain.parts.iter().filter_map(|i| tokens.get(*i)).collect();
    let (start, end) = (parts.first()?.range.start, parts.last()?.range.end);
    let mut code = Mask {
        bytes: vec![b' '; end - start],
        start,
        holes: Vec::new(),
        constants,
    };
    let mut others = chain.others.iter().peekable();
    for (part, index) in parts.iter().zip(&chain.parts) {
        code.literal(text, part);
        let after = part.range.end;
        if let Some((_, other)) = others.next_if(|(before, _)| before == index) {
            code.other(text, tokens, after, other, chain.has_lines);
        } else if chain.has_lines && after < end {
            code.set(after, b'\n');
        }
    }
    let is_unknown = fill(&mut code.bytes, &code.holes);
    Some(JoinedLiterals {
        start,
        text: String::from_utf8(code.bytes).ok()?,
        has_holes: is_unknown || chain.goes_on,
    })
}

struct Mask<'a> {
    bytes: Vec<u8>,
    start: usize,
    holes: Vec<Hole>,
    constants: &'a Constants,
}

impl Mask<'_> {
    fn set(&mut self, at: usize, byte: u8) {
        if let Some(place) = at
            .checked_sub(self.start)
            .and_then(|i| self.bytes.get_mut(i))
        {
            *place = byte;
        }
    }

    fn literal(&mut self, text: &str, token: &ScriptToken) {
        let holes: &[Range<usize>] = match &token.kind {
            ScriptTokenKind::Template(holes) => holes,
            _ => &[],
        };
        let mut holes = holes.iter().peekable();
        let bytes = text.as_bytes();
        let mut at = token.range.start;
        while at < token.range.end {
            if let Some(hole) = holes.next_if(|h| h.start == at) {
                self.hole(text, hole);
                at = hole.end;
                continue;
            }
            let byte = bytes.get(at).copied().unwrap_or(b' ');
            if byte == b'\\' {
                at += self.escape(text, at);
            } else {
                self.set(at, byte);
                at += 1;
            }
        }
    }

    /// Decodes an escape sequence; returns its length.
    fn escape(&mut self, text: &str, at: usize) -> usize {
        let rest = text.get(at + 1..).unwrap_or("");
        let Some(c) = rest.chars().next() else {
            return 1;
        };
        match c {
            // First, so that a backslash before it still continues the line.
            'n' => self.set(at, b'\n'),
            'x' => return self.number(at, rest.get(1..3), 4),
            'u' if rest.starts_with("u{") => {
                let end = rest.find('}').unwrap_or(1);
                return self.number(at, rest.get(2..end), end + 2);
            }
            'u' => return self.number(at, rest.get(1..5), 6),
            '\r' if rest.starts_with("\r\n") => return 3,
            c if c.is_ascii_punctuation() => self.set(at + 1, c as u8),
            _ => {}
        }
        1 + c.len_utf8()
    }

    /// A character given by its code.
    fn number(&mut self, at: usize, digits: Option<&str>, length: usize) -> usize {
        let value = digits.and_then(|d| u8::from_str_radix(d, 16).ok());
        if let Some(value) = value.filter(u8::is_ascii) {
            self.set(at + length - 1, value);
        }
        length
    }

    /// `${...}`
    fn hole(&mut self, text: &str, hole: &Range<usize>) {
        let inner = text.get(hole.start + 2..hole.end.saturating_sub(1));
        self.put(hole.clone(), inner.unwrap_or(""));
    }

    fn put(&mut self, range: Range<usize>, expression: &str) {
        let expression = expression.trim();
        let content = match self.constants.value(expression) {
            Some(value) => HoleContent::Known(value.to_string()),
            None => HoleContent::Expression(expression.to_string()),
        };
        let of = |at: usize| at.saturating_sub(self.start);
        self.holes.push(Hole {
            range: of(range.start)..of(range.end),
            content,
        });
    }

    /// Other expressions after the literal that ends at `from`. Everything between the literals
    /// belongs to it, so that it is adjacent to them as at run time.
    fn other(
        &mut self,
        text: &str,
        tokens: &[ScriptToken],
        from: usize,
        other: &Range<usize>,
        is_line: bool,
    ) {
        let all = tokens.get(other.clone()).unwrap_or(&[]);
        let next = tokens.get(other.end..).unwrap_or(&[]);
        let next = next.iter().find(|t| super::token::is_literal(t));
        let (Some(first), Some(next)) = (all.first(), next) else {
            return;
        };
        let signs = |t: &&ScriptToken| {
            !matches!(
                t.kind,
                ScriptTokenKind::Mark(b'+' | b',') | ScriptTokenKind::Comment
            )
        };
        let last = all.iter().rev().find(signs).unwrap_or(first);
        let words = text.get(first.range.start..last.range.end).unwrap_or("");
        let mut range = from..next.range.start;
        if is_line {
            self.set(range.start, b'\n');
            self.set(range.end - 1, b'\n');
            range = range.start + 1..range.end - 1;
        }
        self.put(range, words);
    }
}
