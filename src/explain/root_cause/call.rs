//! Macro calls that are wrong themselves: wrong number of arguments, or a missing `)`.

use super::candidate::RepairCandidate;
use super::{FaultyShader, MAX_LOOKED_AT};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_syntax::{Lexer, RawKind, RawToken, TokenKind};
use shaderlint_text::{Edit, Span};

/// Maximum number of positions tried for one `)`.
const MAX_PLACES: usize = 12;
/// Maximum number of tokens of one call that are examined.
const MAX_TOKENS: usize = 2_000;

/// The tokens of a call, starting with its name, and the end of its arguments according to the
/// brackets.
#[derive(Default)]
struct CallTokens {
    tokens: Vec<RawToken>,
    /// Span of the `(`.
    open: Span,
    /// Commas between the arguments.
    commas: Vec<Span>,
    close: Option<Span>,
}

impl FaultyShader<'_> {
    pub(super) fn broken_calls(&self) -> Vec<RepairCandidate> {
        let mut all = Vec::new();
        let of_calls = |d: &&Diagnostic| d.is(error::MACRO_ARGUMENTS);
        for d in self.errors.iter().filter(of_calls).take(MAX_LOOKED_AT) {
            if let Some(call) = self.written(d.span.start) {
                self.unclosed_call(&call, &mut all);
                self.wrong_count(d, &call, &mut all);
            }
        }
        // Calls that extend over a statement because a `)` is missing.
        for d in self.errors.iter().take(3) {
            let near = self.calls.near(self.program, d.span);
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

    /// Reads the call whose name starts at `start`.
    fn written(&self, start: u32) -> Option<CallTokens> {
        let (_, rest) = self.program.sources.around(start);
        let mut call = CallTokens::default();
        let mut open = 0_u32;
        use RawKind::{BlockComment, LineComment, Newline, Whitespace};
        let is_blank = |kind| matches!(kind, Whitespace | Newline | LineComment | BlockComment);
        let is_code = |t: &RawToken| !is_blank(t.kind);
        for token in Lexer::new(rest, start).filter(is_code).take(MAX_TOKENS) {
            match token.kind {
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

    /// Candidates for a `)` missing before the end of the statement.
    fn unclosed_call(&self, call: &CallTokens, all: &mut Vec<RepairCandidate>) {
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
            let message = format!("missing `)` in the call of macro `{name}`");
            let found = Diagnostic::error(error::UNCLOSED_DELIMITER, Span::at(at), message)
                .mark("expected `)` here")
                .label(call.open, "unclosed `(`");
            let fix = Fix::suggestion("add `)`", vec![Edit::insert(at, ")")]);
            all.push(RepairCandidate::new(found, fix));
        }
    }

    /// Candidates that remove extra arguments or add missing ones.
    fn wrong_count(&self, d: &Diagnostic, call: &CallTokens, all: &mut Vec<RepairCandidate>) {
        let Some(close) = call.close else { return };
        let expected = self.program.tokens.macros.iter().find_map(|m| {
            let is_it = d.labels.iter().any(|l| l.span == m.name_span);
            m.params.as_ref().filter(|_| is_it).map(Vec::len)
        });
        let Some(expected) = expected else { return };
        if let Some(first) = expected.checked_sub(1).and_then(|i| call.commas.get(i)) {
            let surplus = Span::new(first.start, close.start);
            let fix = Fix::suggestion("remove the extra arguments", vec![Edit::delete(surplus)]);
            all.push(RepairCandidate::new(d.clone(), fix));
            return;
        }
        let is_empty = call.open.end == close.start;
        let have = if is_empty { 0 } else { call.commas.len() + 1 };
        for value in ["0.0", "0", "vec2(0.0)", "vec3(0.0)"] {
            let mut more = vec![value; expected.saturating_sub(have)].join(", ");
            if have > 0 {
                more = format!(", {more}");
            }
            let title = format!("add an argument, such as `{value}`");
            let fix = Fix::suggestion(title, vec![Edit::insert(close.start, more)]);
            all.push(RepairCandidate::new(d.clone(), fix));
        }
    }
}
