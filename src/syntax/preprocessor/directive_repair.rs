//! Fixes for malformed directives.

use super::Preprocessor;
use super::macros::Piece;
use crate::names::{Name, WordClass};
use crate::token::TokenKind;
use shaderlint_diagnostic::Fix;
use shaderlint_text::{Edit, Span};

/// All directives of GLSL.
pub const DIRECTIVES: [&str; 13] = [
    "define",
    "undef",
    "if",
    "ifdef",
    "ifndef",
    "else",
    "elif",
    "endif",
    "error",
    "pragma",
    "extension",
    "version",
    "line",
];

/// Names of directives and condition operators in other languages, with the GLSL equivalent.
const FOREIGN: [(&str, &str); 10] = [
    ("elseif", "elif"),
    ("elsif", "elif"),
    ("elif", "elif"),
    ("ifdefined", "ifdef"),
    ("fi", "endif"),
    ("end", "endif"),
    ("const", "define"),
    ("and", "&&"),
    ("or", "||"),
    ("not", "!"),
];

/// The directive that a misspelled or foreign word probably stands for.
pub(super) fn meant(word: &str) -> Option<&'static str> {
    let lower = word.to_ascii_lowercase();
    if let Some((_, known)) = FOREIGN.iter().find(|(foreign, _)| *foreign == lower) {
        return DIRECTIVES.contains(known).then_some(known);
    }
    let near = DIRECTIVES
        .iter()
        .map(|k| (strsim::damerau_levenshtein(k, &lower), *k));
    let (distance, near) = near.min()?;
    (distance <= 2 && distance < near.len()).then_some(near)
}

impl Preprocessor<'_> {
    /// Rewrites `#ifdef A && B` as `#if defined(A) && defined(B)`.
    pub(super) fn as_condition(
        &self,
        span: Span,
        directive: &str,
        name: &Piece,
        rest: &[Piece],
    ) -> Option<Fix> {
        let mut out = match directive {
            "ifdef" => "#if ".to_string(),
            "ifndef" => "#if !".to_string(),
            _ => return None,
        };
        let ask = |p: &Piece| match self.names.text(Name(p.token.value)) {
            "defined" => "defined".to_string(),
            name => format!("defined({name})"),
        };
        out.push_str(&ask(name));
        let first = rest.first()?.token.kind;
        if !matches!(first, TokenKind::AndAnd | TokenKind::OrOr) {
            return None;
        }
        let mut expects_name = false;
        for piece in rest {
            match piece.token.kind {
                TokenKind::AndAnd if !expects_name => out.push_str(" && "),
                TokenKind::OrOr if !expects_name => out.push_str(" || "),
                TokenKind::Not if expects_name => {
                    out.push('!');
                    continue;
                }
                TokenKind::Identifier if expects_name => out.push_str(&ask(piece)),
                _ => return None,
            }
            expects_name = !expects_name;
        }
        let title = format!("use `{out}`");
        (!expects_name).then(|| Fix::safe(title, vec![Edit::replace(span, out)]))
    }

    /// A fix for a condition that has an unexpected token at `at`.
    pub(super) fn repair_condition(&self, rest: &[Piece], at: Span) -> Option<Fix> {
        let index = rest.iter().position(|p| p.token.span == at)?;
        let piece = rest.get(index)?;
        let text = self.sources.text(at);
        let write = |what: &str| Fix::safe_replacement(at, what);
        match piece.token.kind {
            TokenKind::Equal => return Some(write("==")),
            TokenKind::Float => {
                let digits = text.split('.').next().filter(|d| !d.is_empty())?;
                return Some(write(digits));
            }
            TokenKind::Semicolon if index + 1 == rest.len() => {
                return Some(Fix::safe("remove `;`", vec![Edit::delete(at)]));
            }
            TokenKind::Identifier => {
                let foreign = FOREIGN.iter().find(|(word, _)| *word == text);
                if let Some((_, symbol)) = foreign {
                    return Some(write(symbol));
                }
            }
            TokenKind::Int | TokenKind::Not | TokenKind::LeftParen => {}
            _ => return None,
        }
        // A second operand without an operator.
        index
            .checked_sub(1)
            .map(|_| Fix::suggestion("add `&&`", vec![Edit::insert(at.start, "&& ")]))
    }

    /// A fix for `and`, `or` and `not` in a condition.
    pub(super) fn foreign_operator(&self, rest: &[Piece], at: Span) -> Option<Fix> {
        let text = self.sources.text(at);
        let is_operator = FOREIGN
            .iter()
            .any(|(word, symbol)| *word == text && !DIRECTIVES.contains(symbol));
        if is_operator {
            self.repair_condition(rest, at)
        } else {
            None
        }
    }

    /// Removes the types from `#define F(float x, int y)`.
    pub(super) fn without_types(&self, rest: &[Piece]) -> Option<Fix> {
        let is_type = |p: &Piece| {
            p.token.kind == TokenKind::Identifier
                && !matches!(
                    self.names.class(Name(p.token.value), self.version),
                    WordClass::Plain
                )
        };
        let end = rest
            .iter()
            .position(|p| p.token.kind == TokenKind::RightParen)?;
        let params = rest.get(..end)?;
        let mut edits = Vec::new();
        for pair in params.windows(2) {
            if let [ty, name] = pair
                && is_type(ty)
                && name.token.kind == TokenKind::Identifier
            {
                edits.push(Edit::delete(Span::new(
                    ty.token.span.start,
                    name.token.span.start,
                )));
            }
        }
        (!edits.is_empty()).then(|| Fix::safe("remove the types", edits))
    }
}
