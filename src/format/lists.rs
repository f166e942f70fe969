//! Lists inside brackets whose elements are of one kind. If one of the author's rows is too long,
//! they are filled again as a whole.

use super::item::FormatItem;
use super::place::LineLayout;
use shaderlint_syntax::TokenKind as T;
use shaderlint_syntax::set::TokenSet;
use shaderlint_text::SetAt;

/// Minimum number of elements of a list.
const ELEMENTS: usize = 3;
/// Words of a parameter.
const IN_PARAMETER: TokenSet = TokenSet::of(&[
    T::Identifier,
    T::Type,
    T::In,
    T::Out,
    T::Inout,
    T::Const,
    T::Highp,
    T::Mediump,
    T::Lowp,
]);

/// Tokens after a name that select a part.
const IN_PART: TokenSet = TokenSet::of(&[T::Dot, T::Identifier]);

/// What the elements of a list are.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ElementKind<'a> {
    Number,
    /// A variable, or a part of one.
    Name,
    Parameter,
    /// A call of this function or constructor.
    Call(&'a str),
}

impl LineLayout<'_> {
    /// Finds the lists of which a line that is too long is a row. The line breaks between their
    /// elements are not kept.
    pub(super) fn find_lists(&mut self, from: usize, to: usize) {
        let mut outer = self.role(from).bracket.map(|open| open as usize);
        while let Some(open) = outer {
            self.fill_again(open);
            outer = self.role(open).bracket.map(|open| open as usize);
        }
        for open in from..to {
            let close = self.role(open).partner.map(|close| close as usize);
            if close.is_some_and(|close| close >= to) {
                self.fill_again(open);
            }
        }
    }

    fn fill_again(&mut self, open: usize) {
        let state = self.lists.get(open).copied().flatten();
        let Some(close) = self.role(open).partner.filter(|_| state.is_none()) else {
            return;
        };
        let inner = open + 1..close as usize;
        let is_broken = |at: usize| self.item(at).is_some_and(|item| item.breaks > 0);
        let is_list = self.list(open).is_some();
        let has_rows = inner.clone().skip(1).any(is_broken);
        let from = inner.start + usize::from(is_broken(inner.start));
        self.lists.set_at(open, Some(is_list));
        if is_list && has_rows {
            if let Some(joined) = self.joined.get_mut(from..inner.end) {
                joined.fill(true);
            }
            self.found_list = true;
        }
    }

    /// What the elements of a list are, given its opening bracket; `None` if they are of several
    /// kinds, or may not be moved.
    pub(super) fn list(&self, open: usize) -> Option<ElementKind<'_>> {
        let close = self.role(open).partner? as usize;
        let inner = self.items.get(open + 1..close)?;
        let may_move = |item: &FormatItem| {
            item.token().is_some() && !item.keeps && item.anchor.is_none() && !item.is_tall
        };
        let is_bracket = self.item(open)?.is(T::LeftParen) || self.item(open)?.is(T::LeftBrace);
        if !is_bracket || !inner.iter().all(may_move) {
            return None;
        }
        let is_comma = |at: &usize| {
            self.role(*at).bracket == Some(open as u32)
                && self.item(*at).is_some_and(|item| item.is(T::Comma))
        };
        let ends = (open + 1..close).filter(is_comma).chain([close]);
        let (mut from, mut count, mut kind) = (open + 1, 0, None);
        for to in ends {
            let own = self.element(from, to)?;
            if kind.is_some_and(|kind| kind != own) {
                return None;
            }
            kind = Some(own);
            count += 1;
            from = to + 1;
        }
        kind.filter(|_| count >= ELEMENTS)
    }

    fn element(&self, from: usize, to: usize) -> Option<ElementKind<'_>> {
        let items = self.items.get(from..to)?;
        let signs = items.iter().take_while(|item| item.is_prefix).count();
        let (first, rest) = items.get(signs..)?.split_first()?;
        match first.token()? {
            T::Int | T::Float | T::True | T::False if rest.is_empty() => Some(ElementKind::Number),
            T::Identifier | T::Type if rest.first().is_some_and(|next| next.is(T::LeftParen)) => {
                let close = self.role(from + signs + 1).partner? as usize;
                let name = first.span.start as usize..first.span.end as usize;
                (close + 1 == to).then_some(ElementKind::Call(self.text.get(name)?))
            }
            kind if IN_PARAMETER.contains(kind) => {
                let bracket = self.role(from).bracket;
                let outer = (from + signs + 1..to).filter(|at| self.role(*at).bracket == bracket);
                let mut outer = outer.filter_map(|at| self.item(at)?.token());
                let next = rest.first().and_then(FormatItem::token);
                let (words, kind) = match next.is_some_and(|next| IN_PARAMETER.contains(next)) {
                    true => (IN_PARAMETER, ElementKind::Parameter),
                    false => (IN_PART, ElementKind::Name),
                };
                let is_bracket = |kind| matches!(kind, T::LeftBracket | T::RightBracket);
                outer
                    .all(|kind| words.contains(kind) || is_bracket(kind))
                    .then_some(kind)
            }
            _ => None,
        }
    }

    /// The number of elements of a line that is a column of a matrix, if the bracket of its
    /// constructor opens here.
    pub(super) fn matrix_rows(&self, open: usize, kind: ElementKind) -> Option<usize> {
        let name = self.before(open).filter(|name| name.is(T::Type))?;
        let name = self
            .text
            .get(name.span.start as usize..name.span.end as usize)?;
        let rows = name.strip_prefix("mat")?.chars().last()?.to_digit(10)?;
        Some(if kind == ElementKind::Number {
            rows as usize
        } else {
            1
        })
    }
}
