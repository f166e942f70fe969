//! Fixes are written as the file is: `.5` where it has no `0.5`, `1.` where it has no `1.0`, `d=e` where no
//! `=` has blanks.

use super::stage::FileCheck;
use shaderlint_detect::kind::FileKind;
use shaderlint_syntax::{RawKind, RawToken, TokenKind, tokenize};

/// Longest text whose style is read, in bytes.
const MAX_TEXT: usize = 100_000;

/// How a text writes numbers and assignments.
#[derive(Clone, Copy, PartialEq, Eq)]
struct WrittenStyle {
    /// `.5`
    is_bare: bool,
    /// `1.`
    is_open: bool,
    /// `d=e`
    is_tight: bool,
}

/// Writes the fixes in the style of the file.
pub fn apply(file: &mut FileCheck) {
    let report = &mut file.report;
    let own = report.file.and_then(|id| report.sources.file(id));
    let is_shader = file.kind == FileKind::Shader;
    let has_fix = is_shader && report.diagnostics.iter().any(|d| d.fix.is_some());
    let Some(own) = own.filter(|own| has_fix && own.text.len() <= MAX_TEXT) else {
        return;
    };
    let style = WrittenStyle::of(&own.text);
    if !(style.is_bare || style.is_open || style.is_tight) {
        return;
    }
    for fix in report.diagnostics.iter_mut().filter_map(|d| d.fix.as_mut()) {
        for edit in &mut fix.edits {
            edit.text = style.write(&edit.text);
        }
    }
}

impl WrittenStyle {
    fn of(text: &str) -> WrittenStyle {
        let tokens = tokenize(text, 0);
        let floats = tokens.iter().filter(|t| t.kind == RawKind::Float);
        let floats: Vec<&str> = floats.map(|t| of(text, t)).collect();
        let prefers = |short: fn(&str) -> bool, long: fn(&str) -> bool| {
            floats.iter().any(|n| short(n)) && !floats.iter().any(|n| long(n))
        };
        let is_blank = |at: usize| {
            tokens
                .get(at)
                .is_some_and(|t| t.kind == RawKind::Whitespace)
        };
        let equals = (0..tokens.len()).filter(|&at| is_equal(tokens.get(at)));
        let mut spaced = equals.map(|at| is_blank(at + 1)).peekable();
        WrittenStyle {
            is_bare: prefers(
                |n| n.starts_with('.'),
                |n| n.starts_with("0.") && n != "0." && n != "0.0",
            ),
            is_open: prefers(|n| n.ends_with('.'), |n| n.ends_with(".0")),
            is_tight: spaced.peek().is_some() && !spaced.any(|is_spaced| is_spaced),
        }
    }

    /// A text with its numbers and assignments in this style.
    fn write(self, text: &str) -> String {
        let tokens = tokenize(text, 0);
        let is_next_to_equal =
            |at: usize| is_equal(tokens.get(at + 1)) || at > 0 && is_equal(tokens.get(at - 1));
        let written = tokens.iter().enumerate().map(|(at, token)| {
            let own = of(text, token);
            match token.kind {
                RawKind::Whitespace if self.is_tight && is_next_to_equal(at) => "",
                RawKind::Float if self.is_open && own.ends_with(".0") => {
                    own.strip_suffix('0').unwrap_or(own)
                }
                RawKind::Float if self.is_bare && own != "0.0" => {
                    own.strip_prefix('0').unwrap_or(own)
                }
                _ => own,
            }
        });
        written.collect()
    }
}

fn is_equal(token: Option<&RawToken>) -> bool {
    token.is_some_and(|t| t.kind == RawKind::Operator(TokenKind::Equal))
}

fn of<'t>(text: &'t str, token: &RawToken) -> &'t str {
    let range = token.span.start as usize..token.span.end as usize;
    text.get(range).unwrap_or("")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_assignments_follow_the_file() {
        let check = |file: &str, text: &str, expected: &str| {
            assert_eq!(WrittenStyle::of(file).write(text), expected, "{file}");
        };
        check(
            "float d = 0.5;",
            "float e = 0.25 * 1.0;",
            "float e = 0.25 * 1.0;",
        );
        check("d=.5;e*=2.;", " = 0.25 * 1.0 + 0.0", "=.25 * 1. + 0.");
        check(
            "d = .5; e = 1.0;",
            "e = 0.25 + 10.0 + 0.0;",
            "e = .25 + 10.0 + 0.0;",
        );
        check("d = .5; e = 0.5;", "e = 0.25;", "e = 0.25;");
        check("d=1;", "const float k = 1.5;", "const float k=1.5;");
    }
}
