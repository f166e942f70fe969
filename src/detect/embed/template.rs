//! Placeholders of template languages in shaders: `${x}`, `{{ x }}`, `{x}`, `[[x]]`, `<%= x %>`,
//! `{% if x %}`, `@X@`, `##X##`, `#{x}`, `%s`, `$x`, `$(x)` and `__X__`.

use super::hole::{Hole, HoleContent, is_keyword};
use std::collections::HashSet;
use std::ops::Range;

/// Maximum length of a hole in bytes.
const MAX_HOLE: usize = 1_000;

/// The holes in a text, in source order. Anything that may be GLSL is not a hole.
pub(super) fn holes(code: &str) -> Vec<Hole> {
    let marks = [
        "$", "{{", "{%", "{#", "<%", "@", "%", "__", "[[", "##", "#{",
    ];
    let is_candidate =
        marks.iter().any(|m| code.contains(m)) || has_braced(code) || has_lines(code);
    if !is_candidate {
        return Vec::new();
    }
    let mut scan = TemplateScan {
        code,
        known: defined(code),
        last: None,
        before_last: None,
        in_list: false,
        is_uniform: false,
        depth: 0,
        found: Vec::new(),
    };
    scan.run();
    scan.found
}

/// Whether a line imports a file, or initialises a uniform after a colon.
fn has_lines(code: &str) -> bool {
    let is_one = |line: &str| {
        let line = line.trim_start();
        line.starts_with("import") || line.contains(':') && !line.contains('?')
    };
    (code.contains("import") || code.contains(':')) && code.lines().any(is_one)
}

/// Whether a word is in braces without blanks.
fn has_braced(code: &str) -> bool {
    code.match_indices('{').any(|(at, _)| {
        let rest = code.get(at + 1..).unwrap_or("");
        let word = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_' && c != '-');
        word.is_some_and(|w| w > 0 && rest.get(w..).is_some_and(|r| r.starts_with(['}', '{'])))
    })
}

/// The words in directives, which are macros and not holes.
fn defined(code: &str) -> HashSet<&str> {
    let lines = code.lines().map(str::trim_start);
    let directives = lines.filter_map(|l| l.strip_prefix('#'));
    let directives = directives.filter(|d| !d.trim_start().starts_with("include"));
    let words = directives.map(|d| {
        let rest = d.trim_start();
        let is_test = rest.starts_with("if") || rest.starts_with("elif");
        // The replacement of a macro may be a hole.
        let count = if is_test { usize::MAX } else { 2 };
        let split = rest.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        split.filter(|w| !w.is_empty()).take(count)
    });
    words.flatten().collect()
}

struct TemplateScan<'a> {
    code: &'a str,
    /// Names of macros.
    known: HashSet<&'a str>,
    /// Range of the last token.
    last: Option<Range<usize>>,
    /// Range of the token before it.
    before_last: Option<Range<usize>>,
    /// Whether an initialiser list is open.
    in_list: bool,
    /// Whether the declaration of a uniform or a uniform block is open.
    is_uniform: bool,
    /// Number of open braces.
    depth: u32,
    found: Vec<Hole>,
}

impl<'a> TemplateScan<'a> {
    fn run(&mut self) {
        let bytes = self.code.as_bytes();
        let mut at = 0;
        while let Some(&byte) = bytes.get(at) {
            let rest = self.code.get(at..).unwrap_or("");
            if rest.starts_with("//") {
                at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                let end = rest.get(2..).and_then(|r| r.find("*/"));
                at += end.map_or(rest.len(), |e| e + 4);
            } else if let Some((length, content)) = self.hole(at, rest) {
                self.found.push(Hole {
                    range: at..at + length,
                    content,
                    inserted: None,
                });
                self.passed(at..at + length);
                at += length;
            } else if is_word(byte) {
                let length = word(rest).len();
                self.is_uniform |= self.depth == 0 && word(rest) == "uniform";
                self.passed(at..at + length);
                at += length;
            } else {
                if !byte.is_ascii_whitespace() {
                    match byte {
                        b'{' => {
                            self.in_list |= self.text(&self.last) == "=";
                            self.depth += 1;
                        }
                        b'}' => self.depth = self.depth.saturating_sub(1),
                        b';' => {
                            self.in_list = false;
                            self.is_uniform &= self.depth > 0;
                        }
                        _ => {}
                    }
                    self.passed(at..at + 1);
                }
                at += 1;
            }
        }
    }

