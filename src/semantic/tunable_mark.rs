//! Comments in which an author gives the range of a number, or says that it is a colour.

use crate::Program;
use shaderlint_text::Span;

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

/// What a comment states about the value before it.
#[derive(Clone, PartialEq, Debug)]
pub struct TunableMark {
    /// Its meaning.
    pub meaning: MarkMeaning,
    /// Span of the mark in the comment.
    pub span: Span,
    /// The comment without the mark: a description.
    pub label: String,
}

/// The meaning of a mark.
#[derive(Clone, PartialEq, Debug)]
pub enum MarkMeaning {
    /// Lower and upper bounds, with one number for all components or one for each.
    Range(Vec<f64>, Vec<f64>),
    /// A colour.
    Color,
    /// On or off.
    Switch,
}

/// The range in a comment after a position on the same line, and the text of that comment.
pub fn range_after(program: &Program, place: Span) -> Option<(TunableRange, &str)> {
    let (comment, text, _) = comment_after(program, place)?;
    let (start, end, min, max) = tilde_range(text)?;
    let range = TunableRange {
        min,
        max,
        span: within(comment, start, end),
        text: text.get(start..end)?.to_string(),
    };
    Some((range, text))
}

/// The mark in a comment after a value on the same line. Only punctuation in `allowed` may be
/// between. `value` has the value's components.
pub(crate) fn mark_after(
    program: &Program,
    place: Span,
    allowed: &[char],
    value: &[f64],
) -> Option<TunableMark> {
    let (comment, text, between) = comment_after(program, place)?;
    if !between
        .trim_matches(|c: char| c.is_whitespace() || allowed.contains(&c))
        .is_empty()
    {
        return None;
    }
    let (start, end, meaning) = find_mark(text, value)?;
    Some(TunableMark {
        meaning,
        span: within(comment, start, end),
        label: label(text, text.get(start..end)?),
    })
}

/// The description in the comment after a value on the same line; empty if there is none.
pub(crate) fn description_after(program: &Program, place: Span, allowed: &[char]) -> String {
    let found = comment_after(program, place).filter(|(_, _, between)| {
        let rest = between.trim_matches(|c: char| c.is_whitespace() || allowed.contains(&c));
        rest.is_empty()
    });
    found.map_or(String::new(), |(_, text, _)| label(text, ""))
}

/// The next comment on the same line: its span, its text, and the text before it.
fn comment_after(program: &Program, place: Span) -> Option<(Span, &str, &str)> {
    let comments = &program.tokens.comments;
    let next = comments.partition_point(|c| c.start < place.end);
    let comment = *comments.get(next)?;
    let between = program.sources.text(Span::new(place.end, comment.start));
    let file_of = |span: Span| program.sources.file_id_at(span.start);
    let text = program.sources.text(comment);
    let is_elsewhere = between.contains(['\n', '\r']) || file_of(place) != file_of(comment);
    (!is_elsewhere && !text.is_empty()).then_some((comment, text, between))
}

fn within(comment: Span, start: usize, end: usize) -> Span {
    Span::new(comment.start + start as u32, comment.start + end as u32)
}

/// Parses the marks of a comment: a range with a tilde, a command of Fragmentarium,
/// a range of VS Code Shader Toy, a colour, or an interval that contains the value.
fn find_mark(text: &str, value: &[f64]) -> Option<(usize, usize, MarkMeaning)> {
    let one = |(start, end, min, max)| (start, end, MarkMeaning::Range(vec![min], vec![max]));
    tilde_range(text)
        .map(one)
        .or_else(|| command(text))
        .or_else(|| in_range(text).map(one))
        .or_else(|| color(text))
        .or_else(|| {
            let (start, end, min, max) = interval(text)?;
            let is_within = value.iter().all(|v| (min..=max).contains(v));
            is_within.then(|| one((start, end, min, max)))
        })
}

