//! Shaders in the literals of a script.

use super::token::{Kind, Token, tokens};
use super::{Embedded, Wrapping, is_shader};
use std::ops::Range;

/// Finds them.
pub fn extract(text: &str, base: usize, found: &mut Vec<Embedded>) {
    let tokens = tokens(text);
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if !is_literal(token) {
            at += 1;
            continue;
        }
        let chain = chain(&tokens, at);
        let last = chain.last;
        if let Some(shader) = shader(text, &tokens, at, &chain) {
            found.push(Embedded {
                start: shader.start + base,
                ..shader
            });
        }
        at = last + 1;
    }
}

fn is_literal(token: &Token) -> bool {
    matches!(token.kind, Kind::Quoted | Kind::Template(_))
}

fn is_mark(tokens: &[Token], at: usize, mark: u8) -> bool {
    tokens.get(at).is_some_and(|t| t.kind == Kind::Mark(mark))
}

/// Literals that are put together.
struct Chain {
    /// Their indexes.
    parts: Vec<usize>,
    /// The last token that belongs to it.
    last: usize,
    /// Whether each stands on a line of its own: `[...].join('\n')`.
    is_joined: bool,
    /// Whether something else is put between, before or behind them.
    has_others: bool,
}

/// The literals that are put together with that at `first`.
fn chain(tokens: &[Token], first: usize) -> Chain {
    let starts_array = first
        .checked_sub(1)
        .is_some_and(|b| is_mark(tokens, b, b'['));
    let joined = starts_array.then(|| joined(tokens, first)).flatten();
    joined.unwrap_or_else(|| added(tokens, first))
}

/// `"..." + x + "..."`
fn added(tokens: &[Token], first: usize) -> Chain {
    let mut chain = Chain {
        parts: vec![first],
        last: first,
        is_joined: false,
        has_others: first
            .checked_sub(1)
            .is_some_and(|b| is_mark(tokens, b, b'+')),
    };
    loop {
        let plus = skip_comments(tokens, chain.last + 1);
        if !is_mark(tokens, plus, b'+') {
            return chain;
        }
        let mut next = skip_comments(tokens, plus + 1);
        if !tokens.get(next).is_some_and(is_literal) {
            chain.has_others = true;
            let Some(behind) = behind_operand(tokens, next) else {
                return chain;
            };
            next = behind;
        }
        chain.parts.push(next);
        chain.last = next;
    }
}

/// The literal that follows an operand which is none: `+ (x) + "..."`.
fn behind_operand(tokens: &[Token], mut at: usize) -> Option<usize> {
    /// Longest operand that is looked through, in tokens.
    const MAX_OPERAND: usize = 32;
    let mut depth = 0_u32;
    for _ in 0..MAX_OPERAND {
        match tokens.get(at)?.kind {
            Kind::Mark(b'(' | b'[') => depth += 1,
            Kind::Mark(b')' | b']') => depth = depth.checked_sub(1)?,
            Kind::Mark(b'+') if depth == 0 => {
                let next = skip_comments(tokens, at + 1);
                if is_literal(tokens.get(next)?) {
                    return Some(next);
                }
            }
            Kind::Mark(b';' | b',' | b'{' | b'}') if depth == 0 => return None,
            _ => {}
        }
        at += 1;
    }
    None
}

/// `["...", "..."].join("\n")`
fn joined(tokens: &[Token], first: usize) -> Option<Chain> {
    let mut parts = vec![first];
    let mut at = skip_comments(tokens, first + 1);
    while is_mark(tokens, at, b',') {
        let next = skip_comments(tokens, at + 1);
        if !tokens.get(next).is_some_and(is_literal) {
            at = next;
            break;
        }
        parts.push(next);
        at = skip_comments(tokens, next + 1);
    }
    let is_join = is_mark(tokens, at, b']')
        && is_mark(tokens, at + 1, b'.')
        && is_mark(tokens, at + 3, b'(')
        && tokens.get(at + 4).is_some_and(is_literal);
    is_join.then_some(Chain {
        parts,
        last: at + 4,
        is_joined: true,
        has_others: false,
    })
}

fn skip_comments(tokens: &[Token], mut at: usize) -> usize {
    while tokens.get(at).is_some_and(|t| t.kind == Kind::Comment) {
        at += 1;
    }
    at
}

