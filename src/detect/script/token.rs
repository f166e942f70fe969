//! The tokens of a script, as far as needed to find string literals.

use std::ops::Range;

/// The kind of a token.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ScriptTokenKind {
    /// The contents of a quoted string.
    Quoted,
    /// The contents of a template literal, and the ranges of its `${...}`.
    Template(Vec<Range<usize>>),
    /// `// ...` or `/* ... */`.
    Comment,
    /// A word or a number.
    Word,
    /// Any other character.
    Mark(u8),
}

/// A token; its range excludes quotes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScriptToken {
    /// Quoted string, template, comment, word or mark.
    pub kind: ScriptTokenKind,
    pub range: Range<usize>,
}

/// Whether the token at an index is this mark.
pub fn is_mark(tokens: &[ScriptToken], at: usize, mark: u8) -> bool {
    tokens
        .get(at)
        .is_some_and(|t| t.kind == ScriptTokenKind::Mark(mark))
}

/// The tokens of a script up to the first error.
pub fn tokens(text: &str) -> Vec<ScriptToken> {
    let bytes = text.as_bytes();
    let mut found: Vec<ScriptToken> = Vec::new();
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let from = at;
        let next = bytes.get(at + 1).copied().unwrap_or(0);
        let kind = match byte {
            b'/' if next == b'/' || next == b'*' => {
                at = comment_end(text, at);
                ScriptTokenKind::Comment
            }
            b'/' if may_be_regex(text, found.last()) => {
                let end = regex_end(bytes, at);
                at = end.unwrap_or(at + 1);
                // It counts as an operand, so that a following `/` is a division.
                if end.is_some() {
                    ScriptTokenKind::Word
                } else {
                    ScriptTokenKind::Mark(byte)
                }
            }
            b'\'' if is_apostrophe(text, found.last(), at) => {
                at += 1;
                ScriptTokenKind::Mark(byte)
            }
            b'"' | b'\'' => match quoted_end(bytes, at) {
                Some(end) => {
                    at = end + 1;
                    found.push(ScriptToken {
                        kind: ScriptTokenKind::Quoted,
                        range: from + 1..end,
                    });
                    continue;
                }
                None => {
                    at += 1;
                    ScriptTokenKind::Mark(byte)
                }
            },
            b'`' => {
                let Some((end, holes)) = template_end(text, at) else {
                    return found;
                };
                at = end + 1;
                found.push(ScriptToken {
                    kind: ScriptTokenKind::Template(holes),
                    range: from + 1..end,
                });
                continue;
            }
            _ if is_word(byte) => {
                while bytes.get(at).is_some_and(|b| is_word(*b)) {
                    at += 1;
                }
                ScriptTokenKind::Word
            }
            _ => {
                at += 1;
                if byte.is_ascii_whitespace() {
                    continue;
                }
                ScriptTokenKind::Mark(byte)
            }
        };
        found.push(ScriptToken {
            kind,
            range: from..at,
        });
    }
    found
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'$' || byte >= 0x80
}

/// Whether a `'` is an apostrophe in the text of an element: `don't`.
fn is_apostrophe(text: &str, before: Option<&ScriptToken>, at: usize) -> bool {
    let is_letter = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_alphabetic);
    let word = before.filter(|t| t.kind == ScriptTokenKind::Word && t.range.end == at);
    let word = word.and_then(|t| text.get(t.range.clone()));
    let is_keyword = |w| {
        matches!(
            w,
            "return" | "case" | "typeof" | "in" | "of" | "from" | "import"
        )
    };
    is_letter(at + 1) && word.is_some_and(|w| !is_keyword(w))
}

fn comment_end(text: &str, at: usize) -> usize {
    let rest = text.get(at..).unwrap_or("");
    let length = if rest.starts_with("//") {
        rest.find('\n')
    } else {
        rest.get(2..).and_then(|r| r.find("*/")).map(|end| end + 4)
    };
    at + length.unwrap_or(rest.len())
}

/// Whether a `/` after this token starts a regular expression.
fn may_be_regex(text: &str, before: Option<&ScriptToken>) -> bool {
    match before {
        None => true,
        Some(token) => match token.kind {
            ScriptTokenKind::Mark(mark) => !matches!(mark, b')' | b']' | b'}' | b'<'),
            ScriptTokenKind::Word => matches!(
                text.get(token.range.clone()),
                Some("return" | "typeof" | "case" | "of" | "in")
            ),
            ScriptTokenKind::Comment => true,
            ScriptTokenKind::Quoted | ScriptTokenKind::Template(_) => false,
        },
    }
}

