//! Parts of a shader that are inserted at run time: by `${...}` in a script, by `+`, or by the
//! template language of the text.
//!
//! Each is replaced by code of the same length that fits the syntax around it: usually an
//! undeclared name, the same for equal expressions; nothing between statements; a number next to
//! digits.

use super::hole::{Hole, HoleContent, is_keyword};
use std::ops::Range;

/// Placeholder in the bytes of holes that are not filled yet.
pub(super) const OPEN: u8 = 1;

/// How holes were filled.
pub(super) struct FilledHoles {
    /// Whether unknown code is inserted.
    pub is_unknown: bool,
    /// The holes that are blank, because their text is inserted there.
    pub inserted: Vec<usize>,
}

/// Fills holes in source order.
pub(super) fn fill(bytes: &mut [u8], holes: &[Hole]) -> FilledHoles {
    for hole in holes {
        write(bytes, hole.range.clone(), |_| OPEN);
    }
    let mut words = HoleWords::default();
    let mut filled = FilledHoles {
        is_unknown: false,
        inserted: Vec::new(),
    };
    for (index, hole) in holes.iter().enumerate() {
        let range = hole.range.clone();
        let mut known = match &hole.content {
            HoleContent::Known(value) => fitted(bytes, &range, value),
            HoleContent::Chosen(_, value) if is_include(bytes, &range) => {
                fitted(bytes, &range, value)
            }
            HoleContent::Nothing => Some(String::new()),
            HoleContent::Expression(_) | HoleContent::Chosen(..) => None,
        };
        if known.is_none() && is_apart(bytes, hole) {
            filled.inserted.push(index);
            known = Some(String::new());
        }
        filled.is_unknown |= known.is_none() || hole.content == HoleContent::Nothing;
        let text = known.unwrap_or_else(|| match &hole.content {
            HoleContent::Expression(key)
            | HoleContent::Known(key)
            | HoleContent::Chosen(key, _) => HolePlace::of(bytes, &range).text(&mut words, key),
            HoleContent::Nothing => String::new(),
        });
        let text = text.as_bytes();
        write(bytes, range, |i| text.get(i).copied().unwrap_or(b' '));
    }
    filled
}

/// Whether a hole is outside of directives, and no word of its text touches another, so that tokens may be
/// inserted.
fn is_apart(bytes: &[u8], hole: &Hole) -> bool {
    let Some((first, last)) = hole.inserted else {
        return false;
    };
    let range = &hole.range;
    let before = range.start.checked_sub(1).and_then(|b| bytes.get(b));
    let is_tight = |byte: Option<&u8>| byte.is_some_and(|b| is_word(*b) || *b == b'.');
    let place = HolePlace::of(bytes, range);
    let touches = is_tight(before) && is_tight(Some(&first))
        || is_tight(bytes.get(range.end)) && is_tight(Some(&last));
    !touches && !place.line().trim_start().starts_with('#')
}

/// Whether a hole is in an include directive.
fn is_include(bytes: &[u8], range: &Range<usize>) -> bool {
    let place = HolePlace::of(bytes, range);
    let line = place.line().trim_start();
    line.strip_prefix('#')
        .is_some_and(|rest| rest.trim_start().starts_with("include"))
}

fn write(bytes: &mut [u8], range: Range<usize>, byte: impl Fn(usize) -> u8) {
    let places = bytes.get_mut(range).unwrap_or(&mut []);
    for (i, place) in places.iter_mut().enumerate() {
        *place = byte(i);
    }
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

fn touches(byte: Option<&u8>) -> bool {
    byte.is_some_and(|b| is_word(*b) || *b == OPEN)
}

/// A value padded with blanks where they do not separate tokens; `None` if it does not fit.
fn fitted(bytes: &[u8], range: &Range<usize>, value: &str) -> Option<String> {
    let length = range.len();
    if value.len() > length {
        return None;
    }
    let before = range.start.checked_sub(1).and_then(|b| bytes.get(b));
    let after = bytes.get(range.end);
    let is_tight = |byte: Option<&u8>| touches(byte) || byte == Some(&b'.');
    match (is_tight(before), is_tight(after)) {
        (true, true) if value.len() < length => None,
        (false, true) => Some(format!("{value:>length$}")),
        _ => Some(value.to_string()),
    }
}

/// The names that replace expressions.
#[derive(Default)]
struct HoleWords {
    /// The expressions, each with the length of its hole.
    keys: Vec<(usize, String)>,
}

impl HoleWords {
    /// The name for an expression.
    fn word(&mut self, key: &str, length: usize) -> String {
        let entry = (length, key.to_string());
        let of_length = self.keys.iter().filter(|(l, _)| *l == length);
        let mut number = match of_length.clone().position(|k| *k == entry) {
            Some(at) => at,
            None => {
                let count = of_length.count();
                self.keys.push(entry);
                count
            }
        };
        let mut word = vec![b'h'; length];
        // The number is encoded in letters and digits from the end; the first expression gets the
        // plain name.
        for place in word.iter_mut().skip(1).rev() {
            if number == 0 {
                break;
            }
            let digit = (number % 10) as u8;
            *place = b'0' + digit;
            number /= 10;
        }
        String::from_utf8(word).unwrap_or_default()
    }

    /// A number that differs from those of other expressions, for holes with little room.
    fn number(&mut self, key: &str) -> usize {
        let entry = (0, key.to_string());
        let all = || self.keys.iter().filter(|(l, _)| *l == 0);
        let known = all().position(|k| *k == entry);
        let count = all().count();
        if known.is_none() {
            self.keys.push(entry);
        }
        known.unwrap_or(count)
    }
}

/// The code around a hole.
struct HolePlace<'a> {
    length: usize,
    before: &'a [u8],
    after: &'a [u8],
}

