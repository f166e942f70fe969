//! Constants of a script that are short strings or numbers.

use super::token::{ScriptToken, ScriptTokenKind, is_mark};
use std::collections::HashMap;

/// The constants by name.
#[derive(Default)]
pub struct Constants {
    values: HashMap<String, Option<String>>,
}

impl Constants {
    /// The constants that `const NAME = ...` declares exactly once.
    pub fn of(text: &str, tokens: &[ScriptToken]) -> Constants {
        let word = |at: usize| {
            let range = tokens.get(at).map_or(0..0, |t| t.range.clone());
            text.get(range).unwrap_or("")
        };
        let mut constants = Constants::default();
        for (at, token) in tokens.iter().enumerate() {
            let is_declared = token.kind == ScriptTokenKind::Word
                && matches!(word(at), "const" | "let" | "var")
                && tokens
                    .get(at + 1)
                    .is_some_and(|t| t.kind == ScriptTokenKind::Word);
            if !is_declared {
                continue;
            }
            let mut equals = at + 2;
            // A type annotation of TypeScript.
            if is_mark(tokens, equals, b':') {
                equals += 2;
            }
            let is_value = word(at) == "const" && is_mark(tokens, equals, b'=');
            let value = is_value.then(|| value(text, tokens, equals + 1)).flatten();
            let known = constants.values.entry(word(at + 1).to_string());
            known.and_modify(|v| *v = None).or_insert(value);
        }
        constants
    }

    /// The value of an expression that is the name of a constant.
    pub fn value(&self, expression: &str) -> Option<&str> {
        self.values.get(expression)?.as_deref()
    }
}

/// The text of a literal that is the complete value.
fn value(text: &str, tokens: &[ScriptToken], at: usize) -> Option<String> {
    let first = tokens.get(at)?;
    let start = first.range.start;
    // Numbers are interpolated as JavaScript prints them: 7.0 as `7`.
    let written;
    let (value, end) = match &first.kind {
        ScriptTokenKind::Quoted => (text.get(first.range.clone())?, first.range.end + 1),
        ScriptTokenKind::Template(holes) if holes.is_empty() => {
            (text.get(first.range.clone())?, first.range.end + 1)
        }
        ScriptTokenKind::Word | ScriptTokenKind::Mark(b'-' | b'.') => {
            let rest = text.get(start..)?;
            let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-');
            let end = rest.find(|c: char| !is_part(c)).unwrap_or(rest.len());
            let number = rest.get(..end)?;
            let number = number.parse::<f64>().ok().filter(|n| n.is_finite())?;
            let is_plain = number == 0.0 || (1e-6..1e21).contains(&number.abs());
            written = is_plain.then(|| format!("{number}"))?;
            (written.as_str(), start + end)
        }
        _ => return None,
    };
    let rest = text.get(end..)?;
    let line = rest.split('\n').next().unwrap_or("").trim_start();
    let is_all = line.is_empty() || line.starts_with([';', ',', '\r']) || line.starts_with("//");
    let goes_on = rest
        .trim_start()
        .starts_with(['+', '.', '-', '*', '/', '?', '[', '(']);
    let is_plain = !value.contains(['\\', '\n', '\r']) && value.is_ascii();
    (is_all && !(line.is_empty() && goes_on) && is_plain).then(|| value.to_string())
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let constants = Constants::of(text, &tokens(text));
        assert_eq!(constants.value("A").unwrap_or("none"), expected, "{text}");
    }

    #[test]
    fn constants_initialised_with_literals_have_values() {
        check("const A = 7.0;", "7");
        check("const A = 1e3;", "1000");
        check("const A = 'highp';", "highp");
        check("const A: number = 0.5, b = 1", "0.5");
        check("const A = `a`\nlet b", "a");
        check("const A = -1;", "-1");
        check("let A = 'a';", "none");
        check("const A = 'a' + b;", "none");
        check("const A = x;", "none");
        check("const A = 'a'; function f() { const A = 'b'; }", "none");
        check("const A = 'a'\n  .trim();", "none");
    }
}