/// Whether a `/` in the code of a template starts a regular expression, because it does not follow
/// an operand.
fn starts_regex(bytes: &[u8], at: usize) -> bool {
    let before = bytes.get(..at).unwrap_or(&[]);
    let last = before.iter().rev().find(|b| !b.is_ascii_whitespace());
    let is_comment = matches!(bytes.get(at + 1), Some(b'/' | b'*'));
    !is_comment && last.is_some_and(|b| b"(,=:[!&|?{};".contains(b))
}

fn regex_end(bytes: &[u8], at: usize) -> Option<usize> {
    let mut in_class = false;
    let mut at = at + 1;
    loop {
        match bytes.get(at)? {
            b'\n' => return None,
            b'\\' => at += 1,
            b'[' => in_class = true,
            b']' => in_class = false,
            b'/' if !in_class => return Some(at + 1),
            _ => {}
        }
        at += 1;
    }
}

/// Offset of the closing quote; `None` if the line ends before.
fn quoted_end(bytes: &[u8], at: usize) -> Option<usize> {
    let quote = bytes.get(at)?;
    let mut at = at + 1;
    loop {
        match bytes.get(at)? {
            b'\\' if bytes.get(at + 1) == Some(&b'\r') => at += 2,
            b'\\' => at += 1,
            b'\n' => return None,
            byte if byte == quote => return Some(at),
            _ => {}
        }
        at += 1;
    }
}

/// Offset of the closing backtick, and the outermost `${...}`.
fn template_end(text: &str, at: usize) -> Option<(usize, Vec<Range<usize>>)> {
    /// An open construct: a literal, or the code of `${` with a number of open braces.
    enum OpenToken {
        Literal,
        Code(u32),
    }
    let bytes = text.as_bytes();
    let mut open = vec![OpenToken::Literal];
    let mut holes: Vec<Range<usize>> = Vec::new();
    let mut at = at + 1;
    loop {
        let byte = *bytes.get(at)?;
        let depth = open.len();
        match open.last_mut()? {
            OpenToken::Literal => match byte {
                b'\\' => at += 1,
                b'`' => {
                    open.pop();
                    if open.is_empty() {
                        return Some((at, holes));
                    }
                }
                b'$' if bytes.get(at + 1) == Some(&b'{') => {
                    if depth == 1 {
                        holes.push(at..at);
                    }
                    open.push(OpenToken::Code(0));
                    at += 1;
                }
                _ => {}
            },
            OpenToken::Code(braces) => match byte {
                b'`' => open.push(OpenToken::Literal),
                b'{' => *braces += 1,
                b'}' if *braces > 0 => *braces -= 1,
                b'}' => {
                    open.pop();
                    if open.len() == 1
                        && let Some(hole) = holes.last_mut()
                    {
                        hole.end = at + 1;
                    }
                }
                b'"' | b'\'' => at = quoted_end(bytes, at).unwrap_or(at),
                b'/' if starts_regex(bytes, at) => {
                    at = regex_end(bytes, at).map_or(at, |end| end - 1);
                }
                b'/' if matches!(bytes.get(at + 1), Some(b'/' | b'*')) => {
                    at = comment_end(text, at).saturating_sub(1).max(at);
                }
                _ => {}
            },
        }
        at += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn literals(text: &str) -> Vec<&str> {
        let of = |t: ScriptToken| {
            matches!(
                t.kind,
                ScriptTokenKind::Quoted | ScriptTokenKind::Template(_)
            )
            .then_some(t.range)
        };
        let ranges = tokens(text).into_iter().filter_map(of);
        ranges.map(|r| &text[r]).collect()
    }

    #[test]
    fn ends_of_literals_are_found() {
        assert_eq!(literals(r#"a = 'b\'c' + "d""#), [r"b\'c", "d"]);
        assert_eq!(
            literals("`a${f(`x${1}`, {b: '}'})}c` + `d`"),
            ["a${f(`x${1}`, {b: '}'})}c", "d"]
        );
        assert_eq!(literals("// it's\nx = 'y' /* `no` */"), ["y"]);
        assert_eq!(literals("<p>don't</p>; x = 'y'"), ["y"]);
        assert_eq!(literals("a = b / c; r = /[`/]'/; s = 'y'"), ["y"]);
        assert_eq!(literals("'a"), [""; 0]);
    }

    #[test]
    fn holes_of_templates_are_found() {
        let found = tokens("`a${b}c${`${d}`}`");
        assert_eq!(found[0].kind, ScriptTokenKind::Template(vec![2..6, 7..16]));
    }
}
