//! Tokens that a space splits (`frag Color`, `> =`, `1 .5`), characters that are not code, and the
//! escapes of a string (`\n`).

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_semantic::builtins::BuiltinId;
use shaderlint_syntax::{DIRECTIVES, RawKind, WordClass, classify, tokenize};

impl FaultyShader<'_> {
    pub(super) fn joins(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        for at in 1..line.tokens.len() {
            all.extend(self.split_token(line, at));
            if line.kind(at) == Some(RawKind::Hash) && DIRECTIVES.contains(&line.token(at + 1)) {
                all.push(directive_after_code(line, at));
            }
        }
    }

    fn split_token(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let (first, second) = (line.span(at - 1), line.span(at));
        let gap = Span::new(first.end, second.start);
        let is_blank = |text: &str| !text.is_empty() && text.bytes().all(|b| b == b' ');
        let is_near = |e: &Span| e.touches(first) || e.touches(second);
        if gap.start >= gap.end || !is_blank(line.of(gap)) || !line.errors.iter().any(is_near) {
            return None;
        }
        use RawKind as R;
        let text = format!("{}{}", line.token(at - 1), line.token(at));
        let is_known = match (line.kind(at - 1), line.kind(at)) {
            (Some(R::Word), Some(R::Word | R::Integer)) => self.is_known(&text),
            (Some(R::Operator(_)), Some(R::Operator(_))) => true,
            (Some(R::Integer), Some(R::Float)) => line.token(at).starts_with('.'),
            _ => false,
        };
        let tokens = tokenize(&text, 0);
        if !is_known || tokens.iter().filter(|t| t.kind != R::End).count() != 1 {
            return None;
        }
        let message = format!("unexpected space in `{text}`");
        let edits = vec![Edit::delete(gap)];
        let (span, title) = (first.to(second), format!("use `{text}`"));
        Some(syntax(span, message, title, edits))
    }

    /// Whether a word is of the language, or a name that the shader contains elsewhere.
    fn is_known(&self, word: &str) -> bool {
        classify(word, self.program.version) != WordClass::Plain
            || BuiltinId::named(word).is_some()
            || self.program.names.get(word).is_some()
    }

    /// Characters outside names that no token contains, such as an emoji.
    pub(super) fn strays(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        all.extend(self.escapes(line));
        let of_line = |d: &&Diagnostic| line.errors.contains(&d.span);
        let strays = self.errors.iter().filter(of_line);
        for d in strays.filter(|d| d.is(error::INVALID_CHARACTER) && d.fix.is_none()) {
            let text = line.of(d.span);
            let is_mark = |c: char| !c.is_alphanumeric() && !c.is_whitespace() && c != '"';
            if text.is_empty() || text.len() > MAX_STRAY || !text.chars().all(is_mark) {
                continue;
            }
            let edits = vec![Edit::delete(d.span)];
            let fix = Fix::suggestion("remove it", edits);
            all.push(RepairCandidate::of_error(d, fix));
        }
    }

    /// `\n` in code that was copied from a string.
    fn escapes(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let places = ["\\n", "\\t"].map(|escape| line.text.match_indices(escape));
        let edits: Vec<Edit> = places
            .into_iter()
            .flatten()
            .map(|(at, escape)| {
                let start = line.start + at as u32;
                let blank = if escape == "\\n" { "\n" } else { "\t" };
                Edit::replace(Span::new(start, start + escape.len() as u32), blank)
            })
            .collect();
        let span = edits.first().map(|e| e.span)?;
        let message = format!("unexpected escape `{}` of a string", line.of(span));
        let title = "replace it with the character";
        let kind = error::INVALID_CHARACTER;
        Some(candidate(kind, span, message, title, edits))
    }
}

/// `int a; #define N 2`
fn directive_after_code(line: &FaultyLine, at: usize) -> RepairCandidate {
    let span = line.span(at).to(line.span(at + 1));
    let message = format!("`{}` must be the first on its line", line.of(span));
    let edits = vec![Edit::insert(span.start, "\n")];
    let kind = error::BAD_DIRECTIVE;
    candidate(kind, span, message, "start a new line", edits)
}

/// Maximum length of characters that are removed, in bytes.
const MAX_STRAY: usize = 16;