/// Parses `(80~400)`, `0.5 ~ 2.0` or `-1~1`: start, end, lower and upper bound.
fn tilde_range(text: &str) -> Option<(usize, usize, f64, f64)> {
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

/// Parses `slider[min, value, max]`, where vectors are in parentheses, `color[...]` and
/// `checkbox[...]`.
fn command(text: &str) -> Option<(usize, usize, MarkMeaning)> {
    let words = ["islider", "slider", "color", "checkbox"];
    let found = words.iter().find_map(|word| {
        let start = text.find(word)?;
        let rest = text.get(start + word.len()..)?;
        let open = rest.trim_start().strip_prefix('[')?;
        let inside = open.get(..open.find(']')?)?;
        let end = text.len() - open.len() + inside.len() + 1;
        Some((*word, start, end, inside))
    });
    let (word, start, end, inside) = found?;
    let meaning = match word {
        "color" => MarkMeaning::Color,
        "checkbox" => MarkMeaning::Switch,
        _ => {
            let parts = top_level(inside);
            let (min, max) = match parts.as_slice() {
                [min, max] | [min, _, max] => (min.clone(), max.clone()),
                _ => return None,
            };
            let is_ordered = min.len() == max.len() && min.iter().zip(&max).all(|(a, b)| a < b);
            if min.is_empty() || !is_ordered {
                return None;
            }
            MarkMeaning::Range(min, max)
        }
    };
    Some((start, end, meaning))
}

/// The numbers between commas; those in parentheses belong together.
fn top_level(text: &str) -> Vec<Vec<f64>> {
    let mut parts = vec![String::new()];
    let mut depth = 0_usize;
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => parts.push(String::new()),
            c => parts.last_mut().into_iter().for_each(|part| part.push(c)),
        }
    }
    let parts: Result<Vec<Vec<f64>>, _> = parts
        .iter()
        .map(|part| part.split(',').map(|n| n.trim().parse()).collect())
        .collect();
    parts.unwrap_or_default()
}

/// Parses `in {0.0, 2.0}` or `in [0.0, 2.0]`.
fn in_range(text: &str) -> Option<(usize, usize, f64, f64)> {
    text.match_indices(['{', '[']).find_map(|(open, _)| {
        let before = text.get(..open)?.trim_end();
        let start = before.strip_suffix("in")?;
        let is_word = !start.ends_with(|c: char| c.is_alphanumeric());
        let (end, min, max) = pair(text, open).filter(|_| is_word)?;
        Some((start.len(), end, min, max))
    })
}

/// Parses `[0, 2]` or `[0..2]`.
fn interval(text: &str) -> Option<(usize, usize, f64, f64)> {
    text.match_indices('[').find_map(|(open, _)| {
        let (end, min, max) = pair(text, open)?;
        Some((open, end, min, max))
    })
}

/// The end of a bracket and the two numbers in it, the smaller one first.
fn pair(text: &str, open: usize) -> Option<(usize, f64, f64)> {
    let rest = text.get(open + 1..)?;
    let close = if text.get(open..)?.starts_with('{') {
        '}'
    } else {
        ']'
    };
    let inside = rest.get(..rest.find(close)?)?;
    let (min, max) = inside.split_once(',').or_else(|| inside.split_once(".."))?;
    let (min, max) = (min.trim().parse().ok()?, max.trim().parse().ok()?);
    (min < max).then_some((open + 1 + inside.len() + 1, min, max))
}

/// Parses `(color)` anywhere, and `color` as the whole comment or before a colon.
fn color(text: &str) -> Option<(usize, usize, MarkMeaning)> {
    let lower = text.to_ascii_lowercase();
    for word in ["(color)", "(colour)"] {
        if let Some(start) = lower.find(word) {
            return Some((start, start + word.len(), MarkMeaning::Color));
        }
    }
    let inside = lower.trim_matches(['/', '*', ' ', '\t']);
    let first = inside.split(':').next().unwrap_or(inside).trim();
    let start = lower.find(first)?;
    matches!(first, "color" | "colour").then_some((start, start + first.len(), MarkMeaning::Color))
}

/// The description in a comment: the words before its mark, or else those after it, without a
/// leading "Tunable" or "Adjustable".
fn label(comment: &str, mark: &str) -> String {
    let text = comment
        .trim_start_matches(['/', '*', '!'])
        .trim_end_matches(['/', '*']);
    let (before, after) = match mark {
        "" => (text, ""),
        mark => text.split_once(mark).unwrap_or((text, "")),
    };
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
    use shaderlint_text::each_case;

    #[test]
    fn marks_are_read_from_comments() {
        each_case(include_str!("marks.txt"), |comment, expected| {
            let found = match comment.strip_prefix("range: ") {
                Some(comment) => tilde_range(comment).map(|(start, end, min, max)| {
                    let text = &comment[start..end];
                    format!("{text} | {min} | {max} | {}", label(comment, text))
                }),
                None => find_mark(comment, &[0.5])
                    .map(|(start, end, meaning)| format!("{} | {meaning:?}", &comment[start..end])),
            };
            assert_eq!(found.as_deref().unwrap_or("none"), expected, "{comment}");
        });
        assert_eq!(label("//! slider[0, 1] of all", "slider[0, 1]"), "of all");
    }
}
