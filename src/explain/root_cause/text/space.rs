//! A space lost between two words: `vec2p = q;`, `returnx;`, `constfloat A = 1.0;`.

use super::*;
use shaderlint_semantic::builtins::BuiltinId;
use shaderlint_syntax::{DIRECTIVES, RawKind, TypeWord, WordClass, classify};

/// Maximum number of words of one line that are tried.
const MAX_WORDS: usize = 4;
/// Maximum number of parts of one word: `const highp vec3 p`. The ways to split a longer chain of
/// keywords grow exponentially.
const MAX_PARTS: usize = 4;
/// Keywords that another word or a number follows.
const BEFORE_A_WORD: &str = "\
    return else case const struct uniform varying attribute inout in out flat smooth centroid \
    highp mediump lowp precision void invariant do";

impl FaultyShader<'_> {
    pub(super) fn spaces(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let is_at_error = |span: Span| line.errors.iter().any(|e| e.touches(span));
        let mut words: Vec<usize> = (0..line.tokens.len())
            .filter(|&at| line.kind(at) == Some(RawKind::Word))
            .filter(|&at| self.is_unknown(line.token(at)))
            .collect();
        // A word at an error before the others.
        words.sort_by_key(|&at| !is_at_error(line.span(at)));
        words.truncate(MAX_WORDS);
        for at in words {
            let is_directive = at > 0 && line.kind(at - 1) == Some(RawKind::Hash);
            for parts in splits(line.token(at), is_directive, MAX_PARTS) {
                all.extend(self.split(line.span(at), &parts));
            }
        }
    }

    /// Whether a word is not a keyword, a type or a built-in function.
    fn is_unknown(&self, word: &str) -> bool {
        classify(word, self.program.version) == WordClass::Plain && BuiltinId::named(word).is_none()
    }

    fn split(&self, span: Span, parts: &[&str]) -> Option<RepairCandidate> {
        let [first, second, ..] = parts else {
            return None;
        };
        let mut at = span.start;
        let mut edits = Vec::new();
        for part in parts {
            if at > span.start {
                edits.push(Edit::insert(at, " "));
            }
            at += part.len() as u32;
        }
        let message = format!("missing space between `{first}` and `{second}`");
        let title = format!("use `{}`", parts.join(" "));
        Some(syntax(span, message, title, edits))
    }
}

/// The ways to split a word after a keyword or type into at most `parts`, the most parts first.
fn splits(word: &str, is_directive: bool, parts: usize) -> Vec<Vec<&str>> {
    let mut found = Vec::new();
    let types = TypeWord::ALL
        .into_iter()
        .map(|t| -> &'static str { t.name() });
    let mut prefixes: Vec<&str> = match is_directive {
        true => DIRECTIVES.to_vec(),
        false => BEFORE_A_WORD.split(' ').chain(types).collect(),
    };
    prefixes.sort_by_key(|p| std::cmp::Reverse(p.len()));
    for prefix in prefixes {
        let Some(rest) = word.strip_prefix(prefix) else {
            continue;
        };
        let takes_number = is_directive || matches!(prefix, "return" | "case");
        let starts = |c: char| c.is_ascii_alphabetic() || c == '_' || takes_number;
        if !rest.starts_with(starts) {
            continue;
        }
        if !is_directive && parts > 2 && TypeWord::named(rest).is_none() {
            for mut more in splits(rest, false, parts - 1) {
                more.insert(0, prefix);
                found.push(more);
            }
        }
        found.push(vec![prefix, rest]);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_split_after_keywords_and_types() {
        let check = |word: &str, expected: &[&str]| {
            let found: Vec<String> = splits(word, false, MAX_PARTS)
                .iter()
                .map(|p| p.join(" "))
                .collect();
            assert_eq!(found, expected, "{word}");
        };
        check("vec2p", &["vec2 p"]);
        check("returnx", &["return x"]);
        check("return1", &["return 1"]);
        check("constfloat", &["const float"]);
        check("elsereturn", &["else return"]);
        check("inoutvec2", &["inout vec2", "in out vec2", "in outvec2"]);
        check("constvec3dir", &["const vec3 dir", "const vec3dir"]);
        check("vec33", &[]);
        check("position", &[]);
    }

    #[test]
    fn chains_of_keywords_have_few_splits() {
        let chain = "inout".repeat(60) + "vec4";
        assert!(splits(&chain, false, MAX_PARTS).len() < 20);
    }
}