    fn passed(&mut self, token: Range<usize>) {
        self.before_last = self.last.replace(token);
    }

    fn text(&self, token: &Option<Range<usize>>) -> &'a str {
        let range = token.clone().unwrap_or(0..0);
        self.code.get(range).unwrap_or("")
    }

    /// The hole that starts here: its length and content.
    fn hole(&self, at: usize, rest: &str) -> Option<(usize, HoleContent)> {
        let end = (0..=rest.len().min(MAX_HOLE)).rev();
        let end = end.into_iter().find(|end| rest.is_char_boundary(*end));
        let rest = rest.get(..end.unwrap_or(0)).unwrap_or("");
        match rest.as_bytes().first()? {
            b'$' => dollar(rest),
            b'#' if rest.starts_with("#{") => {
                let name = rest.get(2..rest.find('}')?)?;
                let is_hole = !name.is_empty() && word(name) == name;
                is_hole.then(|| (name.len() + 3, expression(name)))
            }
            b'#' => {
                let name = word(rest.strip_prefix("##")?);
                let is_closed = rest.get(name.len() + 2..)?.starts_with("##");
                let before = at.checked_sub(1).and_then(|b| self.code.as_bytes().get(b));
                let is_apart = !before.is_some_and(|b| is_word(*b));
                let is_hole = is_apart && is_closed && !name.is_empty();
                is_hole.then(|| (name.len() + 4, expression(name)))
            }
            b'{' => self.braces(at, rest),
            b'<' => {
                let inner = rest.strip_prefix("<%")?;
                let end = inner.find("%>")?;
                let inner = inner.get(..end)?;
                let content = match inner.strip_prefix(['=', '-']) {
                    Some(value) => expression(value.trim_end_matches('-')),
                    None => HoleContent::Nothing,
                };
                Some((end + 4, content))
            }
            b'@' => {
                let name = rest.trim_start_matches('@');
                let marks = rest.len() - name.len();
                let name = word(name);
                let closed = rest.get(marks + name.len()..)?.starts_with('@');
                let is_hole = !name.is_empty() && (marks == 2 || marks == 1 && closed);
                let length = marks + name.len() + usize::from(closed);
                is_hole.then(|| (length, expression(name)))
            }
            b'%' => self.percent(rest),
            b':' => self.annotation(rest),
            b'i' => self.import(rest),
            b'[' => {
                // Nothing else is on the line.
                let line = rest.split('\n').next()?.trim_end();
                let name = line.strip_prefix("[[")?.strip_suffix("]]")?;
                let before = self.code.get(..at)?.trim_end_matches([' ', '\t']);
                let is_first = before.is_empty() || before.ends_with('\n');
                let is_hole = is_first && word(name.trim()) == name.trim();
                is_hole.then(|| (line.len(), expression(name)))
            }
            b'_' => {
                let name = word(rest);
                let inner = name.strip_prefix("__")?.strip_suffix("__")?;
                let is_shout = |b: u8| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_';
                let is_named = !inner.is_empty() && inner.bytes().all(is_shout);
                let is_own = matches!(name, "__LINE__" | "__FILE__" | "__VERSION__");
                let is_hole = is_named && !is_own && !self.known.contains(name);
                is_hole.then(|| (name.len(), expression(name)))
            }
            _ => None,
        }
    }

    /// `{{ x }}`, `{% ... %}`, `{# ... #}`, `{x}`.
    fn braces(&self, at: usize, rest: &str) -> Option<(usize, HoleContent)> {
        let line = rest.split('\n').next().unwrap_or("");
        let closed = |text: &str, close: &str| text.get(2..)?.find(close);
        if rest.starts_with("{%") {
            return Some((closed(rest, "%}")? + 4, HoleContent::Nothing));
        }
        if rest.starts_with("{#") {
            return Some((closed(line, "#}")? + 4, HoleContent::Nothing));
        }
        if rest.starts_with("{{{") {
            let inner = line.get(3..line.find("}}}")?)?;
            return is_expression(inner).then(|| (inner.len() + 6, expression(inner)));
        }
        if let Some(end) = line.starts_with("{{").then(|| line.find("}}")).flatten() {
            let inner = line.get(2..end)?;
            let is_mark = inner
                .trim_start()
                .starts_with(['#', '/', '!', '>', '^', '=']);
            if is_mark || inner.trim() == "else" {
                return Some((end + 2, HoleContent::Nothing));
            }
            let is_hole = is_expression(inner) && !self.known.contains(inner.trim());
            return is_hole.then(|| (end + 2, expression(inner)));
        }
        self.brace(at, line)
    }

    /// `{x}` without blanks; in GLSL this is a block only if `x` is a macro.
    fn brace(&self, at: usize, line: &str) -> Option<(usize, HoleContent)> {
        let Some(length) = braced(line) else {
            return self.dashed(line);
        };
        let inner = line.get(1..length - 1)?;
        let next = line.get(length..)?.trim_start();
        let touches = at.checked_sub(1).and_then(|b| self.code.as_bytes().get(b));
        let touches = touches.is_some_and(|b| is_word(*b));
        let owner = matches!(self.text(&self.before_last), "struct" | "uniform");
        let last = self.text(&self.last);
        let is_block = matches!(last, ")" | "else" | "do" | "]") || (touches && owner);
        let is_list = self.in_list || last == "=" && next.starts_with([';', ',', '}']);
        let is_hole = !is_block && !is_list && !self.known.contains(inner);
        is_hole.then(|| (length, expression(inner)))
    }

    /// `{no-repeat}` as an operand.
    fn dashed(&self, line: &str) -> Option<(usize, HoleContent)> {
        let end = line.find('}')?;
        let inner = line.get(1..end)?;
        let is_dashed = inner.starts_with(|c: char| c.is_ascii_alphabetic())
            && inner.contains('-')
            && inner.bytes().all(|b| is_word(b) || b == b'-');
        let is_operand = matches!(self.text(&self.last), "=" | "(" | "<" | ">" | "&" | "|");
        (is_dashed && is_operand).then(|| (end + 1, expression(inner)))
    }

    /// `%s`, `%NAME%` and `%(name)s`, where `%` cannot be an operator.
    fn percent(&self, rest: &str) -> Option<(usize, HoleContent)> {
        let last = self.text(&self.last);
        let line_start = self.last.as_ref().is_none_or(|l| l.end == 0);
        let is_operand = match last.bytes().next_back() {
            None => false,
            // The letter of a format may also be part of the next word.
            Some(byte) if is_word(byte) => {
                let is_macro = self.text(&self.before_last) == "define";
                !is_macro && !is_keyword(last)
            }
            Some(byte) => matches!(byte, b')' | b']' | b'%' | b'}') && !self.ends_statement(byte),
        };
        if is_operand && !line_start {
            return None;
        }
        let inner = rest.get(1..)?;
        if let Some(doubled) = inner.strip_prefix('%') {
            let name = word(doubled);
            let is_closed = doubled.get(name.len()..)?.starts_with("%%");
            return (is_closed && !name.is_empty()).then(|| (name.len() + 4, expression(name)));
        }
        if let Some(named) = inner.strip_prefix('(') {
            let name = word(named);
            let after = named.get(name.len()..)?.strip_prefix(')')?;
            let is_format = after.starts_with(['s', 'd', 'f', 'i', 'g']);
            return (is_format && !name.is_empty()).then(|| (name.len() + 4, expression(name)));
        }
        let name = word(inner);
        if !name.is_empty() && inner.get(name.len()..)?.starts_with('%') {
            return Some((name.len() + 2, expression(name)));
        }
        let digits = inner.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let format = inner.get(digits..)?;
        let is_format = format.starts_with(['s', 'd', 'f', 'i', 'g', 'u', 'x'])
            && !format
                .get(1..)?
                .starts_with(|c: char| c.is_ascii() && is_word(c as u8));
        let number = self.found.len();
        is_format.then(|| (digits + 2, HoleContent::Expression(format!("%{number}"))))
    }

    /// The initial value of a uniform, as some libraries write it: `uniform float x : 1.0;`.
    fn annotation(&self, rest: &str) -> Option<(usize, HoleContent)> {
        let line = rest.split(['\n', ';']).next()?;
        let is_line = rest.get(line.len()..)?.starts_with(';');
        let value = line.get(1..)?.trim();
        let is_number = |c: char| c.is_ascii_digit() || matches!(c, '[' | '-' | '.');
        let is_value = value.starts_with(is_number) || matches!(value, "true" | "false");
        let is_name = self.text(&self.last).bytes().all(is_word);
        let is_declared = self.text(&self.before_last).bytes().all(is_word);
        let may_be = is_line && is_value && is_name && is_declared && !self.in_list;
        (may_be && self.is_uniform).then_some((line.len(), HoleContent::Nothing))
    }

    /// `import 'file.glsl'`, alone on its line.
    fn import(&self, rest: &str) -> Option<(usize, HoleContent)> {
        let path = rest.strip_prefix("import")?;
        let line = rest.split('\n').next()?.trim_end();
        let path = path.split('\n').next()?.trim().trim_end_matches(';');
        let is_path =
            path.len() > 2 && path.starts_with(['"', '\'']) && path.ends_with(['"', '\'']);
        // `#pragma import "path"` is a directive.
        let is_pragma = self.text(&self.last) == "pragma";
        (is_path && !is_pragma).then_some((line.len(), HoleContent::Nothing))
    }

    /// Whether a brace closes a block, after which no operator can follow.
    fn ends_statement(&self, byte: u8) -> bool {
        byte == b'}' && self.last.as_ref().is_some_and(|l| l.len() == 1)
    }
}

