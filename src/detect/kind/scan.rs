//! Tokens of a text in any language, as far as needed to detect the language.
//!
//! Comments of the C family are skipped. A string is one token, whatever it contains: a shader in a
//! string does not determine the language of the program.

/// Maximum number of tokens that are read; the language shows early.
const MAX_TOKENS: usize = 6000;
/// Maximum length of a string in bytes.
const MAX_STRING: usize = 1 << 16;

/// The kind of a token.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ScanKind {
    /// A word or a number.
    Word,
    /// Any other character.
    Mark,
    /// A string.
    Quoted,
}

/// A token of any language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ScanToken<'a> {
    /// Word, mark or string.
    pub kind: ScanKind,
    /// Source text; of a string the quotes only.
    pub text: &'a str,
    /// Start offset.
    pub at: usize,
    /// Whether it is the first of its line.
    pub is_first: bool,
}

/// The first [`MAX_TOKENS`] tokens of a text.
pub fn tokens(text: &str) -> Vec<ScanToken<'_>> {
    first_tokens(text, MAX_TOKENS)
}

/// The first `count` tokens of a text.
pub fn first_tokens(text: &str, count: usize) -> Vec<ScanToken<'_>> {
    // Few texts have more than one token per three characters.
    let mut found = Vec::with_capacity(count.min(text.len() / 3));
    let bytes = text.as_bytes();
    let mut at = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let mut is_first = true;
    while let Some(&byte) = bytes.get(at) {
        let from = at;
        let kind = match byte {
            b'\n' => {
                is_first = true;
                at += 1;
                continue;
            }
            _ if byte.is_ascii_whitespace() => {
                at += 1;
                continue;
            }
            b'/' if matches!(bytes.get(at + 1), Some(b'/' | b'*')) => {
                at = after_comment(text, at);
                continue;
            }
            b'"' | b'\'' | b'`' => match after_string(text, at) {
                Some(end) => {
                    at = end;
                    ScanKind::Quoted
                }
                None => {
                    at += 1;
                    ScanKind::Mark
                }
            },
            _ if is_word(byte) => {
                while bytes.get(at).is_some_and(|b| is_word(*b)) {
                    at += 1;
                }
                ScanKind::Word
            }
            _ => {
                at += 1;
                ScanKind::Mark
            }
        };
        let end = if kind == ScanKind::Quoted {
            from + 1
        } else {
            at
        };
        found.push(ScanToken {
            kind,
            text: text.get(from..end).unwrap_or(""),
            at: from,
            is_first,
        });
        is_first = false;
        if found.len() >= count {
            break;
        }
    }
    found
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte >= 0x80
}

fn after_comment(text: &str, at: usize) -> usize {
    let rest = text.get(at..).unwrap_or("");
    let length = if rest.starts_with("//") {
        rest.find('\n')
    } else {
        rest.get(2..).and_then(|r| r.find("*/")).map(|end| end + 4)
    };
    at + length.unwrap_or(rest.len())
}

/// The end of a string that starts here; `None` if none does, as at an apostrophe.
fn after_string(text: &str, at: usize) -> Option<usize> {
    let rest = text.get(at..)?;
    let (open, before) = (rest.get(..1)?, text.get(..at)?);
    let near = |from: usize, close: &str| {
        let end = rest.get(from..)?.find(close)?;
        (end < MAX_STRING).then_some(at + from + end + close.len())
    };
    // `don't`
    let is_inside = before.ends_with(|c: char| c.is_alphanumeric());
    match open {
        "\"" if rest.starts_with("\"\"\"") => near(3, "\"\"\""),
        "'" if rest.starts_with("'''") => near(3, "'''"),
        // Raw strings of C++ and Rust, with common delimiters.
        "\"" if before.ends_with("R") => near(1, ")\"").or_else(|| near(1, "\"")),
        "\"" if before.ends_with("r#") => near(1, "\"#"),
        "`" => near(1, "`"),
        "'" if is_inside => None,
        _ => {
            // The line is not searched for its end first: a minified script is one line.
            let mut is_escaped = false;
            let end = rest.bytes().skip(1).position(|b| {
                let ends = b == b'\n' || !is_escaped && open.as_bytes() == [b];
                is_escaped = !is_escaped && b == b'\\';
                ends
            })?;
            (rest.as_bytes().get(end + 1) != Some(&b'\n')).then_some(at + end + 2)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let texts: Vec<&str> = tokens(text).iter().map(|t| t.text).collect();
        assert_eq!(texts, expected);
    }

    #[test]
    fn strings_and_comments_are_skipped() {
        check("a // b\nc /* d\n */ e", &["a", "c", "e"]);
        check(
            "x = 'it\\'s' + \"y\" + `z\n`;",
            &["x", "=", "'", "+", "\"", "+", "`", ";"],
        );
        check("s = \"\"\"\nvoid\n\"\"\"", &["s", "=", "\""]);
        check("s = R\"(\n\"a\"\n)\";", &["s", "=", "R", "\"", ";"]);
        check("don't 'a", &["don", "'", "t", "'", "a"]);
    }
}