impl<'a> HolePlace<'a> {
    fn of(bytes: &'a [u8], range: &Range<usize>) -> HolePlace<'a> {
        /// Number of bytes searched before the hole.
        const NEAR: usize = 2048;
        let from = range.start.saturating_sub(NEAR);
        HolePlace {
            length: range.len(),
            before: bytes.get(from..range.start).unwrap_or(&[]),
            after: bytes.get(range.end..).unwrap_or(&[]),
        }
    }

    /// The replacement that fits the syntax.
    fn text(&self, words: &mut HoleWords, key: &str) -> String {
        /// Maximum length of a name.
        const MAX_WORD: usize = 512;
        if self.length > MAX_WORD {
            return String::new();
        }
        if let Some(text) = self.in_directive(words, key) {
            return text;
        }
        if self.is_number() {
            return "1".repeat(self.length);
        }
        if touches(self.before.last()) {
            return words.word(key, self.length);
        }
        let (last, next) = (self.last_sign(), self.next_sign());
        let is_start = matches!(last, HoleSign::Start | HoleSign::Mark(b';' | b'{' | b'}'));
        let after = self.word_after();
        let is_declared = next == Some(OPEN) || is_keyword(after);
        match last {
            _ if is_start && self.is_done(next) => String::new(),
            HoleSign::Word(word) if word == "precision" && self.length >= 4 => {
                let precision = if self.length >= 5 { "highp" } else { "lowp" };
                precision.to_string()
            }
            // An optional qualifier.
            HoleSign::Word(word) if is_declared && is_keyword(word) && word != "return" => {
                String::new()
            }
            HoleSign::Mark(b'(' | b',') if is_declared => String::new(),
            _ if is_start && is_declared => String::new(),
            HoleSign::Word("case") => words.number(key).to_string(),
            HoleSign::Mark(b'=') if self.is_layout() => words.number(key).to_string(),
            HoleSign::Mark(b')') if self.is_done(next) || is_declared => "{}".to_string(),
            HoleSign::Mark(b')' | b']') => self.after_operand(next),
            HoleSign::Word(word) if !is_keyword(word) && !self.is_declaration(word) => {
                self.after_operand(next)
            }
            // The rest of the statement, with its semicolon.
            HoleSign::Word("return") | HoleSign::Mark(b'=')
                if self.length > 0 && self.is_done(next) =>
            {
                words.word(key, self.length - 1) + ";"
            }
            _ => words.word(key, self.length),
        }
    }

    /// The replacement after an operand: an operator, or nothing.
    fn after_operand(&self, next: Option<u8>) -> String {
        match next {
            Some(byte) if is_word(byte) || byte == b'(' || byte == b'.' => " +".to_string(),
            _ => String::new(),
        }
    }

    /// The part of the line before the hole.
    fn line(&self) -> &'a str {
        let from = self.before.iter().rposition(|b| *b == b'\n');
        let line = self.before.get(from.map_or(0, |f| f + 1)..);
        std::str::from_utf8(line.unwrap_or(&[])).unwrap_or("")
    }

    fn in_directive(&self, words: &mut HoleWords, key: &str) -> Option<String> {
        let rest = self.line().trim_start().strip_prefix('#')?.trim_start();
        let name = rest.split(|c: char| !c.is_ascii_alphabetic()).next()?;
        let is_separate = !touches(self.before.last()) && !touches(self.after.first());
        Some(match name {
            "version" => {
                let is_es = self.word_after() == "es";
                let room = self.length >= 6 && !is_es;
                (if room { "300 es" } else { "300" }).to_string()
            }
            "if" | "elif" if is_separate => "1".to_string(),
            "extension" if self.length >= 3 && is_separate => "all".to_string(),
            _ if self.is_number() => "1".repeat(self.length),
            _ => words.word(key, self.length),
        })
    }

