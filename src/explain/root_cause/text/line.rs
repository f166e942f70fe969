//! The lines on which errors are reported.

use super::super::{FaultyShader, MAX_LOOKED_AT};
use shaderlint_diagnostic::{Diagnostic, Facet, error};
use shaderlint_syntax::{RawKind, RawToken, TokenKind, tokenize};
use shaderlint_text::Span;

/// Longest part of a line that is examined, in bytes on either side of an error.
const MAX_AROUND: usize = 600;

/// A line with an error.
pub(super) struct FaultyLine<'a> {
    /// Address of the first byte.
    pub start: u32,
    /// The line, without its line break.
    pub text: &'a str,
    /// The tokens except whitespace and comments.
    pub tokens: Vec<RawToken>,
    /// Where errors start on the line.
    pub errors: Vec<Span>,
}

impl<'a> FaultyLine<'a> {
    pub fn end(&self) -> u32 {
        self.start + self.text.len() as u32
    }

    /// The text of a span on this line.
    pub fn of(&self, span: Span) -> &'a str {
        let range = span.start.checked_sub(self.start).map(|from| {
            let from = from as usize;
            from..from + span.len() as usize
        });
        range.and_then(|r| self.text.get(r)).unwrap_or("")
    }

    /// The kind of a token; `None` after the last one.
    pub fn kind(&self, at: usize) -> Option<RawKind> {
        self.tokens.get(at).map(|t| t.kind)
    }

    pub fn span(&self, at: usize) -> Span {
        let end = Span::at(self.end());
        self.tokens.get(at).map_or(end, |t| t.span)
    }

    /// The text of a token; empty after the last one.
    pub fn token(&self, at: usize) -> &'a str {
        self.of(self.span(at))
    }

    /// Whether a token is this operator.
    pub fn is(&self, at: usize, kind: TokenKind) -> bool {
        self.kind(at) == Some(RawKind::Operator(kind))
    }

    /// Whether there is nothing between a token and the next one.
    pub fn touches_next(&self, at: usize) -> bool {
        self.span(at).end == self.span(at + 1).start
    }

    /// Index after the bracket that closes the one at `open`, if it is on this line.
    pub fn after(&self, open: usize) -> Option<usize> {
        use TokenKind as T;
        let mut depth = 0_u32;
        for at in open..self.tokens.len() {
            match self.kind(at) {
                Some(RawKind::Operator(T::LeftParen | T::LeftBracket | T::LeftBrace)) => depth += 1,
                Some(RawKind::Operator(T::RightParen | T::RightBracket | T::RightBrace)) => {
                    depth = depth.checked_sub(1)?;
                    if depth == 0 {
                        return Some(at + 1);
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// Whether a statement can start at a token: first on the line, or after `;` or a brace.
    pub fn starts_statement(&self, at: usize) -> bool {
        use TokenKind as T;
        at.checked_sub(1).is_none_or(|before| {
            matches!(
                self.kind(before),
                Some(RawKind::Operator(
                    T::Semicolon | T::LeftBrace | T::RightBrace
                ))
            )
        })
    }
}

/// Whether a mistake of the text may be reported as this error.
fn is_textual(d: &Diagnostic) -> bool {
    let kinds = [
        error::UNDECLARED_NAME,
        error::UNKNOWN_TYPE,
        error::INVALID_NUMBER,
        error::TOKEN_PASTE,
        error::LOCAL_FUNCTION,
        error::INVALID_QUALIFIER,
        error::INVALID_SWITCH,
        error::FOREIGN_SYNTAX,
        error::NOT_A_FUNCTION,
        error::RESERVED_WORD,
    ];
    let facets = [Facet::Grammar, Facet::Reads, Facet::Directive];
    kinds.into_iter().any(|k| d.is(k)) || facets.into_iter().any(|f| d.has(f))
}

impl FaultyShader<'_> {
    /// The lines of the first errors, each once, in the order of the errors.
    pub(super) fn faulty_lines(&self) -> Vec<FaultyLine<'_>> {
        let mut all: Vec<FaultyLine> = Vec::new();
        for d in self.errors.iter().take(MAX_LOOKED_AT) {
            if !is_textual(d) {
                continue;
            }
            // Code of a macro is reported in its definition, and a long span covers more than a
            // mistake of the text.
            let at = d.span.start;
            if !self.is_user(d.span) {
                continue;
            }
            if let Some(line) = all.iter_mut().find(|l| l.start <= at && at <= l.end()) {
                line.errors.push(d.span);
                continue;
            }
            if let Some(mut line) = self.line_at(at) {
                line.errors.push(d.span);
                all.push(line);
            }
        }
        all
    }

    /// The line that contains an address.
    pub(super) fn line_at(&self, at: u32) -> Option<FaultyLine<'_>> {
        let code = self.program.sources.code_at(at)?;
        let offset = (at - code.base) as usize;
        let breaks = |c: char| matches!(c, '\n' | '\r');
        let mut from = code.text.get(..offset)?.rfind(breaks).map_or(0, |i| i + 1);
        let mut to = code.text.get(offset..)?.find(breaks);
        if offset - from > MAX_AROUND {
            let skipped = code.text.get(..offset - MAX_AROUND);
            from = skipped.and_then(|t| t.rfind(';')).map_or(offset, |i| i + 1);
            from = from.max(offset.saturating_sub(2 * MAX_AROUND));
        }
        let rest = code.text.get(offset..)?;
        if to.unwrap_or(rest.len()) > MAX_AROUND {
            let near = rest.get(MAX_AROUND..).and_then(|t| t.find(';'));
            let most = rest.len().min(2 * MAX_AROUND);
            to = Some(near.map_or(most, |i| (MAX_AROUND + i + 1).min(most)));
        }
        let to = offset + to.unwrap_or(rest.len());
        let text = code.text.get(from..to)?;
        let start = code.base + from as u32;
        let mut tokens = tokenize(text, start);
        tokens.retain(|t| t.kind != RawKind::Newline && !t.kind.is_blank());
        Some(FaultyLine {
            start,
            text,
            tokens,
            errors: Vec::new(),
        })
    }
}
