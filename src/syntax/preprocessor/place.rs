//! Where code stands: in the text, or in the macro body that supplied all of it.

use super::Tokens;
use crate::Lexer;
use crate::token::Token;
use shaderlint_text::{Role, Sources, Span};

/// Deepest chain of macro calls that is followed.
const MAX_LEVELS: usize = 32;
/// Longest stretch of tokens that is looked at.
const MAX_TOKENS: usize = 4_000;

impl Tokens {
    /// Whether the tokens from `first` to `last` stand in the text just so, outside any macro call.
    pub fn are_direct(&self, first: u32, last: u32) -> bool {
        let tokens = self.tokens.get(first as usize..=last as usize);
        tokens.is_some_and(|all| all.iter().all(Token::is_direct))
    }

    /// Where the tokens from `first` to `last` stand. Where the body of one macro supplied all of
    /// them, that is in its definition; otherwise it is where the user's text calls for them.
    pub fn place(&self, sources: &Sources, first: u32, last: u32) -> Span {
        let all = self.tokens.get(first as usize..=last as usize);
        let (Some(all), Some(a)) = (all, self.tokens.get(first as usize)) else {
            return Span::default();
        };
        let b = all.last().unwrap_or(a);
        let seen = a.span.to(b.span);
        if a.is_direct() || b.is_direct() || all.len() > MAX_TOKENS {
            return seen;
        }
        if all.iter().any(|t| !is_of_body(t)) {
            return seen;
        }
        let (first, last) = (self.levels(sources, a), self.levels(sources, b));
        let common = first.iter().find_map(|(expansion, from)| {
            let (_, to) = last.iter().find(|(other, _)| other == expansion)?;
            (from.start <= to.end).then(|| from.to(*to))
        });
        common.unwrap_or(seen)
    }

    /// Where a token of a macro's body stands in that body, then where the macro is called in the
    /// body of another, and so on outwards, as far as these are the user's definitions.
    fn levels(&self, sources: &Sources, token: &Token) -> Vec<(u32, Span)> {
        let mut levels = Vec::new();
        let mut at = token.expansion;
        let mut span = own_span(sources, token);
        while let Some(expansion) = self.expansions.get(at as usize) {
            let definition = self.macros.get(expansion.definition.0 as usize);
            let is_user = definition.is_some_and(|m| {
                let file = sources.file_at(m.name_span.start);
                !m.predefined && file.is_some_and(|f| f.role == Role::User)
            });
            if is_user && let Some(span) = span {
                levels.push((at, span));
            }
            if levels.len() >= MAX_LEVELS {
                break;
            }
            span = Some(expansion.call);
            at = expansion.parent;
        }
        levels
    }
}

/// Whether a macro's body supplied the token, and not an argument in the text.
fn is_of_body(token: &Token) -> bool {
    !token.is_direct() && token.span.start != token.spelled
}

/// The token's own text.
fn own_span(sources: &Sources, token: &Token) -> Option<Span> {
    let code = sources.code_at(token.spelled)?;
    let rest = code
        .text
        .get(token.spelled.checked_sub(code.base)? as usize..)?;
    Some(Lexer::new(rest, token.spelled).next_token().span)
}