/// The shader that a chain of literals holds, if it holds one.
fn shader(text: &str, tokens: &[Token], first: usize, chain: &Chain) -> Option<Embedded> {
    let parts: Vec<&Token> = chain.parts.iter().filter_map(|i| tokens.get(*i)).collect();
    let (start, end) = (parts.first()?.range.start, parts.last()?.range.end);
    let mut code = Mask {
        bytes: vec![b' '; end - start],
        start,
    };
    let mut has_holes = chain.has_others;
    for part in &parts {
        code.literal(text, part);
        has_holes |= matches!(&part.kind, Kind::Template(holes) if !holes.is_empty());
        if chain.is_joined && part.range.end < end {
            code.set(part.range.end, b'\n');
        }
    }
    let code = String::from_utf8(code.bytes).ok()?;
    let introduced = introduction(text, tokens, first);
    if code.trim().is_empty() || !(introduced || is_shader(&code)) {
        return None;
    }
    let is_template = chain.parts.len() == 1 && matches!(parts.first()?.kind, Kind::Template(_));
    let mut shader = Embedded {
        start,
        code,
        wrapping: if is_template {
            Wrapping::Template
        } else {
            Wrapping::Quotes
        },
        has_holes,
        is_vertex: is_named_vertex(text, tokens, first),
        chapter: 0,
    };
    cut_front(text, tokens, chain.last + 1, &mut shader);
    Some(shader)
}

/// Whether a tag or a comment says that a literal is GLSL.
fn introduction(text: &str, tokens: &[Token], literal: usize) -> bool {
    let Some(before) = literal.checked_sub(1).and_then(|b| tokens.get(b)) else {
        return false;
    };
    let words = text.get(before.range.clone()).unwrap_or("");
    match before.kind {
        Kind::Word => {
            let starts = tokens.get(literal).map_or(0, |t| t.range.start);
            let touches = before.range.end + 1 == starts;
            touches && matches!(words, "glsl" | "frag" | "vert" | "shader")
        }
        Kind::Comment => words
            .trim_matches(['/', '*', ' ', '\t'])
            .eq_ignore_ascii_case("glsl"),
        _ => false,
    }
}

/// Whether a literal is given to something with "vert" in its name.
fn is_named_vertex(text: &str, tokens: &[Token], literal: usize) -> bool {
    let before = tokens
        .get(literal.saturating_sub(6)..literal)
        .unwrap_or(&[]);
    let behind = |t: &&Token| !matches!(t.kind, Kind::Mark(b';' | b',' | b'{' | b'(' | b')'));
    let mut words = before.iter().rev().take_while(behind);
    words.any(|t| {
        let word = text.get(t.range.clone()).unwrap_or("").to_ascii_lowercase();
        t.kind == Kind::Word && (word.contains("vert") || word == "vs")
    })
}

/// Leaves out what `.trim()` or `.slice(1)` behind the literal takes away.
fn cut_front(text: &str, tokens: &[Token], behind: usize, shader: &mut Embedded) {
    if !is_mark(tokens, behind, b'.') {
        return;
    }
    let word = |at: usize| {
        let range = tokens.get(at).map_or(0..0, |t| t.range.clone());
        text.get(range).unwrap_or("")
    };
    match (word(behind + 1), word(behind + 3)) {
        ("trim" | "trimStart" | "trimLeft", _) => shader.trim_start(),
        ("slice" | "substring" | "substr", "1") if shader.code.starts_with(['\n', ' ']) => {
            shader.code.remove(0);
            shader.start += 1;
        }
        _ => {}
    }
}

/// What the compiler reads of a stretch of a script, byte for byte.
struct Mask {
    bytes: Vec<u8>,
    start: usize,
}

impl Mask {
    fn set(&mut self, at: usize, byte: u8) {
        if let Some(place) = at
            .checked_sub(self.start)
            .and_then(|i| self.bytes.get_mut(i))
        {
            *place = byte;
        }
    }

