//! Finds the strings of a JSON text, and changes them without touching the rest.

use memchr::{memchr, memchr2};
use std::borrow::Cow;
use std::ops::Range;

/// A string of a JSON text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct JsonString {
    /// Decoded value.
    pub value: String,
    /// Pairs of an offset in the value and one in the JSON text: at the start, and after each
    /// escape. Between two pairs, both advance equally.
    stretches: Vec<(u32, u32)>,
    /// Whether `/` is escaped as `\/`.
    escapes_slashes: bool,
    /// Whether all characters outside of ASCII are escaped.
    escapes_others: bool,
}

impl JsonString {
    /// Parses the string with its text, without quotes, at `range`.
    fn read(text: &str, range: Range<usize>) -> Option<JsonString> {
        let raw = text.get(range.clone())?;
        let mut value = String::with_capacity(raw.len());
        let mut stretches = vec![(0, range.start as u32)];
        let (mut escapes_slashes, mut has_units) = (false, false);
        let mut at = 0;
        while let Some(plain) = memchr(b'\\', raw.as_bytes().get(at..)?) {
            value.push_str(raw.get(at..at + plain)?);
            at += plain;
            let (c, length) = escape(raw.get(at..)?)?;
            let kind = raw.as_bytes().get(at + 1);
            escapes_slashes |= kind == Some(&b'/');
            has_units |= kind == Some(&b'u');
            value.push(c);
            at += length;
            stretches.push((value.len() as u32, (range.start + at) as u32));
        }
        value.push_str(raw.get(at..)?);
        Some(JsonString {
            value,
            stretches,
            escapes_slashes,
            escapes_others: has_units && raw.is_ascii(),
        })
    }

    /// The range in the JSON text of a range in the value.
    pub fn place(&self, from: usize, to: usize) -> Option<Range<u32>> {
        let place = |at: usize| {
            let at = u32::try_from(at).ok()?;
            let before = self.stretches.partition_point(|(own, _)| *own <= at);
            let (own, written) = self.stretches.get(before.checked_sub(1)?)?;
            Some(written + (at - own))
        };
        let is_inside = from <= self.value.len() && to <= self.value.len();
        is_inside.then_some(place(from)?..place(to)?)
    }

    /// The offset in the value of an offset in the JSON text; inside an escape, that of its
    /// character.
    pub fn value_at(&self, offset: u32) -> Option<u32> {
        let before = self.stretches.partition_point(|(_, own)| *own <= offset);
        let (value, written) = self.stretches.get(before.checked_sub(1)?)?;
        let end = match self.stretches.get(before) {
            // An escape ends at the next pair, and is one character.
            Some((next, _)) => self.value.get(..*next as usize)?.char_indices().last()?.0 as u32,
            None => self.value.len() as u32,
        };
        Some((value + (offset - written)).min(end))
    }

    /// Escapes a text in the style of the string.
    pub fn escape(&self, text: &str) -> String {
        let mut out = String::with_capacity(text.len());
        for c in text.chars() {
            match c {
                '"' => out.push_str("\\\""),
                '\\' => out.push_str("\\\\"),
                '\n' => out.push_str("\\n"),
                '\r' => out.push_str("\\r"),
                '\t' => out.push_str("\\t"),
                '/' if self.escapes_slashes => out.push_str("\\/"),
                c if c < ' ' || (self.escapes_others && !c.is_ascii()) => {
                    let mut units = [0; 2];
                    for unit in c.encode_utf16(&mut units) {
                        out.push_str(&format!("\\u{unit:04x}"));
                    }
                }
                c => out.push(c),
            }
        }
        out
    }
}

/// Replaces every escape of a lone surrogate with U+FFFD, as a browser shows it. Offsets stay the
/// same.
pub fn repair_escapes(text: &str) -> Cow<'_, str> {
    let mut repaired = String::new();
    let (mut at, mut copied) = (0, 0);
    while let Some(plain) = memchr(b'\\', text.as_bytes().get(at..).unwrap_or(&[])) {
        at += plain;
        let Some((c, length)) = text.get(at..).and_then(escape) else {
            at += 1;
            continue;
        };
        if c == char::REPLACEMENT_CHARACTER {
            repaired.push_str(text.get(copied..at).unwrap_or(""));
            repaired.push_str("\\ufffd");
            copied = at + length;
        }
        at += length;
    }
    if copied == 0 {
        return Cow::Borrowed(text);
    }
    repaired.push_str(text.get(copied..).unwrap_or(""));
    Cow::Owned(repaired)
}

