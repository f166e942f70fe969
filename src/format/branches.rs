//! The indentation of code inside preprocessor conditionals, if the author indented it.

use super::item::{FormatItem, ItemKind};
use super::structure::{ItemRole, StatementStart};
use shaderlint_syntax::ConditionalGroups;

/// Indents the code inside each conditional whose first line is indented further than its `#if`,
/// unless that is at the margin inside a function. The directives of a conditional are indented
/// alike, as the outermost of them; code is not indented if it opens or closes blocks around them.
pub fn indent(items: &[FormatItem], roles: &mut [ItemRole], base: u32) {
    let mut extra = vec![0i64; items.len() + 1];
    let mut groups = ConditionalGroups::default();
    for (at, item) in items.iter().enumerate() {
        if let ItemKind::Directive(Some(effect)) = item.kind {
            groups.add(effect, at);
        }
    }
    let indented: Vec<Option<bool>> = groups
        .all
        .iter()
        .map(|group| {
            // The first line that moves with its directive shows what the author does.
            let mut branches = group.branches.iter();
            branches.find_map(|b| is_indented(items, roles, b.directive, base))
        })
        .collect();
    for (group, is_indented) in groups.all.iter().zip(indented) {
        if group.end.is_none() {
            continue;
        }
        let directives: Vec<usize> = group.directives().copied().collect();
        let [first, .., last] = directives[..] else {
            continue;
        };
        let level = |at: &usize| roles.get(*at).map_or(0, |role| role.level);
        let levels = directives.iter().map(level);
        let (Some(least), Some(most)) = (levels.clone().min(), levels.max()) else {
            continue;
        };
        for at in &directives {
            if let Some(role) = roles.get_mut(*at) {
                role.level = least;
            }
        }
        if is_indented != Some(true) || least != most {
            continue;
        }
        let inner = directives.iter().skip(1);
        let changes = [(first + 1, 1), (last, -1)].into_iter();
        let between = inner.filter(|at| **at != last);
        let changes = changes.chain(between.flat_map(|at| [(*at, -1), (*at + 1, 1)]));
        for (at, change) in changes {
            if let Some(extra) = extra.get_mut(at) {
                *extra += change;
            }
        }
    }
    let mut depth = 0;
    for (role, change) in roles.iter_mut().zip(extra) {
        depth += change;
        role.level += u32::try_from(depth).unwrap_or(0);
    }
}

/// Whether the line after a directive is indented further; `None` if it does not move with it.
fn is_indented(items: &[FormatItem], roles: &[ItemRole], at: usize, base: u32) -> Option<bool> {
    let (item, next) = (items.get(at)?, items.get(at + 1)?);
    let (role, next_role) = (roles.get(at)?, roles.get(at + 1)?);
    let goes_on = next.token().is_some() && next_role.start == StatementStart::Nothing;
    if next.keeps || goes_on {
        return None;
    }
    let is_placed = item.column > base || role.level == 0;
    let is_deeper = next.column > item.column + 1 && next_role.level == role.level;
    Some(is_placed && is_deeper && !item.keeps)
}
