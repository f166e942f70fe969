//! Breaks lines that are too long.
//!
//! The rest of a source line is broken at its outermost level: between the arguments of the
//! outermost call, or before the operators of the lowest precedence. Parts that are still too long
//! are broken at the next level.

use super::item::FormatItem;
use super::lists::ElementKind;
use super::place::{ItemPlace, LineLayout};
use super::request::Lines;
use super::spacing::{is_assignment, precedence};
use super::structure::StatementStart;
use super::style::Brace;
use shaderlint_syntax::TokenKind as T;

/// Higher than any other cost; a statement has at most 200 nested brackets.
const LAST: u32 = 1 << 16;
/// Maximum width of the last part of an expression that stays with a part of several lines.
const STUB: u32 = 12;
/// Maximum number of lines that are balanced so that the last one is not short.
const BALANCED: usize = 3;

/// A part of a line that is too long, from the first item, which has its position, to the item
/// after the last one.
#[derive(Clone, Copy)]
struct LinePart {
    from: usize,
    to: usize,
}

/// The breaks of a level.
struct LevelBreaks {
    /// The first item of each line that may start here.
    at: Vec<usize>,
    is_operator: bool,
    /// Whether they are before the `?` or `:` of `? :`.
    is_ternary: bool,
}

impl LineLayout<'_> {
    /// Assigns positions to the items after `at` on its line if the line is too long.
    pub(super) fn fit(&mut self, at: usize) {
        if self.lines == Lines::Kept || self.point.inline.is_some() {
            return;
        }
        let to = self.line_end(at);
        let brace = self.role(to).start == StatementStart::Open && self.style.brace == Brace::Same;
        let after = if brace { 2 } else { 0 };
        let column = self.placed(at).column;
        if to <= at + 1 || column + self.flat(at, to) + after <= self.style.width {
            return;
        }
        self.point.is_over = true;
        self.find_lists(at, to);
        if self.is_table_row(at, to) {
            return;
        }
        self.point.laid = to;
        self.point.after = after;
        self.point.last = to;
        self.lay(LinePart { from: at, to });
    }

    /// Whether items, after an assignment if there is one, contain several cells of a table.
    pub(super) fn is_table_row(&self, from: usize, to: usize) -> bool {
        let is_assignment = |i: &usize| {
            let kind = self.item(*i).and_then(FormatItem::token);
            self.role(*i).bracket.is_none() && kind.is_some_and(is_assignment)
        };
        let start = (from..to).find(is_assignment).map_or(from, |i| i + 1);
        let is_cell =
            |i: &usize| self.is_aligned(*i) && self.item(*i).is_some_and(|item| !item.is_comment());
        (start..to).filter(is_cell).nth(1).is_some()
    }

    /// The item after the last one that follows `at` on its line, without comments at its end.
    fn line_end(&self, at: usize) -> usize {
        let mut end = at + 1;
        let rest = self.items.iter().enumerate().skip(at + 1);
        for (i, item) in rest {
            let before = self.before(i);
            let is_inside = self.role(i).start == StatementStart::Nothing;
            let goes_on = |before| item.breaks == 0 || self.joins(i, item, before);
            if !is_inside
                || item.keeps
                || item.parts_lines()
                || !before.is_some_and(|b| !b.parts_lines() && goes_on(b))
            {
                break;
            }
            if !item.is_comment() {
                end = i + 1;
            }
        }
        end
    }

    /// The width of the items before `to` from `from` on, on one line.
    fn flat(&self, from: usize, to: usize) -> u32 {
        let end = |i: usize| self.ends.get(i).copied().unwrap_or(0);
        let first = self.item(from).map_or(0, |i| i.width);
        (end(to.saturating_sub(1)) + first).saturating_sub(end(from))
    }

    /// Whether items fit on a line that starts at `column`.
    fn fits_at(&self, column: u32, from: usize, to: usize) -> bool {
        let after = if to == self.point.last {
            self.point.after
        } else {
            0
        };
        column + self.flat(from, to) + after <= self.style.width
    }

    /// Assigns positions to a part.
    fn lay(&mut self, part: LinePart) {
        let LinePart { from, to } = part;
        if self.fits_at(self.placed(from).column, from, to) {
            return self.lay_flat(from + 1, to);
        }
        match self.level_breaks(part) {
            Some((LAST.., breaks)) => self.lay_last(part, &breaks),
            Some((_, breaks)) => self.lay_level(part, &breaks),
            None => self.lay_flat(from + 1, to),
        }
    }

    fn lay_flat(&mut self, from: usize, to: usize) {
        for i in from..to {
            if let Some(item) = self.items.get(i).copied() {
                self.go_on(i, &item);
            }
        }
    }

    /// The possible breaks of a part that cost the least.
    fn level_breaks(&self, part: LinePart) -> Option<(u32, LevelBreaks)> {
        // An operator at the end of the line stays there.
        let last = self.point.laid.saturating_sub(1);
        let kind = self.item(last).and_then(FormatItem::token);
        let is_operator = kind.is_some_and(|kind| precedence(kind).is_some());
        let to = part.to.min(last + usize::from(!is_operator));
        let candidates = (part.from + 1..to).filter_map(|i| Some((self.cost(i)?, i)));
        let mut least = u32::MAX;
        let mut at = Vec::new();
        for (cost, i) in candidates {
            if cost < least {
                least = cost;
                at.clear();
            }
            if cost == least {
                at.push(i);
            }
        }
        let first = *at.first()?;
        let bracket = self.role(first).bracket;
        at.retain(|i| least >= LAST || self.role(*i).bracket == bracket);
        let operator = self.operator_of_line(first);
        let breaks = LevelBreaks {
            at,
            is_operator: operator.is_some(),
            is_ternary: matches!(operator, Some(T::Question | T::Colon)),
        };
        Some((least, breaks))
    }

    /// Breaks a part where it should not be broken: after an assignment or a parenthesis.
    fn lay_last(&mut self, part: LinePart, breaks: &LevelBreaks) {
        let LinePart { mut from, to } = part;
        for at in breaks.at.iter().copied() {
            if self.fits_at(self.placed(from).column, from, to) {
                break;
            }
            self.lay_flat(from + 1, at);
            self.break_before(at);
            from = at;
        }
        self.lay(LinePart { from, to });
    }

    /// Breaks a part at a level.
    fn lay_level(&mut self, part: LinePart, breaks: &LevelBreaks) {
        let LinePart { from, to } = part;
        let Some(first) = breaks.at.first().copied() else {
            return;
        };
        let open = self.role(first).bracket.map(|b| b as usize);
        let open = open.filter(|open| *open >= from);
        if breaks.is_operator && open.is_none() && self.lay_after_assignment(part, breaks) {
            return;
        }
        let column = self.placed(from).column;
        let fits = self.fits_at(column, from, first);
        // The column of the bracket determines that of the other lines.
        let flat = match (fits, open) {
            (true, _) => first,
            (false, Some(open)) if self.fits_at(column, from, open + 1) => open + 1,
            _ => from + 1,
        };
        self.lay_flat(from + 1, flat);
        let parts = breaks.parts(from, to);
        let hang = self.hanging(first).0;
        if let Some(open) = open.filter(|_| !breaks.is_operator) {
            if let Some(last) = self.hugged(open, &parts, (column, hang)).filter(|_| fits) {
                self.lay_flat(first, last + 1);
                return self.lay(LinePart { from: last, to });
            }
            if self.lay_below(open, part, breaks, (fits, hang)) {
                return;
            }
        }
        if !fits && let Some(item) = self.items.get(from).copied() {
            self.finish(&item, column);
        }
        if !fits && parts.len() == 2 && !breaks.is_ternary && self.flat(first, to) <= STUB {
            return self.lay_with(LinePart { from, to: first }, to);
        }
        if !fits {
            self.lay(LinePart { from, to: first });
        }
        let hang = self.hanging(first).0;
        self.fill(&parts, (column, hang), breaks);
    }

    /// Breaks after the bracket of a list if its elements do not fit on lines after the bracket, and
    /// have much more space below it. `fits` says whether the first one fits after the bracket, and
    /// `hang` is the column of the others.
    fn lay_below(
        &mut self,
        open: usize,
        part: LinePart,
        breaks: &LevelBreaks,
        (fits, hang): (bool, u32),
    ) -> bool {
        let LinePart { from, to } = part;
        let Some(first) = breaks.at.first().copied() else {
            return false;
        };
        let start = self.placed(from).column;
        let parts = breaks.parts(from, to);
        let fit = fits && self.all_fit(&parts, (start, hang));
        let is_far = hang <= self.placed(open).column;
        let has_several = parts.len() > 2;
        if fit && !(is_far && has_several) || !self.fits_at(start, from, open + 1) {
            return false;
        }
        let indent = self.style.indent.width();
        let column = self.line_column() + indent;
        let parts = breaks.parts(open + 1, to);
        let is_stub = parts.len() == 2 && self.flat(first, to) <= STUB;
        let is_deep = !fit && (hang > column + 2 * indent || is_far && !fits && !is_stub);
        if !is_deep && !self.all_fit(&parts, (column, column)) {
            return false;
        }
        self.break_before(open + 1);
        self.lay(LinePart {
            from: open + 1,
            to: first,
        });
        self.fill(&parts, (column, column), breaks);
        true
    }

    /// The first item of the last element of a list, if it is a call that is broken at its commas
    /// while the elements before it stay on one line: `d = min(d, f(a,` is not broken before `f`.
    fn hugged(&self, open: usize, parts: &[(usize, usize)], columns: (u32, u32)) -> Option<usize> {
        let (from, _) = *parts.first()?;
        let (last, to) = *parts.last()?;
        if self.fits_at(columns.1, last, to) {
            return None;
        }
        let is_prefix = self.item(last)?.is_prefix;
        let call = last + 1 + usize::from(is_prefix);
        let close = self.role(call).partner.filter(|_| self.is_call(call))? as usize;
        let column = columns.0 + self.flat(from, call + 1);
        let is_far = column > self.style.width * 2 / 5;
        if is_far || self.role(close + 1).partner != Some(open as u32) {
            return None;
        }
        let is_comma = |at: &usize| {
            let is_inner = self.role(*at).bracket == Some(call as u32);
            is_inner && self.before(*at).is_some_and(|before| before.is(T::Comma))
        };
        let at: Vec<usize> = (call + 1..close).filter(is_comma).collect();
        let breaks = LevelBreaks {
            at,
            is_operator: false,
            is_ternary: false,
        };
        let parts = breaks.parts(call + 1, to);
        let is_stub = parts.last().is_some_and(|(a, b)| self.flat(*a, *b) <= STUB);
        (parts.len() > 1 && !is_stub && self.all_fit(&parts, (column, column))).then_some(last)
    }

    fn is_call(&self, open: usize) -> bool {
        let is_word = |item: &FormatItem| item.is(T::Identifier) || item.is(T::Type);
        self.item(open).is_some_and(|item| item.is(T::LeftParen))
            && self.before(open).is_some_and(is_word)
    }

    /// Breaks after an assignment if that leaves one line and the alternative a short last one.
    fn lay_after_assignment(&mut self, part: LinePart, breaks: &LevelBreaks) -> bool {
        let (Some(first), Some(last)) = (breaks.at.first(), breaks.at.last()) else {
            return false;
        };
        let is_outer = |i: &usize| self.role(*i).bracket.is_none();
        let is_assigned = |i: &usize| {
            self.item(*i)
                .and_then(FormatItem::token)
                .is_some_and(is_assignment)
        };
        let mut before = (part.from..*first).filter(is_outer);
        let Some(at) = before.find(is_assigned).map(|i| i + 1) else {
            return false;
        };
        let column = self.point.statement_column + self.style.indent.width();
        let is_short = self.flat(*last, part.to) <= 2 * STUB;
        if !(is_outer(first) && is_short && self.fits_at(column, at, part.to)) {
            return false;
        }
        self.lay_flat(part.from + 1, at);
        self.break_before(at);
        self.lay_flat(at + 1, part.to);
        true
    }

    /// Whether each part fits on a line, the first one and the others from these columns on.
    fn all_fit(&self, parts: &[(usize, usize)], columns: (u32, u32)) -> bool {
        let column = |n| if n == 0 { columns.0 } else { columns.1 };
        let mut parts = parts.iter().enumerate();
        parts.all(|(n, (a, b))| self.fits_at(column(n), *a, *b))
    }

    /// Assigns positions to parts, as many on each line as fit, or one if some do not fit on a line.
    /// The first part has its position.
    fn fill(&mut self, parts: &[(usize, usize)], columns: (u32, u32), breaks: &LevelBreaks) {
        let fits = self.all_fit(parts, columns);
        let is_split = breaks.is_operator && (!fits || breaks.is_ternary);
        let (head, tail) = match fits {
            true => (false, false),
            false => self.joined(parts, columns, breaks),
        };
        let width = self.balanced(parts, columns);
        let per_line = self.per_line(parts, columns, breaks);
        let first_fits = parts
            .first()
            .is_none_or(|(a, b)| self.fits_at(columns.0, *a, *b));
        let mut was_broken = is_split || !first_fits;
        for (n, &(a, b)) in parts.iter().enumerate().skip(1) {
            let blank = u32::from(self.blanks.get(a) == Some(&true));
            let goes_on = match per_line {
                Some(count) => n % count > 0,
                None => self.ends_before(width, self.point.end + blank, a, b),
            };
            if !was_broken && goes_on {
                self.lay_flat(a, b);
                continue;
            }
            match n == 1 && head {
                true => self.lay_flat(a, a + 1),
                false => self.break_before(a),
            }
            let line = self.starts.len();
            let part = LinePart { from: a, to: b };
            match parts.last() {
                Some((_, end)) if tail && n + 2 == parts.len() => {
                    return self.lay_with(part, *end);
                }
                _ => self.lay(part),
            }
            was_broken = is_split || self.starts.len() != line;
        }
    }

    /// Assigns positions to a part and to the items after it up to `end`, which stay on its last
    /// line.
    fn lay_with(&mut self, part: LinePart, end: usize) {
        let (last, after) = (self.point.last, self.point.after);
        self.point.after = 1 + self.flat(part.to, end) + if end == last { after } else { 0 };
        self.point.last = part.to;
        self.lay(part);
        (self.point.last, self.point.after) = (last, after);
        self.lay_flat(part.to, end);
    }

    /// Whether the second part stays on the line of the first, which is short, and whether the last
    /// one, if it is short, stays with the one before it, which has several lines.
    fn joined(
        &self,
        parts: &[(usize, usize)],
        columns: (u32, u32),
        breaks: &LevelBreaks,
    ) -> (bool, bool) {
        let column = |n: usize| if n == 0 { columns.0 } else { columns.1 };
        let is_long = |n: usize| {
            let part = parts.get(n);
            part.is_some_and(|(a, b)| !self.fits_at(column(n), *a, *b))
        };
        let is_short = |from: usize, to: usize| self.flat(from, to) <= STUB;
        let bracket = breaks.at.first().and_then(|i| self.role(*i).bracket);
        let starts = |i: &usize| {
            let is_start = |k| is_assignment(k) || matches!(k, T::Return | T::Question | T::Colon);
            let is_start = self
                .item(*i)
                .and_then(FormatItem::token)
                .is_some_and(is_start);
            bracket == Some(*i as u32) || is_start && self.role(*i).bracket == bracket
        };
        let first = parts.first().is_some_and(|&(a, b)| {
            let before = (a..b).rev().find(starts);
            is_short(before.map_or(a, |i| i + 1), b)
        });
        let last = parts.last().is_some_and(|(a, b)| is_short(*a, *b));
        let before = parts.len().wrapping_sub(2);
        (
            breaks.is_operator && !breaks.is_ternary && first && is_long(1),
            last && before > 0 && is_long(before) && !breaks.is_ternary,
        )
    }

    /// The number of parts on each line, if they are the elements of a list that has columns.
    fn per_line(
        &self,
        parts: &[(usize, usize)],
        columns: (u32, u32),
        breaks: &LevelBreaks,
    ) -> Option<usize> {
        let open = self.role(*breaks.at.first()?).bracket? as usize;
        if breaks.is_operator || self.lists.get(open) == Some(&Some(false)) {
            return None;
        }
        let kind = self.list(open)?;
        let has_columns = matches!(kind, ElementKind::Number | ElementKind::Call(_));
        let mut elements = parts.to_vec();
        let first = elements.first_mut()?;
        let column = match first.0 > open {
            true => columns.0,
            false => self.placed(open).column + 1,
        };
        first.0 = first.0.max(open + 1);
        if !has_columns || column != columns.1 {
            return None;
        }
        let fit = |count: usize| {
            let mut rows = elements.chunks(count);
            rows.all(|row| match (row.first(), row.last()) {
                (Some((a, _)), Some((_, b))) => self.fits_at(column, *a, *b),
                _ => true,
            })
        };
        let least = elements.iter().map(|(a, b)| self.flat(*a, *b)).min()?;
        let limit = (self.style.width / least.max(1)) as usize;
        let most = (1..=limit.min(parts.len()))
            .rev()
            .find(|count| fit(*count))?;
        if let Some(rows) = self.matrix_rows(open, kind).filter(|rows| *rows <= most) {
            return Some(rows);
        }
        let parts = parts.len();
        let mut equal = (most.div_ceil(2)..=most).rev();
        let equal = equal.find(|count| parts.is_multiple_of(*count));
        // Without lines of equal length, they are about equal.
        let count = equal.unwrap_or_else(|| parts.div_ceil(parts.div_ceil(most)));
        let (lines, _) = self.filled(&elements, (column, column), self.style.width);
        (parts.div_ceil(count) <= lines + 1).then_some(count)
    }

    fn ends_before(&self, width: u32, column: u32, from: usize, to: usize) -> bool {
        column + self.flat(from, to) <= width && self.fits_at(column, from, to)
    }

    /// The width that avoids a last line of one part where others have several.
    fn balanced(&self, parts: &[(usize, usize)], columns: (u32, u32)) -> u32 {
        let full = self.style.width;
        let (lines, last) = self.filled(parts, columns, full);
        if last > 1 || !(2..=BALANCED).contains(&lines) || lines == parts.len() {
            return full;
        }
        let find = |is_less: &dyn Fn((usize, usize)) -> bool| {
            let (mut low, mut high) = (0, full);
            while low + 1 < high {
                let width = low.midpoint(high);
                match is_less(self.filled(parts, columns, width)) {
                    true => low = width,
                    false => high = width,
                }
            }
            (low, high)
        };
        // The least width of so many lines, and the greatest that has several parts on the last.
        let (_, least) = find(&|(count, _)| count > lines);
        let (most, _) = find(&|(count, last)| count > lines || last > 1);
        match self.filled(parts, columns, least).1 > 1 {
            true => most.max(least),
            false => full,
        }
    }

    /// The number of lines that parts fill, and the number of parts on the last one.
    fn filled(&self, parts: &[(usize, usize)], columns: (u32, u32), width: u32) -> (usize, usize) {
        let (mut lines, mut count, mut end) = (1, 0, columns.0);
        for &(a, b) in parts {
            let blank = u32::from(count > 0 && self.blanks.get(a) == Some(&true));
            if count > 0 && !self.ends_before(width, end + blank, a, b) {
                (lines, count, end) = (lines + 1, 1, columns.1 + self.flat(a, b));
            } else {
                (count, end) = (count + 1, end + blank + self.flat(a, b));
            }
        }
        (lines, count)
    }

    /// Starts a new line before an item, although the source does not.
    fn break_before(&mut self, at: usize) {
        let Some(item) = self.items.get(at).copied() else {
            return;
        };
        let (column, depends_on) = self.hanging(at);
        let level = self.role(at).level + self.base_level();
        let place = ItemPlace {
            breaks: 1,
            column,
            level,
            depends_on,
            ..ItemPlace::default()
        };
        self.put(at, place);
        self.new_line(at);
        self.finish(&item, column);
    }

    /// The cost of a line break before an item; `None` where it is not allowed.
    fn cost(&self, at: usize) -> Option<u32> {
        let (item, before, role) = (self.item(at)?, self.before(at)?, self.role(at));
        let (kind, before_kind) = (item.token()?, before.token()?);
        if role.start != StatementStart::Nothing || item.keeps || self.labels(at) {
            return None;
        }
        let inner = match before_kind {
            _ if kind == T::Semicolon => return None,
            T::Semicolon => 0,
            T::Comma => 1,
            before if is_assignment(before) => LAST,
            T::LeftParen if kind != T::RightParen => return Some(2 * LAST + role.depth),
            _ => match self.operator_of_line(at)? {
                T::Question if self.is_in_chain(at) => 7,
                T::Colon | T::Question => 6,
                operator => 2 * precedence(operator)?,
            },
        };
        Some(role.depth * 64 + inner)
    }

    /// Whether an item belongs to a label.
    fn labels(&self, at: usize) -> bool {
        self.role(at).is_label || self.role(self.point.statement).start == StatementStart::Label
    }
}

impl LevelBreaks {
    /// The parts between the breaks.
    fn parts(&self, start: usize, to: usize) -> Vec<(usize, usize)> {
        let from = std::iter::once(start).chain(self.at.iter().copied());
        let to = self.at.iter().copied().chain([to]);
        from.zip(to).collect()
    }
}
