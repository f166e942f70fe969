//! Calls of macros that are themselves at fault: an argument too few or too many, a `)` that is
//! missing.

use super::candidate::Candidate;
use super::{Case, MAX_LOOKED_AT};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_syntax::{Lexer, RawKind, RawToken, TokenKind};
use shaderlint_text::{Edit, Span};

/// Most places that are tried for one `)`.
const MAX_PLACES: usize = 12;
/// Most tokens of one call that are looked at.
const MAX_TOKENS: usize = 2_000;

/// The tokens of a call, from its name on, and where its arguments end as far as its brackets tell.
struct Written {
    tokens: Vec<RawToken>,
    /// The `(`.
    open: Span,
    /// The commas between the arguments.
    commas: Vec<Span>,
    close: Option<Span>,
}

impl Case<'_> {
    pub(super) fn broken_calls(&self) -> Vec<Candidate> {
        let mut all = Vec::new();
        let of_calls = |d: &&Diagnostic| d.is(error::MACRO_ARGUMENTS);
        for d in self.errors.iter().filter(of_calls).take(MAX_LOOKED_AT) {
            if let Some(call) = self.written(d.span.start) {
                self.unclosed_call(&call, &mut all);
                self.wrong_count(d, &call, &mut all);
            }
        }
        // Calls that swallowed a statement for want of a `)`.
        for d in self.errors.iter().take(3) {
            let near = self.calls.near(self.program, d.span.start);
            for (span, _) in near.iter().rev().take(MAX_LOOKED_AT) {
                if !self.text(*span).contains(';') {
                    continue;
                }
                if let Some(call) = self.written(span.start) {
                    self.unclosed_call(&call, &mut all);
                }
            }
        }
        all
    }

    /// Reads the call whose name stands at `start`.
    fn written(&self, start: u32) -> Option<Written> {
        let code = self.program.sources.code_at(start)?;
        let mut lexer = Lexer::new(code.text.get((start - code.base) as usize..)?, start);
        let mut call = Written {
            tokens: Vec::new(),
            open: Span::default(),
            commas: Vec::new(),
            close: None,
        };
        let mut open = 0_u32;
        while call.tokens.len() < MAX_TOKENS {
            let token = lexer.next_token();
            match token.kind {
                RawKind::End => break,
                RawKind::Whitespace
                | RawKind::Newline
                | RawKind::LineComment
                | RawKind::BlockComment => continue,
                RawKind::Operator(TokenKind::LeftParen) => {
                    open += 1;
                    if open == 1 {
                        call.open = token.span;
                    }
                }
                RawKind::Operator(TokenKind::RightParen) => open = open.saturating_sub(1),
                RawKind::Operator(TokenKind::Comma) if open == 1 => call.commas.push(token.span),
                _ => {}
            }
            call.tokens.push(token);
            if open == 0 && call.tokens.len() > 1 {
                call.close = Some(token.span);
                break;
            }
        }
        (!call.open.is_empty()).then_some(call)
    }

    /// A `)` that is missing before the statement ends.
    fn unclosed_call(&self, call: &Written, all: &mut Vec<Candidate>) {
        let ends = |t: &RawToken| {
            matches!(
                t.kind,
                RawKind::Hash
                    | RawKind::Operator(
                        TokenKind::Semicolon | TokenKind::LeftBrace | TokenKind::RightBrace
                    )
            )
        };
        let end = call.tokens.iter().position(ends);
        let end = end.unwrap_or(call.tokens.len());
        let (Some(name), Some(inside)) = (call.tokens.first(), call.tokens.get(2..end)) else {
            return;
        };
        let name = self.text(name.span);
        let is_operand = |t: &&RawToken| {
            !matches!(t.kind, RawKind::Operator(k)
                if !matches!(k, TokenKind::RightParen | TokenKind::RightBracket))
        };
        for token in inside.iter().rev().filter(is_operand).take(MAX_PLACES) {
            let at = token.span.end;
            let message = format!("the call of macro `{name}` lacks a `)`");
            let found = Diagnostic::error(error::UNCLOSED_DELIMITER, Span::at(at), message)
                .mark("expected `)` here")
                .label(call.open, "this `(` is not closed");
            let fix = Fix::suggestion("put `)` here", vec![Edit::insert(at, ")")]);
            all.push(candidate(found, fix));
        }
    }

    /// Arguments to spare, or a place for one that is missing.
    fn wrong_count(&self, d: &Diagnostic, call: &Written, all: &mut Vec<Candidate>) {
        let Some(close) = call.close else { return };
        let wanted = self.program.tokens.macros.iter().find_map(|m| {
            let is_it = d.labels.iter().any(|l| l.span == m.name_span);
            m.params.as_ref().filter(|_| is_it).map(Vec::len)
        });
        let Some(wanted) = wanted else { return };
        if let Some(first) = wanted.checked_sub(1).and_then(|i| call.commas.get(i)) {
            let surplus = Span::new(first.start, close.start);
            let fix = Fix::suggestion("take out what is too much", vec![Edit::delete(surplus)]);
            all.push(candidate(d.clone(), fix));
            return;
        }
        let is_empty = call.open.end == close.start;
        let have = if is_empty { 0 } else { call.commas.len() + 1 };
        for value in ["0.0", "0", "vec2(0.0)", "vec3(0.0)"] {
            let mut more = vec![value; wanted.saturating_sub(have)].join(", ");
            if have > 0 {
                more = format!(", {more}");
            }
            let title = format!("pass another argument, such as `{value}`");
            let fix = Fix::suggestion(title, vec![Edit::insert(close.start, more)]);
            all.push(candidate(d.clone(), fix));
        }
    }
}

fn candidate(d: Diagnostic, fix: Fix) -> Candidate {
    Candidate {
        edits: fix.edits.clone(),
        diagnostic: d.fix(fix),
        of: None,
    }
}
