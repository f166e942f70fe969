//! Syntax errors: what is reported, and where parsing resumes.

use super::correction::{brace_subject, symbol};
use super::{Parsed, Parser, Reported};
use crate::ast::*;
use crate::names::Name;
use crate::set::{self, TokenSet};
use crate::token::TokenKind;
use shaderlint_diagnostic::{Diagnostic, Fix, Subject, error};
use shaderlint_text::{Edit, Span};

/// Maximum indentation that is measured, in columns.
const MAX_INDENT: usize = 200;
/// Longest parameter list, in tokens; GLSL allows 255 parameters.
const MAX_PARAM_TOKENS: usize = 4_000;
/// Longest type, in bytes, that a message quotes with its array sizes.
const MAX_QUOTED: usize = 40;
/// Longest functions inside a function, in tokens.
const MAX_NESTED: usize = 1_000;

impl Parser<'_> {
    /// Whether the next token is on another line than the one before it.
    pub(super) fn is_on_new_line(&self) -> bool {
        self.starts_line(self.at)
    }

    pub(super) fn starts_line(&self, at: usize) -> bool {
        let Some(before) = at.checked_sub(1) else {
            return true;
        };
        let between = Span::new(self.token(before).span.end, self.token(at).span.start);
        between.start > between.end
            || self.sources.file_id_at(between.start) != self.sources.file_id_at(between.end)
            || self.sources.text(between).contains(['\n', '\r'])
    }

    /// Description of the next token for messages.
    fn found(&self) -> String {
        let token = self.next();
        match token.kind {
            TokenKind::End => "end of shader".to_string(),
            // A token inserted by a correction has no text.
            kind if token.span.is_empty() => format!("`{}`", symbol(kind, token.value)),
            _ => {
                let line = self.text(&token).lines().next().unwrap_or("");
                let text: String = line.chars().take(40).collect();
                format!("`{text}`")
            }
        }
    }

    /// Reports an error of the form "expected X, found Y".
    pub(super) fn unexpected(&mut self, what: &str) -> Reported {
        if !self.is(TokenKind::Bad) {
            let message = format!("expected {what}, found {}", self.found());
            let d = self.error_here(error::SYNTAX_ERROR, message);
            self.report(d.about(brace_subject(self.peek())));
        }
        Reported
    }

    /// Reports that a brace was expected.
    fn expected_brace(&mut self, what: &str) -> Reported {
        let before = self.diagnostics.len();
        let reported = self.unexpected(what);
        if let Some(d) = self.diagnostics.get_mut(before) {
            d.subject = Subject::Brace;
        }
        reported
    }

    pub(super) fn expect(&mut self, kind: TokenKind, what: &str) -> Parsed<TokenId> {
        match self.eat(kind) {
            Some(id) => Ok(id),
            None if brace_subject(kind).is_brace() => Err(self.expected_brace(what)),
            None => Err(self.unexpected(what)),
        }
    }

    /// Reports that no expression starts here.
    pub(super) fn no_expression(&mut self) -> Reported {
        if self.is(TokenKind::Bad) {
            return Reported;
        }
        let found = self.found();
        let message = match set::ENDS_EXPRESSION.contains(self.peek()) {
            true => format!("expected an expression before {found}"),
            false => format!("expected an expression, found {found}"),
        };
        let d = self.error_here(error::SYNTAX_ERROR, message);
        self.report(d.about(brace_subject(self.peek())));
        Reported
    }

    pub(super) fn type_as_value(&mut self, ty: TypeId) -> Reported {
        let extent = self.tree.ty(ty).extent;
        let mut name = self.sources.text(self.span(extent));
        if name.len() > MAX_QUOTED || name.contains('\n') {
            name = self.text(&self.token(extent.first as usize));
        }
        self.unexpected(&format!("`(` after type `{name}`"))
    }

    /// Reports the current word as a misspelled keyword.
    pub(super) fn misspelled_keyword(&mut self) -> Reported {
        let word = self.next();
        let keyword = self
            .keyword_like(self.at)
            .map_or("", |kind| symbol(kind, 0));
        let message = format!("expected `{keyword}`, found `{}`", self.text(&word));
        let edit = Edit::replace(word.span, keyword);
        let fix = Fix::suggestion(format!("did you mean `{keyword}`?"), vec![edit]);
        let d = self.error_here(error::SYNTAX_ERROR, message).fix(fix);
        self.report(d);
        Reported
    }

    pub(super) fn else_without_if(&mut self) -> Reported {
        let d = self
            .error_here(error::SYNTAX_ERROR, "`else` without a matching `if`")
            .note("a `;` after `if (...)`, or a second statement without braces, ends it early");
        self.report(d);
        Reported
    }

    pub(super) fn no_body(&mut self) -> Reported {
        self.expected_brace("`{` or `;` after the parameter list")
    }

    /// Parses the `;` of a statement. If it is missing after a complete statement, the error is
    /// reported at the end of the statement and parsing continues.
    pub(super) fn semicolon(&mut self) -> Parsed<()> {
        if self.eat(TokenKind::Semicolon).is_some() {
            return Ok(());
        }
        if self.is(TokenKind::Bad) {
            return Err(Reported);
        }
        let ends = matches!(self.peek(), TokenKind::RightBrace | TokenKind::End);
        if !ends && !self.is_on_new_line() && !self.looks_like_statement() {
            return Err(self.unexpected("`;`"));
        }
        let last = self.token(self.last() as usize);
        let place = self.gap();
        let d = Diagnostic::error(error::MISSING_SEMICOLON, place, "missing `;`")
            .mark("expected `;` here")
            .fix(Fix::safe("add `;`", vec![Edit::insert(place.start, ";")]));
        self.report_at(d, &last);
        Ok(())
    }

    /// Whether the next tokens look like the start of a statement.
    fn looks_like_statement(&self) -> bool {
        use TokenKind as T;
        match self.peek() {
            T::Type => self.kind(1) == T::Identifier,
            T::Identifier => match self.kind(1) {
                T::Identifier => matches!(
                    self.kind(2),
                    T::Equal | T::Semicolon | T::Comma | T::LeftBracket
                ),
                kind => set::ASSIGNMENTS.contains(kind),
            },
            kind => set::STARTS_STATEMENT.contains(kind),
        }
    }

    /// The position after the last token, extended over the blanks up to the next token on the same
    /// line.
    fn gap(&self) -> Span {
        let last = self.token(self.last() as usize).span;
        let next = self.next().span;
        let between = Span::new(last.end, next.start);
        let is_blank = self
            .sources
            .text(between)
            .bytes()
            .all(|b| matches!(b, b' ' | b'\t'));
        if between.start < between.end && is_blank && !self.is_on_new_line() {
            between
        } else {
            last.after()
        }
    }

    /// Parses the bracket that closes the one at `open`. If it is missing after complete contents,
    /// the error is reported there and parsing continues.
    pub(super) fn close(&mut self, kind: TokenKind, open: TokenId) -> Parsed<()> {
        if self.eat(kind).is_some() {
            return Ok(());
        }
        if self.is(TokenKind::Bad) {
            return Err(Reported);
        }
        let symbol = if kind == TokenKind::RightBracket {
            "]"
        } else {
            ")"
        };
        let ends = set::ENDS_STATEMENT.contains(self.peek())
            || (self.is_on_new_line() && self.looks_like_statement());
        if !ends {
            return Err(self.unexpected(&format!("`{symbol}`")));
        }
        let last = self.token(self.last() as usize);
        let place = self.gap();
        let partner = if kind == TokenKind::RightBracket {
            "["
        } else {
            "("
        };
        let d = Diagnostic::error(
            error::UNCLOSED_DELIMITER,
            place,
            format!("missing `{symbol}`"),
        )
        .mark(format!("expected `{symbol}` here"))
        .label(self.token_span(open), format!("unclosed `{partner}`"))
        .fix(Fix::suggestion(
            format!("add `{symbol}`"),
            vec![Edit::insert(place.start, symbol)],
        ));
        self.report_at(d, &last);
        Ok(())
    }

    /// Parses the `)` of a statement header. If a `;` comes before it on the same line, that is the
    /// error, and the header still ends at the `)`.
    pub(super) fn close_head(&mut self, open: TokenId) -> Parsed<()> {
        if !self.is(TokenKind::Semicolon) || self.has_many_errors() || !self.closes_in_line() {
            return self.close(TokenKind::RightParen, open);
        }
        self.unexpected("`)`");
        self.skip_to_close();
        self.advance();
        Ok(())
    }

    /// Whether the enclosing parentheses are closed before the line ends.
    fn closes_in_line(&self) -> bool {
        let mut open = 0_u32;
        let last = self.tokens.len().min(self.at + MAX_PARAM_TOKENS);
        for at in self.at..last {
            if self.starts_line(at) {
                return false;
            }
            match self.token(at).kind {
                TokenKind::LeftParen => open += 1,
                TokenKind::RightParen if open == 0 => return true,
                TokenKind::RightParen => open -= 1,
                TokenKind::LeftBrace | TokenKind::RightBrace => return false,
                _ => {}
            }
        }
        false
    }

    /// Parses the closing bracket inside an expression. If it is missing, the extent of the
    /// brackets is unknown, so the expression is not checked further.
    pub(super) fn close_operand(&mut self, kind: TokenKind, open: TokenId) -> Parsed<()> {
        let is_there = self.is(kind);
        self.close(kind, open)?;
        if is_there { Ok(()) } else { Err(Reported) }
    }

    /// Treats names that appear to be declared in the skipped tokens from `first` on, outside
    /// braces, as declared with an unknown type, so that uses of them are not errors.
    pub(super) fn lose_names(&mut self, first: TokenId) {
        use TokenKind as T;
        let mut open = 0_u32;
        let mut before = T::End;
        for at in first as usize..self.at {
            let token = self.token(at);
            let follows_type = matches!(
                before,
                T::Type | T::Identifier | T::Void | T::RightBrace | T::RightBracket
            );
            match token.kind {
                T::LeftBrace => open += 1,
                T::RightBrace => open = open.saturating_sub(1),
                T::Identifier if open == 0 && follows_type => {
                    self.tree.lost.push(Name(token.value));
                }
                _ => {}
            }
            before = token.kind;
        }
    }

    /// Skips the rest of a member of a struct.
    pub(super) fn skip_field(&mut self) {
        loop {
            match self.peek() {
                TokenKind::End | TokenKind::RightBrace => return,
                TokenKind::Semicolon => {
                    self.advance();
                    return;
                }
                TokenKind::LeftBrace => self.skip_braces(),
                _ => {
                    self.advance();
                }
            }
        }
    }

    /// Reports that the block opened at `open`, or one inside it, is not closed; once for all
    /// blocks that end at the same place.
    pub(super) fn missing_brace(&mut self, open: TokenId) {
        if self.missing_brace_at == Some(self.at) || self.has_many_errors() {
            return;
        }
        self.missing_brace_at = Some(self.at);
        let outermost = if self.function_open < open {
            self.function_open
        } else {
            open
        };
        let (open, place) = self.find_unclosed(outermost);
        let d = Diagnostic::error(error::UNCLOSED_DELIMITER, place, "missing `}`")
            .about(Subject::MissingClose)
            .mark("expected `}` here")
            .label(self.token_span(open), "unclosed `{`")
            .fix(Fix::suggestion(
                "add `}`",
                vec![Edit::insert(place.start, "\n}")],
            ));
        let token = self.token(self.last() as usize);
        self.report_at(d, &token);
    }

    /// Finds the unclosed brace by indentation, and where its `}` belongs.
    fn find_unclosed(&self, outermost: TokenId) -> (TokenId, Span) {
        let default = self.token(self.at.saturating_sub(1)).span.after();
        let mut open: Vec<(usize, usize)> = Vec::new();
        for at in outermost as usize..self.at {
            match self.token(at).kind {
                TokenKind::LeftBrace => open.push((at, self.indent(at))),
                TokenKind::RightBrace => {
                    let Some((brace, indent)) = open.pop() else {
                        continue;
                    };
                    if self.starts_line(at) && self.indent(at) < indent {
                        return (
                            brace as TokenId,
                            self.place_of_brace(brace, indent, default),
                        );
                    }
                }
                _ => {}
            }
        }
        match open.last() {
            Some(&(brace, indent)) => (
                brace as TokenId,
                self.place_of_brace(brace, indent, default),
            ),
            None => (outermost, default),
        }
    }

    /// The position after the last line that is indented more than the line of `brace`.
    fn place_of_brace(&self, brace: usize, indent: usize, default: Span) -> Span {
        (brace + 1..self.at)
            .find(|&at| self.starts_line(at) && self.indent(at) <= indent)
            .map_or(default, |at| self.token(at - 1).span.after())
    }

    /// Indentation of the line that contains a token, up to a limit.
    pub(super) fn indent(&self, at: usize) -> usize {
        let blanks = self.blanks_before_line(at).chars().take(MAX_INDENT);
        blanks.map(|c| if c == '\t' { 4 } else { 1 }).sum()
    }

    /// The blanks before the line that contains a token.
    pub(super) fn blanks_before_line(&self, at: usize) -> &str {
        let start = self.token(at).span.start;
        let Some(file) = self.sources.file_at(start) else {
            return "";
        };
        let lines = file.lines();
        let line = lines.start(lines.line(start - file.base)).unwrap_or(0);
        let text = file.text.get(line as usize..).unwrap_or("");
        let end = text.find(|c| !matches!(c, ' ' | '\t'));
        text.get(..end.unwrap_or(text.len())).unwrap_or("")
    }

    /// Whether the function that starts here indicates that the block opened at `open` is unclosed:
    /// it is not indented more than the line of that block, and no code behind it is.
    pub(super) fn is_left_open(&self, open: TokenId) -> bool {
        let indent = self.indent(open as usize);
        if !self.starts_line(self.at) || self.indent(self.at) > indent {
            return false;
        }
        let mut next = self.at;
        while let Some(after) = self.after_function(next) {
            next = after;
        }
        let ends = [TokenKind::RightBrace, TokenKind::End].contains(&self.token(next).kind);
        ends || self.indent(next) <= indent
    }

    /// The token after a function definition, within some distance of the current token.
    fn after_function(&self, at: usize) -> Option<usize> {
        let body = self.head_at(at)?;
        let mut depth = 0_u32;
        for i in body..self.at + MAX_NESTED {
            match self.token(i).kind {
                TokenKind::LeftBrace => depth += 1,
                TokenKind::RightBrace if depth == 1 => return Some(i + 1),
                TokenKind::RightBrace => depth = depth.checked_sub(1)?,
                TokenKind::End => return None,
                _ => {}
            }
        }
        None
    }

    /// Whether `type name (` starts here.
    pub(super) fn at_function(&self) -> bool {
        let is_type = matches!(
            self.kind(0),
            TokenKind::Type | TokenKind::Void | TokenKind::Identifier
        );
        is_type && self.kind(1) == TokenKind::Identifier && self.kind(2) == TokenKind::LeftParen
    }

    /// Whether `type name ( ... ) {` starts here.
    pub(super) fn at_function_definition(&self) -> bool {
        if !self.at_function() {
            return false;
        }
        let mut open = 0_u32;
        for i in self.at + 2..self.at + MAX_PARAM_TOKENS {
            match self.token(i).kind {
                TokenKind::LeftParen => open += 1,
                TokenKind::RightParen => {
                    open -= 1;
                    if open == 0 {
                        return self.token(i + 1).kind == TokenKind::LeftBrace;
                    }
                }
                kind if set::ENDS_STATEMENT.contains(kind) => return false,
                _ => {}
            }
        }
        false
    }

    /// Skips the rest of a statement that started at `first`.
    pub(super) fn skip_statement(&mut self, first: TokenId) {
        loop {
            match self.peek() {
                // A `}` before these tokens does not end a block.
                TokenKind::RightBrace
                    if matches!(self.kind(1), TokenKind::Comma | TokenKind::RightParen) =>
                {
                    self.advance();
                }
                TokenKind::End | TokenKind::RightBrace => return,
                TokenKind::Semicolon => {
                    self.advance();
                    return;
                }
                TokenKind::LeftBrace => {
                    self.skip_braces();
                    return;
                }
                _ if self.id() > first && self.is_on_new_line() && self.starts_afresh() => return,
                _ => {
                    self.advance();
                }
            }
        }
    }

    /// Whether the next token can only start a statement.
    fn starts_afresh(&self) -> bool {
        use TokenKind as T;
        match self.peek() {
            T::Type => self.kind(1) == T::Identifier,
            T::Identifier => matches!(self.kind(1), T::Identifier | T::Equal),
            kind => set::STARTS_AFRESH.contains(kind),
        }
    }

    /// Skips the rest of an item at global scope that started at `first`.
    pub(super) fn skip_item(&mut self, first: TokenId) {
        if self.id() == first {
            self.advance();
        }
        loop {
            match self.peek() {
                TokenKind::End => return,
                TokenKind::Semicolon | TokenKind::RightBrace => {
                    self.advance();
                    return;
                }
                TokenKind::LeftBrace => {
                    self.skip_braces();
                    return;
                }
                _ if self.is_on_new_line() && self.starts_item() => return,
                _ => {
                    self.advance();
                }
            }
        }
    }

    fn starts_item(&self) -> bool {
        use TokenKind as T;
        match self.peek() {
            T::Void | T::Type => self.kind(1) == T::Identifier && self.kind(2) == T::LeftParen,
            kind => set::STARTS_ITEM.contains(kind),
        }
    }

    /// Skips to the `)` that closes the enclosing parentheses, without consuming it.
    pub(super) fn skip_to_close(&mut self) {
        self.skip_inside(const { TokenSet::of(&[TokenKind::LeftBrace, TokenKind::RightBrace]) });
    }

    /// Skips to the `)` that closes the enclosing parentheses, or to a token that cannot be inside
    /// them.
    fn skip_inside(&mut self, ends: TokenSet) {
        let mut open = 0_u32;
        loop {
            match self.peek() {
                TokenKind::End => return,
                kind if ends.contains(kind) => return,
                TokenKind::RightParen if open == 0 => return,
                TokenKind::LeftParen => open += 1,
                TokenKind::RightParen => open -= 1,
                _ => {}
            }
            self.advance();
        }
    }

    /// Skips to the `,` or `;` after an initializer that started at `start`.
    pub(super) fn skip_initializer(&mut self, start: TokenId) {
        let mut open = 0_u32;
        for at in start as usize..self.at {
            match self.token(at).kind {
                TokenKind::LeftParen | TokenKind::LeftBracket => open += 1,
                TokenKind::RightParen | TokenKind::RightBracket => open = open.saturating_sub(1),
                _ => {}
            }
        }
        let first = self.id();
        loop {
            match self.peek() {
                TokenKind::End | TokenKind::Semicolon | TokenKind::RightBrace => return,
                TokenKind::Comma if open == 0 => return,
                TokenKind::LeftParen | TokenKind::LeftBracket => open += 1,
                TokenKind::RightParen | TokenKind::RightBracket => open = open.saturating_sub(1),
                TokenKind::LeftBrace => {
                    self.skip_braces();
                    continue;
                }
                _ if self.id() > first && self.is_on_new_line() && self.starts_afresh() => return,
                _ => {}
            }
            self.advance();
        }
    }

    /// Skips `( ... )`.
    pub(super) fn skip_parens(&mut self) {
        use TokenKind as T;
        self.advance();
        // Arguments contain no statements, so unclosed parentheses end with the statement.
        self.skip_inside(const { TokenSet::of(&[T::LeftBrace, T::RightBrace, T::Semicolon]) });
        self.eat(T::RightParen);
    }

    /// Skips `{ ... }`.
    pub(super) fn skip_braces(&mut self) {
        let mut open = 0_u32;
        loop {
            match self.peek() {
                TokenKind::End => return,
                TokenKind::LeftBrace => open += 1,
                TokenKind::RightBrace => open = open.saturating_sub(1),
                _ => {}
            }
            self.advance();
            if open == 0 {
                return;
            }
        }
    }
}
