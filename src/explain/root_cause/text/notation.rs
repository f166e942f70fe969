//! Notations of mathematics and of other languages: `x²`, `45°`, `50%`, `1.0.0`, `"0.5"`,
//! `1.0 if c else 0.0`.

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_syntax::{RawKind, TokenKind};

/// Letters of mathematics with their values.
const LETTERS: &[(&str, &str)] = &[
    ("π", "3.14159265"),
    ("τ", "6.28318531"),
    ("½", "0.5"),
    ("¼", "0.25"),
    ("¾", "0.75"),
    ("∞", "1e30"),
];
/// Exponents.
const POWERS: &[(char, u32)] = &[('²', 2), ('³', 3)];

impl FaultyShader<'_> {
    pub(super) fn notations(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        for at in 0..line.tokens.len() {
            all.extend(self.letter(line, at));
            all.extend(self.power(line, at));
            all.extend(self.degrees(line, at));
            all.extend(self.percent(line, at));
            all.extend(self.quoted_number(line, at));
            all.extend(self.hex_color(line, at));
            self.joined_number(line, at, all);
        }
        all.extend(self.inline_if(line));
    }

    /// `π`
    fn letter(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let text = line.token(at);
        let (_, value) = LETTERS.iter().find(|(letter, _)| *letter == text)?;
        let message = format!("unexpected character `{text}`; use `{value}`");
        let kind = error::INVALID_CHARACTER;
        Some(replacement(kind, line.span(at), message, value.to_string()))
    }

    /// `x²`: the name and the exponent are one word.
    fn power(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let text = line.token(at);
        let mut powers = POWERS.iter();
        let (base, c, n) = powers.find_map(|&(c, n)| Some((text.strip_suffix(c)?, c, n)))?;
        let is_name = base.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        // `(a + b)²` repeats no text.
        if base.is_empty() || !is_name {
            return None;
        }
        let product = vec![base; n as usize].join(" * ");
        let message = format!("unexpected character `{c}`; GLSL has no exponents");
        let (kind, text) = (error::INVALID_CHARACTER, format!("({product})"));
        Some(replacement(kind, line.span(at), message, text))
    }

    /// `45°`
    fn degrees(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_number = |i: usize| matches!(line.kind(i), Some(RawKind::Integer | RawKind::Float));
        if line.token(at + 1) != "°" || !is_number(at) || !line.touches_next(at) {
            return None;
        }
        let text = format!("radians({})", decimal(line.token(at)));
        let span = line.span(at).to(line.span(at + 1));
        let message = "unexpected character `°`; GLSL measures angles in radians";
        Some(replacement(error::INVALID_CHARACTER, span, message, text))
    }

    /// `50%`
    fn percent(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_number = matches!(line.kind(at), Some(RawKind::Integer | RawKind::Float));
        let is_last = !matches!(
            line.kind(at + 2),
            Some(
                RawKind::Word
                    | RawKind::Integer
                    | RawKind::Float
                    | RawKind::Operator(TokenKind::LeftParen)
            )
        );
        let value = line.token(at).parse::<f64>();
        let (true, true, Ok(value)) = (
            is_number && line.is(at + 1, TokenKind::Percent),
            is_last,
            value,
        ) else {
            return None;
        };
        let text = format!("{:?}", value / 100.0);
        let span = line.span(at).to(line.span(at + 1));
        let message = "GLSL has no percentages";
        Some(replacement(error::FOREIGN_SYNTAX, span, message, text))
    }

    /// `"0.5"`, in any quotation marks.
    fn quoted_number(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let quote = |i: usize| matches!(line.token(i), "\"" | "'" | "“" | "”" | "‘" | "’" | "`");
        let is_number = |i: usize| matches!(line.kind(i), Some(RawKind::Integer | RawKind::Float));
        let (span, text) = if quote(at) && is_number(at + 1) && quote(at + 2) {
            let span = line.span(at).to(line.span(at + 2));
            (span, line.token(at + 1))
        } else {
            let whole = line.token(at).strip_prefix('"');
            match whole.and_then(|t| t.strip_suffix('"')) {
                Some(number) if number.parse::<f32>().is_ok() => (line.span(at), number),
                _ => return None,
            }
        };
        let message = "unexpected quotation marks around a number";
        let kind = error::INVALID_CHARACTER;
        Some(replacement(kind, span, message, text.to_string()))
    }

    /// `#ff8800` as a color.
    fn hex_color(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        if line.kind(at) != Some(RawKind::Hash) || at == 0 {
            return None;
        }
        let start = line.span(at).end;
        let from = (start - line.start) as usize;
        let rest = line.text.get(from..).unwrap_or("");
        let len = rest
            .find(|c: char| !c.is_ascii_hexdigit())
            .unwrap_or(rest.len());
        let digits = rest.get(..len).unwrap_or("");
        let each = match len {
            3 => 1,
            6 => 2,
            _ => return None,
        };
        let channel = |i: usize| {
            let text = digits.get(i * each..(i + 1) * each)?;
            let value = u32::from_str_radix(text, 16).ok()?;
            let most = if each == 1 { 15.0 } else { 255.0 };
            Some(format!(
                "{:?}",
                (f64::from(value) / most * 1000.0).round() / 1000.0
            ))
        };
        let (r, g, b) = (channel(0)?, channel(1)?, channel(2)?);
        let span = Span::new(line.span(at).start, start + len as u32);
        let text = format!("vec3({r}, {g}, {b})");
        let message = format!("GLSL has no colors such as `#{digits}`");
        Some(replacement(error::FOREIGN_SYNTAX, span, message, text))
    }

    /// `1.0.0`, `0..5`, `2.0x`, `0.0. 0.5`: a number with a part too many, or with what follows it.
    fn joined_number(&self, line: &FaultyLine, at: usize, all: &mut Vec<RepairCandidate>) {
        if line.kind(at) != Some(RawKind::BadNumber) {
            return;
        }
        let (span, text) = (line.span(at), line.token(at));
        let kind = error::INVALID_NUMBER;
        let message = format!("invalid number `{text}`");
        let is_number = |i: usize| matches!(line.kind(i), Some(RawKind::Integer | RawKind::Float));
        if let Some(number) = text.strip_suffix('.').filter(|n| n.contains('.'))
            && is_number(at + 1)
        {
            let dot = Span::new(span.end - 1, span.end);
            let edits = vec![Edit::replace(dot, ",")];
            let message = "expected `,` between the numbers, found `.`";
            let title = format!("use `{number},`");
            all.push(candidate(kind, span, message, title, edits));
        }
        let cut = text
            .strip_suffix(['e', 'E'])
            .filter(|n| n.parse::<f64>().is_ok());
        for number in one_point(text).into_iter().chain(cut.map(decimal)) {
            all.push(replacement(kind, span, message.clone(), number));
        }
        let digits = text
            .find(|c: char| !c.is_ascii_digit() && c != '.')
            .unwrap_or(text.len());
        let (number, rest) = text.split_at_checked(digits).unwrap_or((text, ""));
        let is_name =
            rest.len() > 1 || matches!(rest, "x" | "y" | "z" | "w" | "t" | "p" | "r" | "s");
        // After a type it is a name that starts with a digit.
        let is_named = at > 0 && line.kind(at - 1) == Some(RawKind::Word);
        if is_name
            && !is_named
            && number.contains(|c: char| c.is_ascii_digit())
            && !rest.contains("..")
        {
            let place = span.start + digits as u32;
            let edits = vec![Edit::insert(place, " * ")];
            let title = format!("use `{number} * {rest}`");
            let message = format!("missing operator between `{number}` and `{rest}`");
            all.push(syntax(span, message, title, edits));
        }
    }

    /// `1.0 if c else 0.0` and `if (c) 1.0 else 0.0` as values.
    fn inline_if(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let find =
            |word: &str, from: usize| (from..line.tokens.len()).find(|&i| line.token(i) == word);
        let condition = find("if", 1)?;
        let other = find("else", condition + 1)?;
        let end = (other + 1..line.tokens.len()).find(|&i| line.is(i, TokenKind::Semicolon))?;
        let text = |from: usize, to: usize| {
            let last = line.span(to.saturating_sub(1)).end;
            line.of(Span::new(line.span(from).start, last)).trim()
        };
        let (start, c, yes) = match line.is(condition - 1, TokenKind::Equal)
            || line.token(condition - 1) == "return"
        {
            true => match line.after(condition + 1) {
                Some(after) if after < other => {
                    (condition, text(condition + 1, after), text(after, other))
                }
                _ => return None,
            },
            false => {
                let starts =
                    |&i: &usize| line.is(i - 1, TokenKind::Equal) || line.token(i - 1) == "return";
                let start = (1..condition).rev().find(starts)?;
                (start, text(condition + 1, other), text(start, condition))
            }
        };
        let span = line.span(start).to(line.span(end - 1));
        let value = format!("{c} ? {yes} : {}", text(other + 1, end));
        let message = "`if` is a statement and has no value; use `c ? a : b`";
        Some(replacement(error::FOREIGN_SYNTAX, span, message, value))
    }
}

