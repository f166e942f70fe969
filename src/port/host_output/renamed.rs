//! The code of a user with other names for some identifiers and without some declarations, and the
//! positions in it.

use shaderlint_syntax::{RawKind, written_tokens};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// New names of identifiers.
pub(super) type NewNames = BTreeMap<String, String>;

/// A text in which identifiers were renamed.
pub(super) struct RenamedText {
    pub(super) text: String,
    /// By change: its offset and length in the old text, and its length in the new one.
    moves: Vec<(usize, usize, usize)>,
}

impl RenamedText {
    /// Renames all identifiers at once, also in directives, and removes parts of the text.
    pub(super) fn of(old: &str, names: &NewNames, removed: &[Range<usize>]) -> RenamedText {
        let is_removed = |at: usize| removed.iter().any(|part| part.contains(&at));
        let words = words(old).into_iter();
        let renamed = words.filter(|(start, _)| !is_removed(*start));
        let renamed = renamed.filter_map(|(start, word)| {
            let new = names.get(word)?;
            Some((start..start + word.len(), new.as_str()))
        });
        let removed = removed.iter().map(|part| (part.clone(), ""));
        let mut changes: Vec<_> = renamed.chain(removed).collect();
        changes.sort_by_key(|(part, _)| part.start);
        let (mut text, mut moves, mut from) = (String::new(), Vec::new(), 0);
        for (part, new) in changes {
            text.push_str(old.get(from..part.start).unwrap_or(""));
            text.push_str(new);
            from = part.end;
            moves.push((part.start, part.len(), new.len()));
        }
        text.push_str(old.get(from..).unwrap_or(""));
        RenamedText { text, moves }
    }

    /// The offset in the old text for one in the new text.
    pub(super) fn old_offset(&self, new: usize) -> usize {
        let mut grown = 0_isize;
        for (start, old_length, new_length) in &self.moves {
            let at = start.saturating_add_signed(grown);
            if new < at {
                break;
            }
            if new < at + new_length {
                return *start;
            }
            grown += *new_length as isize - *old_length as isize;
        }
        new.saturating_add_signed(-grown)
    }
}

/// The words of a text with their offsets, without those in comments.
pub(super) fn words(text: &str) -> Vec<(usize, &str)> {
    let words = written_tokens(text).filter(|(kind, ..)| *kind == RawKind::Word);
    words.map(|(_, range, word)| (range.start, word)).collect()
}

/// A name that is not among the words, based on another one.
pub(super) fn unused(base: &str, taken: &BTreeSet<String>) -> String {
    let mut number = 2;
    loop {
        let name = format!("{base}{number}");
        if !taken.contains(&name) {
            return name;
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_swapped_simultaneously() {
        let names: NewNames = [("a", "bb"), ("bb", "a"), ("c", "long")]
            .map(|(old, new)| (old.to_string(), new.to_string()))
            .into();
        let text = "a = bb + c; // a\n#define bb c\nd";
        let renamed = RenamedText::of(text, &names, &[]);
        assert_eq!(renamed.text, "bb = a + long; // a\n#define a long\nd");
        for (old, letter) in [(2, '='), (9, 'l'), (10, ';'), (30, 'd')] {
            let new = match letter {
                'l' => 9,
                letter => renamed.text.rfind(letter).unwrap(),
            };
            assert_eq!(renamed.old_offset(new), old, "{letter}");
        }
        let start = 0..4;
        let shorter = RenamedText::of(text, &names, std::slice::from_ref(&start));
        assert_eq!(shorter.text, "a + long; // a\n#define a long\nd");
        assert_eq!(shorter.old_offset(shorter.text.len() - 1), 30);
    }
}
