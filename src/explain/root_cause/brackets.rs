//! Macro definitions with unbalanced brackets.

use super::FaultyShader;
use super::candidate::RepairCandidate;
use super::definition::{Definition, is_operator};
use shaderlint_diagnostic::{Diagnostic, Fix};
use shaderlint_syntax::{Piece, TokenKind, WordClass, classify};
use shaderlint_text::{Edit, Span};

/// Maximum number of positions tried for one bracket.
const MAX_PLACES: usize = 24;

/// The closing bracket of an opening one, and both as text.
fn partner(kind: TokenKind) -> Option<(TokenKind, &'static str, &'static str)> {
    match kind {
        TokenKind::LeftParen => Some((TokenKind::RightParen, "(", ")")),
        TokenKind::LeftBracket => Some((TokenKind::RightBracket, "[", "]")),
        TokenKind::LeftBrace => Some((TokenKind::RightBrace, "{", "}")),
        _ => None,
    }
}

/// Indices of the unclosed and the unopened brackets of a macro body.
fn lone(body: &[Piece]) -> (Vec<usize>, Vec<usize>) {
    let mut open: Vec<(usize, TokenKind)> = Vec::new();
    let mut closing = Vec::new();
    for (i, piece) in body.iter().enumerate() {
        let kind = piece.token.kind;
        if let Some((close, ..)) = partner(kind) {
            open.push((i, close));
        } else if matches!(
            kind,
            TokenKind::RightParen | TokenKind::RightBracket | TokenKind::RightBrace
        ) {
            match open.last() {
                Some((_, expected)) if *expected == kind => {
                    open.pop();
                }
                _ => closing.push(i),
            }
        }
    }
    (open.into_iter().map(|(i, _)| i).collect(), closing)
}

