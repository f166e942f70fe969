//! `#define NAME value // description (min~max)`: numbers that an author marked as tunable.

use crate::Program;
use shaderlint_syntax::{MacroId, TokenKind};
use shaderlint_text::Span;

/// A number with the range given by its author.
#[derive(Clone, PartialEq, Debug)]
pub struct Tunable {
    /// The macro that defines it.
    pub definition: MacroId,
    /// Span of the name in the `#define`.
    pub name: Span,
    /// Span of the value, including its sign.
    pub value_span: Span,
    /// Value as written.
    pub value: f64,
    /// Lower bound of the range.
    pub min: f64,
    /// Upper bound of the range.
    pub max: f64,
    /// Span of the range in the comment.
    pub range: Span,
    /// Text of the comment without the range.
    pub label: String,
}

/// The tunable numbers of a shader, in source order.
pub fn tunables(program: &Program) -> Vec<Tunable> {
    let macros = &program.tokens.macros;
    let found = macros.iter().enumerate().filter_map(|(i, definition)| {
        if definition.params.is_some() || definition.name_span.is_empty() {
            return None;
        }
        let (value_span, value) = number(program, i)?;
        let (range, text) = range_after(program, value_span)?;
        Some(Tunable {
            definition: MacroId(i as u32),
            name: definition.name_span,
            value_span,
            value,
            min: range.min,
            max: range.max,
            range: range.span,
            label: label(text, &range.text),
        })
    });
    found.collect()
}

/// Whether a text may contain a tunable number: a cheap test before the full check that
/// [`tunables`] needs.
pub fn may_hold_tunables(text: &str) -> bool {
    text.contains('~')
}

/// The number that is the whole body of a macro.
fn number(program: &Program, definition: usize) -> Option<(Span, f64)> {
    let body = &program.tokens.macros.get(definition)?.body;
    let (sign, number) = match body.as_slice() {
        [one] => (None, one),
        [sign, one] if sign.token.kind == TokenKind::Minus => (Some(sign), one),
        _ => return None,
    };
    let value = match number.token.kind {
        TokenKind::Int => number.token.value as f64,
        // The value as written rather than rounded to 32 bits, because people see it.
        TokenKind::Float => {
            let text = program.sources.text(number.token.span);
            text.trim_end_matches(['f', 'F']).parse().ok()?
        }
        _ => return None,
    };
    Some(match sign {
        Some(sign) => (sign.token.span.to(number.token.span), -value),
        None => (number.token.span, value),
    })
}

/// A numeric range in a comment.
#[derive(Clone, PartialEq, Debug)]
pub struct TunableRange {
    /// Lower bound.
    pub min: f64,
    /// Upper bound.
    pub max: f64,
    /// Span of the range, including its parentheses.
    pub span: Span,
    /// Text of the range.
    pub text: String,
}

/// The range in a comment after a position on the same line, and the text of that comment.
pub fn range_after(program: &Program, place: Span) -> Option<(TunableRange, &str)> {
    let comments = &program.tokens.comments;
    let next = comments.partition_point(|c| c.start < place.end);
    let comment = *comments.get(next)?;
    let between = program.sources.text(Span::new(place.end, comment.start));
    let file_of = |span: Span| program.sources.file_id_at(span.start);
    let is_elsewhere = between.contains(['\n', '\r']) || file_of(place) != file_of(comment);
    if is_elsewhere || program.sources.text(comment).is_empty() {
        return None;
    }
    let text = program.sources.text(comment);
    let (start, end, min, max) = find_range(text)?;
    let start_of = |offset: usize| comment.start + offset as u32;
    let range = TunableRange {
        min,
        max,
        span: Span::new(start_of(start), start_of(end)),
        text: text.get(start..end)?.to_string(),
    };
    Some((range, text))
}

/// Parses `(80~400)`, `0.5 ~ 2.0` or `-1~1`: start, end, lower and upper bound.
fn find_range(text: &str) -> Option<(usize, usize, f64, f64)> {
    let mut from = 0;
    while let Some(tilde) = text.get(from..)?.find('~').map(|i| i + from) {
        from = tilde + 1;
        let (before, after) = (text.get(..tilde)?, text.get(tilde + 1..)?);
        let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e');
        let left = before.trim_end();
        let start = left.rfind(|c: char| !is_part(c)).map_or(0, |i| {
            i + left
                .get(i..)
                .and_then(|r| r.chars().next())
                .map_or(1, char::len_utf8)
        });
        let right = after.trim_start();
        let len = right.find(|c: char| !is_part(c)).unwrap_or(right.len());
        // A full stop after the number ends a sentence.
        let high = right.get(..len)?.trim_end_matches('.');
        let right_end = tilde + 1 + (after.len() - right.len()) + high.len();
        let low = left.get(start..).and_then(|t| t.parse::<f64>().ok());
        let high = high.parse::<f64>().ok();
        let (Some(min), Some(max)) = (low, high) else {
            continue;
        };
        if min >= max {
            continue;
        }
        let opened = text.get(..start)?.ends_with('(');
        let closed = text.get(right_end..)?.starts_with(')');
        let wide = (opened && closed) as usize;
        return Some((start - wide, right_end + wide, min, max));
    }
    None
}

/// The description in a comment: the words before its range, or else those after it, without a
/// leading "Tunable" or "Adjustable".
fn label(comment: &str, range: &str) -> String {
    let text = comment
        .trim_start_matches(['/', '*'])
        .trim_end_matches(['/', '*']);
    let (before, after) = text.split_once(range).unwrap_or((text, ""));
    let tidy = |text: &str| {
        let text = text.trim();
        let rest = text
            .strip_prefix("Tunable")
            .or_else(|| text.strip_prefix("Adjustable"));
        rest.unwrap_or(text)
            .trim_matches([' ', '\t', ':', ',', ';', '.', '(', ')'])
            .to_string()
    };
    let label = tidy(before);
    if label.is_empty() { tidy(after) } else { label }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(comment: &str, expected: Option<(&str, f64, f64, &str)>) {
        let found = find_range(comment).map(|(start, end, min, max)| {
            let text = &comment[start..end];
            (text, min, max, label(comment, text))
        });
        let found = found.as_ref().map(|(t, a, b, l)| (*t, *a, *b, l.as_str()));
        assert_eq!(found, expected);
    }

    #[test]
    fn ranges_are_read_from_comments() {
        check(
            "// Ray march step count (80~400)",
            Some(("(80~400)", 80.0, 400.0, "Ray march step count")),
        );
        check(
            "// Adjustable: max step count, 64~256, more = slower",
            Some(("64~256", 64.0, 256.0, "max step count")),
        );
        check("// z=1.0 gives ~90 degrees", None);
        check("// -1.5 ~ 1.5.", Some(("-1.5 ~ 1.5", -1.5, 1.5, "")));
        check("// 3~1", None);
    }
}
