//! The source text that produced some tokens and nothing else, where it can be replaced or surrounded.

use super::macros::Macro;
use super::place::is_of_body;
use super::{Expansion, Tokens};
use crate::token::{ExactPlace, Token, TokenKind};
use shaderlint_text::{Role, Sources, Span};

/// Longest token range that is examined.
const MAX_TOKENS: usize = 1_000;
/// Longest chain of macro calls that is followed.
const MAX_LEVELS: usize = 32;

/// Some tokens and their neighbours.
struct TokenRange<'t> {
    tokens: &'t Tokens,
    all: &'t [Token],
    first: &'t Token,
    last: &'t Token,
    before: Option<&'t Token>,
    after: Option<&'t Token>,
}

/// Where a token comes from, as seen from the body of a macro.
#[derive(Clone, Copy, PartialEq)]
enum BodyPlace {
    /// From this piece of the body, perhaps through other macros.
    Piece(usize),
    /// From elsewhere: an argument, or the text around the call.
    Other,
}

impl Tokens {
    /// The outermost source span that supplies the tokens from `first` to `last` and nothing else: in the
    /// text, in an argument of a macro call, or in the body of a macro.
    pub fn exact_place(&self, sources: &Sources, first: u32, last: u32) -> Option<ExactPlace> {
        let all = self.tokens.get(first as usize..=last as usize)?;
        let range = TokenRange {
            tokens: self,
            all,
            first: all.first()?,
            last: all.last()?,
            before: first
                .checked_sub(1)
                .and_then(|i| self.tokens.get(i as usize)),
            after: self.tokens.get(last as usize + 1),
        };
        if all.len() > MAX_TOKENS {
            return None;
        }
        let in_text = range.in_text(|t| range.call(t));
        let in_text = in_text.or_else(|| range.in_text(|t| range.own_or_call(t)));
        let in_text = in_text.map(|span| ExactPlace {
            span,
            in_body: false,
            has_params: false,
        });
        in_text.or_else(|| range.in_body(sources))
    }
}