    fn literal(&mut self, text: &str, token: &Token) {
        let holes: &[Range<usize>] = match &token.kind {
            Kind::Template(holes) => holes,
            _ => &[],
        };
        let mut holes = holes.iter().peekable();
        let bytes = text.as_bytes();
        let mut at = token.range.start;
        while at < token.range.end {
            if let Some(hole) = holes.next_if(|h| h.start == at) {
                self.hole(text, &token.range, hole);
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

    /// Reads an escape; gives its length.
    fn escape(&mut self, text: &str, at: usize) -> usize {
        let rest = text.get(at + 1..).unwrap_or("");
        let Some(c) = rest.chars().next() else {
            return 1;
        };
        match c {
            // First, so that a backslash before it still goes on with the line.
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

    /// A character given by its number.
    fn number(&mut self, at: usize, digits: Option<&str>, length: usize) -> usize {
        let value = digits.and_then(|d| u8::from_str_radix(d, 16).ok());
        if let Some(value) = value.filter(u8::is_ascii) {
            self.set(at + length - 1, value);
        }
        length
    }

    /// `${...}`: nothing where a line holds nothing else between two statements, a number beside
    /// digits, a name otherwise.
    fn hole(&mut self, text: &str, literal: &Range<usize>, hole: &Range<usize>) {
        /// How far is looked around, in bytes.
        const NEAR: usize = 256;
        let from = literal.start.max(hole.start.saturating_sub(NEAR));
        let from = (from..=hole.start).find(|at| text.is_char_boundary(*at));
        let before = text
            .get(from.unwrap_or(hole.start)..hole.start)
            .unwrap_or("");
        let behind = text.get(hole.end..literal.end).unwrap_or("");
        let mut lines = before.rsplit('\n');
        let line = lines.next().unwrap_or("");
        let above = lines.find(|l| !l.trim().is_empty()).unwrap_or("").trim();
        let rest = behind
            .bytes()
            .take_while(|b| *b != b'\n')
            .all(|b| b.is_ascii_whitespace());
        let is_done = above.is_empty()
            || above.starts_with(['#', '/'])
            || above.ends_with([';', '}', '{', '/']);
        if line.trim().is_empty() && rest && is_done {
            return;
        }
        let behind = behind.as_bytes();
        let point =
            behind.first() == Some(&b'.') && !behind.get(1).is_some_and(u8::is_ascii_alphabetic);
        let letter = if point || before.ends_with('.') {
            b'1'
        } else {
            b'h'
        };
        for at in hole.clone() {
            self.set(at, letter);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let mut found = Vec::new();
        extract(text, 0, &mut found);
        for shader in &found {
            assert!(text.get(shader.start..shader.end()).is_some());
        }
        let codes: Vec<&str> = found.iter().map(|s| s.code.as_str()).collect();
        assert_eq!(codes, expected);
    }

    #[test]
    fn literals_that_are_shaders() {
        check(
            "const a = `#version 300 es\nx`, b = 'void 0';",
            &["#version 300 es\nx"],
        );
        check(
            "f(glsl`float f();`, /* glsl */ `x`, /*no*/`y`)",
            &["float f();", "x"],
        );
        check(
            "s = 'void  main ( ) {}'; t = \"void mainly()\"",
            &["void  main ( ) {}"],
        );
    }

    #[test]
    fn literals_that_are_put_together() {
        check(
            "s = 'void main() {\\n' +\n 'x;' + // it's\n '}';",
            &["void main() {\n       x;              }"],
        );
        check(
            "s = ['void main() {', '}'].join('\\n');",
            &["void main() {\n   }"],
        );
        check(
            "s = 'void main() {' + f(1) + '}';",
            &["void main() {            }"],
        );
    }

    #[test]
    fn escapes_keep_their_length() {
        check(
            r"s = 'void main() { \
}\t\x41\\\n';",
            &["void main() {   }     A \\\n "],
        );
    }

    #[test]
    fn holes_become_names_numbers_or_nothing() {
        check(
            "s = `void main() {\n${a}\nx = ${b};y = ${c}.0; z = vec${d}(1);}`",
            &["void main() {\n    \nx = hhhh;y = 1111.0; z = vechhhh(1);}"],
        );
    }

    #[test]
    fn what_the_program_cuts_off_is_cut_off() {
        check("s = `\n#version 300 es`.trim()", &["#version 300 es"]);
        check("s = `\n#version 300 es`.slice(1)", &["#version 300 es"]);
        check("s = `\n#version 300 es`", &["\n#version 300 es"]);
    }
}