fn expression(text: &str) -> HoleContent {
    HoleContent::Expression(text.trim().to_string())
}

/// `${x}`, `$(x)`, `$(x)s`, `$x` and `$x$`; `$` is not a GLSL character.
fn dollar(rest: &str) -> Option<(usize, HoleContent)> {
    /// Maximum length of an expression in bytes.
    const MAX: usize = 2000;
    if let Some(inner) = rest.strip_prefix("${") {
        let mut depth = 1_u32;
        let end = inner.bytes().take(MAX).position(|b| {
            match b {
                b'{' => depth += 1,
                b'}' => depth -= 1,
                _ => {}
            }
            depth == 0
        })?;
        return Some((end + 3, expression(inner.get(..end)?)));
    }
    if let Some(inner) = rest.strip_prefix("$(") {
        let end = inner.split('\n').next()?.find(')')?;
        let after = inner.get(end + 1..)?;
        let format = after.starts_with('s') && word(after) == "s";
        let is_named = end > 0 && !inner.get(..end)?.contains('(');
        return is_named.then(|| (end + 3 + usize::from(format), expression(inner)));
    }
    let name = rest.trim_start_matches('$');
    let marks = rest.len() - name.len();
    let name = word(name);
    if !name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        return None;
    }
    let after = rest.get(marks + name.len()..)?;
    let closing = after.len() - after.trim_start_matches('$').len();
    Some((marks + name.len() + closing, expression(name)))
}