impl TokenRange<'_> {
    /// The expansions that produced a token, the innermost first.
    fn expansions(&self, token: &Token) -> impl Iterator<Item = (u32, &Expansion)> {
        let get = |at: u32| Some((at, self.tokens.expansions.get(at as usize)?));
        let all = std::iter::successors(get(token.expansion), move |(_, e)| get(e.parent));
        all.take(MAX_LEVELS)
    }

    /// Span of the outermost macro call that produced a token, or of the token in the text.
    fn call(&self, token: &Token) -> Span {
        let outermost = self.expansions(token).last();
        outermost.map_or(token.span, |(_, e)| e.call)
    }

    /// The same, but a token of an argument is where it is written.
    fn own_or_call(&self, token: &Token) -> Span {
        match is_of_body(token) {
            true => self.call(token),
            false => token.span,
        }
    }

    /// Span in the text, if its parts supply exactly the range.
    fn in_text(&self, part: impl Fn(&Token) -> Span) -> Option<Span> {
        let (from, to) = (part(self.first), part(self.last));
        if from.start > to.end {
            return None;
        }
        let span = from.to(to);
        let is_outside =
            |t: Option<&Token>, edge: Span| t.is_none_or(|t| part(t).start != edge.start);
        let is_exact = is_outside(self.before, from) && is_outside(self.after, to);
        (is_exact && self.all.iter().all(|t| span.contains(part(t)))).then_some(span)
    }

    /// Span in the body of the outermost macro of which some pieces supply exactly the range.
    fn in_body(&self, sources: &Sources) -> Option<ExactPlace> {
        let mut macros: Vec<(usize, u32)> = Vec::new();
        for token in self.all {
            let chain: Vec<u32> = self.expansions(token).map(|(at, _)| at).collect();
            for (depth, at) in chain.into_iter().rev().enumerate() {
                if !macros.contains(&(depth, at)) {
                    macros.push((depth, at));
                }
            }
        }
        macros.sort_unstable();
        macros.dedup();
        macros.into_iter().find_map(|(_, at)| {
            let expansion = self.tokens.expansions.get(at as usize)?;
            let definition = self.tokens.macros.get(expansion.definition.0 as usize)?;
            let file = sources.file_at(definition.name_span.start);
            let is_user = !definition.predefined && file.is_some_and(|f| f.role == Role::User);
            is_user.then(|| self.pieces(at, definition)).flatten()
        })
    }

    /// Where a token comes from in an expansion, and whether through another macro.
    fn place_in(&self, token: &Token, expansion: u32, of: &Macro) -> (BodyPlace, bool) {
        let mut start = is_of_body(token).then_some(token.spelled);
        let mut is_nested = false;
        for (at, found) in self.expansions(token) {
            if at == expansion {
                let mut pieces = of.body.iter();
                let index = start.and_then(|s| pieces.position(|p| p.token.spelled == s));
                return (index.map_or(BodyPlace::Other, BodyPlace::Piece), is_nested);
            }
            (start, is_nested) = (Some(found.call.start), true);
        }
        (BodyPlace::Other, false)
    }

    /// Span of the pieces of a body that supply exactly the range.
    fn pieces(&self, expansion: u32, of: &Macro) -> Option<ExactPlace> {
        use BodyPlace::{Other, Piece};
        let place = |token: &Token| match self.place_in(token, expansion, of) {
            // The arguments of a call in the body belong to it.
            (Piece(at), true) => (Piece(at), end_of_call(of, at)),
            (Piece(at), false) => (Piece(at), at),
            (Other, _) => (Other, 0),
        };
        let places: Vec<(BodyPlace, usize)> = self.all.iter().map(place).collect();
        let is_param = |at: &usize| {
            let piece = of.body.get(*at);
            piece.is_some_and(|p| p.token.expansion != Token::DIRECT)
        };
        let starts = places.iter().filter_map(|(p, _)| match p {
            Piece(at) => Some(*at),
            Other => None,
        });
        let ends = places
            .iter()
            .filter(|(p, _)| *p != Other)
            .map(|(_, end)| *end);
        let first = match places.first()?.0 {
            Piece(at) => at,
            Other => starts.clone().next()?.checked_sub(1).filter(is_param)?,
        };
        let last = match places.last()? {
            (Piece(_), end) => *end,
            (Other, _) => Some(ends.clone().next_back()? + 1).filter(is_param)?,
        };
        let is_within = starts.chain(ends).all(|at| (first..=last).contains(&at));
        let before = self.before.map_or((Other, 0), place);
        let after = self.after.map_or((Other, 0), place);
        let starts_there = match (places.first()?.0, before) {
            (Piece(_), (before, _)) => before != Piece(first),
            (Other, (Piece(_), end)) => end + 1 == first,
            (Other, (Other, _)) => first == 0,
        };
        let ends_there = match (places.last()?.0, after.0) {
            (Piece(at), after) => after != Piece(at),
            (Other, Piece(after)) => after == last + 1,
            (Other, Other) => last + 1 == of.body.len(),
        };
        let used = of.body.get(first..=last)?;
        let place = ExactPlace {
            span: used.first()?.token.span.to(used.last()?.token.span),
            in_body: true,
            has_params: (first..=last).any(|at| is_param(&at)),
        };
        (is_within && starts_there && ends_there).then_some(place)
    }
}

/// The last piece of a macro call in a body: its closing parenthesis, or its name.
fn end_of_call(of: &Macro, name: usize) -> usize {
    let rest = of.body.iter().enumerate().skip(name + 1);
    let mut depth = 0_u32;
    for (at, piece) in rest {
        match piece.token.kind {
            TokenKind::LeftParen => depth += 1,
            TokenKind::RightParen if depth == 1 => return at,
            TokenKind::RightParen => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    name
}