impl FaultyShader<'_> {
    /// Number of unclosed brackets in a definition.
    pub(super) fn unclosed(&self, d: &Definition) -> usize {
        lone(&d.of.body).0.len()
    }

    pub(super) fn brackets(&self, d: &Definition, all: &mut Vec<RepairCandidate>) {
        let (open, close) = lone(&d.of.body);
        if let [only] = open.as_slice() {
            self.unclosed_bracket(d, *only, all);
        } else if open.len() > 1 {
            all.extend(self.unclosed_brackets(d, &open));
        }
        if let [only] = close.as_slice() {
            self.unopened_bracket(d, *only, all);
        }
    }

    fn lacks(&self, d: &Definition, at: u32, symbol: &str) -> Diagnostic {
        let span = Span::at(at);
        let message = format!("missing `{symbol}` in the definition of macro `{}`", d.name);
        d.faulty(span, message)
            .mark(format!("expected `{symbol}` here"))
    }

    fn unclosed_bracket(&self, d: &Definition, open: usize, all: &mut Vec<RepairCandidate>) {
        let body = &d.of.body;
        let Some(opener) = body.get(open) else { return };
        let Some((_, left, right)) = partner(opener.token.kind) else {
            return;
        };
        // At the end, before a final `;`, then wherever an operand ends.
        let ends_operand = |i: &usize| {
            let next = body.get(i + 1).map(|p| p.token.kind);
            next.is_none_or(|k| {
                is_operator(k)
                    || matches!(
                        k,
                        TokenKind::Comma | TokenKind::Semicolon | TokenKind::RightParen
                    )
            })
        };
        let places = (open..body.len())
            .rev()
            .filter(ends_operand)
            .take(MAX_PLACES);
        let label = (opener.token.span, format!("unclosed `{left}`"));
        let places = places.filter_map(|i| body.get(i));
        all.extend(places.map(|place| self.added(d, place.token.span.end, right, &label)));
        all.push(removed(d, opener.token.span, left));
    }

    /// Adds a bracket; the label is at the other one.
    fn added(
        &self,
        d: &Definition,
        at: u32,
        symbol: &str,
        (other, label): &(Span, String),
    ) -> RepairCandidate {
        let found = self.lacks(d, at, symbol).label(*other, label);
        let fix = Fix::suggestion(format!("add `{symbol}`"), vec![Edit::insert(at, symbol)]);
        d.candidate(found, fix)
    }

    /// Several brackets are unclosed: closes all of them at the end.
    fn unclosed_brackets(&self, d: &Definition, open: &[usize]) -> Option<RepairCandidate> {
        let kinds = open.iter().rev().filter_map(|&i| d.of.body.get(i));
        let symbols: String = kinds
            .filter_map(|p| partner(p.token.kind))
            .map(|(_, _, right)| right)
            .collect();
        let last = d.last()?;
        let at = last.token.span.end;
        let found = self.lacks(d, at, &symbols);
        let title = format!("add `{symbols}`");
        let fix = Fix::suggestion(title, vec![Edit::insert(at, symbols)]);
        Some(d.candidate(found, fix))
    }

    fn unopened_bracket(&self, d: &Definition, close: usize, all: &mut Vec<RepairCandidate>) {
        let body = &d.of.body;
        let Some(closer) = body.get(close) else {
            return;
        };
        let (left, right) = match closer.token.kind {
            TokenKind::RightParen => ("(", ")"),
            TokenKind::RightBracket => ("[", "]"),
            _ => ("{", "}"),
        };
        // Most likely after the name of a function, otherwise before an operand.
        let called = |i: &usize| {
            let kind = |i: usize| body.get(i).map(|p| p.token.kind);
            kind(*i) == Some(TokenKind::Identifier)
                && kind(i + 1).is_some_and(|k| {
                    !is_operator(k)
                        && !matches!(
                            k,
                            TokenKind::LeftParen | TokenKind::Comma | TokenKind::RightParen
                        )
                })
        };
        let after = (0..close).rev().filter(called).filter_map(|i| body.get(i));
        let after = after.map(|p| p.token.span.end);
        let starts_operand = |i: &usize| {
            i.checked_sub(1).and_then(|b| body.get(b)).is_none_or(|p| {
                is_operator(p.token.kind)
                    || matches!(p.token.kind, TokenKind::Comma | TokenKind::LeftParen)
            })
        };
        let before = (0..close)
            .filter(starts_operand)
            .filter_map(|i| body.get(i));
        let before = before.map(|p| p.token.span.start);
        let split = body
            .iter()
            .take(close)
            .flat_map(|p| self.splits(p.token.span));
        let label = (closer.token.span, format!("unmatched `{right}`"));
        let places = after.chain(before).take(MAX_PLACES);
        let places = places.chain(split.take(MAX_PLACES));
        all.extend(places.map(|at| self.added(d, at, left, &label)));
        all.push(removed(d, closer.token.span, right));
    }

    /// Positions inside a word where a `(` may be missing: after the name of a function or type.
    fn splits(&self, word: Span) -> Vec<u32> {
        let text = self.text(word);
        let program = self.program;
        let builtins = program.builtins();
        let is_called = |name: &str| {
            let is_own = || {
                let mut own = program.functions.iter().map(|f| f.name);
                own.any(|own| program.names.text(own) == name)
            };
            classify(name, program.version) != WordClass::Plain
                || builtins.function(name).is_some()
                || is_own()
        };
        let ends = (1..text.len().min(64)).rev();
        let called = ends.filter(|&i| text.get(..i).is_some_and(is_called));
        called.map(|i| word.start + i as u32).collect()
    }
}

/// Removes a bracket without a counterpart.
fn removed(d: &Definition, span: Span, symbol: &str) -> RepairCandidate {
    let name = d.name;
    let message = format!("unmatched `{symbol}` in the definition of macro `{name}`");
    let fix = Fix::suggestion(format!("remove `{symbol}`"), vec![Edit::delete(span)]);
    d.candidate(d.faulty(span, message), fix)
}