    /// Whether digits or a decimal point are next to it.
    fn is_number(&self) -> bool {
        let is_point = |b: Option<&u8>| b == Some(&b'.');
        let after =
            is_point(self.after.first()) && !self.after.get(1).is_some_and(u8::is_ascii_alphabetic);
        let before = match self.before.split_last() {
            Some((b'.', rest)) => starts_with_digit(rest) || !rest.last().is_some_and(ends_operand),
            _ => starts_with_digit(self.before),
        };
        before || (after && !touches(self.before.last()))
    }

    /// The last token before the hole that is not a comment.
    fn last_sign(&self) -> HoleSign<'a> {
        let text = match std::str::from_utf8(self.before) {
            Ok(text) => text,
            Err(error) => {
                // The searched range may start inside a character.
                let rest = self.before.get(error.valid_up_to() + 1..).unwrap_or(&[]);
                std::str::from_utf8(rest).unwrap_or("")
            }
        };
        for line in text.rsplit('\n') {
            let code = line.split("//").next().unwrap_or("").trim();
            let is_own = line.len() == self.line().len();
            if code.starts_with('#') && !is_own || code.ends_with("*/") {
                return HoleSign::Start;
            }
            let Some(last) = code.bytes().next_back() else {
                continue;
            };
            if !is_word(last) {
                return HoleSign::Mark(last);
            }
            let from = code.rfind(|c: char| !c.is_ascii() || !is_word(c as u8));
            return HoleSign::Word(code.get(from.map_or(0, |f| f + 1)..).unwrap_or(""));
        }
        HoleSign::Start
    }

    /// The first byte after it that is not white space.
    fn next_sign(&self) -> Option<u8> {
        let mut all = self.after.iter();
        all.find(|b| !b.is_ascii_whitespace()).copied()
    }

    /// The next word on the same line.
    fn word_after(&self) -> &'a str {
        let is_blank = |b: &u8| matches!(b, b' ' | b'\t');
        let from = self.after.iter().position(|b| !is_blank(b));
        let rest = self.after.get(from.unwrap_or(0)..).unwrap_or(&[]);
        let end = rest.iter().position(|b| !is_word(*b));
        let word = rest.get(..end.unwrap_or(rest.len())).unwrap_or(&[]);
        std::str::from_utf8(word).unwrap_or("")
    }

    /// Whether a statement may end after it.
    fn is_done(&self, next: Option<u8>) -> bool {
        let mut line = self.after.iter().take_while(|b| **b != b'\n');
        let is_last = line.all(|b| b.is_ascii_whitespace());
        match next {
            None | Some(b'}' | b'#') => true,
            Some(byte) => is_last && (is_word(byte) || matches!(byte, OPEN | b'/' | b'{')),
        }
    }

    /// Whether its statement has only one word before it, which therefore is a type.
    fn is_declaration(&self, word: &str) -> bool {
        let text = std::str::from_utf8(self.before).unwrap_or("").trim_end();
        let rest = text.strip_suffix(word).unwrap_or("").trim_end();
        let last = rest.bytes().next_back();
        let before = rest.rsplit(|c: char| !c.is_ascii() || !is_word(c as u8));
        let is_start = last.is_none_or(|b| matches!(b, b';' | b'{' | b'}' | b'(' | b',' | b'/'));
        is_start
            || before.take(1).any(is_keyword)
            || self.line().trim_start().len() <= word.len() + 1
    }

    /// Whether it is in `layout(...)`.
    fn is_layout(&self) -> bool {
        let line = self.line();
        let after = line.rsplit("layout").next().unwrap_or(line);
        after.len() < line.len() && !after.contains(')')
    }
}

/// The token before a hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum HoleSign<'a> {
    /// Nothing, or the end of a line.
    Start,
    Word(&'a str),
    Mark(u8),
}

fn ends_operand(byte: &u8) -> bool {
    is_word(*byte) || matches!(*byte, b')' | b']' | OPEN)
}

/// Whether the word at the end of a text is a number.
fn starts_with_digit(text: &[u8]) -> bool {
    let length = text.iter().rev().take_while(|b| is_word(**b)).count();
    let first = text.get(text.len() - length..).and_then(<[u8]>::first);
    first.is_some_and(u8::is_ascii_digit)
}

/// A text of the same length with the holes of templates filled; `None` if it has none. Anything
/// that may be GLSL is not a hole.
pub fn mask(code: &str) -> Option<String> {
    let holes = super::template::holes(code);
    if holes.is_empty() {
        return None;
    }
    let mut bytes = code.as_bytes().to_vec();
    fill(&mut bytes, &holes);
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        assert_eq!(mask(text).as_deref().unwrap_or("none"), expected, "{text}");
    }

    #[test]
    fn holes_become_placeholders_of_their_length() {
        let cases = include_str!("holes.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            check(&text.replace('↵', "\n"), &expected.replace('↵', "\n"));
        }
    }
}