/// Length of a word in braces, which may be nested: `{A_{i}}`.
fn braced(line: &str) -> Option<usize> {
    let mut depth = 0_u32;
    for (at, byte) in line.bytes().enumerate() {
        match byte {
            b'{' => depth += 1,
            b'}' if depth == 1 => return (at > 1).then_some(at + 1),
            b'}' => depth -= 1,
            b'.' if depth > 0 && at > 1 => {}
            _ if is_word(byte) && (at > 1 || !byte.is_ascii_digit()) => {}
            _ => return None,
        }
    }
    None
}

/// Whether the text in braces is an expression: it contains no complete statement or block.
fn is_expression(inner: &str) -> bool {
    let is_bad = |c: char| matches!(c, ';' | '{' | '}' | '=' | '\n');
    let start = inner.trim().chars().next();
    let starts =
        |c: char| c.is_ascii_alphabetic() || matches!(c, '_' | '$' | '&' | '@' | '~' | '"');
    start.is_some_and(starts) && !inner.contains(is_bad)
}

fn word(text: &str) -> &str {
    let end = text.bytes().position(|b| !is_word(b));
    text.get(..end.unwrap_or(text.len())).unwrap_or("")
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the holes of a text with their contents.
    #[track_caller]
    fn check(text: &str, expected: &str) {
        let all = holes(text);
        let reported = all.iter().map(|h| match &h.content {
            HoleContent::Expression(key) => format!("{}={key}", &text[h.range.clone()]),
            _ => text[h.range.clone()].to_string(),
        });
        assert_eq!(reported.collect::<Vec<_>>().join(" | "), expected, "{text}");
    }

    #[test]
    fn template_syntaxes_are_recognised() {
        let cases = include_str!("templates.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (text, expected) = case.split_once(" ⇒ ").unwrap();
            check(&text.replace('↵', "\n"), &expected.replace('↵', "\n"));
        }
    }
}
