//! Source positions of code: in the text, or in the macro body that supplied all of it.

use super::Tokens;
use crate::Lexer;
use crate::token::Token;
use shaderlint_text::{Role, Sources, Span};

/// Longest chain of macro calls that is followed.
const MAX_LEVELS: usize = 32;
/// Longest token range that is examined.
const MAX_TOKENS: usize = 4_000;

impl Tokens {
    /// Whether the tokens from `first` to `last` are in the source text, outside any macro call.
    pub fn are_direct(&self, first: u32, last: u32) -> bool {
        let expanded = self.expanded.get_or_init(|| {
            let all = (0..).zip(&self.tokens);
            let expanded = all.filter(|(_, token)| !token.is_direct());
            expanded.map(|(number, _)| number).collect()
        });
        let next = expanded.partition_point(|number| *number < first);
        let is_within = (last as usize) < self.tokens.len();
        is_within && expanded.get(next).is_none_or(|number| *number > last)
    }

    /// Whether a host decides if the code at a span is compiled.
    pub fn is_undecided(&self, span: Span) -> bool {
        let next = self.undecided.partition_point(|s| s.start <= span.start);
        let before = next.checked_sub(1).and_then(|i| self.undecided.get(i));
        before.is_some_and(|s| s.contains(span))
    }

    /// Source span of the tokens from `first` to `last`: if one macro body supplied all of them,
    /// the span in its definition; otherwise the span in the user's text.
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

    /// The position of a token in the macro body that supplied it, then of that macro's call in the
    /// next outer body, and so on, for user-defined macros.
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

/// Whether a macro's body supplied the token, rather than an argument.
pub(super) fn is_of_body(token: &Token) -> bool {
    !token.is_direct() && token.span.start != token.spelled
}

/// Span of the token where it is spelled.
fn own_span(sources: &Sources, token: &Token) -> Option<Span> {
    let code = sources.code_at(token.spelled)?;
    let rest = code
        .text
        .get(token.spelled.checked_sub(code.base)? as usize..)?;
    Some(Lexer::new(rest, token.spelled).next_token().span)
}