/// A number with a decimal point.
fn decimal(number: &str) -> String {
    match number.contains('.') {
        true => number.to_string(),
        false => format!("{number}.0"),
    }
}

/// The numbers with one decimal point that a number with several may have been.
fn one_point(text: &str) -> Vec<String> {
    let parts: Vec<&str> = text.split('.').collect();
    let is_digits = |p: &&str| p.chars().all(|c| c.is_ascii_digit());
    if parts.len() < 3 || !parts.iter().all(is_digits) {
        return Vec::new();
    }
    let filled: Vec<&str> = parts.iter().copied().filter(|p| !p.is_empty()).collect();
    match filled[..] {
        [only] if text.starts_with('.') => vec![format!("0.{only}")],
        [only] => vec![format!("{only}.0")],
        [whole, rest, ..] => vec![format!("{whole}.{rest}")],
        [] => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_of_several_decimal_points_is_kept() {
        for (text, expected) in [
            ("1.0.0", "1.0"),
            ("1..0", "1.0"),
            ("0..5", "0.5"),
            ("1..", "1.0"),
            (".5.", "0.5"),
            ("..25", "0.25"),
        ] {
            assert_eq!(one_point(text), [expected], "{text}");
        }
        assert!(one_point("1.0").is_empty() && one_point("1.x.0").is_empty());
    }
}
