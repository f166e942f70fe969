//! Operators at line breaks: whether lines start or end with them, and how far lines that continue
//! an operand are indented.

use super::item::FormatItem;
use super::place::LineLayout;
use super::spacing::{is_assignment, precedence};
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::TokenKind as T;

/// The binary operator that an item is.
fn operator(item: Option<&FormatItem>) -> Option<T> {
    let item = item.filter(|i| !i.is_prefix)?;
    item.token().filter(|kind| precedence(*kind).is_some())
}

fn is_ternary(kind: T) -> bool {
    matches!(kind, T::Question | T::Colon)
}

fn before(items: &[FormatItem], at: usize) -> Option<&FormatItem> {
    at.checked_sub(1).and_then(|i| items.get(i))
}

/// Whether most of the author's lines end with operators, rather than start with them.
pub fn end_lines(items: &[FormatItem], roles: &[ItemRole]) -> bool {
    let mut ends = 0;
    for (i, (item, role)) in items.iter().zip(roles).enumerate() {
        if item.breaks == 0 || role.start != StatementStart::Nothing {
            continue;
        }
        let counted = |item| operator(item).is_some_and(|kind| !is_ternary(kind));
        ends += i64::from(counted(before(items, i))) - i64::from(counted(Some(item)));
    }
    ends > 0
}

/// By item: the additional indentation, in levels, of a line that starts there: operands of
/// operators of higher precedence, and operands in lists, are indented further.
pub fn steps(items: &[FormatItem], roles: &[ItemRole]) -> Vec<u8> {
    // The current list element in each bracket, and whether the bracket has several; the first is
    // for code outside brackets.
    let mut elements = vec![0; items.len() + 1];
    let mut is_list = vec![false; items.len() + 1];
    let mut lowest = vec![u32::MAX];
    let mut found = Vec::new();
    for (i, (item, role)) in items.iter().zip(roles).enumerate() {
        let slot = role.bracket.map_or(0, |b| b as usize + 1);
        let starts = match item.token() {
            _ if role.start != StatementStart::Nothing => Some(0),
            Some(T::LeftParen | T::LeftBracket | T::LeftBrace) => Some(i + 1),
            Some(T::Comma) => {
                is_list.get_mut(slot).into_iter().for_each(|is| *is = true);
                Some(slot)
            }
            _ => None,
        };
        if let Some(element) = starts.and_then(|slot| elements.get_mut(slot)) {
            *element = lowest.len();
            lowest.push(u32::MAX);
        }
        let element = elements.get(slot).copied().unwrap_or(0);
        if let Some(precedence) = operator(Some(item)).and_then(precedence)
            && let Some(least) = lowest.get_mut(element)
        {
            *least = precedence.min(*least);
            found.push((i, slot, element, precedence));
        }
    }
    let mut steps = vec![0; items.len()];
    for (i, slot, element, precedence) in found {
        let is_tighter = lowest.get(element).is_some_and(|least| *least < precedence);
        let is_in_list = slot > 0 && is_list.get(slot) == Some(&true);
        for step in steps.iter_mut().skip(i).take(2) {
            *step = u8::from(is_tighter) + u8::from(is_in_list);
        }
    }
    steps
}

/// Of chains of `? :` outside brackets (`a ? b : c ? d : e`): each `:`, and the first item of the
/// first condition.
pub fn chains(items: &[FormatItem], roles: &[ItemRole]) -> Vec<(u32, u32)> {
    let mut found = Vec::new();
    let (mut head, mut first, mut is_open) = (0, 0, false);
    for (at, (item, role)) in items.iter().zip(roles).enumerate() {
        if role.start != StatementStart::Nothing {
            (head, first, is_open) = (at, found.len(), false);
        }
        if role.bracket.is_some() || role.is_label {
            continue;
        }
        if item.is_comment() && head == at {
            head += 1;
            continue;
        }
        let at = at as u32;
        match item.token() {
            Some(T::Question) if !is_open => is_open = true,
            Some(T::Colon) if is_open => {
                is_open = false;
                found.push((at, head as u32));
            }
            // `a ? b ? c : d : e` is no chain.
            Some(T::Question | T::Colon) => found.truncate(first),
            Some(T::Semicolon | T::Comma) => {
                if found.len() == first + 1 {
                    found.pop();
                }
                (head, first, is_open) = (at as usize + 1, found.len(), false);
            }
            Some(T::Return) => head = at as usize + 1,
            Some(kind) if is_assignment(kind) => head = at as usize + 1,
            _ => {}
        }
    }
    found
}

impl LineLayout<'_> {
    /// The first item of the chain of `? :` to which a `:` belongs.
    pub(super) fn chain(&self, at: usize) -> Option<usize> {
        let found = self
            .chains
            .binary_search_by_key(&(at as u32), |(colon, _)| *colon);
        let (_, head) = self.chains.get(found.ok()?)?;
        Some(*head as usize)
    }

    /// Whether a `?` is in a chain of `? :`.
    pub(super) fn is_in_chain(&self, at: usize) -> bool {
        let next = self
            .chains
            .partition_point(|(colon, _)| (*colon as usize) < at);
        let next = self.chains.get(next);
        next.is_some_and(|(_, head)| (*head as usize) < at && self.role(at).bracket.is_none())
    }

    /// The operator with which a line starts if it is broken before an item, or with which the line
    /// before it ends.
    pub(super) fn operator_of_line(&self, at: usize) -> Option<T> {
        let last = operator(self.before(at)).filter(|kind| !is_ternary(*kind));
        let first = operator(self.item(at));
        match self.operators_end_lines {
            true => last.or(first.filter(|kind| is_ternary(*kind))),
            false => first,
        }
    }
}
