//! Single words and marks of other languages: `this.x`, `x <- 1.0`, `my-value`, `loop {`, `unless (x)`,
//! `ouput vec4 c`, a lost name, `end` for a brace.

use super::*;
use shaderlint_diagnostic::error;
use shaderlint_semantic::builtins::BuiltinId;
use shaderlint_syntax::{RawKind, TokenKind, WordClass, classify};

/// Most names that are tried for a declaration without one.
const MAX_NAMES: usize = 3;
/// Most places where a name with a hyphen is replaced.
const MAX_HYPHENS: usize = 100;
/// The qualifiers of parameters.
const DIRECTIONS: [&str; 3] = ["in", "out", "inout"];

impl FaultyShader<'_> {
    pub(super) fn words(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        for at in 0..line.tokens.len() {
            all.extend(self.this(line, at));
            all.extend(self.left_arrow(line, at));
            all.extend(self.hyphen(line, at));
            self.lost_name(line, at, all);
            self.lost_type_of_constant(line, at, all);
            all.extend(self.ellipsis(line, at));
            self.direction(line, at, all);
            all.extend(self.reference(line, at));
            all.extend(self.member_value(line, at));
            all.extend(self.number_suffix(line, at));
            all.extend(self.swapped_operator(line, at));
            self.power_assignment(line, at, all);
            all.extend(self.bare_argument(line, at));
            all.extend(self.negated_words(line, at));
        }
        all.extend(self.precision_order(line));
        self.foreign_block(line, all);
        all.extend(self.word_for_brace(line));
    }

    /// Whether a token is an ordinary identifier.
    pub(super) fn is_plain(&self, line: &FaultyLine, at: usize) -> bool {
        line.kind(at) == Some(RawKind::Word)
            && classify(line.token(at), self.program.version) == WordClass::Plain
    }

    /// Whether a token is the name of a built-in type.
    fn is_type_word(&self, line: &FaultyLine, at: usize) -> bool {
        let class = classify(line.token(at), self.program.version);
        line.kind(at) == Some(RawKind::Word) && matches!(class, WordClass::Type(_))
    }

    /// `this.x`
    fn this(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        if line.token(at) != "this" || !line.is(at + 1, TokenKind::Dot) {
            return None;
        }
        let span = line.span(at);
        let edits = vec![Edit::delete(span.to(line.span(at + 1)))];
        let (kind, message) = (error::RESERVED_WORD, "GLSL has no `this`");
        Some(candidate(kind, span, message, "remove `this.`", edits))
    }

    /// `float x <- 1.0;`
    fn left_arrow(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_arrow = line.is(at, TokenKind::Less)
            && line.is(at + 1, TokenKind::Minus)
            && line.touches_next(at);
        let before = at.checked_sub(1);
        if !is_arrow || before.is_none_or(|at| line.kind(at) != Some(RawKind::Word)) {
            return None;
        }
        let span = line.span(at).to(line.span(at + 1));
        let edits = vec![Edit::replace(span, "=")];
        let message = "unexpected `<-`; assignments use `=`";
        Some(syntax(span, message, "use `=`", edits))
    }

    /// `float my-value = 1.0;`
    fn hyphen(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_name = self.is_type_word(line, at)
            && self.is_plain(line, at + 1)
            && line.is(at + 2, TokenKind::Minus)
            && self.is_plain(line, at + 3)
            && line.touches_next(at + 1)
            && line.touches_next(at + 2);
        let code = self
            .program
            .sources
            .code_at(line.start)
            .filter(|_| is_name)?;
        let span = line.span(at + 1).to(line.span(at + 3));
        let name = line.of(span);
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let places = code.text.match_indices(name).filter(|(from, _)| {
            let before = code.text.get(..*from).and_then(|t| t.chars().next_back());
            let after = code
                .text
                .get(from + name.len()..)
                .and_then(|t| t.chars().next());
            !before.is_some_and(is_part) && !after.is_some_and(is_part)
        });
        let text = name.replace('-', "_");
        let edits = places.take(MAX_HYPHENS).map(|(from, _)| {
            let start = code.base + from as u32;
            Edit::replace(Span::new(start, start + name.len() as u32), text.clone())
        });
        let message = format!("unexpected `-` in the name `{name}`");
        let title = format!("use `{text}`");
        Some(syntax(span, message, title, edits.collect()))
    }

    /// `float = 0.0;`: the name may be one that is undeclared later.
    fn lost_name(&self, line: &FaultyLine, at: usize, all: &mut Vec<RepairCandidate>) {
        if !self.is_type_word(line, at) || !line.is(at + 1, TokenKind::Equal) {
            return;
        }
        let span = line.span(at + 1);
        let later = self.errors.iter().filter(|d| {
            d.is(error::UNDECLARED_NAME) && d.span.start > span.start && self.is_user(d.span)
        });
        for d in later.take(MAX_NAMES) {
            let name = self.program.sources.text(d.span);
            let edits = vec![Edit::insert(line.span(at).end, format!(" {name}"))];
            let message = "expected a name, found `=`";
            let title = format!("add the name `{name}`");
            all.push(syntax(span, message, title, edits));
        }
    }

    /// `const r = 0.5;`
    fn lost_type_of_constant(&self, line: &FaultyLine, at: usize, all: &mut Vec<RepairCandidate>) {
        let is_it = line.token(at) == "const"
            && self.is_plain(line, at + 1)
            && line.is(at + 2, TokenKind::Equal);
        if !is_it {
            return;
        }
        let (span, name) = (line.span(at), line.token(at + 1));
        let message = format!("missing type of `{name}`");
        for ty in [
            "float", "vec2", "vec3", "vec4", "int", "bool", "mat2", "mat3",
        ] {
            for text in [format!("const {ty}"), ty.to_string()] {
                let edits = vec![Edit::replace(span, text.clone())];
                let title = format!("use `{text} {name}`");
                all.push(syntax(line.span(at + 1), message.clone(), title, edits).safe());
            }
        }
    }

    /// `...` for code that was left out.
    fn ellipsis(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_dot = |at: usize| line.is(at, TokenKind::Dot);
        let is_it = line.starts_statement(at) && is_dot(at) && is_dot(at + 1) && is_dot(at + 2);
        let span = line.span(at).to(line.span(at + 2));
        let message = "`...` stands for code that was left out";
        is_it.then(|| syntax(span, message, "remove it", vec![Edit::delete(span)]))
    }

    /// `ouput vec4 color` in a parameter list.
    fn direction(&self, line: &FaultyLine, at: usize, all: &mut Vec<RepairCandidate>) {
        let is_first = at.checked_sub(1).is_some_and(|before| {
            line.is(before, TokenKind::LeftParen) || line.is(before, TokenKind::Comma)
        });
        let is_parameter = is_first
            && self.is_plain(line, at)
            && self.is_type_word(line, at + 1)
            && self.is_plain(line, at + 2);
        if !is_parameter {
            return;
        }
        let word = line.token(at);
        let mut near = DIRECTIONS.map(|known| (strsim::damerau_levenshtein(known, word), known));
        near.sort_unstable();
        for (_, known) in near {
            let span = line.span(at);
            let message = format!("`{word}` is not a qualifier");
            let kind = error::SYNTAX_ERROR;
            all.push(replacement(kind, span, message, known.into()));
        }
    }

    /// `vec2 &n = uv;`
    fn reference(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_reference = self.is_type_word(line, at)
            && line.is(at + 1, TokenKind::And)
            && self.is_plain(line, at + 2)
            && line.is(at + 3, TokenKind::Equal);
        let span = line.span(at + 1);
        let message = "GLSL has no references";
        is_reference.then(|| foreign(span, message, "remove `&`", vec![Edit::delete(span)]))
    }

    /// `struct Ray { vec3 o = vec3(0.0); };`
    fn member_value(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let span = line.span(at);
        let is_it = |d: &Diagnostic| d.is(error::FOREIGN_SYNTAX) && d.span.start == span.start;
        let is_reported = self.errors.iter().any(is_it);
        if !is_reported || !line.is(at, TokenKind::Equal) || at == 0 {
            return None;
        }
        let end = (at..line.tokens.len()).find(|&at| line.is(at, TokenKind::Semicolon))?;
        let value = Span::new(line.span(at - 1).end, line.span(end).start);
        let edits = vec![Edit::delete(value)];
        let message = "a member cannot have an initializer";
        Some(foreign(span, message, "remove the initializer", edits))
    }

    /// `2.0px`, `45.0deg`: a number with a unit.
    fn number_suffix(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let (text, span) = (line.token(at), line.span(at));
        let number = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let unit = text.get(number.len()..).unwrap_or("");
        let is_number = line.kind(at) == Some(RawKind::BadNumber)
            && number.parse::<f32>().is_ok()
            && !unit.is_empty();
        if !is_number {
            return None;
        }
        let value = match unit {
            "deg" => format!("radians({number})"),
            _ => number.to_string(),
        };
        let message = format!("GLSL has no units such as `{unit}`");
        Some(replacement(error::INVALID_NUMBER, span, message, value))
    }

    /// `c =* 0.5;`
    fn swapped_operator(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let operator = line.token(at + 1);
        let is_swapped = line.is(at, TokenKind::Equal) && line.touches_next(at);
        if !is_swapped || !matches!(operator, "*" | "/" | "%") {
            return None;
        }
        let span = line.span(at).to(line.span(at + 1));
        let message = format!("unexpected `={operator}`");
        let text = format!("{operator}=");
        Some(replacement(error::SYNTAX_ERROR, span, message, text))
    }

    /// `x **= 2.0;`
    fn power_assignment(&self, line: &FaultyLine, at: usize, all: &mut Vec<RepairCandidate>) {
        let is_power = line.is(at, TokenKind::Star)
            && line.is(at + 1, TokenKind::StarEqual)
            && line.touches_next(at);
        let starts = |&at: &usize| line.starts_statement(at);
        let first = (0..at).rev().find(starts).filter(|_| is_power);
        let end = (at..line.tokens.len()).find(|&at| line.is(at, TokenKind::Semicolon));
        let (Some(first), Some(end)) = (first, end) else {
            return;
        };
        let base = line.of(line.span(first).to(line.span(at - 1)));
        let exponent = line.of(line.span(at + 2).to(line.span(end - 1)));
        let span = line.span(first).to(line.span(end - 1));
        for ty in ["", "vec2", "vec3", "vec4"] {
            let exponent = match ty {
                "" => exponent.to_string(),
                ty => format!("{ty}({exponent})"),
            };
            let text = format!("{base} = pow({base}, {exponent})");
            let edits = vec![Edit::replace(span, text.clone())];
            let message = "GLSL has no operator `**=`";
            let operator = line.span(at).to(line.span(at + 1));
            all.push(foreign(operator, message, format!("use `{text}`"), edits));
        }
    }

    /// `abs p`, `discard(c);`
    fn bare_argument(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let (word, span) = (line.token(at), line.span(at));
        if word == "discard" && line.is(at + 1, TokenKind::LeftParen) {
            let after = line.after(at + 1)?;
            let arguments = line.span(at + 1).to(line.span(after - 1));
            let edits = vec![Edit::delete(arguments)];
            let message = "`discard` has no arguments";
            return Some(syntax(arguments, message, "remove them", edits));
        }
        // `#define texture lookup` defines the name.
        let is_defined = at > 0 && line.token(at - 1) == "define";
        if is_defined || BuiltinId::named(word).is_none() || !self.is_plain(line, at + 1) {
            return None;
        }
        let mut last = at + 1;
        while line.is(last + 1, TokenKind::Dot) && line.kind(last + 2) == Some(RawKind::Word) {
            last += 2;
        }
        let argument = line.span(at + 1).to(line.span(last));
        let text = format!("{word}({})", line.of(argument));
        let message = format!("arguments of `{word}` must be in parentheses");
        let whole = span.to(argument);
        Some(replacement(error::SYNTAX_ERROR, whole, message, text))
    }

    /// `if (not x > 0.5)`: the word negates the comparison, where `!` would negate `x`.
    fn negated_words(&self, line: &FaultyLine, at: usize) -> Option<RepairCandidate> {
        let is_not = BuiltinId::named(line.token(at)) == Some(BuiltinId::Not);
        if !is_not || line.is(at + 1, TokenKind::LeftParen) {
            return None;
        }
        let mut depth = 0_u32;
        let end = (at + 1..line.tokens.len()).find(|&at| match line.kind(at) {
            Some(RawKind::Operator(TokenKind::LeftParen)) => {
                depth += 1;
                false
            }
            Some(RawKind::Operator(TokenKind::RightParen)) if depth > 0 => {
                depth -= 1;
                false
            }
            Some(RawKind::Operator(
                TokenKind::RightParen | TokenKind::AndAnd | TokenKind::OrOr | TokenKind::Semicolon,
            )) => depth == 0,
            _ => depth == 0 && matches!(line.token(at), "and" | "or"),
        });
        let compares = |at: usize| matches!(line.token(at), "<" | ">" | "<=" | ">=" | "==" | "!=");
        let end = end.filter(|end| (at + 1..*end).any(compares))?;
        let inner = line.span(at + 1).to(line.span(end - 1));
        let text = format!("!({})", line.of(inner));
        let span = line.span(at);
        let edits = vec![Edit::replace(span.to(inner), text.clone())];
        let message = "GLSL has no operator `not`";
        Some(foreign(span, message, format!("use `{text}`"), edits))
    }

    /// `precision float highp;`
    fn precision_order(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let is_swapped = line.token(0) == "precision"
            && self.is_type_word(line, 1)
            && matches!(line.token(2), "highp" | "mediump" | "lowp");
        let span = line.span(1).to(line.span(2));
        let text = format!("{} {}", line.token(2), line.token(1));
        let message = format!("expected a precision, found `{}`", line.token(1));
        is_swapped.then(|| replacement(error::SYNTAX_ERROR, span, message, text))
    }

    /// `loop {`, `try { ... } catch (e) { ... }`, `unless (x) ...`
    fn foreign_block(&self, line: &FaultyLine, all: &mut Vec<RepairCandidate>) {
        let starts = |&at: &usize| line.starts_statement(at) && self.is_plain(line, at);
        for at in (0..line.tokens.len()).filter(starts) {
            let (word, span) = (line.token(at), line.span(at));
            let message = format!("GLSL has no `{word}` statement");
            let mut push = |title: &str, edits| {
                all.push(foreign(span, message.clone(), title, edits));
            };
            if line.is(at + 1, TokenKind::LeftBrace) {
                let mut edits = vec![Edit::delete(span)];
                edits.extend(self.handler_after(span.start).map(Edit::delete));
                push("remove it", edits);
                push("use `for (;;)`", vec![Edit::replace(span, "for (;;)")]);
            }
            if word == "unless"
                && line.is(at + 1, TokenKind::LeftParen)
                && let Some(after) = line.after(at + 1)
            {
                let word = Span::new(span.start, line.span(at + 1).start);
                let edits = vec![
                    Edit::replace(word, "if (!"),
                    Edit::insert(line.span(after - 1).end, ")"),
                ];
                push("use `if (!(...))`", edits);
            }
        }
    }

    /// `catch (e) { ... }` after a block: a word that is no GLSL, and its block.
    fn handler_after(&self, block: u32) -> Option<Span> {
        let end = self.braced_from(block)?.end;
        let (_, rest) = self.program.sources.around(end);
        let start = end + (rest.len() - rest.trim_start().len()) as u32;
        let word = rest
            .trim_start()
            .split(|c: char| !c.is_ascii_alphanumeric())
            .next()?;
        let is_plain = classify(word, self.program.version) == WordClass::Plain;
        let header = rest.trim_start().split('{').next()?;
        (!word.is_empty() && is_plain && !header.contains([';', '=', '}']))
            .then(|| self.braced_from(start))?
    }

    /// `if (x) { y(); end`
    fn word_for_brace(&self, line: &FaultyLine) -> Option<RepairCandidate> {
        let last = line.tokens.len().checked_sub(1)?;
        let is_open = self.errors.iter().any(|d| d.is(error::UNCLOSED_DELIMITER));
        if !is_open || !line.starts_statement(last) || !self.is_plain(line, last) {
            return None;
        }
        let (word, span) = (line.token(last), line.span(last));
        let message = format!("GLSL has no `{word}`; a block ends with `}}`");
        let kind = error::FOREIGN_SYNTAX;
        Some(replacement(kind, span, message, "}".into()))
    }
}
