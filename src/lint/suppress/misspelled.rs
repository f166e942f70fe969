//! Malformed suppression comments: `shaderlint-disable-line x`, `shaderlint allow(x)`,
//! `shaderlint: alow(x)`. Comments for other programs are ignored.

use crate::rule::{Group, Rule};
use std::ops::Range;

/// The name of the program in comments.
const NAME: &str = "shaderlint";
/// The verbs that linters use for suppression.
const VERBS: [&str; 8] = [
    "allow", "disable", "ignore", "suppress", "skip", "off", "nolint", "noqa",
];

/// The suppression that was probably intended.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MisspelledComment {
    /// Byte range in the comment.
    pub range: Range<usize>,
    /// `allow` or `allow-file`.
    pub order: &'static str,
    /// The rules and groups that the comment names.
    pub names: Vec<&'static str>,
}

impl MisspelledComment {
    /// The correct spelling, for these rules and groups.
    pub fn corrected(&self, names: &[&str]) -> String {
        format!("{NAME}: {}({})", self.order, names.join(", "))
    }
}

/// Parses a comment without a well-formed suppression; `None` if it does not look like one.
pub fn read(comment: &str, rules: &[&'static Rule]) -> Option<MisspelledComment> {
    let start = comment.find(|c: char| c.is_ascii_alphanumeric())?;
    let rest = comment.get(start..)?;
    let after = rest.get(name_length(rest)?..)?;
    let is_attached = after.starts_with([':', '-', '=', '_']);
    let order = after.trim_start_matches(|c: char| !c.is_ascii_alphanumeric());
    let end = order.find(|c: char| !c.is_ascii_alphabetic() && c != '-' && c != '_');
    let (verb, list) = order.split_at(end.unwrap_or(order.len()));
    let head = verb.split(['-', '_']).next().unwrap_or("");
    if !is_verb(head) {
        return None;
    }
    let offset = comment.len() - list.len();
    let (names, length) = names(list, rules);
    // Prose may mention the program, too.
    let is_order = is_attached || list.trim_start().starts_with('(') || !names.is_empty();
    is_order.then(|| MisspelledComment {
        range: start..offset + length,
        order: match verb.to_ascii_lowercase().contains("file") {
            true => "allow-file",
            false => "allow",
        },
        names,
    })
}

/// Length of the program name that a text starts with, with at most two typos.
fn name_length(text: &str) -> Option<usize> {
    let end = text.find(|c: char| !c.is_ascii_alphanumeric());
    let end = end.unwrap_or(text.len());
    let split = ["shader-lint", "shader_lint", "shader lint"];
    let head = text.get(..split[0].len());
    if head.is_some_and(|h| split.iter().any(|s| s.eq_ignore_ascii_case(h))) {
        return Some(split[0].len());
    }
    let word = text.get(..end)?;
    // Each letter that is not in the name is a typo.
    let is_other = |b: &u8| !NAME.as_bytes().contains(&b.to_ascii_lowercase());
    let is_near = word.len().abs_diff(NAME.len()) <= 2
        && word.bytes().filter(is_other).count() <= 2
        && strsim::damerau_levenshtein(&word.to_ascii_lowercase(), NAME) <= 2;
    is_near.then_some(end)
}

fn is_verb(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    let is_near = |verb: &&str| {
        let max_distance = usize::from(verb.len() > 4);
        verb.len().abs_diff(word.len()) <= max_distance
            && strsim::damerau_levenshtein(verb, &word) <= max_distance
    };
    VERBS.iter().any(is_near)
}

/// The rules and groups at the start of a list, and the length of the list.
fn names(list: &str, rules: &[&'static Rule]) -> (Vec<&'static str>, usize) {
    let mut names = Vec::new();
    let mut length = 0;
    let mut at = 0;
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    while let Some(rest) = list.get(at..) {
        let Some(start) = rest.find(is_part) else {
            break;
        };
        let word = rest.get(start..).unwrap_or("");
        let word = word.get(..word.find(|c| !is_part(c)).unwrap_or(word.len()));
        let Some(word) = word.filter(|w| !w.is_empty()) else {
            break;
        };
        let Some(name) = nearest(word, rules) else {
            break;
        };
        if !names.contains(&name) {
            names.push(name);
        }
        at += start + word.len();
        length = at;
    }
    let tail = list.get(length..).unwrap_or("");
    let closing = tail.len() - tail.trim_start_matches([' ', ')', ']', '"', '\'']).len();
    let closes = tail.get(..closing).unwrap_or("").trim_end();
    match names.is_empty() {
        true => (names, list.find(')').map_or(0, |i| i + 1)),
        false => (names, length + closes.len()),
    }
}

fn nearest(word: &str, rules: &[&'static Rule]) -> Option<&'static str> {
    let word = word.to_ascii_lowercase().replace('_', "-");
    let names = rules.iter().map(|r| r.name);
    let names = names.chain(Group::ALL.iter().map(|g| g.name()));
    let distance = |name: &str| match name.len().abs_diff(word.len()) {
        0..=2 if name.len() > 6 => strsim::damerau_levenshtein(name, &word),
        _ => usize::from(name != word) * 9,
    };
    let near = names.map(|n| (distance(n), n)).min();
    near.filter(|(d, _)| *d <= 2).map(|(_, n)| n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example_rules::RULES;
    use shaderlint_text::each_case;

    /// Each case is a comment and what was intended.
    #[test]
    fn misspelled_suppressions_are_recognised() {
        each_case(include_str!("misspelled.txt"), |comment, expected| {
            let corrected = read(comment, RULES).map_or("none".to_string(), |m| {
                let mut text = comment.to_string();
                text.replace_range(m.range.clone(), &m.corrected(&m.names));
                text
            });
            assert_eq!(corrected, expected, "{comment}");
        });
    }
}
