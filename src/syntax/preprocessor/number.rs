//! Values of number literals, and fixes for invalid ones (GLSL ES 3.00 sections 4.1.3 and 4.1.4).

use super::{Preprocessor, error_at};
use crate::token::{Token, TokenKind};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_text::Edit;

/// Kind and value of an integer; `None` if it does not fit in 32 bits.
pub(super) fn integer(text: &str) -> Option<(TokenKind, u32)> {
    let (kind, digits) = match text.strip_suffix(['u', 'U']) {
        Some(digits) => (TokenKind::Uint, digits),
        None => (TokenKind::Int, text),
    };
    let value = match digits.as_bytes() {
        [digit @ b'0'..=b'9'] => Ok(u32::from(digit - b'0')),
        [b'0', b'x' | b'X', ..] => u32::from_str_radix(digits.get(2..)?, 16),
        [b'0', ..] => u32::from_str_radix(digits, 8),
        _ => digits.parse(),
    };
    value.ok().map(|v| (kind, v))
}

/// Value of a float literal; clamped to the largest finite float.
pub(super) fn float(text: &str) -> f32 {
    let digits = text.strip_suffix(['f', 'F']).unwrap_or(text);
    let short = short_decimal(digits.as_bytes());
    short.unwrap_or_else(|| digits.parse::<f32>().map_or(0.0, |v| v.min(f32::MAX)))
}

/// Fast path for short decimals: digits and power of ten are exact, so one division rounds
/// correctly.
fn short_decimal(digits: &[u8]) -> Option<f32> {
    const POWERS: [f32; 8] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7];
    if digits.len() > POWERS.len() {
        return None;
    }
    let mut whole: u32 = 0;
    let mut after_point = None;
    for &byte in digits {
        match byte {
            b'0'..=b'9' => {
                whole = whole * 10 + u32::from(byte - b'0');
                after_point = after_point.map(|n| n + 1);
            }
            b'.' => after_point = Some(0),
            _ => return None,
        }
    }
    let power = POWERS.get(after_point.unwrap_or(0))?;
    // A float represents integers of up to 24 bits exactly.
    (whole < 1 << 24).then_some(whole as f32 / power)
}

/// The error for text that starts like a number.
pub(super) fn bad_number(token: &Token, text: &str) -> Diagnostic {
    let d = error_at(
        error::INVALID_NUMBER,
        token.span,
        format!("invalid number `{text}`"),
    );
    let lower = text.to_ascii_lowercase();
    let digits = lower.trim_end_matches(['f', 'l']);
    let is_int = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    if lower.ends_with('f') && is_int {
        let fixed = format!("{digits}.0");
        return d
            .note("the suffix `f` requires a decimal point or an exponent: `1.0f`, `1.f`")
            .fix(Fix::safe_replacement(token.span, fixed));
    }
    if lower.ends_with('l') && is_int {
        return d
            .note("GLSL has no long integers and no suffix `l`")
            .fix(Fix::safe_replacement(token.span, digits.to_string()));
    }
    if let Some(number) = foreign_number(&lower) {
        return d
            .note(number.1)
            .fix(Fix::safe_replacement(token.span, number.0));
    }
    if lower.starts_with('0') && lower.bytes().all(|b| b.is_ascii_digit()) {
        let fixed = lower.trim_start_matches('0').to_string();
        return d
            .note("an integer with a leading 0 is octal, with digits from 0 to 7")
            .fix(Fix::suggested_replacement(token.span, fixed));
    }
    d
}

impl Preprocessor<'_> {
    /// A name that starts with a digit: no number follows a type. It is reported where it is declared,
    /// with all its uses.
    pub(super) fn numbered_name(&mut self, token: &Token, text: &str) -> Option<Token> {
        let is_word = text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        if !is_word || !token.is_direct() || token.span.len() as usize != text.len() {
            return None;
        }
        let name = self.names.intern(text);
        let declared = self.numbered_names.get(&name);
        if let Some(fix) = declared.and_then(|at| self.diagnostics.get_mut(*at)?.fix.as_mut()) {
            let to = fix.edits.first().map_or(String::new(), |e| e.text.clone());
            fix.edits.push(Edit::replace(token.span, to));
        } else {
            let last = self.out.tokens.last()?;
            if last.kind != TokenKind::Type {
                return None;
            }
            let free = self.names.unused(&format!("_{text}"));
            let edits = vec![Edit::replace(token.span, free.clone())];
            let message = format!("name `{text}` starts with a digit");
            let d = error_at(error::INVALID_NUMBER, token.span, message)
                .note("a name starts with a letter or `_` (section 3.9)")
                .fix(Fix::safe(format!("rename it to `{free}`"), edits));
            self.numbered_names.insert(name, self.diagnostics.len());
            self.report(d);
        }
        Some(Token {
            kind: TokenKind::Identifier,
            value: name.0,
            ..*token
        })
    }
}

/// Converts a number literal of another language to GLSL, with a note about the difference.
fn foreign_number(lower: &str) -> Option<(String, &'static str)> {
    if let Some(bits) = lower.strip_prefix("0b") {
        let value = u32::from_str_radix(&bits.replace('_', ""), 2).ok()?;
        return Some((format!("0x{value:X}"), "GLSL has no binary literals"));
    }
    let plain = lower.replace(['_', '\''], "");
    let digits = plain.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let suffix = plain.get(digits.len()..)?;
    let is_float = digits.contains('.') && digits.parse::<f32>().is_ok();
    let is_int = digits.parse::<u32>().is_ok() && (digits == "0" || !digits.starts_with('0'));
    Some(match suffix {
        "" | "f" if is_float && plain != lower => (plain, "GLSL has no digit separators"),
        "" | "u" if is_int && plain != lower => (plain, "GLSL has no digit separators"),
        "h" | "d" | "lf" | "l" | "m" | "f16" | "f32" | "f64" if is_float => (
            digits.to_string(),
            "a number with a decimal point is a `float`",
        ),
        "h" | "d" | "lf" | "m" | "f16" | "f32" | "f64" if is_int => {
            (format!("{digits}.0"), "a `float` needs a decimal point")
        }
        "i" | "s" | "i32" | "i64" | "ll" if is_int => {
            (digits.to_string(), "GLSL has no such number suffix")
        }
        "ul" | "ull" | "u32" | "u64" if is_int => {
            (format!("{digits}u"), "the only integer suffix is `u`")
        }
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_numbers_equal_those_of_the_standard_parser() {
        for text in [
            "0.1", ".5", "5.", "16777215", "1.234567", "0.000001", "3.14159", "99999.99",
        ] {
            let short = short_decimal(text.as_bytes());
            assert_eq!(short, text.parse().ok(), "{text}");
        }
        for text in ["1e3", "123456789", "1.2345678"] {
            assert_eq!(short_decimal(text.as_bytes()), None, "{text}");
        }
        assert_eq!(integer("017u"), Some((TokenKind::Uint, 15)));
        assert_eq!(integer("0xFFFFFFFF"), Some((TokenKind::Int, u32::MAX)));
        assert_eq!(integer("4294967296"), None);
    }
}