/// The character of the escape at the start of a text, and the length of the escape.
fn escape(rest: &str) -> Option<(char, usize)> {
    let c = match rest.as_bytes().get(1)? {
        b'n' => '\n',
        b'r' => '\r',
        b't' => '\t',
        b'b' => '\u{8}',
        b'f' => '\u{c}',
        b'u' => {
            let unit = |at: usize| u16::from_str_radix(rest.get(at..at + 4)?, 16).ok();
            let high = unit(2)?;
            if let Some(c) = char::from_u32(u32::from(high)) {
                return Some((c, 6));
            }
            let low = unit(8).filter(|_| rest.get(6..8) == Some("\\u"));
            let pair = low.and_then(|low| char::decode_utf16([high, low]).next()?.ok());
            return Some(pair.map_or((char::REPLACEMENT_CHARACTER, 6), |c| (c, 12)));
        }
        b'"' | b'\\' | b'/' => char::from(*rest.as_bytes().get(1)?),
        _ => return None,
    };
    Some((c, 2))
}

/// An open object or array.
struct OpenContainer<'a> {
    is_list: bool,
    /// Index of the current entry.
    index: usize,
    /// Key of the current entry.
    key: &'a str,
    awaits_key: bool,
}

/// The strings under `key` in the objects of the array `list`, with their indices. `None` if one is
/// invalid.
pub fn strings_in(text: &str, list: &str, key: &str) -> Option<Vec<(usize, JsonString)>> {
    let bytes = text.as_bytes();
    let mut open: Vec<OpenContainer> = Vec::new();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'{' | b'[' => open.push(OpenContainer {
                is_list: byte == b'[',
                index: 0,
                key: "",
                awaits_key: byte == b'{',
            }),
            b'}' | b']' => {
                open.pop();
            }
            b',' => {
                let top = open.last_mut()?;
                top.index += 1;
                top.awaits_key = !top.is_list;
            }
            b'"' => {
                let end = string_end(bytes, at)?;
                let range = at + 1..end;
                at = end;
                let depth = open.len();
                let above = |up: usize| depth.checked_sub(up).and_then(|i| open.get(i));
                let is_requested = above(1).is_some_and(|o| !o.awaits_key && o.key == key)
                    && above(2).is_some_and(|o| o.is_list)
                    && above(3).is_some_and(|o| o.key == list);
                if is_requested {
                    let index = above(2)?.index;
                    found.push((index, JsonString::read(text, range)?));
                } else if let Some(top) = open.last_mut().filter(|o| o.awaits_key) {
                    top.key = text.get(range)?;
                    top.awaits_key = false;
                }
            }
            _ => {}
        }
        at += 1;
    }
    Some(found)
}

fn string_end(bytes: &[u8], open: usize) -> Option<usize> {
    let mut at = open + 1;
    loop {
        at += memchr2(b'\\', b'"', bytes.get(at..)?)?;
        if bytes.get(at) == Some(&b'"') {
            return Some(at);
        }
        at += 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_are_found_with_their_position() {
        let text = r#"{"code": "no", "a": {"list": [{"code": "x\ny", "b": "code"}, {"c": ["z"]}, {"code": ""}]}}"#;
        let found = strings_in(text, "list", "code").unwrap();
        let values: Vec<(usize, &str)> = found.iter().map(|(i, s)| (*i, &*s.value)).collect();
        assert_eq!(values, [(0, "x\ny"), (2, "")]);
        let place = found[0].1.place(1, 2).unwrap();
        assert_eq!(&text[place.start as usize..place.end as usize], "\\n");
    }

    #[test]
    fn escaped_strings_keep_the_style_of_the_original() {
        let raw = r#"[{"l": [{"k": "a\/b \u00e9 \ud834\udd1e \"\\\t"}]}]"#;
        let found = strings_in(raw, "l", "k").unwrap();
        let string = &found[0].1;
        assert_eq!(string.value, "a/b é 𝄞 \"\\\t");
        assert!(raw.contains(&string.escape(&string.value)));
        let plain = strings_in(r#"[{"l": [{"k": "a/é"}]}]"#, "l", "k").unwrap();
        assert_eq!(plain[0].1.escape("/é\r\n"), r"/é\r\n");
    }
}
