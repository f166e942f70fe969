//! Statements and statement headers that GLSL does not have.

use super::*;
use crate::parser::keyword_near;

/// Spellings of `else if` in other languages.
const ELSE_IF: &[&str] = &["elif", "elseif", "elsif", "elsIf", "elseIf"];
/// Words that end a block.
const ENDS: &[&str] = &[
    "end", "endif", "fi", "endfor", "endwhile", "done", "End", "END",
];
/// Statements that consist of a keyword and a value.
const REMOVED: &[&str] = &[
    "throw", "raise", "delete", "del", "goto", "yield", "await", "defer",
];
/// Keywords of loops over collections.
const EACH: &[&str] = &["foreach", "for_each", "forEach"];

impl Translator<'_> {
    pub(super) fn statement(&mut self) -> bool {
        self.else_if()
            || self.then()
            || self.end()
            || self.attribute()
            || self.comment()
            || self.macro_call()
            || self.loop_over()
            || self.loop_with_commas()
            || self.bare_condition()
            || self.removed()
            || self.unknown_head()
    }

    /// `throw x;`, `delete x;`: statements without a GLSL equivalent.
    fn removed(&mut self) -> bool {
        use TokenKind as T;
        let is_word = matches!(self.kind(0), T::Identifier | T::Reserved);
        if !is_word || !self.starts_statement() || !REMOVED.contains(&self.text(0)) {
            return false;
        }
        let is_plain = matches!(self.kind(1), T::Identifier | T::Int | T::Float | T::Bad);
        let end = (1..MAX_INSIDE).find(|&i| {
            matches!(
                self.kind(i),
                T::Semicolon | T::LeftBrace | T::RightBrace | T::End
            )
        });
        let Some(end) = end.filter(|&end| is_plain && self.kind(end) == T::Semicolon) else {
            return false;
        };
        let fix = self.remove(0, end + 1);
        let fix = fix.map(|fix| Fix::suggestion("remove the statement", fix.edits));
        self.report(
            self.span(0, end + 1),
            format!("GLSL has no `{}`", self.text(0)),
            fix,
        );
        self.at += end + 1;
        true
    }

    /// `loop {`, `try {`, `catch (e) {`: drops the unknown header and keeps the block.
    fn unknown_head(&mut self) -> bool {
        use TokenKind as T;
        if self.kind(0) != T::Identifier || !self.starts_statement() || self.braces == 0 {
            return false;
        }
        let end = match self.kind(1) {
            T::LeftBrace => Some(1),
            T::LeftParen => self.after(1).filter(|&end| self.kind(end) == T::LeftBrace),
            _ => None,
        };
        // `f(float x) {` is a function without a return type.
        let declares = |end: usize| {
            (2..end).any(|i| self.kind(i) == T::Type && self.kind(i + 1) == T::Identifier)
        };
        let Some(end) = end.filter(|&end| !declares(end) && self.kind(2) != T::RightParen) else {
            return false;
        };
        let word = self.text(0);
        // The parser corrects typos of keywords.
        if keyword_near(word).is_some() {
            return false;
        }
        self.report(
            self.span(0, end),
            format!("GLSL has no `{word}` statement"),
            None,
        );
        self.note("GLSL has `if`, `switch`, `for`, `while` and `do`");
        self.at += end;
        true
    }

    /// `elif (c)`
    fn else_if(&mut self) -> bool {
        use TokenKind as T;
        let is_one = ELSE_IF.contains(&self.word(0))
            && self.kind(1) == T::LeftParen
            && matches!(self.before(), T::RightBrace | T::Semicolon);
        if is_one {
            let span = self.token(0).span;
            let message = format!("GLSL has no `{}`; use `else if`", self.text(0));
            self.report(span, message, Self::write(span, "else if"));
            self.put(T::Else, 0, span);
            self.put(T::If, 0, span);
            self.at += 1;
        }
        is_one
    }

    /// `then ... end` after a condition, and `begin ... end`.
    fn then(&mut self) -> bool {
        use TokenKind as T;
        let is_one = match self.word(0) {
            "then" => self.before() == T::RightParen,
            "begin" => self.starts_statement() || self.before() == T::RightParen,
            _ => false,
        };
        if !is_one || self.kind(1) == T::Equal {
            return false;
        }
        let span = self.token(0).span;
        let mut depth = 0_u32;
        let mut end = None;
        for ahead in 1..MAX_INSIDE {
            match (self.kind(ahead), self.word(ahead)) {
                (T::End | T::RightBrace, _) => break,
                (_, "then" | "begin") => depth += 1,
                (_, word) if ENDS.contains(&word) && depth == 0 => {
                    end = Some(ahead);
                    break;
                }
                (_, word) if ENDS.contains(&word) => depth -= 1,
                _ => {}
            }
        }
        let message = format!(
            "GLSL has no `{}`; a block is enclosed in braces",
            self.text(0)
        );
        match end {
            Some(end) => {
                let edits = vec![
                    Edit::replace(span, "{"),
                    Edit::replace(self.token(end).span, "}"),
                ];
                self.report(span, message, Some(Fix::safe("use `{ ... }`", edits)));
                self.ends.push(self.at + end);
                self.put(T::LeftBrace, 0, span);
            }
            None => {
                let fix = self.remove(0, 1);
                self.report(span, message, fix);
            }
        }
        self.at += 1;
        true
    }

    /// The `end` of a `then`, or a lone one.
    fn end(&mut self) -> bool {
        use TokenKind as T;
        if !ENDS.contains(&self.word(0)) || !self.starts_statement() {
            return false;
        }
        let span = self.token(0).span;
        if self.ends.last() == Some(&self.at) {
            self.ends.pop();
            self.put(T::RightBrace, 0, span);
            self.at += 1;
            return true;
        }
        let is_alone = matches!(self.kind(1), T::Semicolon | T::RightBrace | T::End)
            || (self.starts_line(1) && self.kind(1) != T::Equal);
        if is_alone {
            let after = if self.kind(1) == T::Semicolon { 2 } else { 1 };
            let fix = self.remove(0, after);
            let message = format!("GLSL has no `{}`; a block ends with `}}`", self.text(0));
            self.report(span, message, fix);
            self.at += after;
        }
        is_alone
    }

    /// `[unroll]` and `[[...]]` before a statement or declaration.
    fn attribute(&mut self) -> bool {
        use TokenKind as T;
        if self.kind(0) != T::LeftBracket || !self.starts_statement() {
            return false;
        }
        let Some(end) = self.after(0) else {
            return false;
        };
        if end == 2
            || matches!(
                self.kind(end),
                T::Equal | T::Semicolon | T::Dot | T::LeftParen
            )
        {
            return false;
        }
        let span = self.span(0, end);
        let fix = self.remove(0, end);
        self.report(span, "GLSL has no `[...]` attributes", fix);
        self.note("the browser's compiler decides how code is executed");
        self.at += end;
        true
    }

    /// `-- text`, a comment in SQL and Lua.
    fn comment(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::Decrement
            && self.starts_line(0)
            && self.starts_statement()
            && !self.touches_next(0)
            && self.kind(1) == T::Identifier
            && !self.starts_line(1)
            && matches!(
                self.kind(2),
                T::Identifier | T::Type | T::In | T::For | T::If
            );
        if is_one {
            let end = self.end_of_line();
            let span = self.token(0).span;
            let fix = Self::write(span, "//");
            self.report(
                self.span(0, end),
                "`--` does not start a comment in GLSL",
                fix,
            );
            self.at += end;
        }
        is_one
    }

    /// Index of the first token of the next line.
    pub(super) fn end_of_line(&self) -> usize {
        let mut end = 1;
        while self.kind(end) != TokenKind::End && !self.starts_line(end) {
            end += 1;
        }
        end
    }

    /// `println!(...)`
    fn macro_call(&mut self) -> bool {
        use TokenKind as T;
        let is_one = self.kind(0) == T::Identifier
            && self.kind(1) == T::Not
            && self.kind(2) == T::LeftParen
            && self.touches_next(0)
            && self.starts_statement();
        let Some(end) = is_one.then(|| self.after(2)).flatten() else {
            return false;
        };
        let end = end + (self.kind(end) == T::Semicolon) as usize;
        let fix = self.remove(0, end);
        self.report(
            self.span(0, end),
            format!("GLSL has no `{}!`", self.text(0)),
            fix,
        );
        self.at += end;
        true
    }

    /// `for (x in list)`, `for (auto x : list)`, `foreach (...)`: a range becomes a GLSL loop.
    fn loop_over(&mut self) -> bool {
        use TokenKind as T;
        let is_each = EACH.contains(&self.word(0)) && self.starts_statement();
        if self.kind(0) != T::For && !is_each {
            return false;
        }
        let has_parens = self.kind(1) == T::LeftParen;
        let close = match has_parens {
            true => match self.after(1) {
                Some(end) => end - 1,
                None => return false,
            },
            false => match (1..MAX_INSIDE)
                .find(|&i| matches!(self.kind(i), T::LeftBrace | T::Colon | T::End))
            {
                Some(end) => end,
                None => return false,
            },
        };
        let first = 1 + has_parens as usize;
        let plain = |i: usize| matches!(self.kind(i), T::In | T::Colon) || self.word(i) == "of";
        let Some(between) = (first + 1..close.min(first + 5)).find(|&i| plain(i)) else {
            return false;
        };
        if (first..close).any(|i| self.kind(i) == T::Semicolon)
            || self.kind(between - 1) != T::Identifier
        {
            return false;
        }
        let name = self.token(between - 1);
        let range = self.range(between + 1, close);
        let after = close + (has_parens || self.kind(close) == T::Colon) as usize;
        let span = self.span(0, after);
        let text = self.sources.text(name.span);
        let fix = range.map(|(from, to)| {
            let (from, to) = (from.unwrap_or("0"), self.sources.text(to));
            Self::write(
                span,
                &format!("for (int {text} = {from}; {text} < {to}; {text}++)"),
            )
        });
        let fix = fix
            .flatten()
            .or_else(|| self.loop_over_array(between, close, after));
        self.report(span, "GLSL has no range-based loops", fix);
        self.note("use a counting loop: `for (int i = 0; i < n; i++)`");
        // The body is parsed as a loop that never runs, with an unknown loop variable.
        self.lost.push(Name(name.value));
        for kind in [T::While, T::LeftParen, T::False, T::RightParen] {
            self.put(kind, 0, span);
        }
        self.at += after;
        true
    }

    /// `for (float x : list) {`: a loop over the indices of an array.
    fn loop_over_array(&self, between: usize, close: usize, after: usize) -> Option<Fix> {
        use TokenKind as T;
        let list = (self.kind(between + 1), between + 2) == (T::Identifier, close);
        let is_typed = matches!(self.kind(between - 2), T::Type | T::Identifier);
        let has_length = self.version == Version::Es300;
        if !list || !is_typed || !has_length || self.kind(after) != T::LeftBrace {
            return None;
        }
        let (ty, name) = (self.text(between - 2), self.text(between - 1));
        let list = self.text(between + 1);
        let index = ["i", "j", "k"]
            .into_iter()
            .find(|i| ![name, list].contains(i))?;
        let header = format!("for (int {index} = 0; {index} < {list}.length(); {index}++)");
        let edits = vec![
            Edit::replace(self.span(0, after), header.clone()),
            Edit::insert(
                self.token(after).span.end,
                format!(" {ty} {name} = {list}[{index}];"),
            ),
        ];
        Some(Fix::suggestion(format!("use `{header}`"), edits))
    }

    /// Start and end of `range(to)`, `range(from, to)` or `from..to`.
    fn range(&self, first: usize, close: usize) -> Option<(Option<&str>, Span)> {
        use TokenKind as T;
        if self.word(first) == "range" && self.kind(first + 1) == T::LeftParen && close > first + 3
        {
            let comma = (first + 2..close - 1).find(|&i| self.kind(i) == T::Comma);
            return match comma {
                Some(comma) => {
                    let from = self.sources.text(self.span(first + 2, comma));
                    Some((Some(from), self.span(comma + 1, close - 1)))
                }
                None => Some((None, self.span(first + 2, close - 1))),
            };
        }
        let span = self.span(first, close);
        if close == first + 1 && self.kind(first) == T::Int {
            return Some((None, span));
        }
        let (from, to) = self.sources.text(span).split_once("..")?;
        let to_at = span.start + from.len() as u32 + "..".len() as u32;
        let is_exclusive = to.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
        is_exclusive.then_some((Some(from), Span::new(to_at, span.end)))
    }

    /// `for (int i = 0, i < n, i++)`
    fn loop_with_commas(&mut self) -> bool {
        use TokenKind as T;
        if self.kind(0) != T::For || self.kind(1) != T::LeftParen {
            return false;
        }
        let Some(end) = self.after(1) else {
            return false;
        };
        let mut depth = 0_u32;
        let mut commas = Vec::new();
        for ahead in 2..end - 1 {
            match self.kind(ahead) {
                T::LeftParen | T::LeftBracket => depth += 1,
                T::RightParen | T::RightBracket => depth = depth.saturating_sub(1),
                T::Comma if depth == 0 => commas.push(ahead),
                T::Semicolon => return false,
                _ => {}
            }
        }
        let [first, second] = commas[..] else {
            return false;
        };
        let spans = [first, second].map(|ahead| self.token(ahead).span);
        let edits = spans.map(|span| Edit::replace(span, ";")).to_vec();
        let fix = Fix::safe("use `;`", edits);
        let message = "expected `;` in the header of `for`, found `,`";
        self.report(spans[0], message, Some(fix));
        for ahead in 0..end {
            match ahead == first || ahead == second {
                true => {
                    let span = self.token(0).span;
                    self.put(T::Semicolon, 0, span);
                    self.at += 1;
                }
                false => self.keep(),
            }
        }
        true
    }

    /// `if p {` and `while x < 1.0 {`, without parentheses.
    fn bare_condition(&mut self) -> bool {
        use TokenKind as T;
        let is_head = matches!(self.kind(0), T::If | T::While | T::Switch);
        if !is_head || self.kind(1) == T::LeftParen {
            return false;
        }
        let ends = |i: &usize| {
            matches!(
                self.kind(*i),
                T::LeftBrace
                    | T::Semicolon
                    | T::End
                    | T::RightBrace
                    | T::RightParen
                    | T::If
                    | T::While
            ) || self.starts_line(*i)
                || self.word(*i) == "then"
        };
        let Some(end) = (1..MAX_INSIDE).find(ends) else {
            return false;
        };
        if end == 1 || !(self.kind(end) == T::LeftBrace || self.word(end) == "then") {
            return false;
        }
        let span = self.span(1, end);
        let text = self.text(0);
        let edits = vec![Edit::insert(span.start, "("), Edit::insert(span.end, ")")];
        let message = format!("`{text}` needs parentheses around its condition");
        self.report(span, message, Some(Fix::safe("add parentheses", edits)));
        self.keep();
        self.put(T::LeftParen, 0, span);
        for _ in 1..end {
            self.keep();
        }
        self.put(T::RightParen, 0, span);
        true
    }
}
